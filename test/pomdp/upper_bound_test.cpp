// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/upper_bound.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "crowd_scene.h"

namespace pomdp_crowd_nav {
namespace {

ModelParams withBound(ModelParams params, UpperBoundKind kind) {
  params.upper_bound = kind;
  return params;
}

RobotState robotAt(double x, double speed) { return RobotState::from({{x, 0.0}, 0.0, speed}); }

TEST(UpperBound, OfThePaperDiscountsTheStraightWayAtFullSpeed) {
  const UpperBound bound(withBound(ModelParams(), UpperBoundKind::kPaper), {10.0, 0.0});
  EXPECT_FLOAT_EQ(bound.value(robotAt(10.0, 0.0)), 1000.0F);
  EXPECT_FLOAT_EQ(bound.value(robotAt(9.5, 0.0)), 1000.0F) << "within the tolerance";
  EXPECT_FLOAT_EQ(bound.value(robotAt(8.0, 0.0)), 970.0F);  // 1 m to go: one step
  EXPECT_FLOAT_EQ(bound.value(robotAt(3.5, 0.0)), static_cast<float>(1000.0 * std::pow(0.97, 3)));
}

TEST(UpperBound, TightChargesTheCostsThatNoDriveAvoids) {
  const UpperBound bound(withBound(ModelParams(), UpperBoundKind::kTight), {10.0, 0.0});
  EXPECT_FLOAT_EQ(bound.value(robotAt(10.0, 2.0)), 999.0F) << "one more step of time";
  // 5.5 m to go at 2 m/s: three steps and the one that is paid.
  double expected = 0.0;
  for (int n = 0; n < 4; ++n) expected -= std::pow(0.97, n);
  expected += 1000.0 * std::pow(0.97, 3);
  EXPECT_NEAR(bound.value(robotAt(3.5, 2.0)), expected, 1e-3);
  // From rest: 1 m at 1 m/s, charged as rest; 4.5 m left, first step of it charged as 1 m/s.
  expected = -2.0 - 0.97 * 1.5 - std::pow(0.97, 2) - std::pow(0.97, 3) - std::pow(0.97, 4) +
             1000.0 * std::pow(0.97, 4);
  // Steps: 1 m, 2 m, 2 m, 0.5 m: arrival after four.
  EXPECT_NEAR(bound.value(robotAt(3.5, 0.0)), expected, 1e-3);
}

TEST(UpperBound, IsAtLeastNothing) {
  const UpperBound bound(withBound(ModelParams(), UpperBoundKind::kTight), {1e4, 0.0});
  EXPECT_EQ(bound.value(robotAt(0.0, 0.0)), 0.0F);
  EXPECT_GE(bound.value(robotAt(-1e6, 0.0)), 0.0F);
}

TEST(UpperBound, TightIsTheTighter) {
  for (const ModelParams& model : {paperModel(), rampedModel()}) {
    const UpperBound paper(withBound(model, UpperBoundKind::kPaper), {38.0, 19.0});
    const UpperBound tight(withBound(model, UpperBoundKind::kTight), {38.0, 19.0});
    const CrowdScene scene(model, {0, 1, false, 1});
    std::mt19937_64 random(4);
    for (int i = 0; i < 2000; ++i) {
      const RobotState state = scene.randomState(random);
      EXPECT_LE(tight.value(state), paper.value(state) + 1e-3F);
    }
  }
}

struct Setting {
  std::string name;
  ModelParams model;
};

void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.name; }

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const UpperBoundKind kind : {UpperBoundKind::kPaper, UpperBoundKind::kTight}) {
    const std::string suffix = kind == UpperBoundKind::kPaper ? "_paper" : "_tight";
    all.push_back({"instant" + suffix, withBound(paperModel(), kind)});
    all.push_back({"ramped" + suffix, withBound(rampedModel(), kind)});
    ModelParams long_steps = rampedModel();
    long_steps.step = 1.0;
    long_steps.goal_tolerance = 1.0;  // a step of 1.5 m must not leap over it
    all.push_back({"long_steps" + suffix, withBound(long_steps, kind)});
    ModelParams free_drive = rampedModel();
    free_drive.beyond_horizon = BeyondHorizon::kFreeDrive;
    all.push_back({"free_drive" + suffix, withBound(free_drive, kind)});
  }
  return all;
}

class UpperBoundTest : public testing::TestWithParam<Setting> {};

float tolerance(float value) { return 1e-4F * (1.0F + std::abs(value)); }

// The return of a roll-out is the return of a policy: no bound may be below it.
TEST_P(UpperBoundTest, NoRollOutEarnsMore) {
  const ModelParams& model = GetParam().model;
  for (const int people : {0, 3}) {
    const CrowdScene scene(model, {people, 4, people > 0, 6});
    const CrowdModel crowd_model(model, scene.field(), scene.futures());
    std::mt19937_64 random(1);
    for (int i = 0; i < 10000; ++i) {
      const RobotState state = scene.randomState(random);
      const auto& actions = crowd_model.legalActions(state);
      RobotState next;
      const Branch branch =
          crowd_model.step(state, i % 4, 0, actions[random() % actions.size()], next);
      if (branch.terminal) continue;
      for (const float lower : branch.lower) {
        ASSERT_LE(lower, branch.upper + tolerance(branch.upper)) << i;
      }
    }
  }
}

// Over several steps of any actions too: reward now plus the bound of what follows.
TEST_P(UpperBoundTest, NoActionsAndThenARollOutEarnMore) {
  const ModelParams& model = GetParam().model;
  const CrowdScene scene(model, {2, 4, false, 6});
  const CrowdModel crowd_model(model, scene.field(), scene.futures());
  const UpperBound bound(model, scene.field().goal());
  std::mt19937_64 random(2);
  int arrivals = 0;
  for (int i = 0; i < 5000; ++i) {
    RobotState state = scene.randomState(random);
    const float upper = bound.value(state);
    double earned = 0.0;
    double discount = 1.0;
    for (int depth = 0; depth < 8; ++depth) {
      const auto& actions = crowd_model.legalActions(state);
      const Action& action = actions[random() % 3 == 0 ? random() % actions.size() : 0];
      RobotState next;
      const Branch branch = crowd_model.step(state, i % 4, depth, action, next);
      earned += discount * branch.reward;
      arrivals += branch.reward > 500.0F ? 1 : 0;
      ASSERT_LE(earned, upper + tolerance(upper));
      if (branch.terminal) break;
      discount *= model.discount();
      const double best = *std::max_element(branch.lower.begin(), branch.lower.end());
      ASSERT_LE(earned + discount * best, upper + tolerance(upper)) << i << ", depth " << depth;
      state = next;
    }
  }
  EXPECT_GT(arrivals, 20);
}

// On an empty field, straight at the goal, the roll-out does what the bound imagines.
TEST_P(UpperBoundTest, TightIsAttainedOnAnOpenRoad) {
  ModelParams model = GetParam().model;
  if (model.upper_bound != UpperBoundKind::kTight) return;
  model.horizon = 60.0;
  const CrowdScene scene(model, {0, 1, false, 1});
  const CrowdModel crowd_model(model, scene.field(), scene.futures());
  const int scenario = 0;
  for (double distance = 3.0; distance < 36.0; distance += 0.37) {
    const RobotState state = RobotState::from(
        {scene.field().goal() - Point(distance, 0.0), 0.0, model.vehicle.max_speed});
    double lower = 0.0;
    double upper = 0.0;
    crowd_model.rootBounds(&state, &scenario, 1, lower, upper);
    EXPECT_LE(lower, upper + tolerance(static_cast<float>(upper)));
    // One step of discount is lost where the path's small bends cost one.
    EXPECT_GE(lower, model.discount() * upper - 2.0) << distance;
  }
}

INSTANTIATE_TEST_SUITE_P(EverySetting, UpperBoundTest, testing::ValuesIn(settings()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace pomdp_crowd_nav
