// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/omniscient_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

namespace pomdp_crowd_nav {
namespace {

World field(double width, double height, const Point& start, const Point& goal) {
  World world;
  world.name = "field";
  world.bounds = {{0.0, 0.0}, {width, height}};
  world.start = {start, 0.0};
  world.goal = goal;
  world.destinations = {{0.0, 0.0}, {0.0, height}, {width, height}, {width, 0.0}};
  return world;
}

Simulator::Params crowdOf(int pedestrians, std::uint64_t seed) {
  Simulator::Params params;
  params.pedestrians = pedestrians;
  params.seed = seed;
  return params;
}

// Everybody at every tick, as an episode meets them.
class TrueCrowd {
 public:
  TrueCrowd(const World& world, const Simulator::Params& params, double duration) {
    Simulator simulator(world, params);
    record(simulator);
    for (double time = 0.0; time < duration; time += Crowd::kTick) {
      simulator.advance(Crowd::kTick);
      record(simulator);
    }
  }

  // To somebody who is where they are between two ticks [m].
  double nearest(const Point& place, double time) const {
    const auto tick = static_cast<size_t>(time / Crowd::kTick + 1e-9);
    const double share = time / Crowd::kTick - static_cast<double>(tick);
    double distance = std::numeric_limits<double>::infinity();
    for (const auto& [id, to] : ticks_.at(tick + 1)) {
      const auto from = ticks_[tick].find(id);
      const Point here =
          from == ticks_[tick].end() ? to : Point(from->second + share * (to - from->second));
      distance = std::min(distance, (here - place).norm());
    }
    return distance;
  }

 private:
  void record(const Simulator& simulator) {
    ticks_.emplace_back();
    for (const Walker& walker : simulator.crowd().walkers()) {
      ticks_.back()[walker.id] = walker.position;
    }
  }
  std::vector<std::map<std::int64_t, Point>> ticks_;
};

void expectDrivable(const OmniscientBound::Plan& plan, const World& world,
                    const OmniscientBound::Params& params, const TrueCrowd& crowd) {
  const StaticMap map = world.map();
  Point here = world.start.position;
  double ready = params.start_delay;
  for (const OmniscientBound::Leg& leg : plan.legs) {
    EXPECT_LT((leg.from - here).norm(), 1e-9);
    EXPECT_GE(leg.departure, ready - 1e-9);
    EXPECT_NEAR((leg.to - leg.from).norm(), params.max_speed * (leg.arrival - leg.departure), 1e-6);
    for (double time = leg.departure; time <= leg.arrival; time += 0.005) {
      const Point place =
          leg.from + (leg.to - leg.from) * ((time - leg.departure) / (leg.arrival - leg.departure));
      ASSERT_GE(crowd.nearest(place, time), params.person_distance - 1e-6) << time;
      ASSERT_GE(map.clearance(place), params.obstacle_clearance - 1e-3) << time;
      ASSERT_TRUE(world.bounds.contains(place));
    }
    here = leg.to;
    ready = leg.arrival;
  }
  EXPECT_DOUBLE_EQ(plan.arrival, ready);
  EXPECT_LE((here - world.goal).norm(), params.goal_tolerance);
}

// Arrival over the same lattice by correcting all labels until none changes, each way sampled
// finely and each departure put off from the earliest one. No heuristic, no order.
double bruteForceArrival(const World& world, const OmniscientBound::Params& params,
                         const TrueCrowd& crowd) {
  const Point start = world.start.position;
  const Point along = (world.goal - start).normalized();
  const Point across(-along.y(), along.x());
  const StaticMap map = world.map();
  const auto place = [&](int i, int j) {
    return Point(start + params.spacing * (i * along + j * across));
  };
  const auto isStaticallyClear = [&](const Point& from, const Point& to) {
    for (double share = 0.0; share <= 1.0; share += 0.01) {
      const Point here = from + share * (to - from);
      if (!world.bounds.contains(here) || map.clearance(here) < params.obstacle_clearance) {
        return false;
      }
    }
    return true;
  };
  const auto arrivalBy = [&](const Point& from, const Point& to, double ready) {
    const double duration = (to - from).norm() / params.max_speed;
    for (double departure = ready; departure < ready + 15.0; departure += params.wait) {
      bool is_clear = true;
      for (double time = 0.0; time < duration && is_clear; time += 0.002) {
        is_clear = crowd.nearest(from + time / duration * (to - from), departure + time) >=
                   params.person_distance - 1e-9;
      }
      if (is_clear) return departure + duration;
    }
    return std::numeric_limits<double>::infinity();
  };
  std::map<std::pair<int, int>, double> arrivals{{{0, 0}, params.start_delay}};
  double best = std::numeric_limits<double>::infinity();
  std::vector<std::pair<int, int>> changed{{0, 0}};
  while (!changed.empty()) {
    const auto [i, j] = changed.back();
    changed.pop_back();
    const Point here = place(i, j);
    const double ready = arrivals[{i, j}];
    const Point to_goal = world.goal - here;
    const Point end = world.goal - to_goal.normalized() * params.goal_tolerance;
    if (to_goal.norm() > params.goal_tolerance && isStaticallyClear(here, end)) {
      best = std::min(best, arrivalBy(here, end, ready));
    }
    for (int row = -params.reach; row <= params.reach; ++row) {
      for (int column = -params.reach; column <= params.reach; ++column) {
        if (std::gcd(row, column) != 1) continue;
        if (row * row + column * column > params.reach * params.reach) continue;
        const Point there = place(i + column, j + row);
        if (!isStaticallyClear(here, there)) continue;
        const double arrival = arrivalBy(here, there, ready);
        const std::pair<int, int> node(i + column, j + row);
        if (arrivals.count(node) > 0 && arrivals[node] <= arrival + 1e-9) continue;
        if (arrival >= best) continue;
        arrivals[node] = arrival;
        changed.push_back(node);
      }
    }
  }
  return best;
}

OmniscientBound::Params smallParams() {
  OmniscientBound::Params params;
  params.start_delay = 1.0;
  params.obstacle_clearance = 0.5;
  params.goal_tolerance = 0.5;
  params.spacing = 1.0;
  params.reach = 2;
  params.pull_straight = false;
  return params;
}

TEST(OmniscientBound, WithoutPeopleItIsTheBeeline) {
  const World world = field(100.0, 100.0, {1.0, 25.0}, {100.0, 75.0});
  const OmniscientBound bound(world, {});
  CrowdHistory nobody(world, crowdOf(0, 1));
  const auto plan = bound.plan(nobody);
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->arrival, 1.5 + (std::hypot(99.0, 50.0) - 1.0) / 2.0, 1e-6);
  EXPECT_NEAR(bound.beelineTime(), plan->arrival, 1e-6);
  EXPECT_NEAR(bound.emptyDriveTime(), plan->arrival, 1e-6);
}

TEST(OmniscientBound, GoesRoundAnObstacleOnTheShortestWay) {
  World world = field(40.0, 40.0, {5.0, 20.0}, {35.0, 20.0});
  world.obstacles.circles = {{{20.0, 20.0}, 3.0}};
  OmniscientBound::Params params;
  params.start_delay = 0.0;
  const OmniscientBound bound(world, params);
  CrowdHistory nobody(world, crowdOf(0, 1));
  const auto plan = bound.plan(nobody);
  ASSERT_TRUE(plan);
  // Two tangents to the circle of radius 6 m and the arc between them, to within 1 m of the goal.
  const double tangent = std::sqrt(15.0 * 15.0 - 36.0);
  const double length = 2.0 * tangent + 6.0 * (M_PI - 2.0 * std::acos(6.0 / 15.0)) - 1.0;
  EXPECT_GT(plan->arrival, length / 2.0 - 1e-3);
  EXPECT_LT(plan->arrival, length / 2.0 * 1.005);
  EXPECT_GE(plan->arrival, bound.beelineTime());
}

TEST(OmniscientBound, PlansCanBeDrivenAmongTheTruePeople) {
  for (const int pedestrians : {100, 400}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      World world = field(100.0, 100.0, {1.0, 25.0}, {100.0, 75.0});
      if (seed == 3) world.obstacles.circles = {{{50.0, 50.0}, 5.0}, {{70.0, 60.0}, 5.0}};
      OmniscientBound::Params params;
      const OmniscientBound bound(world, params);
      CrowdHistory people(world, crowdOf(pedestrians, seed));
      const auto plan = bound.plan(people);
      ASSERT_TRUE(plan);
      EXPECT_GE(plan->arrival, bound.beelineTime());
      EXPECT_LT(plan->arrival, bound.emptyDriveTime() + 2.0);
      expectDrivable(*plan, world, params, TrueCrowd(world, crowdOf(pedestrians, seed), 80.0));
    }
  }
}

TEST(OmniscientBound, PullingStraightMakesNoPlanLater) {
  const World world = field(60.0, 60.0, {1.0, 10.0}, {60.0, 40.0});
  OmniscientBound::Params params;
  params.pull_straight = false;
  const OmniscientBound crooked(world, params);
  params.pull_straight = true;
  const OmniscientBound straight(world, params);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CrowdHistory people(world, crowdOf(200, seed));
    EXPECT_LE(straight.plan(people)->arrival, crooked.plan(people)->arrival + 1e-9) << seed;
  }
}

TEST(OmniscientBound, IsWhatBruteForceFindsInSmallWorlds) {
  const OmniscientBound::Params params = smallParams();
  int delayed = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    World world = field(9.0, 6.0, {1.0, 2.5}, {8.0, 3.5});
    if (seed % 3 == 0) world.obstacles.circles = {{{4.5, 3.0}, 0.6}};
    const Simulator::Params crowd = crowdOf(4 + static_cast<int>(seed % 4), seed);
    const OmniscientBound bound(world, params);
    CrowdHistory people(world, crowd);
    const auto plan = bound.plan(people);
    ASSERT_TRUE(plan) << seed;
    const TrueCrowd truth(world, crowd, 80.0);
    const double brute_force = bruteForceArrival(world, params, truth);
    // Grazing past somebody may fall to one side or the other: it costs one putting off.
    EXPECT_NEAR(plan->arrival, brute_force, params.wait + 1e-6) << seed;
    expectDrivable(*plan, world, params, truth);
    if (plan->arrival > bound.emptyDriveTime() + 0.05) ++delayed;
  }
  EXPECT_GE(delayed, 3) << "people were in the way";
}

TEST(OmniscientBound, RefusesParametersOutOfRange) {
  const World world = field(10.0, 10.0, {1.0, 5.0}, {9.0, 5.0});
  OmniscientBound::Params params;
  params.spacing = 0.0;
  EXPECT_THROW(OmniscientBound(world, params), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
