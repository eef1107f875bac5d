// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/velocity_guard_server.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kReportPeriod = 0.5;      // [s]
constexpr int kReportsPerDiagnostics = 2;  // 1 Hz
constexpr double kClockSlack = 0.1;        // [s], a system clock may be set back this much

// Moment on the steady clock at which a message was measured; a stamp of the future is now.
double measuredAt(const ros::Time& stamp, const ros::Time& now) {
  return steadySeconds() - std::max(0.0, (now - stamp).toSec());
}

std::uint8_t stateOf(const VelocityGuard::Output& output) {
  if (!output.command) return GuardStatus::IDLE;
  if (output.cause != GuardCause::kNone) return GuardStatus::STOPPING;
  return output.is_limited ? GuardStatus::LIMITING : GuardStatus::FORWARDING;
}

const char* nameOf(std::uint8_t state) {
  constexpr const char* kNames[] = {"IDLE", "FORWARDING", "LIMITING", "STOPPING"};
  return kNames[state];
}

ros::SteadyTimer startTimer(ros::NodeHandle& node, double period, ros::CallbackQueue* queue,
                            const ros::SteadyTimerCallback& callback) {
  ros::SteadyTimerOptions options;
  options.period = ros::WallDuration(period);
  options.callback = callback;
  options.callback_queue = queue;
  return node.createSteadyTimer(options);
}

}  // namespace

NavigationParams loadGuardNodeParams(ParamReader& reader) {
  const NavigationParams params = loadNavigationParams(reader);
  loadSimulatorParams(reader, params.planning.model.vehicle);  // a profile serves every node
  reader.requireAllUsed();
  return params;
}

VelocityGuardServer::VelocityGuardServer(ros::NodeHandle node, ros::NodeHandle private_node,
                                         const NavigationParams& params)
    : tolerance_(params.transform_tolerance),
      state_(State(VelocityGuard(params.guard, params.planning.model.vehicle))),
      transforms_(buffer_),
      commands_(node.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
      statuses_(private_node.advertise<GuardStatus>("status", 10, true)),
      diagnostics_(node, private_node),
      command_spinner_(1, &command_queue_) {
  const VehicleParams& vehicle = params.planning.model.vehicle;
  braking_time_ = vehicle.instant_velocity ? 0.0 : vehicle.max_speed / vehicle.brake_deceleration;
  const auto hints = ros::TransportHints().tcpNoDelay();
  raw_commands_ = node.subscribe("cmd_vel_raw", 1, &VelocityGuardServer::onCommand, this, hints);
  odometry_ = node.subscribe("odom", 1, &VelocityGuardServer::onOdometry, this, hints);
  persons_ = node.subscribe("tracked_persons", 1, &VelocityGuardServer::onPersons, this, hints);
  diagnostics_.setHardwareID("none");
  diagnostics_.add("velocity guard", this, &VelocityGuardServer::diagnose);
  command_timer_ = startTimer(node, 1.0 / params.guard.frequency, &command_queue_,
                              [this](const ros::SteadyTimerEvent&) { onCommandTimer(); });
  report_timer_ = startTimer(node, kReportPeriod, nullptr,
                             [this](const ros::SteadyTimerEvent&) { onReportTimer(); });
  command_spinner_.start();
}

VelocityGuardServer::~VelocityGuardServer() {
  command_spinner_.stop();
  command_timer_.stop();
  report_timer_.stop();
}

void VelocityGuardServer::onCommand(const geometry_msgs::Twist& twist) {
  const std::optional<BaseCommand> command = toCommand(twist);
  const double nan = std::nan("");
  state_.with([&](State& state) {
    state.guard.takeCommand(command.value_or(BaseCommand{Point(nan, nan), nan}), steadySeconds());
    if (!command) ++state.counts.bad_commands;
  });
}

void VelocityGuardServer::onOdometry(const nav_msgs::Odometry& odometry) {
  const ros::Time now = ros::Time::now();
  noticeClockJump(now);
  const std::optional<Pose> pose = toPose(odometry.pose.pose);
  const std::optional<BaseCommand> velocity = toCommand(odometry.twist.twist);
  const double measured_at = measuredAt(odometry.header.stamp, now);
  state_.with([&](State& state) {
    state.odom_frame = odometry.header.frame_id;
    if (pose && velocity) return state.guard.takeMotion(*pose, *velocity, measured_at);
    state.guard.noteBadOdometry(steadySeconds());
    ++state.counts.bad_odometry;
  });
}

void VelocityGuardServer::onPersons(const TrackedPersons& persons) {
  const ros::Time now = ros::Time::now();
  noticeClockJump(now);
  const double measured_at = measuredAt(persons.header.stamp, now);
  const std::string target = state_.with([](State& state) { return state.odom_frame; });
  if (target.empty()) return;  // there is no odometry to relate them to
  const std::optional<Pose> frame = frameOf(persons.header, target);
  const TrackList people = frame ? toTracks(persons, *frame) : TrackList();
  const bool are_nowhere = frame && people.tracks.empty() && !persons.tracks.empty();
  if (are_nowhere) return;  // somebody is there, and nobody knows where
  state_.with([&](State& state) {
    if (frame) return state.guard.takePeople(people, measured_at);
    state.guard.noteMissingTransform(steadySeconds());
    ++state.counts.transform_failures;
  });
  if (frame) return;
  ROS_WARN_THROTTLE(5.0, "no transform from '%s' to '%s'", persons.header.frame_id.c_str(),
                    target.c_str());
}

// At the message's stamp, else the newest one if it is not older than the tolerance.
std::optional<Pose> VelocityGuardServer::frameOf(const std_msgs::Header& header,
                                                 const std::string& target) const {
  if (header.frame_id == target) return Pose{};
  try {
    std::string error;
    if (buffer_.canTransform(target, header.frame_id, header.stamp, &error)) {
      return toPose(buffer_.lookupTransform(target, header.frame_id, header.stamp).transform);
    }
    const auto newest = buffer_.lookupTransform(target, header.frame_id, ros::Time(0));
    if (header.stamp - newest.header.stamp > tolerance_) return std::nullopt;
    return toPose(newest.transform);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

void VelocityGuardServer::noticeClockJump(const ros::Time& now) {
  const bool jumped = state_.with([&](State& state) {
    const bool back = now + ros::Duration(kClockSlack) < state.last_time;
    state.last_time = back ? now : std::max(state.last_time, now);
    if (back) state.guard.noteClockJump(steadySeconds());
    return back;
  });
  if (!jumped) return;
  buffer_.clear();
  ROS_WARN("the clock jumped back: the base is braked until inputs are fresh");
}

void VelocityGuardServer::onCommandTimer() {
  const VelocityGuard::Output output = state_.with([](State& state) {
    const bool stopped_before = stateOf(state.output) == GuardStatus::STOPPING;
    state.output = state.guard.tick(steadySeconds());
    if (stateOf(state.output) == GuardStatus::STOPPING && !stopped_before) ++state.counts.stops;
    return state.output;
  });
  if (output.command) commands_.publish(toMessage(*output.command));
  is_sending_ = output.command.has_value();
  const bool is_new = output.cause != last_cause_ || stateOf(output) != last_state_;
  if (is_new) statuses_.publish(status());
  if (output.cause != last_cause_ && output.cause != GuardCause::kNone) {
    ROS_WARN_THROTTLE(1.0, "the base is braked: %s", describe(output.cause));
  }
  last_cause_ = output.cause;
  last_state_ = stateOf(output);
}

void VelocityGuardServer::onReportTimer() {
  statuses_.publish(status());
  if (++reports_ % kReportsPerDiagnostics == 0) diagnostics_.force_update();
}

GuardStatus VelocityGuardServer::status() {
  const double now = steadySeconds();
  GuardStatus status = state_.with([&](State& state) {
    GuardStatus result = state.counts;
    const VelocityGuard::Output& output = state.output;
    result.state = stateOf(output);
    result.stop_cause = describe(output.cause);
    result.blocking_person = output.person;
    result.command_age = state.guard.commandAge(now);
    result.odom_age = state.guard.odometryAge(now);
    result.people_age = state.guard.peopleAge(now);
    result.wanted_speed = output.wanted_speed;
    result.speed = output.command ? output.command->velocity.norm() : 0.0;
    return result;
  });
  status.header.stamp = ros::Time::now();
  status.state_name = nameOf(status.state);
  return status;
}

void VelocityGuardServer::diagnose(diagnostic_updater::DiagnosticStatusWrapper& out) {
  using diagnostic_msgs::DiagnosticStatus;
  const GuardStatus now = status();
  const bool is_alarmed = !now.stop_cause.empty();
  out.summary(is_alarmed ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
              is_alarmed ? now.state_name + ": " + now.stop_cause : now.state_name);
  out.add("command age [s]", now.command_age);
  out.add("odometry age [s]", now.odom_age);
  out.add("people age [s]", now.people_age);
  out.add("blocking person", now.blocking_person);
  out.add("stops", now.stops);
  out.add("commands not finite", now.bad_commands);
  out.add("odometry messages not finite", now.bad_odometry);
  out.add("messages without transform", now.transform_failures);
}

void VelocityGuardServer::stopBase() {
  constexpr double kSlack = 1.0;  // [s]
  const bool was_sending = is_sending_;
  state_.with([](State& state) { state.guard.shutDown(); });
  const double give_up = steadySeconds() + braking_time_ + kSlack;
  while (is_sending_ && steadySeconds() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  command_spinner_.stop();
  command_timer_.stop();
  if (!was_sending) return;
  commands_.publish(geometry_msgs::Twist());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // it is sent by another thread
}

}  // namespace pomdp_crowd_nav
