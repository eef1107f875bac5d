// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/arrival_time_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace pomdp_crowd_nav {
namespace {

using Field = std::function<double(const Point&)>;

SpeedMap makeMap(double side, int cells, const Field& speed) {
  SpeedMap map{{{0.0, 0.0}, side / cells, cells, cells}, {}};
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      map.speed.push_back(static_cast<float>(speed(map.grid.center(column, row))));
    }
  }
  return map;
}

double freeSpeed(const Point&) { return 1.0; }

struct Error {
  double max = 0.0;
  double mean = 0.0;
};

// Over the cells where `counts`.
Error errorOf(const ArrivalTimeField& field, const Field& exact,
              const std::function<bool(const Point&)>& counts) {
  Error error;
  int count = 0;
  const GridFrame& grid = field.grid();
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Point point = grid.center(column, row);
      if (!counts(point)) continue;
      const double off = std::abs(field.times()[grid.index(column, row)] - exact(point));
      error.max = std::max(error.max, off);
      error.mean += off;
      ++count;
    }
  }
  error.mean /= count;
  return error;
}

bool everywhere(const Point&) { return true; }

constexpr int kCells[] = {100, 200, 400};

// Errors at three resolutions that halve; the orders are those of the last halving.
struct Convergence {
  std::vector<Error> errors;
  double maxOrder() const { return std::log2(errors[1].max / errors[2].max); }
  double meanOrder() const { return std::log2(errors[1].mean / errors[2].mean); }
};

void report(const std::string& what, const Convergence& found, double side) {
  for (size_t i = 0; i < found.errors.size(); ++i) {
    std::printf("%s: cell %.3f m, max error %.2e m, mean error %.2e m\n", what.c_str(),
                side / kCells[i], found.errors[i].max, found.errors[i].mean);
  }
  std::printf("%s: order of max %.2f, of mean %.2f\n", what.c_str(), found.maxOrder(),
              found.meanOrder());
  testing::Test::RecordProperty("finest_max_error", std::to_string(found.errors[2].max));
  testing::Test::RecordProperty("finest_mean_error", std::to_string(found.errors[2].mean));
  testing::Test::RecordProperty("max_order", std::to_string(found.maxOrder()));
  testing::Test::RecordProperty("mean_order", std::to_string(found.meanOrder()));
}

// Length of the shortest path round a disc, both ends outside it: the straight line, or tangent,
// arc, tangent.
double lengthRound(const Circle& disc, const Point& from, const Point& to) {
  if (distanceToSegment(disc.center, from, to) >= disc.radius) return (to - from).norm();
  const Point a = from - disc.center;
  const Point b = to - disc.center;
  const double turn = std::acos(a.dot(b) / (a.norm() * b.norm()));
  const double arc = turn - std::acos(disc.radius / a.norm()) - std::acos(disc.radius / b.norm());
  return std::sqrt(a.squaredNorm() - disc.radius * disc.radius) +
         std::sqrt(b.squaredNorm() - disc.radius * disc.radius) + disc.radius * arc;
}

TEST(ArrivalTimeFieldTest, ReferenceLengthRoundADiscIsThatOfTangentArcTangent) {
  const Circle unit_disc{{0.0, 0.0}, 1.0};
  EXPECT_DOUBLE_EQ(lengthRound(unit_disc, {-2.0, 2.0}, {2.0, 2.0}), 4.0);
  // Tangents of sqrt(3) at 60 degrees either side, and 60 degrees of arc between them.
  EXPECT_NEAR(lengthRound(unit_disc, {-2.0, 0.0}, {2.0, 0.0}), 2.0 * std::sqrt(3.0) + M_PI / 3.0,
              1e-12);
}

TEST(ArrivalTimeFieldTest, ConvergesWithTheSquareOfTheCellOnAnEmptyField) {
  const double side = 40.0;
  const Point source(13.3, 17.1);
  Convergence found;
  for (int cells : kCells) {
    const ArrivalTimeField field(makeMap(side, cells, freeSpeed), source);
    const auto exact = [&](const Point& p) { return (p - source).norm(); };
    found.errors.push_back(errorOf(field, exact, everywhere));
  }
  report("empty field", found, side);
  EXPECT_LT(found.errors[0].max, 0.04);
  EXPECT_LT(found.errors[2].max, 0.0025);
  EXPECT_GT(found.maxOrder(), 1.8);
  EXPECT_GT(found.meanOrder(), 1.8);
}

TEST(ArrivalTimeFieldTest, ConvergesRoundACircle) {
  const double side = 40.0;
  const Point source(5.2, 18.7);
  const Circle disc{{20.0, 20.0}, 6.0};
  const auto outside = [&](const Point& p) { return (p - disc.center).norm() >= disc.radius; };
  Convergence found;
  for (int cells : kCells) {
    const auto speed = [&](const Point& p) { return outside(p) ? 1.0 : 1e-3; };
    const ArrivalTimeField field(makeMap(side, cells, speed), source);
    const auto exact = [&](const Point& p) { return lengthRound(disc, source, p); };
    found.errors.push_back(errorOf(field, exact, outside));
  }
  report("round a circle", found, side);
  // Linear: the outline is a staircase of cells, along which the front loses a few cells' time.
  EXPECT_LT(found.errors[0].max, 1.4);
  EXPECT_LT(found.errors[2].max, 0.45);
  EXPECT_LT(found.errors[2].mean, 0.03);
  EXPECT_GT(found.maxOrder(), 0.7);
  EXPECT_GT(found.meanOrder(), 0.8);
}

TEST(ArrivalTimeFieldTest, SolvesAFieldWhoseSpeedGrowsWithX) {
  const double slope = 0.1;
  const Point source(10.05, 10.05);
  const auto speed = [&](const Point& p) { return 1.0 + slope * p.x(); };
  const ArrivalTimeField field(makeMap(20.0, 200, speed), source);
  // The rays are arcs of circles: Slotnick's formula.
  const auto exact = [&](const Point& p) {
    const double stretched = slope * (p - source).norm();
    return std::acosh(1.0 + stretched * stretched / (2.0 * speed(source) * speed(p))) / slope;
  };
  EXPECT_LT(errorOf(field, exact, everywhere).max, 0.05);
}

TEST(ArrivalTimeFieldTest, PathLengthIsTheTimeAtUnitSpeed) {
  const ArrivalTimeField field(makeMap(20.0, 100, freeSpeed), {3.0, 4.0});
  for (size_t i = 0; i < field.times().size(); ++i) {
    ASSERT_NEAR(field.pathLengths()[i], field.times()[i], 1e-3);
  }
}

TEST(ArrivalTimeFieldTest, PathLengthIsNotInflatedByASlowBand) {
  const auto speed = [](const Point& p) { return p.x() > 8.0 && p.x() < 12.0 ? 0.01 : 1.0; };
  const ArrivalTimeField field(makeMap(20.0, 100, speed), {2.0, 10.0});
  EXPECT_NEAR(field.timeAt({18.0, 10.0}), 12.0 + 4.0 / 0.01, 25.0);
  EXPECT_NEAR(field.pathLengthAt({18.0, 10.0}), 16.0, 0.1);
}

TEST(ArrivalTimeFieldTest, SourceInASlowAreaStartsTheFrontThere) {
  const auto speed = [](const Point& p) { return p.x() < 5.0 ? 0.01 : 1.0; };
  const ArrivalTimeField field(makeMap(20.0, 100, speed), {4.0, 10.0});
  EXPECT_NEAR(field.timeAt({15.0, 10.0}), 1.0 / 0.01 + 10.0, 15.0);
  EXPECT_NEAR(field.pathLengthAt({15.0, 10.0}), 11.0, 0.1);
  // 1 m out of the slow area and 0.3 m back into it beat 2.6 m inside.
  EXPECT_NEAR(field.timeAt({4.7, 12.5}), 1.3 / 0.01 + 2.5, 15.0);
}

// Whatever the speeds: a front enters a cell from an earlier neighbour, in no more than the time
// to cross it.
TEST(ArrivalTimeFieldTest, EveryCellIsReachedThroughAnEarlierNeighbour) {
  std::mt19937 random(3);
  std::lognormal_distribution<double> any_speed(0.0, 1.5);
  const Point source(5.0, 5.0);
  const SpeedMap map = makeMap(10.0, 100, [&](const Point&) { return any_speed(random); });
  const ArrivalTimeField field(map, source);
  const GridFrame& grid = field.grid();
  for (int row = 1; row < grid.rows - 1; ++row) {
    for (int column = 1; column < grid.columns - 1; ++column) {
      if ((grid.center(column, row) - source).norm() < 0.2) continue;
      const float* t = &field.times()[grid.index(column, row)];
      const float earliest = std::min({t[-1], t[1], t[-grid.columns], t[grid.columns]});
      const double crossing_time = grid.resolution / map.speed[grid.index(column, row)];
      ASSERT_GE(*t, earliest);
      ASSERT_LE(*t, earliest + crossing_time * 1.0001 + 1e-5);
    }
  }
}

// A wall ends the exact disc's sight: behind it the way leads round the wall's end.
TEST(ArrivalTimeFieldTest, ExactDiscDoesNotReachThroughAWall) {
  const auto speed = [](const Point& p) {
    return p.x() > 10.5 && p.x() < 10.8 && p.y() < 12.0 ? 1e-3 : 1.0;
  };
  const ArrivalTimeField field(makeMap(20.0, 200, speed), {10.0, 10.0});
  const double round_the_end = Point(0.5, 2.0).norm() + 0.3 + Point(0.2, 2.0).norm();
  EXPECT_NEAR(field.timeAt({11.0, 10.0}), round_the_end, 0.2);
}

TEST(ArrivalTimeFieldTest, SourceMayLieOnTheBorder) {
  const Point source(20.0, 15.0);
  const ArrivalTimeField field(makeMap(20.0, 100, freeSpeed), source);
  EXPECT_NEAR(field.timeAt({20.0, 12.0}), 3.0, 0.01);
  EXPECT_NEAR(field.timeAt({0.0, 0.0}), 25.0, 0.05);
}

TEST(ArrivalTimeFieldTest, RejectsMapsAndSourcesItCannotSolve) {
  SpeedMap map = makeMap(2.0, 20, freeSpeed);
  EXPECT_THROW(ArrivalTimeField(map, {2.01, 1.0}), std::invalid_argument);
  EXPECT_THROW(ArrivalTimeField(map, {std::nan(""), 1.0}), std::invalid_argument);
  map.speed[7] = 0.0F;
  EXPECT_THROW(ArrivalTimeField(map, {1.0, 1.0}), std::invalid_argument);
  map.speed.pop_back();
  EXPECT_THROW(ArrivalTimeField(map, {1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(ArrivalTimeField(makeMap(1.0, 1, freeSpeed), {0.5, 0.5}), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
