// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/velocity_guard_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/message_gate.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kReportPeriod = 0.5;      // [s]
constexpr int kReportsPerDiagnostics = 2;  // 1 Hz
constexpr double kClockSlack = 0.1;        // [s], a system clock may be set back this much

// Of one topic messages may come in any order: several sensors may share it.
MessageFault faultOf(const std_msgs::Header& header, double now) {
  return faultOfStamp(header.stamp.toSec(), now, NewestStamp(), 0);
}

// Moment on the steady clock at which a message was measured; a stamp of the future is now. In
// seconds, as the difference of two ros::Time throws where it does not fit into a ros::Duration.
double measuredAt(const std_msgs::Header& header, double now) {
  return steadySeconds() - std::max(0.0, now - header.stamp.toSec());
}

bool isOfTransform(MessageFault fault) {
  return fault == MessageFault::kNoTransform || fault == MessageFault::kOldTransform ||
         fault == MessageFault::kBadTransform;
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
    : state_(State(VelocityGuard(params.guard, params.planning.model.vehicle))),
      frames_({"", params.transform_tolerance}),
      commands_(node.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
      statuses_(private_node.advertise<GuardStatus>("status", 10, true)),
      diagnostics_(node, private_node),
      command_spinner_(1, &command_queue_) {
  const VehicleParams& vehicle = params.planning.model.vehicle;
  braking_time_ = vehicle.instant_velocity ? 0.0 : vehicle.max_speed / vehicle.brake_deceleration;
  const auto hints = ros::TransportHints().tcpNoDelay();
  raw_commands_ = node.subscribe("cmd_vel_raw", 1, &VelocityGuardServer::onCommand, this, hints);
  odometry_ = node.subscribe("odom", 1, &VelocityGuardServer::onOdometry, this, hints);
  people_ = {node.subscribe<TrackedPersons>(
                 "tracked_persons", 1,
                 [this](const TrackedPersonsConstPtr& message) { onPeople(0, *message); },
                 ros::VoidConstPtr(), hints),
             node.subscribe<People>(
                 "people", 1, [this](const PeopleConstPtr& message) { onPeople(1, *message); },
                 ros::VoidConstPtr(), hints)};
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
  const double now = ros::Time::now().toSec();
  noticeClockJump(now);
  const MessageFault fault = faultOf(odometry.header, now);
  if (fault != MessageFault::kNone) return refuseOdometry(fault);
  takeOdometry(odometry, measuredAt(odometry.header, now));
}

void VelocityGuardServer::takeOdometry(const nav_msgs::Odometry& odometry, double measured_at) {
  const std::optional<Pose> pose = toPose(odometry.pose.pose);
  const std::optional<BaseCommand> velocity = toCommand(odometry.twist.twist);
  state_.with([&](State& state) {
    state.odom_frame = odometry.header.frame_id;
    if (pose && velocity) return state.guard.takeMotion(*pose, *velocity, measured_at);
    state.guard.noteBadOdometry(steadySeconds());
    state.odometry_fault = describe(MessageFault::kNotFinite);
    ++state.counts.bad_odometry;
  });
}

void VelocityGuardServer::refuseOdometry(MessageFault fault) {
  state_.with([&](State& state) {
    state.guard.noteBadOdometry(steadySeconds(), GuardCause::kOdometryRefused);
    state.odometry_fault = describe(fault);
    ++state.counts.bad_odometry;
  });
}

template <class Message>
void VelocityGuardServer::onPeople(size_t source, const Message& message) {
  const ros::Time ros_time = ros::Time::now();
  const double now = ros_time.toSec();
  noticeClockJump(now);
  const std_msgs::Header& header = message.header;
  const MessageFault fault = faultOf(header, now);
  if (fault != MessageFault::kNone) return refusePeople(source, header, fault);
  const std::string target = state_.with([](State& state) { return state.odom_frame; });
  if (target.empty()) return;  // there is no odometry to relate them to
  const ros::Time stamp = std::min(header.stamp, ros_time);  // a stamp of the future is now
  const FrameSource::Frame frame = frames_.frameIn(target, header.frame_id, stamp);
  if (frame.fault != MessageFault::kNone) return refusePeople(source, header, frame.fault);
  const TrackList people = toTracks(message, frame.pose);
  const bool are_nowhere = people.tracks.empty() && countPeople(message) > 0;
  if (are_nowhere) return refusePeople(source, header, MessageFault::kNotFinite);
  const double measured_at = measuredAt(header, now);
  state_.with([&](State& state) { state.guard.takePeople(people, measured_at, source); });
}

void VelocityGuardServer::refusePeople(size_t source, const std_msgs::Header& header,
                                       MessageFault fault) {
  const bool lacks_frame = isOfTransform(fault);
  state_.with([&](State& state) {
    state.guard.noteBadPeople(steadySeconds(),
                              lacks_frame ? GuardCause::kNoTransform : GuardCause::kPeopleRefused);
    const std::string detail =
        lacks_frame ? fmt::format("from '{}' to '{}'", header.frame_id, state.odom_frame)
                    : std::string(describe(fault));
    state.people_fault = fmt::format("{}: {}", people_[source].getTopic(), detail);
    ++(lacks_frame ? state.counts.transform_failures : state.counts.refused_people);
  });
}

void VelocityGuardServer::noticeClockJump(double now) {
  const bool jumped = state_.with([&](State& state) {
    const bool back = now + kClockSlack < state.last_time;
    state.last_time = back ? now : std::max(state.last_time, now);
    if (back) state.guard.noteClockJump(steadySeconds());
    return back;
  });
  if (!jumped) return;
  frames_.clear();
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
  if (++reports_ % kReportsPerDiagnostics != 0) return;
  try {
    diagnostics_.force_update();
  } catch (const std::exception& error) {  // it throws when ROS time is near its end
    ROS_WARN_THROTTLE(10.0, "diagnostics: %s", error.what());
  }
}

// With what is wrong with the messages where they are refused.
std::string VelocityGuardServer::causeOf(GuardCause cause, const State& state) {
  const bool is_odometry = cause == GuardCause::kOdometryRefused;
  const bool is_people = cause == GuardCause::kPeopleRefused || cause == GuardCause::kNoTransform;
  std::string text = describe(cause);
  if (is_odometry) text += ": " + state.odometry_fault;
  if (is_people) text += ": " + state.people_fault;
  return text;
}

GuardStatus VelocityGuardServer::status() {
  const double now = steadySeconds();
  GuardStatus status = state_.with([&](State& state) {
    GuardStatus result = state.counts;
    const VelocityGuard::Output& output = state.output;
    result.state = stateOf(output);
    result.stop_cause = causeOf(output.cause, state);
    result.people_fault = state.people_fault;
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
  out.add("odometry messages refused", now.bad_odometry);
  out.add("messages without transform", now.transform_failures);
  out.add("messages of people refused", now.refused_people);
  out.add("last fault of people", now.people_fault);
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
