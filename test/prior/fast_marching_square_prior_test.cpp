// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/fast_marching_square_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

const Point kGoal(55.0, 20.0);

// A disc in the straight way.
StaticMap discMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{30.0, 20.0}, 4.0}};
  return StaticMap({{0.0, 0.0}, {60.0, 40.0}}, obstacles);
}

PriorParams testParams() {
  PriorParams params;
  params.clearance = 2.0;
  params.extra_clearance = 0.5;
  params.saturation_distance = 8.0;
  return params;
}

float speedAt(const SpeedMap& map, const Point& place) {
  return map.speed[map.grid.index(map.grid.columnOf(place), map.grid.rowOf(place))];
}

struct Way {
  double least_clearance = std::numeric_limits<double>::infinity();  // [m]
  double sharpest_bend = 0.0;                                        // [rad/m]
};

Way follow(const RolloutPrior& prior, const StaticMap& map, Point place) {
  constexpr double kStride = 0.1;  // [m]
  constexpr int kStrides = 10;     // over which a bend is measured
  Way way;
  std::vector<double> headings;
  while ((place - prior.goal()).norm() > 1.0 && headings.size() < 2000) {
    headings.push_back(*prior.directionAt({place, 0.0}));
    place += kStride * unitVector(headings.back());
    way.least_clearance = std::min(way.least_clearance, map.clearance(place));
  }
  for (size_t i = kStrides; i < headings.size(); ++i) {
    const double turn = std::abs(wrapAngle(headings[i] - headings[i - kStrides]));
    way.sharpest_bend = std::max(way.sharpest_bend, turn / (kStrides * kStride));
  }
  return way;
}

ClearanceGrid sampled(const StaticMap& map) { return {map, testParams().resolution}; }

TEST(FastMarchingSquare, TheFrontIsFasterFartherFromObstacles) {
  const SpeedMap map = makeSquareSpeedMap(sampled(discMap()), kGoal, testParams());
  const double cell = testParams().resolution;
  EXPECT_NEAR(speedAt(map, {30.0, 27.0}), 3.0 / 8.0, cell / 8.0);  // 3 m off
  EXPECT_NEAR(speedAt(map, {30.0, 30.0}), 6.0 / 8.0, cell / 8.0);
  EXPECT_EQ(speedAt(map, {30.0, 33.0}), 1.0F) << "beyond the saturation distance";
  EXPECT_EQ(speedAt(map, {30.0, 25.0}), 0.1F) << "inside the clearance, with room for the robot";
  EXPECT_EQ(speedAt(map, {30.0, 21.0}), 0.001F) << "inside the obstacle";
}

TEST(FastMarchingSquare, PathsSwingWiderAndBendLess) {
  const StaticMap map = discMap();
  const Way shortest = follow(FastMarchingPrior(map, kGoal, testParams()), map, {5.0, 20.5});
  const Way square =
      follow(*makeFastMarchingSquare(sampled(map), kGoal, testParams()), map, {5.0, 20.5});
  EXPECT_LT(shortest.least_clearance, 2.8);
  EXPECT_GT(square.least_clearance, shortest.least_clearance + 2.0);
  EXPECT_LT(square.sharpest_bend, shortest.sharpest_bend);
}

TEST(FastMarchingSquare, IsFastMarchingOnAnEmptyMap) {
  const StaticMap map({{0.0, 0.0}, {60.0, 40.0}}, {});
  const FastMarchingPrior shortest(map, kGoal, testParams());
  const auto square = makeFastMarchingSquare(sampled(map), kGoal, testParams());
  for (double x = 1.0; x < 60.0; x += 7.0) {
    for (double y = 1.0; y < 40.0; y += 6.5) {
      EXPECT_EQ(square->directionAt({{x, y}, 0.0}), shortest.directionAt({{x, y}, 0.0}));
    }
  }
}

TEST(FastMarchingSquare, RejectsASaturationDistanceThatIsNotPositive) {
  PriorParams params = testParams();
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    params.saturation_distance = bad;
    EXPECT_THROW(makeFastMarchingSquare(sampled(discMap()), kGoal, params), std::invalid_argument);
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
