// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "pomdp_crowd_nav/control/stopping_path.h"
#include "pomdp_crowd_nav/control/velocity_limiter.h"

namespace pomdp_crowd_nav {

// Why the guard does not forward a command.
enum class GuardCause {
  kNone,
  kNoCommand,
  kCommandNotFinite,
  kClockJumped,
  kNoOdometry,
  kOdometryRefused,  // for its stamp
  kOdometryNotFinite,
  kNoPeople,
  kPeopleRefused,  // for their stamps, frames or numbers
  kNoTransform,
  kPerson,
  kShutDown
};

const char* describe(GuardCause cause);

// The last line before the base: cuts commands to the limits, and brakes the base for a person in
// its stopping path and whenever a command, odometry or people are missing or too old.
//
// What it puts out is never faster than a command that is fresh, never over the limits, always
// finite. It knows nothing of the planner. A guard that starts beside a base in motion and hears no
// command brakes it once. All times [s], steady clock.
class VelocityGuard {
 public:
  struct Params {
    double frequency = 50.0;        // [Hz] of the output
    double command_timeout = 0.25;  // [s], an older command brakes the base
    double margin = 0.05;           // [m], of a person's centre from the robot's disc
    double reaction_time = 0.2;     // [s] from a command to the base's answer
    double hold_time = 0.5;         // [s] that the way is free before it drives on
    double odom_timeout = 0.5;      // [s], older odometry brakes the base
    double people_timeout = 1.0;    // [s], older tracks brake the base
  };

  // Of people; whoever one of them reports counts. One is enough, but one that goes silent while it
  // reports somebody is missed for 10 s.
  static constexpr size_t kSources = 2;

  VelocityGuard(const Params& params, const VehicleParams& vehicle);

  // What came in, in the frame in which odometry is given; velocities in the base frame. Odometry
  // that cannot be is passed over.
  void takeCommand(const BaseCommand& command, double now);
  void takeMotion(const Pose& pose, const BaseCommand& velocity, double measured_at);
  void takePeople(const TrackList& people, double measured_at, size_t source = 0);
  // Why messages are dropped: kOdometry... and, of people, kPeopleRefused or kNoTransform.
  void noteBadOdometry(double now, GuardCause why = GuardCause::kOdometryNotFinite);
  void noteBadPeople(double now, GuardCause why);
  // Everything measured before is forgotten.
  void noteClockJump(double now);
  // From now on the base is braked.
  void shutDown() { is_shut_down_ = true; }

  struct Output {
    std::optional<BaseCommand> command;  // none: there is nothing to say
    GuardCause cause = GuardCause::kNone;
    std::int64_t person = -1;   // track id, of kPerson
    bool is_limited = false;    // less than was commanded, for no cause but the limits
    double wanted_speed = 0.0;  // [m/s], commanded; 0 without a fresh command
  };

  Output tick(double now);

  // Ages [s]; -1: never.
  double commandAge(double now) const { return age(command_at_, now); }
  double odometryAge(double now) const { return age(motion_at_, now); }
  double peopleAge(double now) const { return age(peopleAt(), now); }

 private:
  static double age(double moment, double now) { return moment < 0.0 ? -1.0 : now - moment; }
  static bool isRecent(double moment, double limit, double now);

  bool hasMotion(double now) const;
  GuardCause whyNoCommand(double now) const;
  GuardCause missingInput(double now) const;
  double peopleAt() const;
  bool hasLostPeople(double now) const;
  std::vector<Track> peopleOf(double now) const;
  bool mustTakeOver(double now);
  std::optional<std::int64_t> personInTheWay(double now);
  Pose poseAt(double now) const;
  Output stopped(GuardCause cause, double now, double period);
  bool isIdle(double now);

  Params params_;
  VehicleParams vehicle_;
  StoppingPath path_;
  VelocityLimiter limiter_;

  BaseCommand command_;
  bool is_command_finite_ = true;
  Pose pose_;
  BaseCommand velocity_;
  struct Sweep {
    TrackList people;
    double at = -1.0;
  };
  std::array<Sweep, kSources> sweeps_;
  double command_at_ = -1.0;
  double motion_at_ = -1.0;
  double bad_odometry_at_ = -1.0;
  GuardCause bad_odometry_ = GuardCause::kOdometryNotFinite;
  double bad_people_at_ = -1.0;
  GuardCause bad_people_ = GuardCause::kPeopleRefused;
  double clock_jump_at_ = -1.0;

  double first_tick_ = -1.0;
  double last_tick_ = -1.0;
  double blocked_at_ = -1.0;
  std::int64_t blocking_person_ = -1;
  double zero_since_ = -1.0;  // output is zero and there is no fresh command
  bool is_shut_down_ = false;
  // Of a guard that has not heard any command yet.
  enum class TakeOver { kUndecided, kBrakes, kOver } take_over_ = TakeOver::kUndecided;
  double moving_since_ = -1.0;
};

// Throws std::invalid_argument naming the first key ("guard/...") that is out of range.
void validate(const VelocityGuard::Params& params);

}  // namespace pomdp_crowd_nav
