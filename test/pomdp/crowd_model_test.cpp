// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/crowd_model.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <ostream>
#include <string>

#include "crowd_scene.h"
#include "pomdp_crowd_nav/prior/straight_line_prior.h"
#include "reference_model.h"

namespace pomdp_crowd_nav {
namespace {

struct Setting {
  std::string name;
  ModelParams model;
  bool obstacles = false;
  int people = 6;
  std::string prior = "fast_marching";
};

void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.name; }

std::vector<Setting> settings() {
  ModelParams timid = paperModel();
  timid.bold_rollouts = false;
  ModelParams far_sighted = rampedModel();
  far_sighted.beyond_horizon = BeyondHorizon::kFreeDrive;
  ModelParams paper_bound = paperModel();
  paper_bound.upper_bound = UpperBoundKind::kPaper;
  ModelParams five_checks = paperModel();
  five_checks.collision_checks = 5;
  ModelParams two_checks = carModel();
  two_checks.collision_checks = 2;
  ModelParams ramped_three_checks = rampedModel();
  ramped_three_checks.collision_checks = 3;
  return {{"paper_five_checks", five_checks, true},
          {"ramped_three_checks", ramped_three_checks, true, 20},
          {"car", carModel(), false, 6, "straight_line"},
          {"car_obstacles", carModel(), true, 10},
          {"car_two_checks", two_checks, true, 6, "straight_line"},
          {"ramped_car", rampedCarModel(), false, 6, "straight_line"},
          {"ramped_car_obstacles", rampedCarModel(), true, 20},
          {"paper", paperModel()},
          {"paper_obstacles", paperModel(), true},
          {"paper_one_policy", timid, true},
          {"paper_bound", paper_bound, true},
          {"ramped", rampedModel()},
          {"ramped_obstacles", rampedModel(), true},
          {"ramped_free_drive", far_sighted, true},
          {"ramped_crowded", rampedModel(), true, 20},
          {"paper_alone", paperModel(), true, 0}};
}

class CrowdModelTest : public testing::TestWithParam<Setting> {
 protected:
  CrowdScene scene_{GetParam().model,
                    {GetParam().people, 8, GetParam().obstacles, 3, false, GetParam().prior}};
  CrowdModel model_{GetParam().model, scene_.field(), scene_.futures()};
  std::mt19937_64 random_{11};

  int randomDepth() { return static_cast<int>(random_() % scene_.futures().depth()); }
  int randomScenario() { return static_cast<int>(random_() % 8); }
};

TEST_P(CrowdModelTest, StepIsThatOfTheReference) {
  const ModelParams& params = GetParam().model;
  constexpr double kMargin = 3e-4;
  ReferenceModel reference(params, scene_.field(), scene_.futures());
  int compared = 0;
  int terminal = 0;
  for (int i = 0; i < 2500; ++i) {
    const RobotState state = scene_.randomState(random_);
    const VehicleState vehicle{
        Point(state.x, state.y),
        std::atan2(static_cast<double>(state.direction_y), static_cast<double>(state.direction_x)),
        state.speed};
    const auto& actions = model_.legalActions(state);
    const Action& action = actions[random_() % actions.size()];
    const int scenario = randomScenario();
    const int depth = randomDepth();
    const auto expected = reference.step(vehicle, scenario, depth, action);
    if (expected.margin < kMargin) continue;
    ++compared;
    RobotState next;
    const Branch branch = model_.step(state, scenario, depth, action, next);
    ASSERT_EQ(branch.terminal, expected.terminal) << describe(action);
    ASSERT_NEAR(branch.reward, expected.reward, 1e-4 * (1.0 + std::abs(expected.reward)));
    ASSERT_NEAR(next.x, expected.next.position.x(), 1e-4);
    ASSERT_NEAR(next.y, expected.next.position.y(), 1e-4);
    ASSERT_NEAR(next.speed, expected.next.speed, 1e-5);
    ASSERT_NEAR(next.direction_x, std::cos(expected.next.heading), 1e-4);
    ASSERT_NEAR(next.direction_y, std::sin(expected.next.heading), 1e-4);
    EXPECT_EQ(branch.observation, scene_.futures().observation(scenario, depth + 1));
    terminal += branch.terminal ? 1 : 0;
    if (branch.terminal) continue;
    for (int p = 0; p < (params.bold_rollouts ? 2 : 1); ++p) {
      if (params.beyond_horizon == BeyondHorizon::kNothing) {
        ASSERT_NEAR(branch.lower[p], expected.rollouts[p], 0.02) << describe(action) << ", " << i;
      } else {
        ASSERT_GE(branch.lower[p], expected.rollouts[p] - 0.02) << describe(action) << ", " << i;
      }
    }
    if (!params.bold_rollouts) {
      ASSERT_EQ(branch.lower[1], std::numeric_limits<float>::lowest());
    }
  }
  EXPECT_GT(compared, 1000) << "too many cases were left to rounding";
  EXPECT_GT(terminal, GetParam().people > 0 ? 20 : 0) << "nothing ever happened";
}

// Every action of every scenario, from beliefs of one and of several scenarios.
TEST_P(CrowdModelTest, ExpandIsStepBitForBit) {
  Expansion<CrowdModel> out;
  for (int i = 0; i < 300; ++i) {
    const RobotState state = scene_.randomState(random_);
    const int depth = randomDepth();
    std::vector<int> scenarios(i % 3 == 0 ? 8 : 1);
    std::iota(scenarios.begin(), scenarios.end(), i % 3 == 0 ? 0 : randomScenario());
    const int count = static_cast<int>(scenarios.size());
    model_.expand(&state, scenarios.data(), count, depth, out);
    ASSERT_EQ(out.actions, model_.legalActions(state));
    ASSERT_EQ(out.states.size(), out.actions.size());
    ASSERT_EQ(out.branches.size(), out.actions.size() * scenarios.size());
    for (size_t a = 0; a < out.actions.size(); ++a) {
      for (int s = 0; s < count; ++s) {
        const Branch& branch = out.branches[a * scenarios.size() + s];
        RobotState next;
        const Branch twin = model_.step(state, scenarios[s], depth, out.actions[a], next);
        ASSERT_EQ(std::memcmp(&out.states[a], &next, sizeof(next)), 0);
        ASSERT_EQ(branch.terminal, twin.terminal);
        ASSERT_EQ(branch.reward, twin.reward);
        ASSERT_EQ(branch.observation, twin.observation);
        if (branch.terminal) continue;
        ASSERT_EQ(branch.lower, twin.lower);
        ASSERT_EQ(branch.upper, twin.upper);
      }
    }
  }
}

TEST_P(CrowdModelTest, AllKernelsAgreeBitForBit) {
  const auto kernels = laneKernels();
  ASSERT_FALSE(kernels.empty());
  EXPECT_EQ(&laneKernel(), kernels.back());
  const std::vector<int> scenarios{0, 1, 2, 3, 4, 5, 6, 7};
  Expansion<CrowdModel> expected;
  Expansion<CrowdModel> out;
  for (const LaneKernel* kernel : kernels) {
    const CrowdModel first(GetParam().model, scene_.field(), scene_.futures(), *kernels.front());
    const CrowdModel other(GetParam().model, scene_.field(), scene_.futures(), *kernel);
    std::mt19937_64 random(5);
    for (int i = 0; i < 300; ++i) {
      const RobotState state = scene_.randomState(random);
      const int depth = static_cast<int>(random() % scene_.futures().depth());
      first.expand(&state, scenarios.data(), 8, depth, expected);
      other.expand(&state, scenarios.data(), 8, depth, out);
      ASSERT_EQ(out.model_steps, expected.model_steps) << kernel->name;
      ASSERT_EQ(out.branches.size(), expected.branches.size());
      ASSERT_EQ(std::memcmp(out.states.data(), expected.states.data(),
                            out.states.size() * sizeof(RobotState)),
                0)
          << kernel->name;
      for (size_t b = 0; b < out.branches.size(); ++b) {
        ASSERT_EQ(out.branches[b].reward, expected.branches[b].reward) << kernel->name;
        ASSERT_EQ(out.branches[b].terminal, expected.branches[b].terminal) << kernel->name;
        ASSERT_EQ(out.branches[b].lower, expected.branches[b].lower) << kernel->name;
        ASSERT_EQ(out.branches[b].upper, expected.branches[b].upper) << kernel->name;
      }
    }
  }
}

TEST_P(CrowdModelTest, CountsEveryStepOfEveryRollOut) {
  ReferenceModel reference(GetParam().model, scene_.field(), scene_.futures());
  Expansion<CrowdModel> out;
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    const RobotState state = scene_.randomState(random_);
    const int scenario = randomScenario();
    const int depth = randomDepth();
    model_.expand(&state, &scenario, 1, depth, out);
    long steps = 0;
    double margin = 1.0;
    for (const Action& action : out.actions) {
      const auto outcome = reference.step(state.vehicle(), scenario, depth, action);
      steps += 1 + outcome.rollout_steps;
      margin = std::min(margin, outcome.margin);
    }
    if (margin < 1e-5) continue;
    ++compared;
    ASSERT_EQ(out.model_steps, steps);
  }
  EXPECT_GT(compared, 50);
}

TEST_P(CrowdModelTest, RootBoundsAreMeansOverTheScenarios) {
  ReferenceModel reference(GetParam().model, scene_.field(), scene_.futures());
  const RobotState state = RobotState::from({Point(5.13, 12.31), 0.2, 0.0});
  const std::vector<int> scenarios{0, 1, 2, 3, 4, 5, 6, 7};
  double lower = 0.0;
  double upper = 0.0;
  model_.rootBounds(&state, scenarios.data(), 8, lower, upper);
  const int policies = GetParam().model.bold_rollouts ? 2 : 1;
  double best = -1e9;
  for (int policy = 0; policy < policies; ++policy) {
    double mean = 0.0;
    for (int k = 0; k < 8; ++k) mean += reference.rollOut(state.vehicle(), k, policy) / 8.0;
    best = std::max(best, mean);
  }
  EXPECT_GE(lower, best - 0.05);
  if (GetParam().model.beyond_horizon == BeyondHorizon::kNothing) {
    EXPECT_LE(lower, best + 0.05);
  }
  EXPECT_EQ(upper, UpperBound(GetParam().model, scene_.field().goal()).value(state));
  EXPECT_LE(lower, upper);
}

TEST_P(CrowdModelTest, DefaultActionIsLegal) {
  for (int i = 0; i < 300; ++i) {
    const RobotState state = scene_.randomState(random_);
    const auto& legal = model_.legalActions(state);
    const Action action = model_.defaultAction(&state);
    EXPECT_NE(std::find(legal.begin(), legal.end(), action), legal.end()) << describe(action);
  }
}

TEST_P(CrowdModelTest, MoveIsThePartOfAStepWithoutPeople) {
  for (int i = 0; i < 100; ++i) {
    const RobotState state = scene_.randomState(random_);
    for (const Action& action : model_.legalActions(state)) {
      RobotState next;
      model_.step(state, 0, 0, action, next);
      const RobotState moved = model_.move(state, action);
      EXPECT_EQ(std::memcmp(&moved, &next, sizeof(next)), 0);
      EXPECT_EQ(moved.speed, model_.speedAfter(state, action));
    }
  }
}

// A roll-out that starts at the horizon has nothing left to pay for.
TEST_P(CrowdModelTest, RollOutsEndAtTheHorizon) {
  const bool counts_beyond = GetParam().model.beyond_horizon == BeyondHorizon::kFreeDrive;
  for (int i = 0; i < 200; ++i) {
    const RobotState state = scene_.randomState(random_);
    RobotState next;
    const Branch branch = model_.step(state, 0, scene_.futures().depth() - 1,
                                      model_.legalActions(state).front(), next);
    if (branch.terminal) continue;
    EXPECT_TRUE(counts_beyond ? branch.lower[0] >= 0.0F : branch.lower[0] == 0.0F);
  }
}

INSTANTIATE_TEST_SUITE_P(EverySetting, CrowdModelTest, testing::ValuesIn(settings()),
                         [](const auto& test) { return test.param.name; });

TEST(CrowdModel, ADecisionPeriodScalesTheCosts) {
  ModelParams params = rampedModel();
  const CrowdScene scene(params, {0, 1, false, 1});
  const CrowdModel model(params, scene.field(), scene.futures());
  RobotState next;
  const Branch branch =
      model.step(RobotState::from({{5.0, 5.0}, 0.0, 0.75}), 0, 0, Action::turnBy(0.0, 1), next);
  EXPECT_FLOAT_EQ(branch.reward, 0.5F * (-1.0F - 0.5F));
  EXPECT_FLOAT_EQ(next.speed, 1.25F);
  EXPECT_FLOAT_EQ(next.x, 5.0F + 0.5F * 1.0F) << "the mean of both speeds";
}

TEST(CrowdModel, FreeDriveValuesWhatLiesBeyondTheHorizon) {
  ModelParams nothing = rampedModel();
  nothing.horizon = 4.0;
  ModelParams free_drive = nothing;
  free_drive.beyond_horizon = BeyondHorizon::kFreeDrive;
  const CrowdScene scene(nothing, {3, 4, true, 2});
  const CrowdModel without(nothing, scene.field(), scene.futures());
  const CrowdModel with(free_drive, scene.field(), scene.futures());
  std::mt19937_64 random(3);
  int more = 0;
  for (int i = 0; i < 500; ++i) {
    const RobotState state = scene.randomState(random);
    RobotState next;
    const Action action = with.legalActions(state).front();
    const Branch plain = without.step(state, 0, 0, action, next);
    const Branch branch = with.step(state, 0, 0, action, next);
    if (branch.terminal) continue;
    for (int p = 0; p < 2; ++p) {
      EXPECT_GE(branch.lower[p], plain.lower[p]);
      EXPECT_LE(branch.lower[p], branch.upper + 0.05F);
    }
    more += branch.lower[0] > plain.lower[0] + 1.0F ? 1 : 0;
  }
  EXPECT_GT(more, 250);
}

// Along a wall that comes closer by 0.25 mm a cell: who is in the margin may stay at its depth, and
// nobody else may slip into it.
TEST(CrowdModel, NobodyClearOfObstaclesSlipsIntoTheirMargin) {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{0.0, 5.0}, {40.0, 5.04}}, false}};
  const StaticMap map({{0.0, 0.0}, {40.0, 10.0}}, obstacles);
  const NavigationField field(StraightLinePrior({39.0, 8.0}), map, 0.25);
  const RobotLanes<float> robot{20.125F, 6.125F, 1.0F, 0.0F, 0.5F};
  const FieldLanes<float> here = lookUp(field, robot.x, robot.y);
  const float next = clearanceAt(field, 20.375F, 6.125F);
  ASSERT_GT(here.clearance, next + 1e-4F);
  ASSERT_LT(here.clearance, next + 4e-4F);
  ModelParams params = rampedModel();
  const auto hits = [&](double clearance) {
    params.obstacle_distance = clearance - params.vehicle.radius;
    const StepConstants constants(params, field);
    return moveRobots<float>(constants, field, robot, here, 0.5F, 1.0F, 0.0F, false).hits_obstacle;
  };
  EXPECT_TRUE(hits(0.5 * (here.clearance + next)));
  EXPECT_FALSE(hits(here.clearance + 1e-3)) << "it is in the margin already";
  EXPECT_FALSE(hits(next - 1e-4)) << "neither of the cells is";
}

TEST(CrowdModel, RejectsParametersOutOfRange) {
  const CrowdScene scene(paperModel(), {0, 1, false, 1});
  ModelParams params = paperModel();
  params.step = 0.0;
  EXPECT_THROW(CrowdModel(params, scene.field(), scene.futures()), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
