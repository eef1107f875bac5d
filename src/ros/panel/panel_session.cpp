// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/panel_session.h"

#include <fmt/format.h>

#include <utility>

#include "pomdp_crowd_nav/ros/decision_schedule.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kPatience = 3.0;  // [s], for an answer of a node

CallResult sendGoal(RobotLink& link, const std::optional<geometry_msgs::PoseStamped>& goal) {
  if (!goal) return {false, "there is no goal yet: set one with '2D Nav Goal'"};
  if (!link.sendGoal(*goal)) return {false, "nobody takes goals"};
  const geometry_msgs::Point& place = goal->pose.position;
  return {true, fmt::format("goal ({:.1f}, {:.1f}) sent", place.x, place.y)};
}

}  // namespace

PanelSession::PanelSession(const PanelNames& names) : names_(names), connection_(names) { tick(); }

bool PanelSession::setNames(const PanelNames& names) {
  const std::string fault = faultOf(names);
  say({fault.empty(), fault});
  if (!fault.empty() || names == names_) return fault.empty();
  names_ = names;
  connection_.setNames(names);
  watch_ = PlannerWatch();
  cycles_ = CycleHistory();
  news_ = RobotNews();
  has_simulator_ = false;
  return true;
}

void PanelSession::tick() {
  now_ = steadySeconds();
  takeNews(now_);
  connection_.tick(now_, !watch_.isHeard(now_));
  if (const auto result = calls_.poll(now_)) say(*result);
}

void PanelSession::takeNews(double now) {
  const auto link = connection_.link();
  has_simulator_ = link && link->hasSimulator();
  watch_.setPublishers(link ? link->plannerPublishers() : 0);
  if (!link) return;
  RobotNews news = link->takeNews();
  for (const PlannerStatus& status : news.statuses) {
    if (watch_.hear(status, now)) cycles_.add(status.decisions, status.cycle_time);
  }
  // A link that was made anew may know less.
  if (!news.goal) news.goal = news_.goal;
  if (!news.planner) news.planner = news_.planner;
  if (!news.search_time) news.search_time = news_.search_time;
  news_ = std::move(news);
}

ControlInputs PanelSession::controlInputs() const {
  ControlInputs inputs;
  if (watch_.isHeard(now_)) inputs.state = watch_.status()->state;
  inputs.has_goal = news_.goal || has_simulator_;
  inputs.has_trip = news_.has_trip;
  inputs.has_simulator = has_simulator_;
  inputs.is_busy = calls_.isBusy();
  inputs.planner_node = names_.planner_node;
  inputs.sim_node = names_.sim_node;
  return inputs;
}

std::optional<double> PanelSession::deadline() const {
  const double frequency = connection_.facts().planner_frequency;
  if (!news_.search_time || !(frequency > 0.0)) return std::nullopt;
  const DecisionSchedule schedule(1.0 / frequency, *news_.search_time);
  return schedule.searchTime() + DecisionSchedule::kMargin;
}

PanelPicture PanelSession::picture() const {
  PanelPicture picture;
  picture.texts = watch_.texts(names_.planner_node, deadline(), now_);
  if (!watch_.isHeard(now_) && !connection_.hasMaster()) picture.texts.state = "no ROS master";
  picture.controls = controls();
  picture.planners = plannersFor(connection_.facts().vehicle);
  picture.planner = news_.planner.value_or("");
  picture.cycles = cycles_;
  picture.deadline = deadline();
  picture.message = said_.text;
  picture.is_complaint = !said_.is_done;
  picture.is_busy = calls_.isBusy();
  return picture;
}

// Where the planner has not been heard of any goal, it is the world's.
void PanelSession::start() {
  const PanelControls now = controls();
  const auto link = connection_.link();
  if (!now.start.is_enabled || !link) return;
  ask(names_.planner_node, [link, names = names_, goal = news_.goal,
                            is_resume = now.is_resume](InterruptibleCall& call) {
    const CallResult resumed = setPause(call, names, false);
    if (is_resume || !resumed.is_done) return resumed;
    const auto destination = goal ? goal : goalOfWorld(names);
    if (call.isInterrupted()) return CallResult{false, "given up"};
    const CallResult sent = sendGoal(*link, destination);
    if (call.isInterrupted())
      link->cancelGoals();  // a stop in between may have come before the goal
    return sent;
  });
}

void PanelSession::pause() {
  if (!controls().pause.is_enabled) return;
  ask(names_.planner_node,
      [names = names_](InterruptibleCall& call) { return setPause(call, names, true); });
}

// A start that still waits for an answer must not begin a trip later.
void PanelSession::stop() {
  if (!controls().stop.is_enabled) return;
  calls_.giveUp();
  const auto link = connection_.link();
  const bool is_heard = link && link->cancelGoals();
  say({is_heard, is_heard ? "stop sent" : "nobody takes a stop"});
}

void PanelSession::choosePlanner(const std::string& planner) {
  if (!controls().planner.is_enabled || planner == news_.planner) return;
  ask(names_.planner_node, [names = names_, planner](InterruptibleCall& call) {
    return pomdp_crowd_nav::choosePlanner(call, names, planner);
  });
}

void PanelSession::reset(const ResetRequest& request) {
  if (!controls().reset.is_enabled) return;
  ask(names_.sim_node, [names = names_, request](InterruptibleCall& call) {
    return resetSimulation(call, names, request);
  });
}

void PanelSession::ask(const std::string& whom,
                       std::function<CallResult(InterruptibleCall&)> work) {
  const auto call = std::make_shared<InterruptibleCall>();
  const bool is_asked = calls_.start(
      {whom, kPatience, [call, work] { return work(*call); }, [call] { call->interrupt(); }}, now_);
  say({is_asked, is_asked ? "asking " + whom + " ..." : "waiting for an answer"});
}

void PanelSession::say(const CallResult& result) { said_ = result; }

}  // namespace pomdp_crowd_nav
