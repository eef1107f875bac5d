// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "crowd_scene.h"

namespace pomdp_crowd_nav {
namespace {

TEST(Lanes, PolynomialsAreNearlyExactInTheirRange) {
  for (int i = -1000; i <= 1000; ++i) {
    const float x = 0.001F * static_cast<float>(i);
    EXPECT_NEAR(arcTangent<float>(x), std::atan(static_cast<double>(x)), 2e-7) << x;
    const double angle = M_PI / 4.0 * static_cast<double>(x);
    const auto narrow = static_cast<float>(angle);
    EXPECT_NEAR(cosineOf<float>(narrow), std::cos(angle), 2e-7) << angle;
    const double ratio = i == 0 ? 1.0 : std::sin(angle) / angle;
    EXPECT_NEAR(sineOver<float>(narrow), ratio, 2e-7) << angle;
  }
}

// Every turn of the action sets from anywhere at any speed, against the arcs of world/vehicle.
TEST(Lanes, ACarEndsWhereSinesAndCosinesPutIt) {
  for (const ModelParams& params : {carModel(), rampedCarModel()}) {
    const CrowdScene scene(params, {0, 1, false, 1, false, "straight_line"});
    const CrowdModel model(params, scene.field(), scene.futures());
    std::mt19937_64 random(2);
    for (int i = 0; i < 2000; ++i) {
      const RobotState state = scene.randomState(random);
      const VehicleState from{Point(state.x, state.y),
                              std::atan2(static_cast<double>(state.direction_y),
                                         static_cast<double>(state.direction_x)),
                              state.speed};
      for (const Action& action : model.legalActions(state)) {
        if (action.heading == Action::Heading::kFollowPrior) continue;
        const RobotState to = model.move(state, action);
        const VehicleState expected =
            stepMotion(params.vehicle, from, from.heading + action.turn, to.speed, params.step)
                .end();
        ASSERT_NEAR((Point(to.x, to.y) - expected.position).norm(), 0.0, 1e-5);
        ASSERT_NEAR(to.direction_x, std::cos(expected.heading), 1e-6);
        ASSERT_NEAR(to.direction_y, std::sin(expected.heading), 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
