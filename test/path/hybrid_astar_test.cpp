// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/path/hybrid_astar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "naive_astar.h"
#include "pomdp_crowd_nav/prior/prior_factory.h"

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kDestinations{{0.0, 0.0}, {0.0, 30.0}, {40.0, 30.0}, {40.0, 0.0}};

StaticMap openMap() { return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, {}); }

StaticMap discMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 14.0}, 3.0}, {{30.0, 24.0}, 2.0}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

// A bay that opens toward the start, across the straight way.
StaticMap bayMap() {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{14.0, 22.0}, {24.0, 22.0}, {24.0, 8.0}, {14.0, 8.0}}, false}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

class Rig {
 public:
  Rig(StaticMap some_map, const Point& goal, HybridAstar::Params some_params = {})
      : map(std::move(some_map)),
        field(*makePrior(map.hasObstacles() ? "fast_marching" : "straight_line", map, goal,
                         prior(some_params)),
              map, 0.2),
        params(some_params),
        search(map, field, params) {}

  HybridAstar::Result find(const Pose& start, const std::vector<PersonBelief>& people = {},
                           const HybridAstar::Limit& limit = {}) {
    return search.find(start, people, kDestinations, limit);
  }

  StaticMap map;
  NavigationField field;
  HybridAstar::Params params;
  HybridAstar search;

 private:
  static PriorParams prior(const HybridAstar::Params& params) {
    PriorParams prior;
    prior.clearance = params.clearance;
    prior.extra_clearance = 0.0;
    return prior;
  }
};

HybridAstar::Params paramsOf(VehicleKind kind, double clearance = 1.5) {
  HybridAstar::Params params;
  params.vehicle = kind;
  params.clearance = clearance;
  return params;
}

std::vector<PersonBelief> somePeople(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<PersonBelief> people;
  for (int i = 0; i < count; ++i) {
    PersonBelief person{
        i, {40.0 * unit(random), 30.0 * unit(random)}, {0.0, 0.0}, 1.0, IntentionBelief(4)};
    const Point before = person.position - 0.5 * unitVector(2.0 * M_PI * unit(random));
    for (int k = 0; i % 2 == 0 && k < 12; ++k) {
      person.intention.update(before, person.position, kDestinations);
    }
    people.push_back(person);
  }
  return people;
}

class EveryVehicle : public testing::TestWithParam<VehicleKind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, EveryVehicle,
                         testing::Values(VehicleKind::kHolonomic, VehicleKind::kCar),
                         [](const auto& test) {
                           return test.param == VehicleKind::kCar ? "car" : "holonomic";
                         });

// The flat arrays, tables and early ends against std::map and every test in full.
TEST_P(EveryVehicle, FindsWhatANaiveSearchFinds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int found = 0;
  int starts_squeezed = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const StaticMap map = trial % 3 == 0 ? openMap() : (trial % 3 == 1 ? discMap() : bayMap());
    Rig rig(map, {36.3, 17.1}, paramsOf(GetParam()));
    const Pose start{{1.0 + 30.0 * unit(random), 1.0 + 28.0 * unit(random)},
                     2.0 * M_PI * unit(random)};
    const std::vector<PersonBelief> people = somePeople(random, trial % 7);
    const long limit = 2000;
    const HybridAstar::Result fast =
        rig.find(start, people, {HybridAstar::Clock::time_point::max(), limit});
    const NaiveAstar naive(rig.map, rig.field, rig.params, people, kDestinations);
    const NaiveAstar::Result slow = naive.find(start, limit);
    ASSERT_EQ(fast.outcome == HybridAstar::Outcome::kFound, slow.found) << trial;
    EXPECT_EQ(fast.expansions, slow.expansions) << trial;
    if (map.clearance(start.position) < rig.params.clearance) ++starts_squeezed;
    if (!slow.found) continue;
    ++found;
    EXPECT_NEAR(fast.cost, slow.cost, 1e-9) << trial;
    ASSERT_NEAR(fast.path.length(), static_cast<double>(slow.places.size() - 1), 1e-9);
    for (size_t i = 0; i < slow.places.size(); ++i) {
      EXPECT_LT((fast.path.positionAt(static_cast<double>(i)) - slow.places[i]).norm(), 1e-6);
    }
  }
  EXPECT_GE(found, 12);
  EXPECT_GE(starts_squeezed, 1);
}

TEST_P(EveryVehicle, PathsLeadFromThePoseToTheGoalAndKeepClear) {
  for (const StaticMap& map : {openMap(), discMap(), bayMap()}) {
    Rig rig(map, {36.3, 17.1}, paramsOf(GetParam()));
    for (const double heading : {0.3, 2.0, -2.9}) {
      const Pose start{{4.2, 14.7}, heading};
      const HybridAstar::Result result = rig.find(start);
      ASSERT_EQ(result.outcome, HybridAstar::Outcome::kFound);
      const Path& path = result.path;
      EXPECT_EQ(path.positionAt(0.0), start.position);
      EXPECT_LT((path.positionAt(path.length()) - Point(36.3, 17.1)).norm(), 1.0);
      for (double s = 1.0; s < path.length() + 0.1; s += 0.5) {
        EXPECT_GE(map.clearance(path.positionAt(s)), 1.5 - 1e-9);
        EXPECT_TRUE(map.bounds().contains(path.positionAt(s)));
      }
    }
  }
}

TEST_P(EveryVehicle, KeepsFromPeople) {
  Rig rig(openMap(), {36.3, 17.1}, paramsOf(GetParam()));
  std::mt19937 random(3);
  int found = 0;
  int kept_from = 0;  // whose cost is felt
  for (int trial = 0; trial < 10; ++trial) {
    const std::vector<PersonBelief> people = somePeople(random, 6);
    CrowdCost crowd(rig.params.crowd);
    crowd.predict({2.0, 14.0}, people, kDestinations, rig.map.bounds());
    const HybridAstar::Result result = rig.find({{2.0, 14.0}, 0.0}, people);
    if (result.outcome != HybridAstar::Outcome::kFound) continue;
    ++found;
    double cost = 0.0;
    double cost_alone = 0.0;
    for (int t = 1; t <= std::lround(result.path.length()); ++t) {
      const Point place = result.path.positionAt(t);
      const double people_cost = crowd.at(place.x(), place.y(), t);
      ASSERT_TRUE(std::isfinite(people_cost));
      cost += std::pow(0.99, t) * (1.0 + people_cost);
      cost_alone += std::pow(0.99, t);
    }
    EXPECT_NEAR(cost, result.cost, 1e-6);
    if (cost > cost_alone + 1.0) ++kept_from;
  }
  EXPECT_GE(found, 8);
  EXPECT_GE(kept_from, 6);
}

TEST(HybridAstar, ACarsPathHasNoCornersAndNoSharperTurnsThanItSteers) {
  Rig rig(discMap(), {36.3, 17.1}, paramsOf(VehicleKind::kCar));
  const HybridAstar::Result result = rig.find({{4.2, 14.7}, 3.0});
  ASSERT_EQ(result.outcome, HybridAstar::Outcome::kFound);
  double heading = 3.0;
  for (const PathLeg& leg : result.path.legs()) {
    EXPECT_NEAR(wrapAngle(leg.heading - heading), 0.0, 1e-9);
    EXPECT_LE(std::abs(leg.turn), M_PI / 4.0 + 1e-12);
    heading = leg.headingAt(leg.length);
  }
}

TEST(HybridAstar, ACarThatTurnsWideHasAPathThatDoes) {
  for (const double turn : {0.09, 0.2, 0.35}) {
    HybridAstar::Params params = paramsOf(VehicleKind::kCar);
    params.max_turn = turn;
    Rig rig(openMap(), {36.3, 17.1}, params);
    const HybridAstar::Result result = rig.find({{4.2, 14.7}, 0.6});
    ASSERT_EQ(result.outcome, HybridAstar::Outcome::kFound) << turn;
    double sharpest = 0.0;
    for (const PathLeg& leg : result.path.legs()) sharpest = std::max(sharpest, std::abs(leg.turn));
    EXPECT_LE(sharpest, turn);
    EXPECT_GT(sharpest, 0.0);
  }
}

TEST(HybridAstar, TheTurnOfACarIsThatOfItsTightestLimit) {
  VehicleParams car;
  car.kind = VehicleKind::kCar;
  car.max_speed = 4.0;
  car.max_yaw_rate = 3.2;
  EXPECT_NEAR(HybridAstar::maxTurn(car), std::tan(0.67), 1e-12);
  EXPECT_GE(HybridAstar::maxTurn(car), M_PI / 4.0) << "the paper's car";
  car.wheelbase = 2.0;
  EXPECT_NEAR(HybridAstar::maxTurn(car), std::tan(0.67) / 2.0, 1e-12);
  car.max_yaw_rate = 1.2;
  EXPECT_NEAR(HybridAstar::maxTurn(car), 0.3, 1e-12);
  car.lateral_acceleration = 1.6;
  EXPECT_NEAR(HybridAstar::maxTurn(car), 0.3, 1e-12) << "an instant base has any acceleration";
  car.instant_velocity = false;
  EXPECT_NEAR(HybridAstar::maxTurn(car), 0.1, 1e-12);
}

TEST(HybridAstar, IsNearlyStraightOnAnOpenField) {
  Rig rig(openMap(), {36.3, 17.1}, paramsOf(VehicleKind::kHolonomic));
  const HybridAstar::Result result = rig.find({{2.0, 5.0}, 0.0});
  EXPECT_LE(result.path.length(), 1.03 * std::hypot(34.3, 12.1) + 1.0);
  EXPECT_LT(result.expansions, 500);
}

TEST(HybridAstar, SaysWhyThereIsNoPath) {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{20.0, -1.0}, {20.0, 31.0}}, false}};
  Rig rig(StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles), {36.0, 15.0},
          paramsOf(VehicleKind::kHolonomic, 0.3));
  const HybridAstar::Result exhausted = rig.find({{4.0, 15.0}, 0.0});
  EXPECT_EQ(exhausted.outcome, HybridAstar::Outcome::kExhausted);
  EXPECT_GT(exhausted.expansions, 1000);
  const HybridAstar::Result limited =
      rig.find({{4.0, 15.0}, 0.0}, {}, {HybridAstar::Clock::time_point::max(), 100});
  EXPECT_EQ(limited.outcome, HybridAstar::Outcome::kTimedOut);
  EXPECT_EQ(limited.expansions, 100);
  const HybridAstar::Result late = rig.find(
      {{4.0, 15.0}, 0.0}, {}, {HybridAstar::Clock::now() - std::chrono::seconds(1), 1000000});
  EXPECT_EQ(late.outcome, HybridAstar::Outcome::kTimedOut);
  EXPECT_EQ(late.expansions, 0);
}

TEST(HybridAstar, LeadsOutOfAnObstacleAndBackOntoTheField) {
  Rig rig(discMap(), {36.3, 17.1}, paramsOf(VehicleKind::kHolonomic));
  for (const Point& place : {Point(20.5, 14.0), Point(20.0, 17.5), Point(-2.5, 5.0),
                             Point(0.0, 0.0), Point(40.0, 30.0), Point(41.5, 31.0)}) {
    const HybridAstar::Result result = rig.find({place, 2.0});
    ASSERT_EQ(result.outcome, HybridAstar::Outcome::kFound) << place.transpose();
    bool has_been_clear = false;
    for (int t = 0; t <= std::lround(result.path.length()); ++t) {
      const bool is_clear = rig.map.clearance(result.path.positionAt(t)) >= 1.5;
      EXPECT_TRUE(is_clear || !has_been_clear) << "leaves, and does not come back";
      has_been_clear = has_been_clear || is_clear;
    }
  }
}

TEST(HybridAstar, ReachesAGoalOnTheBorder) {
  for (const Point& goal : {Point(40.0, 15.0), Point(40.0, 30.0), Point(0.0, 12.0)}) {
    Rig rig(openMap(), goal, paramsOf(VehicleKind::kHolonomic));
    const HybridAstar::Result result = rig.find({{20.0, 15.0}, 0.4});
    ASSERT_EQ(result.outcome, HybridAstar::Outcome::kFound);
    for (int t = 0; t <= std::lround(result.path.length()); ++t) {
      EXPECT_TRUE(rig.map.bounds().contains(result.path.positionAt(t)));
    }
  }
}

TEST(HybridAstar, AtTheGoalThereIsNothingToDrive) {
  Rig rig(openMap(), {36.3, 17.1});
  const HybridAstar::Result result = rig.find({{36.0, 17.0}, 0.0});
  EXPECT_EQ(result.outcome, HybridAstar::Outcome::kFound);
  EXPECT_TRUE(result.path.isEmpty());
  EXPECT_EQ(result.expansions, 0);
}

TEST(HybridAstar, ASearchLeavesNoTraceInTheNext) {
  std::mt19937 random(5);
  Rig used(discMap(), {36.3, 17.1}, paramsOf(VehicleKind::kHolonomic));
  for (int i = 0; i < 5; ++i) {
    const std::vector<PersonBelief> people = somePeople(random, 6);
    Rig fresh(discMap(), {36.3, 17.1}, paramsOf(VehicleKind::kHolonomic));
    const HybridAstar::Result a = used.find({{3.0, 4.0 + i}, 0.1 * i}, people);
    const HybridAstar::Result b = fresh.find({{3.0, 4.0 + i}, 0.1 * i}, people);
    EXPECT_EQ(a.expansions, b.expansions);
    EXPECT_EQ(a.cost, b.cost);
  }
}

TEST(HybridAstar, NamesAParameterThatIsOutOfRange) {
  const auto messageFor = [](const HybridAstar::Params& params) -> std::string {
    try {
      validate(params);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(messageFor({}), "accepted");
  HybridAstar::Params params;
  params.cell = 0.0;
  EXPECT_EQ(messageFor(params), "path/cell must be positive, got 0");
  params = {};
  params.cost_discount = 1.1;
  EXPECT_EQ(messageFor(params), "path/cost_discount must be in (0, 1], got 1.1");
  params = {};
  params.crowd.field_radius = -1.0;
  EXPECT_EQ(messageFor(params), "path/field_radius must be at least 0, got -1");
}

}  // namespace
}  // namespace pomdp_crowd_nav
