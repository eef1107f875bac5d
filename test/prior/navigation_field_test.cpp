// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/navigation_field.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "pomdp_crowd_nav/prior/fast_marching_prior.h"
#include "pomdp_crowd_nav/prior/straight_line_prior.h"

namespace pomdp_crowd_nav {
namespace {

StaticMap discMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{10.0, 10.0}, 2.0}};
  return StaticMap(Bounds{{-5.0, 0.0}, {25.0, 20.0}}, obstacles);
}

TEST(NavigationFieldTest, HoldsPriorAndClearanceOfTheCellCentres) {
  const StaticMap map = discMap();
  const FastMarchingPrior prior(map, {24.0, 12.0}, PriorParams());
  const NavigationField field(prior, map, 0.5);
  ASSERT_EQ(field.raster().columns, 60);
  ASSERT_EQ(field.raster().last_row, 39.0F);
  EXPECT_FLOAT_EQ(field.raster().cells_per_meter, 2.0F);
  for (double x = -4.75; x < 25.0; x += 1.5) {
    for (double y = 0.25; y < 20.0; y += 1.5) {
      const NavigationCell cell =
          field.at(static_cast<float>(x + 0.2), static_cast<float>(y - 0.2));
      const Point way = unitVector(*prior.directionAt({{x, y}, 0.0}));
      EXPECT_NEAR(cell.direction_x, way.x(), 2e-5);
      EXPECT_NEAR(cell.direction_y, way.y(), 2e-5);
      EXPECT_NEAR(cell.clearance, map.clearance({x, y}), 1e-5);
      EXPECT_NEAR(cell.distance_to_goal, prior.distanceToGoal({x, y}), 1e-5);
    }
  }
}

TEST(NavigationFieldTest, PlacesOffTheMapReadTheBorderCell) {
  const StaticMap map = discMap();
  const NavigationField field(StraightLinePrior({24.0, 12.0}), map, 0.5);
  EXPECT_EQ(field.cellOf(-7.0F, -1.0F), 0);
  EXPECT_EQ(field.cellOf(25.0F, 20.0F), 60 * 40 - 1);
  EXPECT_EQ(field.cellOf(99.0F, 0.1F), 59);
  EXPECT_EQ(field.cellOf(std::numeric_limits<float>::quiet_NaN(), 0.1F), 0);
  EXPECT_EQ(field.cellOf(0.1F, std::numeric_limits<float>::infinity()), 60 * 39 + 10);
}

TEST(NavigationFieldTest, DirectionsArePackedIntoOneWord) {
  EXPECT_EQ(packDirection(0.0, 0.0), 0);
  EXPECT_EQ(packDirection(1.0, 0.0), 0x00007FFF);
  EXPECT_EQ(packDirection(0.0, 1.0), 0x7FFF0000);
  EXPECT_EQ(packDirection(-1.0, 0.0), 0x00008001);
  EXPECT_EQ(static_cast<std::uint32_t>(packDirection(0.0, -1.0)), 0x80010000U);
}

TEST(NavigationFieldTest, CarriesGoalAndBounds) {
  const StaticMap map = discMap();
  const NavigationField field(StraightLinePrior({24.0, 12.0}), map, 0.5);
  EXPECT_EQ(field.goal(), Point(24.0, 12.0));
  EXPECT_EQ(field.bounds().min, Point(-5.0, 0.0));
  EXPECT_TRUE(field.hasObstacles());
}

// Knows no way at all.
class LostPrior : public RolloutPrior {
 public:
  const Point& goal() const override { return goal_; }
  std::optional<double> directionAt(const Pose&) const override { return std::nullopt; }
  double distanceToGoal(const Point&) const override {
    return std::numeric_limits<double>::infinity();
  }

 private:
  Point goal_{1.0, 1.0};
};

TEST(NavigationFieldTest, InfinitiesBecomeLargeNumbers) {
  const NavigationField field(LostPrior(), StaticMap(Bounds{{0.0, 0.0}, {5.0, 5.0}}, {}), 0.5);
  const NavigationCell cell = field.at(2.0F, 2.0F);
  EXPECT_EQ(cell.direction_x, 0.0F);
  EXPECT_EQ(cell.direction_y, 0.0F);
  EXPECT_EQ(cell.clearance, 1e6F);
  EXPECT_EQ(cell.distance_to_goal, 1e6F);
  EXPECT_FALSE(field.hasObstacles());
}

TEST(NavigationFieldTest, RejectsAResolutionThatIsNotPositive) {
  const StraightLinePrior prior({24.0, 12.0});
  EXPECT_THROW(NavigationField(prior, discMap(), 0.0), std::invalid_argument);
  EXPECT_THROW(NavigationField(prior, discMap(), -1.0), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
