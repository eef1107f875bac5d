// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/navigation_server.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "pomdp_crowd_nav/evaluation/reachability.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kReportPeriod = 0.5;      // [s], of the status
constexpr int kReportsPerDiagnostics = 2;  // 1 Hz
constexpr int kReportsBeforeWarning = 5;   // of the status: 2.5 s
constexpr int kReportsPerWarning = 20;     // 10 s
constexpr const char* kClosing = "the planner is being shut down";

Drive makeDrive(const NavigationParams& params) {
  Drive drive(MotionExecutor(params.command, params.planning.model.vehicle,
                             1.0 / params.controller_frequency),
              ProgressWatch(params.progress));
  drive.params = std::make_shared<const NavigationParams>(params);
  return drive;
}

}  // namespace

NavigationServer::NavigationServer(ros::NodeHandle node, ros::NodeHandle private_node,
                                   const PlannerNodeParams& params)
    : params_(params),
      drive_(makeDrive(params.navigation)),
      map_work_(params.navigation.planning.prior.resolution),
      command_loop_(params),
      inputs_(node, params, drive_),
      display_(private_node, params, drive_),
      status_(node, private_node, params.frames.base),
      commands_(node.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
      goals_(node,
             {[this](const auto& goal, std::string& why) { return checkGoal(goal, why); },
              [this](const Goal& goal) { startTrip(goal); },
              [this](long number) {
                drive_.with([&](Drive& drive) { cancelTrip(number, steadySeconds(), drive); });
              }}),
      pause_(private_node.advertiseService("pause", &NavigationServer::onPause, this)),
      make_plan_(private_node, params, drive_, map_work_,
                 [this](const auto& goal, std::string& why) { return checkGoal(goal, why); }),
      decisions_(
          params, drive_, map_work_,
          {[this](const auto& report, const Planner& planner) { reportDecision(report, planner); },
           [this](const Goal& goal, const std::string& why) { failTrip(goal, why); },
           [this](const Planner& planner) { display_.showPlanner(planner); }}),
      reconfiguration_(private_node, params.navigation,
                       [this](const NavigationParams& changed) { return adoptParams(changed); }),
      command_spinner_(1, &command_queue_) {
  command_timer_ = startTimer(node, 1.0 / params.navigation.controller_frequency, &command_queue_,
                              &NavigationServer::onCommandTimer);
  report_timer_ = startTimer(node, kReportPeriod, nullptr, &NavigationServer::onReportTimer);
  command_spinner_.start();
}

NavigationServer::~NavigationServer() {
  command_spinner_.stop();
  command_timer_.stop();
  report_timer_.stop();
}

ros::SteadyTimer NavigationServer::startTimer(ros::NodeHandle& node, double period,
                                              ros::CallbackQueue* queue,
                                              void (NavigationServer::*callback)()) {
  ros::SteadyTimerOptions options;
  options.period = ros::WallDuration(period);
  options.callback = [this, callback](const ros::SteadyTimerEvent&) { (this->*callback)(); };
  options.callback_queue = queue;
  return node.createSteadyTimer(options);
}

std::optional<Pose> NavigationServer::checkGoal(const geometry_msgs::PoseStamped& goal,
                                                std::string& reason) {
  if (drive_.with([](Drive& drive) { return drive.closing; })) {
    reason = kClosing;
    return std::nullopt;
  }
  const std::optional<Pose> local = toPose(goal.pose);
  if (!local) {
    reason = "goal is not finite or its orientation is no rotation";
    return std::nullopt;
  }
  const std::optional<Pose> frame = inputs_.frameAt(goal.header.frame_id, goal.header.stamp);
  if (!frame) {
    reason = fmt::format("no transform from the goal's frame '{}' to '{}'", goal.header.frame_id,
                         params_.frames.global);
    return std::nullopt;
  }
  const Pose pose = transformed(*frame, *local);
  const auto [map, params] =
      drive_.with([](Drive& drive) { return std::make_pair(drive.inputs.map, drive.params); });
  if (map) reason = whyNotAPlace(pose.position, *map, params->planning.model);
  return reason.empty() ? std::optional<Pose>(pose) : std::nullopt;
}

void NavigationServer::startTrip(const Goal& goal) {
  const double now = steadySeconds();
  const bool begins = drive_.with([&](Drive& drive) { return beginTrip(goal, now, drive); });
  if (!begins) return goals_.finish({goal, Outcome::kFailed, kClosing, now});
  display_.showGoal(goal);
  ROS_INFO("new goal (%.2f, %.2f)", goal.pose.position.x(), goal.pose.position.y());
}

void NavigationServer::failTrip(const Goal& goal, const std::string& reason) {
  drive_.with([&](Drive& drive) {
    if (drive.goal.number != goal.number) return;
    endTrip(Outcome::kFailed, reason, steadySeconds(), drive);
  });
}

std::string NavigationServer::adoptParams(const NavigationParams& params) {
  return drive_.with([&](Drive& drive) -> std::string {
    const bool is_idle = !drive.hasGoal() && !drive.ending;
    if (!is_idle && params.planner != drive.params->planner) {
      return "planner can be changed only while no trip is under way";
    }
    command_loop_.setParams(params);
    drive.params = std::make_shared<const NavigationParams>(params);
    return "";
  });
}

void NavigationServer::reportDecision(const DecisionReport& report, const Planner& planner) {
  publishStatus();
  geometry_msgs::PoseStamped robot;
  robot.header.frame_id = params_.frames.global;
  robot.header.stamp = ros::Time::now();
  robot.pose = toMessage(report.robot);
  goals_.publishFeedback(robot);
  display_.showDecision(report, planner);
}

void NavigationServer::onCommandTimer() {
  const double now = steadySeconds();
  std::uint8_t state = 0;
  const CommandLoop::Tick tick = drive_.with([&](Drive& drive) {
    const CommandLoop::Tick result = command_loop_.tick(now, drive);
    state = toStatus(drive, command_loop_.limits(), now).state;
    return result;
  });
  if (tick.command) commands_.publish(toMessage(*tick.command));
  is_active_ = tick.command.has_value();
  if (tick.finished) {
    ROS_INFO("trip is over: %s", tick.finished->text.c_str());
    goals_.finish(*tick.finished);
    display_.clearPlans();
  }
  if (state != last_state_) publishStatus();
  last_state_ = state;
}

void NavigationServer::onReportTimer() {
  warnOfMissingInput(publishStatus());
  ++reports_;
  if (reports_ % kReportsPerDiagnostics != 0) return;
  status_.publishDiagnostics(drive_.with([this](Drive& drive) {
    return inputHealth(drive.inputs, command_loop_.limits(), steadySeconds());
  }));
}

PlannerStatus NavigationServer::publishStatus() {
  const PlannerStatus status = drive_.with(
      [this](Drive& drive) { return toStatus(drive, command_loop_.limits(), steadySeconds()); });
  status_.publish(status);
  return status;
}

// Says in the log what ~status has said for a while.
void NavigationServer::warnOfMissingInput(const PlannerStatus& status) {
  const bool is_waiting = status.state == PlannerStatus::WAITING_FOR_INPUT;
  reports_without_input_ = is_waiting ? reports_without_input_ + 1 : 0;
  if (reports_without_input_ % kReportsPerWarning != kReportsBeforeWarning) return;
  ROS_WARN("waiting for input: %s", status.stop_cause.c_str());
}

bool NavigationServer::onPause(PauseService::Request& request, PauseService::Response& response) {
  drive_.with([&](Drive& drive) { drive.paused = request.data; });
  response.success = true;
  response.message = request.data ? "paused" : "resumed";
  return true;
}

void NavigationServer::stopBase() {
  constexpr double kSlack = 1.0;  // [s]
  const VehicleParams& vehicle = params_.navigation.planning.model.vehicle;
  drive_.with([](Drive& drive) {
    drive.closing = true;
    cancelTrip(steadySeconds(), drive);
  });
  const double braking_time =
      vehicle.instant_velocity ? 0.0 : vehicle.max_speed / vehicle.brake_deceleration;
  const double give_up = steadySeconds() + braking_time + kSlack;
  while (is_active_ && steadySeconds() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  command_spinner_.stop();
  command_timer_.stop();
  commands_.publish(geometry_msgs::Twist());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // it is sent by another thread
}

}  // namespace pomdp_crowd_nav
