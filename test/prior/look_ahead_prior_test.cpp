// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/look_ahead_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

// East to x = 10, then north to the goal at (10, 10).
class CornerPrior : public RolloutPrior {
 public:
  const Point& goal() const override { return goal_; }
  std::optional<double> directionAt(const Pose& pose) const override {
    if (pose.position.y() < -1.0) return std::nullopt;
    return pose.position.x() < 10.0 - 1e-9 ? 0.0 : M_PI / 2.0;
  }
  double distanceToGoal(const Point& position) const override {
    return std::abs(10.0 - position.x()) + std::abs(10.0 - position.y());
  }

 private:
  Point goal_{10.0, 10.0};
};

double directionFrom(double x, double distance) {
  const LookAheadPrior prior(std::make_shared<CornerPrior>(), distance);
  return *prior.directionAt({{x, 0.0}, 0.0});
}

TEST(LookAheadPrior, TurnsBeforeThePathDoes) {
  EXPECT_EQ(directionFrom(8.0, 0.0), 0.0);
  EXPECT_NEAR(directionFrom(5.0, 4.0), 0.0, 1e-12);
  EXPECT_NEAR(directionFrom(8.0, 4.0), std::atan2(2.0, 2.0), 1e-9);
  EXPECT_NEAR(directionFrom(9.0, 4.0), std::atan2(3.0, 1.0), 1e-9);
}

TEST(LookAheadPrior, LooksNoFartherThanTheGoal) {
  const LookAheadPrior prior(std::make_shared<CornerPrior>(), 50.0);
  EXPECT_NEAR(*prior.directionAt({{7.0, 9.0}, 0.0}), std::atan2(1.0, 3.0), 1e-9);
  EXPECT_NEAR(*prior.directionAt({{10.0, 9.9}, 0.0}), M_PI / 2.0, 1e-9);
}

TEST(LookAheadPrior, KnowsNoWayWhereThePathIsNot) {
  const LookAheadPrior prior(std::make_shared<CornerPrior>(), 2.0);
  EXPECT_FALSE(prior.directionAt({{5.0, -2.0}, 0.0}));
  EXPECT_EQ(prior.distanceToGoal({4.0, 3.0}), 13.0);
  EXPECT_EQ(prior.goal(), Point(10.0, 10.0));
  EXPECT_FALSE(prior.isStraightLine());
}

TEST(LookAheadPrior, RejectsADistanceThatIsNone) {
  for (const double bad : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(LookAheadPrior(std::make_shared<CornerPrior>(), bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
