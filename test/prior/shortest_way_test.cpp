// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/shortest_way.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <random>
#include <stdexcept>
#include <vector>

#include "pomdp_crowd_nav/prior/navigation_field.h"
#include "pomdp_crowd_nav/prior/quad.h"
#include "pomdp_crowd_nav/prior/straight_line_prior.h"

namespace pomdp_crowd_nav {
namespace {

// A map with its tables.
struct Ways {
  Ways(const StaticMap& some_map, const Point& goal, const ShortestWay::Params& some_params,
       double cell = 0.2)
      : map(some_map),
        params(some_params),
        field(StraightLinePrior(goal), map, cell),
        table(ClearanceGrid(map, cell), goal, params) {}

  double from(const Point& p) const {
    return table.lengthFrom(static_cast<float>(p.x()), static_cast<float>(p.y()));
  }
  double straightFrom(const Point& p) const {
    return (p - field.goal()).norm() - params.goal_tolerance;
  }
  // What the cell of a place says, which decides where a robot may be.
  bool isClear(const Point& p) const {
    return field.at(static_cast<float>(p.x()), static_cast<float>(p.y())).clearance >
           params.clearance;
  }

  StaticMap map;
  ShortestWay::Params params;
  NavigationField field;
  ShortestWay table;
};

const Bounds kField{{0.0, 0.0}, {50.0, 40.0}};
const ShortestWay::Params kSmall{0.9, 0.75, 0.5};  // a ramped base of 1.5 m/s and 0.5 s steps
const ShortestWay::Params kPaper{3.0, 2.0, 1.0};

StaticMap walledMap() {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{25.0, 0.0}, {25.0, 25.0}}, false}};
  return StaticMap(kField, obstacles);
}

StaticMap crowdedMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{10.0, 10.0}, 3.0}, {{14.0, 30.0}, 2.0}, {{34.0, 31.0}, 4.0}};
  obstacles.polygons = {{{{20.0, 12.0}, {26.0, 9.0}, {29.0, 15.0}, {23.0, 18.0}}, true},
                        {{{35.0, 0.0}, {38.0, 17.0}}, false}};
  return StaticMap(kField, obstacles);
}

// Round the end of the wall of walledMap() at `clearance`: tangents and an arc.
double detour(const Point& from, const Point& to, double clearance) {
  const Point end(25.0, 25.0);
  double length = 0.0;
  double arc = 0.0;
  for (const Point& place : {from, to}) {
    const double distance = (place - end).norm();
    length += std::sqrt(distance * distance - clearance * clearance);
    arc += M_PI - std::asin(std::abs(place.x() - end.x()) / distance);  // from straight up
    arc -= std::acos(clearance / distance);
  }
  return length + clearance * arc;
}

TEST(ShortestWayTest, KnowsTheDetourRoundAWall) {
  const Point goal(45.0, 5.0);
  for (const double cell : {0.1, 0.2}) {
    for (const ShortestWay::Params& params : {kSmall, kPaper}) {
      const Ways ways(walledMap(), goal, params, cell);
      for (const Point& from : {Point(5.0, 5.0), Point(15.0, 20.0), Point(21.5, 1.0)}) {
        const double length = detour(from, goal, params.clearance) - params.goal_tolerance;
        EXPECT_LE(ways.from(from), length);
        EXPECT_GE(ways.from(from), 0.96 * length) << "cell " << cell << ", from " << from;
        EXPECT_GT(ways.from(from), ways.straightFrom(from) + 5.0);
      }
    }
  }
}

// --- Against shortest paths in a graph of places that see each other ----------------------------

// Paths that stay `clearance` away from the obstacles of crowdedMap().
class VisibilityGraph {
 public:
  VisibilityGraph(const StaticMap& map, double clearance, const Point& goal)
      : map_(map), clearance_(clearance), places_{goal} {
    for (const Circle& circle : map.obstacles().circles) addRing(circle.center, circle.radius);
    for (const Polygon& polygon : map.obstacles().polygons) {
      for (const Point& vertex : polygon.vertices) addRing(vertex, 0.0);
    }
    findShortest();
  }

  double lengthFrom(const Point& from) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < places_.size(); ++i) {
      const double length = (places_[i] - from).norm() + lengths_[i];
      if (length < shortest && see(from, places_[i])) shortest = length;
    }
    return shortest;
  }

 private:
  // Corners of a polygon around the circle of places that keep the clearance.
  void addRing(const Point& center, double radius) {
    constexpr int kCorners = 60;
    const double out = (radius + clearance_) / std::cos(M_PI / kCorners) + 1e-6;
    for (int i = 0; i < kCorners; ++i) {
      const Point place = center + out * unitVector(2.0 * M_PI * i / kCorners);
      if (map_.bounds().contains(place) && map_.clearance(place) >= clearance_) {
        places_.push_back(place);
      }
    }
  }

  // Clearance changes by no more than the way.
  bool see(const Point& from, const Point& to) const {
    const double length = (to - from).norm();
    for (double way = 0.0; way < length;) {
      const double room = map_.clearance(from + way / length * (to - from)) - clearance_;
      if (room < 0.0) return false;
      way += std::max(room, 1e-2);
    }
    return true;
  }

  void findShortest() {
    lengths_.assign(places_.size(), std::numeric_limits<double>::infinity());
    std::priority_queue<std::pair<double, size_t>> queue;  // negative lengths
    lengths_[0] = 0.0;
    queue.push({0.0, 0});
    while (!queue.empty()) {
      const auto [length, here] = queue.top();
      queue.pop();
      if (-length > lengths_[here]) continue;
      for (size_t i = 0; i < places_.size(); ++i) {
        const double found = lengths_[here] + (places_[i] - places_[here]).norm();
        if (found >= lengths_[i] || !see(places_[here], places_[i])) continue;
        lengths_[i] = found;
        queue.push({-found, i});
      }
    }
  }

  const StaticMap& map_;
  double clearance_;
  std::vector<Point> places_;
  std::vector<double> lengths_;
};

Point anywhere(std::mt19937_64& random) {
  std::uniform_real_distribution<double> x(kField.min.x(), kField.max.x());
  std::uniform_real_distribution<double> y(kField.min.y(), kField.max.y());
  const double first = x(random);
  return {first, y(random)};
}

TEST(ShortestWayTest, IsNoLongerThanShortestPathsInAVisibilityGraphAndNotMuchShorter) {
  const Point goal(47.0, 4.0);
  const Ways ways(crowdedMap(), goal, {1.2, 0.75, 0.5});
  const VisibilityGraph graph(ways.map, 1.2, goal);
  std::mt19937_64 random(1);
  double ratios = 0.0;
  int count = 0;
  int detours = 0;
  while (count < 600) {
    const Point from = anywhere(random);
    if (ways.map.clearance(from) < 1.4) continue;
    const double length = graph.lengthFrom(from) - 0.5;
    const double bound = std::max(ways.from(from), ways.straightFrom(from));
    ASSERT_LE(bound, length + 1e-3) << from;
    detours += length > 1.1 * ways.straightFrom(from) ? 1 : 0;
    if (length > 2.0) {
      EXPECT_GE(bound, 0.93 * length) << from;
    }
    ratios += bound / length;
    ++count;
  }
  EXPECT_GT(detours, 100);
  EXPECT_GE(ratios / count, 0.98);
}

// --- The certificate ----------------------------------------------------------------------------

// Whoever drives a bit is closer by no more than that bit: the table over places that see each
// other at the clearance C.
TEST(ShortestWayTest, ChangesByNoMoreThanTheWay) {
  const Ways ways(crowdedMap(), {47.0, 4.0}, {1.2, 0.75, 0.5});
  EXPECT_GE(ways.table.slope(), 1.0);
  EXPECT_LE(ways.table.slope(), 1.001);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double steepest = 0.0;
  for (int pairs = 0; pairs < 200000;) {
    const Point from = anywhere(random);
    const Point to = from + (1e-3 + 0.5 * unit(random)) * unitVector(2.0 * M_PI * unit(random));
    if (!kField.contains(to) || ways.map.clearance(from) < 1.6) continue;
    if (ways.map.clearance(to) < 1.4) continue;  // the way keeps 1.2 m, and so do its cells
    ++pairs;
    const double way = (to - from).norm();
    const double change = std::abs(ways.from(to) - ways.from(from));
    ASSERT_LE(change, way + 1e-4) << from << " to " << to;
    if (way > 0.2) steepest = std::max(steepest, change / way);
  }
  EXPECT_GT(steepest, 0.99) << "else the test has not seen the table";
}

// The surface in which a table is read: two planes that meet in a fold.
TEST(ShortestWayTest, AQuadBendsAlongItsFlatterDiagonal) {
  const float fold[] = {0.0F, 0.0F, 0.0F, 1.0F};  // of min(x, y)
  const Quad quad(fold, 2);
  EXPECT_FLOAT_EQ(quad.slopeSq(), 1.0F) << "bilinear: 2 at the corner";
  EXPECT_FLOAT_EQ(quad.at(0.5F, 0.5F), 0.5F);
  EXPECT_FLOAT_EQ(quad.at(0.75F, 0.25F), 0.25F);
  EXPECT_FLOAT_EQ(quad.at(1.0F, 1.0F), 1.0F);
  const float mirrored[] = {0.0F, 0.0F, 1.0F, 0.0F};  // of min(1 - x, y)
  EXPECT_FLOAT_EQ(Quad(mirrored, 2).slopeSq(), 1.0F);
  EXPECT_FLOAT_EQ(Quad(mirrored, 2).at(0.5F, 0.5F), 0.5F);
  EXPECT_FLOAT_EQ(Quad(mirrored, 2).at(0.5F, 0.75F), 0.5F);
  const float plane[] = {1.0F, 1.5F, 0.0F, 0.5F};
  EXPECT_FLOAT_EQ(Quad(plane, 2).slopeSq(), 1.25F);
  EXPECT_FLOAT_EQ(Quad(plane, 2).at(0.3F, 0.6F), 1.0F + 0.15F - 0.6F);
}

TEST(ShortestWayTest, IsNothingWithinTheGoalTolerance) {
  const Point goals[] = {{30.0, 5.0}, {50.0, 40.0}, {25.6, 12.0}};
  for (const Point& goal : goals) {  // in the open, in a corner, by the wall
    const Ways ways(walledMap(), goal, kSmall);
    std::mt19937_64 random(3);
    int clear = 0;
    for (int i = 0; i < 20000; ++i) {
      std::uniform_real_distribution<double> unit(0.0, 1.0);
      const double radius = 0.5 * std::sqrt(unit(random));
      const Point place = goal + radius * unitVector(2.0 * M_PI * unit(random));
      if (!kField.contains(place)) continue;
      clear += ways.isClear(place) ? 1 : 0;
      ASSERT_LE(ways.from(place), 0.0) << place;
    }
    EXPECT_GT(clear, 100) << goal;
    const double open = ways.from({goal.x(), 30.0});
    EXPECT_GT(open, 0.97 * ways.straightFrom({goal.x(), 30.0}) - 0.1) << goal;
  }
}

// --- Where nothing is known ---------------------------------------------------------------------

TEST(ShortestWayTest, SaysNothingInsideTheMargin) {
  const Ways ways(walledMap(), {45.0, 5.0}, kSmall);
  EXPECT_EQ(ways.from({24.5, 10.0}), 0.0);
  EXPECT_EQ(ways.from({25.1, 10.0}), 0.0);
  EXPECT_GT(ways.from({23.9, 10.0}), 30.0);
  EXPECT_NEAR(ways.from({26.1, 10.0}), ways.straightFrom({26.1, 10.0}), 0.6);
}

TEST(ShortestWayTest, SaysNothingWhereNoWayLeadsToTheGoal) {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{25.0, 0.0}, {25.0, 40.0}}, false}};
  const Ways ways(StaticMap(kField, obstacles), {45.0, 5.0}, kSmall);
  EXPECT_LE(ways.from({5.0, 5.0}), 0.0);
  EXPECT_GT(ways.from({30.0, 5.0}), 13.0);
}

TEST(ShortestWayTest, SaysNothingWhereStridesLeapOverObstacles) {
  const Ways ways(walledMap(), {45.0, 5.0}, {0.4, 1.5, 0.5});
  EXPECT_TRUE(std::isinf(ways.table.openClearance()));
  EXPECT_EQ(ways.from({5.0, 5.0}), 0.0);
}

// 3 m through the gap where a robot that needs 3.2 m does not fit but strides might cut corners.
TEST(ShortestWayTest, LongerStridesMayCutCloser) {
  const Ways shorter(walledMap(), {45.0, 5.0}, {1.5, 0.2, 0.5});
  const Ways longer(walledMap(), {45.0, 5.0}, {1.5, 4.0, 0.5});
  const double corner = 1.5 - M_SQRT1_2 * 0.2;
  EXPECT_NEAR(longer.table.openClearance(), std::sqrt(corner * corner - 1.0) - M_SQRT2 * 0.2, 1e-6);
  EXPECT_LT(longer.from({5.0, 5.0}), shorter.from({5.0, 5.0}) - 0.5);
}

// --- Occupancy grids ----------------------------------------------------------------------------

OccupancyGrid wallGrid(double resolution) {
  OccupancyGrid grid;
  grid.origin = {20.0, 0.0};
  grid.resolution = resolution;
  grid.columns = static_cast<int>(std::lround(10.0 / resolution));
  grid.rows = static_cast<int>(std::lround(30.0 / resolution));
  grid.blocked.assign(static_cast<size_t>(grid.columns) * grid.rows, 0);
  const int wall = grid.columns / 2;
  for (int row = 0; row < static_cast<int>(std::lround(25.0 / resolution)); ++row) {
    grid.blocked[static_cast<size_t>(row) * grid.columns + wall] = 1;
  }
  return grid;
}

TEST(ShortestWayTest, KnowsTheDetourRoundAWallOfAnOccupancyGrid) {
  for (const double resolution : {0.05, 0.25}) {
    StaticMap::Obstacles obstacles;
    obstacles.grid = wallGrid(resolution);
    const Ways ways(StaticMap(kField, obstacles), {45.0, 5.0}, {1.5, 0.75, 0.5});
    const double length = detour({5.0, 5.0}, {45.0, 5.0}, 1.5) - 0.5;
    EXPECT_LE(ways.from({5.0, 5.0}), length + resolution) << "which makes the wall longer";
    EXPECT_GE(ways.from({5.0, 5.0}), 0.94 * length) << resolution;
  }
}

TEST(ShortestWayTest, RejectsNegativeParameters) {
  const ClearanceGrid map(walledMap(), 0.5);
  const Point goal(45.0, 5.0);
  EXPECT_THROW(ShortestWay(map, goal, {-1.0, 0.75, 0.5}), std::invalid_argument);
  EXPECT_THROW(ShortestWay(map, goal, {1.0, -0.75, 0.5}), std::invalid_argument);
  EXPECT_THROW(ShortestWay(map, goal, {1.0, 0.75, std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
