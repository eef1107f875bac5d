// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/grid_frame.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

const GridFrame kGrid{{-1.0, 2.0}, 0.5, 4, 3};  // x in [-1, 1], y in [2, 3.5]

TEST(GridFrameTest, FindsTheCellOfAPoint) {
  EXPECT_EQ(kGrid.columnOf({-0.6, 3.0}), 0);
  EXPECT_EQ(kGrid.columnOf({0.6, 3.0}), 3);
  EXPECT_EQ(kGrid.columnOf({1.0, 3.0}), 3);  // the border belongs to the last cell
  EXPECT_EQ(kGrid.rowOf({0.0, 3.2}), 2);
  EXPECT_EQ(kGrid.center(1, 2), Point(-0.25, 3.25));
  EXPECT_EQ(kGrid.index(1, 2), 9U);
}

TEST(GridFrameTest, ContainsItsBorder) {
  EXPECT_TRUE(kGrid.contains({-1.0, 2.0}));
  EXPECT_TRUE(kGrid.contains({1.0, 3.5}));
  EXPECT_FALSE(kGrid.contains({1.001, 3.0}));
  EXPECT_FALSE(kGrid.contains({0.0, 1.999}));
}

TEST(GridFrameTest, InterpolationIsExactForAPlaneUpToTheBorder) {
  const auto plane = [](const Point& p) { return 3.0 * p.x() - 2.0 * p.y() + 1.0; };
  std::vector<float> values;
  for (int row = 0; row < kGrid.rows; ++row) {
    for (int column = 0; column < kGrid.columns; ++column) {
      values.push_back(static_cast<float>(plane(kGrid.center(column, row))));
    }
  }
  for (const Point& p : {Point(0.1, 2.9), Point(-0.75, 2.25), Point(-1.0, 2.0), Point(1.0, 3.5)}) {
    EXPECT_NEAR(interpolate(kGrid, values, p), plane(p), 1e-5) << p.transpose();
  }
}

TEST(GridFrameTest, CoversBoundsThatAreNoWholeNumberOfCells) {
  EXPECT_EQ(coveringGrid({{0.0, 0.0}, {100.0, 30.0}}, 0.1).columns, 1000);
  EXPECT_EQ(coveringGrid({{0.0, 0.0}, {1.01, 30.0}}, 0.1).columns, 11);
  EXPECT_EQ(coveringGrid({{0.0, 0.0}, {0.01, 30.0}}, 0.1).columns, 2);
  EXPECT_THROW(coveringGrid({{0.0, 0.0}, {1.0, 1.0}}, 0.0), std::invalid_argument);
  EXPECT_THROW(coveringGrid({{0.0, 0.0}, {100.0, 100.0}}, 0.001), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
