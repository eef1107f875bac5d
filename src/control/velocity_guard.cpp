// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/velocity_guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kLongestPeriod = 0.1;     // [s], a later tick allows no more change
constexpr double kRestSpeed = 0.03;        // [m/s]
constexpr double kRestYawRate = 0.05;      // [rad/s]
constexpr double kFarthest = 1e6;          // [m] from the origin of odometry
constexpr double kPlausible = 3.0;         // times its maximum speed, no base drives faster
constexpr double kFastestPerson = 20.0;    // [m/s], the speed of a faster one is not known
constexpr double kRestTime = 0.2;          // [s] of zeros at least
constexpr double kRestPatience = 5.0;      // [s] of zeros for a base that is not seen to rest
constexpr double kTakeOverPatience = 1.0;  // [s] the same for a base that others may drive
constexpr double kTakeOverWindow = 5.0;    // [s] after its start in which a guard takes over
constexpr double kLostPersonTime = 10.0;   // [s] that a silent source's people are missed

double speedOf(const Point& velocity) { return std::hypot(velocity.x(), velocity.y()); }

bool isZero(const BaseCommand& command) {
  return command.velocity == Point(0.0, 0.0) && command.yaw_rate == 0.0;
}

bool isFinite(const BaseCommand& command) {
  return command.velocity.allFinite() && std::isfinite(command.yaw_rate);
}

Point turned(double angle, const Point& vector) {
  const Point x = unitVector(angle);
  return {x.x() * vector.x() - x.y() * vector.y(), x.y() * vector.x() + x.x() * vector.y()};
}

StoppingPath::Params pathParams(const VelocityGuard::Params& params, const VehicleParams& vehicle) {
  return {vehicle.radius + params.margin, params.reaction_time};
}

}  // namespace

const char* describe(GuardCause cause) {
  switch (cause) {
    case GuardCause::kNone:
      return "";
    case GuardCause::kNoCommand:
      return "the planner is silent";
    case GuardCause::kCommandNotFinite:
      return "the command is not finite";
    case GuardCause::kClockJumped:
      return "the clock jumped back";
    case GuardCause::kNoOdometry:
      return "odometry is silent or too old";
    case GuardCause::kOdometryRefused:
      return "odometry is refused";
    case GuardCause::kOdometryNotFinite:
      return "odometry is not finite or out of range";
    case GuardCause::kNoTransform:
      return "no transform from the frame of tracked people to that of odometry";
    case GuardCause::kNoPeople:
      return "tracked people are silent or too old";
    case GuardCause::kPeopleRefused:
      return "tracked people are refused";
    case GuardCause::kPerson:
      return "a person is in the stopping path";
    case GuardCause::kShutDown:
      return "the guard is being shut down";
  }
  return "";
}

void validate(const VelocityGuard::Params& params) {
  const auto require = [](bool holds, const char* key, const char* expected, double value) {
    if (holds) return;
    throw std::invalid_argument(fmt::format("{} must be {}, got {}", key, expected, value));
  };
  const double period = 1.0 / params.frequency;
  require(params.frequency >= 20.0 && params.frequency <= 1000.0, "guard/frequency",
          "between 20 and 1000 Hz", params.frequency);
  require(params.command_timeout >= 2.0 * period, "guard/command_timeout",
          "at least two periods of guard/frequency", params.command_timeout);
  require(params.margin >= 0.0, "guard/margin", "at least 0", params.margin);
  require(params.reaction_time >= 0.0, "guard/reaction_time", "at least 0", params.reaction_time);
  require(params.hold_time >= 0.0, "guard/hold_time", "at least 0", params.hold_time);
  require(params.odom_timeout > 0.0, "odom_timeout", "positive", params.odom_timeout);
  require(params.people_timeout > 0.0, "people_timeout", "positive", params.people_timeout);
}

VelocityGuard::VelocityGuard(const Params& params, const VehicleParams& vehicle)
    : params_(params),
      vehicle_(vehicle),
      path_(pathParams(params, vehicle), vehicle),
      limiter_(vehicle) {
  validate(params);
}

void VelocityGuard::takeCommand(const BaseCommand& command, double now) {
  is_command_finite_ = isFinite(command);
  command_ = is_command_finite_ ? command : BaseCommand();
  command_at_ = now;
}

void VelocityGuard::takeMotion(const Pose& pose, const BaseCommand& velocity, double measured_at) {
  const bool is_plausible = isFinite(velocity) && std::isfinite(pose.heading) &&
                            speedOf(pose.position) <= kFarthest &&
                            speedOf(velocity.velocity) <= kPlausible * vehicle_.max_speed;
  if (!is_plausible) return noteBadOdometry(measured_at);
  pose_ = pose;
  velocity_ = velocity;
  motion_at_ = measured_at;
}

void VelocityGuard::takePeople(const TrackList& people, double measured_at, size_t source) {
  Sweep& sweep = sweeps_.at(source);
  const bool is_outdated =
      measured_at < sweep.at && !isRecent(measured_at, params_.people_timeout, sweep.at);
  if (is_outdated) return;  // newer ones are known
  sweep = {people, measured_at};
  for (Track& person : sweep.people.tracks) {
    if (!(speedOf(person.velocity) <= kFastestPerson)) person.velocity = Point(0.0, 0.0);
  }
}

void VelocityGuard::noteBadOdometry(double now, GuardCause why) {
  bad_odometry_at_ = now;
  bad_odometry_ = why;
}

void VelocityGuard::noteBadPeople(double now, GuardCause why) {
  bad_people_at_ = now;
  bad_people_ = why;
}

void VelocityGuard::noteClockJump(double now) {
  clock_jump_at_ = now;
  motion_at_ = -1.0;
  sweeps_ = {};
}

double VelocityGuard::peopleAt() const {
  double newest = -1.0;
  for (const Sweep& sweep : sweeps_) newest = std::max(newest, sweep.at);
  return newest;
}

// One of them reported somebody, and has been silent since.
bool VelocityGuard::hasLostPeople(double now) const {
  return std::any_of(sweeps_.begin(), sweeps_.end(), [&](const Sweep& sweep) {
    return !sweep.people.tracks.empty() && !isRecent(sweep.at, params_.people_timeout, now) &&
           isRecent(sweep.at, kLostPersonTime, now);
  });
}

bool VelocityGuard::isRecent(double moment, double limit, double now) {
  return moment >= 0.0 && now - moment <= limit;
}

bool VelocityGuard::hasMotion(double now) const {
  return isRecent(motion_at_, params_.odom_timeout, now);
}

VelocityGuard::Output VelocityGuard::tick(double now) {
  const double period = std::clamp(now - last_tick_, 0.0, kLongestPeriod);
  last_tick_ = now;
  if (first_tick_ < 0.0) first_tick_ = now;
  const GuardCause no_command = whyNoCommand(now);
  if (no_command != GuardCause::kNone) {
    if (mustTakeOver(now)) limiter_.limit(velocity_, {}, period, velocity_.velocity);
    return stopped(no_command, now, period);
  }
  zero_since_ = -1.0;
  const bool is_motion_wanted = !isZero(command_);
  const GuardCause missing = is_motion_wanted ? missingInput(now) : GuardCause::kNone;
  if (missing != GuardCause::kNone) return stopped(missing, now, period);
  if (const std::optional<std::int64_t> person = personInTheWay(now)) {
    Output output = stopped(GuardCause::kPerson, now, period);
    output.person = *person;
    return output;
  }
  Output output;
  const Point measured = hasMotion(now) ? velocity_.velocity : Point(0.0, 0.0);
  output.wanted_speed = speedOf(command_.velocity);
  output.command = limiter_.limit(command_, {}, period, measured);
  const double cut = (command_.velocity - output.command->velocity).norm() +
                     std::abs(command_.yaw_rate - output.command->yaw_rate);
  output.is_limited = !(cut <= 1e-6);
  return output;
}

GuardCause VelocityGuard::whyNoCommand(double now) const {
  if (is_shut_down_) return GuardCause::kShutDown;
  if (!isRecent(command_at_, params_.command_timeout, now)) return GuardCause::kNoCommand;
  return is_command_finite_ ? GuardCause::kNone : GuardCause::kCommandNotFinite;
}

GuardCause VelocityGuard::missingInput(double now) const {
  const bool has_people = isRecent(peopleAt(), params_.people_timeout, now) && !hasLostPeople(now);
  if (hasMotion(now) && has_people) return GuardCause::kNone;
  if (isRecent(clock_jump_at_, params_.people_timeout, now)) return GuardCause::kClockJumped;
  if (!hasMotion(now)) {
    const bool is_bad = isRecent(bad_odometry_at_, params_.odom_timeout, now);
    return is_bad ? bad_odometry_ : GuardCause::kNoOdometry;
  }
  const bool are_bad = isRecent(bad_people_at_, params_.people_timeout, now);
  return are_bad ? bad_people_ : GuardCause::kNoPeople;
}

// Moved on since it was measured.
Pose VelocityGuard::poseAt(double now) const {
  const double elapsed = std::max(0.0, now - motion_at_);
  return {pose_.position + elapsed * turned(pose_.heading, velocity_.velocity),
          pose_.heading + elapsed * velocity_.yaw_rate};
}

// Whoever was seen lately, moved on since.
std::vector<Track> VelocityGuard::peopleOf(double now) const {
  std::vector<Track> people;
  for (const Sweep& sweep : sweeps_) {
    if (!isRecent(sweep.at, params_.people_timeout, now)) continue;
    const double age = std::max(0.0, now - sweep.at);
    for (Track person : sweep.people.tracks) {
      person.position += age * person.velocity;
      people.push_back(person);
    }
  }
  return people;
}

// Looks along the command and along the present motion, which differ while the base takes up the
// command. The last person counts until the way has been free for a while.
std::optional<std::int64_t> VelocityGuard::personInTheWay(double now) {
  const double wanted = std::min(speedOf(command_.velocity), vehicle_.max_speed);
  if (!(wanted > 0.0)) return std::nullopt;
  const std::vector<Track> people = peopleOf(now);
  const Pose pose = poseAt(now);
  const auto blocked = [&](const Point& velocity, double speed, double yaw_rate) {
    const double heading = pose.heading + std::atan2(velocity.y(), velocity.x());
    const bool is_car = vehicle_.kind == VehicleKind::kCar;
    const double curvature = is_car && speed > 0.0 ? yaw_rate / speed : 0.0;
    return path_.blockedBy({pose.position, heading, speed}, curvature, people);
  };
  std::optional<std::int64_t> person = blocked(command_.velocity, wanted, command_.yaw_rate);
  const double measured = speedOf(velocity_.velocity);
  if (!person && measured > kRestSpeed) {
    person = blocked(velocity_.velocity, measured, velocity_.yaw_rate);
  }
  if (person) {
    blocked_at_ = now;
    blocking_person_ = *person;
  }
  const bool holds = isRecent(blocked_at_, params_.hold_time, now);
  return holds ? std::optional<std::int64_t>(blocking_person_) : std::nullopt;
}

// Brakes along the command where there is one, else along what was put out last.
VelocityGuard::Output VelocityGuard::stopped(GuardCause cause, double now, double period) {
  const bool has_command = cause != GuardCause::kNoCommand && cause != GuardCause::kShutDown &&
                           cause != GuardCause::kCommandNotFinite;
  const double measured = hasMotion(now) ? speedOf(velocity_.velocity) : VelocityLimiter::kNoCap;
  const VelocityLimiter::Caps caps = limiter_.brakingCaps(period, measured);
  const bool had_nothing_to_stop =
      !has_command && isZero(command_) && is_command_finite_ && take_over_ != TakeOver::kBrakes;
  Output output;
  output.cause = had_nothing_to_stop ? GuardCause::kNone : cause;
  output.wanted_speed = has_command ? speedOf(command_.velocity) : 0.0;
  const BaseCommand braked = limiter_.limit(has_command ? command_ : limiter_.last(), caps, period);
  if (has_command || !isIdle(now)) output.command = braked;
  return output;
}

// A guard that was started anew beside a planner that is dead, or never was, finds a base that goes
// on by itself. True once, when braking begins: it begins with the measured velocity.
bool VelocityGuard::mustTakeOver(double now) {
  const bool is_late = take_over_ == TakeOver::kUndecided && now - first_tick_ > kTakeOverWindow;
  if (command_at_ >= 0.0 || is_late) take_over_ = TakeOver::kOver;
  if (take_over_ != TakeOver::kUndecided || !hasMotion(now)) return false;
  if (speedOf(velocity_.velocity) < kRestSpeed && std::abs(velocity_.yaw_rate) < kRestYawRate) {
    take_over_ = TakeOver::kOver;
    return false;
  }
  if (moving_since_ < 0.0) moving_since_ = now;
  if (now - moving_since_ <= params_.command_timeout) return false;
  take_over_ = TakeOver::kBrakes;
  return true;
}

// Zeros are sent until odometry shows rest, or for some time where it shows nothing.
bool VelocityGuard::isIdle(double now) {
  if (command_at_ < 0.0 && take_over_ != TakeOver::kBrakes) return true;
  if (!isZero(limiter_.last())) zero_since_ = -1.0;
  if (!isZero(limiter_.last())) return false;
  if (zero_since_ < 0.0) zero_since_ = now;
  const bool rests = hasMotion(now) && speedOf(velocity_.velocity) < kRestSpeed &&
                     std::abs(velocity_.yaw_rate) < kRestYawRate;
  const double patience = take_over_ == TakeOver::kBrakes ? kTakeOverPatience : kRestPatience;
  const bool is_idle = now - zero_since_ > (rests ? kRestTime : patience);
  if (is_idle) take_over_ = TakeOver::kOver;
  return is_idle;
}

}  // namespace pomdp_crowd_nav
