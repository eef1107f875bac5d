// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/planner_builder.h"

#include <ros/console.h>

#include <chrono>
#include <exception>
#include <utility>

#include "pomdp_crowd_nav/evaluation/reachability.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {
namespace {

constexpr std::chrono::milliseconds kNap(5);  // how soon a new goal or map is noticed

}  // namespace

PlannerBuilder::PlannerBuilder(const PlannerNodeParams& params, Guarded<Drive>& drive,
                               MapWork& map_work, Failed failed)
    : params_(params),
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

std::optional<PlannerBuilder::Order> PlannerBuilder::nextOrder() {
  const auto order = drive_.with([](Drive& drive) {
    if (!drive.hasGoal() || !drive.inputs.map || !drive.inputs.robot) return std::optional<Order>();
    return std::optional<Order>({drive.goal, drive.inputs.map, drive.inputs.robot->pose.position});
  });
  if (!order || (order->goal.number == last_.goal.number && order->map == last_.map)) {
    return std::nullopt;
  }
  last_ = *order;
  return order;
}

bool PlannerBuilder::isNewest(const Order& order) const {
  return drive_.with([&](Drive& drive) {
    return drive.goal.number == order.goal.number && drive.inputs.map == order.map;
  });
}

// Leaves the planner to be taken, or says why there is none.
std::string PlannerBuilder::make(const Order& order) {
  const NavigationParams& navigation = params_.navigation;
  const Point& goal = order.goal.pose.position;
  try {
    std::string reason = whyNotAPlace(goal, *order.map, navigation.planning.model);
    if (!reason.empty()) return "failed: " + reason;
    const Task task{*order.map, goal, params_.destinations, nullptr, map_work_.of(order.map)};
    ReadyPlanner made{order.goal, order.map,
                      makePlanner(navigation.planner, task, navigation.planning)};
    reason = whyNoWay(made.planner->globalPath(order.robot), goal, *order.map, navigation);
    if (!reason.empty()) return reason;
    ready_.with([&](auto& ready) { ready = std::move(made); });
  } catch (const std::exception& error) {
    return std::string("failed: ") + error.what();
  }
  return "";
}

}  // namespace pomdp_crowd_nav
