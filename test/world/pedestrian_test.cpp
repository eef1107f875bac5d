// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/pedestrian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

const Pedestrian kWalker{{1.0, 2.0}, {31.0, 42.0}, 1.5};  // 50 m along (0.6, 0.8)

void expectAt(const Point& found, double x, double y) {
  EXPECT_NEAR(found.x(), x, 1e-12);
  EXPECT_NEAR(found.y(), y, 1e-12);
}

TEST(StraightLinePedestrianTest, WalksTowardTheDestinationAtItsSpeed) {
  const StraightLinePedestrian model({0.1});
  expectAt(model.advance(kWalker, 2.0, 0.0), 1.0 + 0.6 * 3.0, 2.0 + 0.8 * 3.0);
  expectAt(model.advance(kWalker, 0.0, 0.0), 1.0, 2.0);
}

TEST(StraightLinePedestrianTest, NoiseLengthensOrShortensTheStep) {
  const StraightLinePedestrian model({0.2});
  expectAt(model.advance(kWalker, 2.0, 1.0), 1.0 + 0.6 * 3.2, 2.0 + 0.8 * 3.2);
  expectAt(model.advance(kWalker, 2.0, -0.5), 1.0 + 0.6 * 2.9, 2.0 + 0.8 * 2.9);
  expectAt(StraightLinePedestrian({0.0}).advance(kWalker, 2.0, 1.0), 2.8, 4.4);
}

TEST(StraightLinePedestrianTest, StaysAtTheDestination) {
  const StraightLinePedestrian model({0.1});
  const Pedestrian arrived{{3.0, 4.0}, {3.0, 4.0}, 1.0};
  expectAt(model.advance(arrived, 1.0, 1.0), 3.0, 4.0);
}

TEST(StraightLinePedestrianTest, RejectsNegativeOrUndefinedNoise) {
  EXPECT_THROW(StraightLinePedestrian({-0.1}), std::invalid_argument);
  EXPECT_THROW(StraightLinePedestrian({std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
