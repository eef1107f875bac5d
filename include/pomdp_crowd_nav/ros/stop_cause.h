// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pomdp_crowd_nav {

// Why the base is braked or stopped while it has a goal.
enum class StopCause {
  kNone,
  kNoOdometry,
  kOdometryRefused,  // messages come, the MessageFault says what is wrong with them
  kNoPeople,
  kPeopleRefused,
  kWatchingPeople,  // beliefs need a second of tracks before they mean anything
  kNoMap,
  kMapRefused,
  kClockStandsStill,
  kClockJumped,  // beliefs began afresh
  kPoseJumped,   // the robot is suddenly elsewhere: beliefs began afresh
  kPreparing,
  kNoDecision,
  kEmergency,
  kObstacle,  // of a map that the planner does not know yet
  kPaused
};

const char* describe(StopCause cause);

// Why a message was refused.
enum class MessageFault {
  kNone,
  kUnstamped,
  kFuture,
  kOutOfOrder,
  kNoFrameName,
  kNoTransform,
  kOldTransform,
  kBadTransform,
  kNotFinite,
  kOutOfRange,
  kMalformed,
};

constexpr int kMessageFaults = static_cast<int>(MessageFault::kMalformed) + 1;

// Reads on after "odometry is refused: ".
const char* describe(MessageFault fault);

}  // namespace pomdp_crowd_nav
