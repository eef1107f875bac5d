// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/planner_builder.h"

#include <ros/console.h>

#include <chrono>
#include <exception>
#include <utility>

#include "pomdp_crowd_nav/evaluation/reachability.h"
#include "pomdp_crowd_nav/params/param_effects.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr std::chrono::milliseconds kNap(5);  // how soon a new goal or map is noticed

}  // namespace

PlannerBuilder::PlannerBuilder(std::vector<Point> destinations, Guarded<Drive>& drive,
                               MapWork& map_work, Failed failed)
    : destinations_(std::move(destinations)),
      drive_(drive),
      map_work_(map_work),
      failed_(std::move(failed)),
      ready_(std::nullopt),
      thread_([this] { run(); }) {}

PlannerBuilder::~PlannerBuilder() {
  stop_ = true;
  thread_.join();
}

std::optional<ReadyPlanner> PlannerBuilder::take() {
  return ready_.with([](auto& ready) { return std::exchange(ready, std::nullopt); });
}

void PlannerBuilder::run() {
  while (!stop_) {
    const std::optional<Order> order = nextOrder();
    if (!order) {
      std::this_thread::sleep_for(kNap);
      continue;
    }
    const std::string reason = make(*order);
    if (reason.empty() || !isNewest(*order)) continue;
    ROS_WARN("goal given up: %s", reason.c_str());
    failed_(order->goal, reason);
  }
}

// What is wanted at the moment; nothing without a goal or an input to plan with.
std::optional<PlannerBuilder::Order> PlannerBuilder::present() const {
  return drive_.with([](Drive& drive) {
    const Inputs& inputs = drive.inputs;
    if (!drive.hasGoal() || !inputs.map || !inputs.robot) return std::optional<Order>();
    return std::optional<Order>(
        {drive.goal, inputs.map, drive.params, inputs.robot->pose.position, false});
  });
}

std::optional<PlannerBuilder::Order> PlannerBuilder::nextOrder() {
  std::optional<Order> order = present();
  if (!order) return std::nullopt;
  const bool same_trip = order->isOfTrip(last_);
  if (same_trip && order->params == last_.params) return std::nullopt;
  const bool keeps_planner = same_trip && !concernsPlanner(*last_.params, *order->params);
  const bool keeps_tables = same_trip && !concernsTables(*last_.params, *order->params);
  if (!keeps_tables) tables_ = std::make_shared<SharedTables>();
  order->is_change = same_trip;
  last_ = *order;
  return keeps_planner ? std::nullopt : order;
}

bool PlannerBuilder::isNewest(const Order& order) const {
  const std::optional<Order> newest = present();
  return newest && newest->isOfTrip(order) && !concernsPlanner(*order.params, *newest->params);
}

// Leaves the planner to be taken, or says why there is none.
std::string PlannerBuilder::make(const Order& order) {
  const NavigationParams& params = *order.params;
  const Point& goal = order.goal.pose.position;
  const double begin = steadySeconds();
  try {
    std::string reason = whyNotAPlace(goal, *order.map, params.planning.model);
    if (!reason.empty()) return "failed: " + reason;
    const Task task{*order.map, goal, destinations_, tables_.get(), map_work_.of(order.map)};
    ReadyPlanner made{order.goal, order.map, makePlanner(params.planner, task, params.planning)};
    reason = whyNoWay(*made.planner, {order.robot, goal}, *order.map, params.planning.model);
    if (!reason.empty()) return reason;
    ready_.with([&](auto& ready) { ready = std::move(made); });
    ROS_INFO("planner %s %s after %.2f s", params.planner.c_str(),
             order.is_change ? "goes on with the new parameters" : "is ready",
             steadySeconds() - begin);
  } catch (const std::exception& error) {
    return std::string("failed: ") + error.what();
  }
  return "";
}

}  // namespace pomdp_crowd_nav
