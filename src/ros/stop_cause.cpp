// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/stop_cause.h"

namespace pomdp_crowd_nav {

const char* describe(StopCause cause) {
  switch (cause) {
    case StopCause::kNone:
      return "";
    case StopCause::kNoOdometry:
      return "odometry is silent or too old";
    case StopCause::kOdometryRefused:
      return "odometry is refused";
    case StopCause::kNoPeople:
      return "tracked people are silent or too old";
    case StopCause::kPeopleRefused:
      return "tracked people are refused";
    case StopCause::kWatchingPeople:
      return "watching people before the start";
    case StopCause::kNoMap:
      return "the map is missing or too old";
    case StopCause::kMapRefused:
      return "the map is refused";
    case StopCause::kClockStandsStill:
      return "the clock stands still";
    case StopCause::kClockJumped:
      return "the clock jumped";
    case StopCause::kPoseJumped:
      return "the robot's pose jumped";
    case StopCause::kPreparing:
      return "the way to the goal is being worked out";
    case StopCause::kNoDecision:
      return "no decision in time";
    case StopCause::kEmergency:
      return "emergency brake, a person is too close";
    case StopCause::kObstacle:
      return "an obstacle of the new map is in the way";
    case StopCause::kPaused:
      return "paused";
  }
  return "";
}

const char* describe(MessageFault fault) {
  switch (fault) {
    case MessageFault::kNone:
      return "";
    case MessageFault::kUnstamped:
      return "it has no time stamp";
    case MessageFault::kFuture:
      return "stamped in the future";
    case MessageFault::kOutOfOrder:
      return "stamped before the last one";
    case MessageFault::kNoFrameName:
      return "it names no frame";
    case MessageFault::kNoTransform:
      return "no transform to the global frame";
    case MessageFault::kOldTransform:
      return "the transform to the global frame is too old";
    case MessageFault::kBadTransform:
      return "the transform to the global frame is not finite or no rotation";
    case MessageFault::kNotFinite:
      return "a number is not finite or an orientation no rotation";
    case MessageFault::kOutOfRange:
      return "a number is out of range";
    case MessageFault::kMalformed:
      return "it contradicts itself";
  }
  return "";
}

}  // namespace pomdp_crowd_nav
