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
    ModelParams five_checks = paperModel();
    five_checks.collision_checks = 5;
    all.push_back({"car" + suffix, withBound(carModel(), kind)});
    all.push_back({"ramped_car" + suffix, withBound(rampedCarModel(), kind)});
    all.push_back({"five_checks" + suffix, withBound(five_checks, kind)});
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

// --- Among walls
// ----------------------------------------------------------------------------------

float straightWay(const CrowdScene& scene, const RobotState& state) {
  const Point goal = scene.field().goal();
  const double tolerance = scene.model().goal_tolerance;
  return static_cast<float>((state.vehicle().position - goal).norm() - tolerance);
}

bool isClear(const CrowdScene& scene, const RobotState& state) {
  return scene.field().at(state.x, state.y).clearance > scene.model().obstacleClearance();
}

// Fewer drives of a car, which turns wide, arrive.
bool isCar(const ModelParams& model) { return model.vehicle.kind == VehicleKind::kCar; }

// Room for roll-outs that arrive after a long detour.
ModelParams farSighted(ModelParams model) {
  model.horizon = std::max(model.horizon, 70.0);
  return model;
}

TEST_P(UpperBoundTest, NoRollOutAroundWallsEarnsMore) {
  const ModelParams model = farSighted(GetParam().model);
  const CrowdScene scene(model, {0, 1, false, 6, true});
  ASSERT_EQ(scene.shortestWay() != nullptr, model.upper_bound == UpperBoundKind::kTight);
  const CrowdModel crowd_model(model, scene.tables(), scene.futures());
  std::mt19937_64 random(1);
  int detours = 0;
  for (int i = 0; i < 30000; ++i) {
    const RobotState state = scene.randomState(random);
    const int scenario = 0;
    double lower = 0.0;
    double upper = 0.0;
    crowd_model.rootBounds(&state, &scenario, 1, lower, upper);
    ASSERT_LE(lower, upper + tolerance(static_cast<float>(upper))) << i;
    if (scene.shortestWay() == nullptr || lower < 20.0) continue;
    const float way = scene.shortestWay()->lengthFrom(state.x, state.y);
    detours += way > straightWay(scene, state) + 4.0F ? 1 : 0;
  }
  if (scene.shortestWay() != nullptr) {
    EXPECT_GT(detours, isCar(model) ? 50 : 2000) << "who arrived after one";
  }
}

// What the tight bound takes for the length of a step.
double lengthOf(const ModelParams& model, const RobotState& from, const RobotState& to) {
  if (!model.vehicle.instant_velocity) return 0.5 * model.step * (from.speed + to.speed);
  return std::hypot(to.x - from.x, to.y - from.y);
}

// Drives of legal steps that cut every corner the model allows: down the very table, now and then
// in any direction.
class CornerCutter {
 public:
  explicit CornerCutter(const CrowdScene& scene)
      : scene_(scene), model_(scene.model(), scene.tables(), scene.futures()) {}

  // Empty unless it arrives.
  std::vector<RobotState> drive(RobotState state, std::mt19937_64& random) const {
    std::vector<RobotState> states{state};
    const unsigned one_in = 3 + random() % 60;
    for (int k = 0; k < 150; ++k) {
      const auto& actions = model_.legalActions(state);
      RobotState next = state;
      const Action any = actions[random() % actions.size()];
      const Action action = random() % one_in == 0 ? any : best(state);
      const Branch branch = model_.step(state, 0, 0, action, next);
      if (branch.reward > 500.0F) return states;
      if (branch.terminal) break;
      states.push_back(next);
      state = next;
    }
    return {};
  }

 private:
  Action best(const RobotState& state) const {
    Action best = model_.legalActions(state).front();
    double least = 1e9;  // [m]
    for (const Action& action : model_.legalActions(state)) {
      RobotState next;
      if (model_.step(state, 0, 0, action, next).terminal) continue;
      RobotState ahead = next;  // of a base that goes on like this
      const double reach = scene_.model().step * next.speed;
      ahead.x += static_cast<float>(reach * next.direction_x);
      ahead.y += static_cast<float>(reach * next.direction_y);
      const double way =
          isClear(scene_, ahead) ? scene_.shortestWay()->lengthFrom(ahead.x, ahead.y) : 1e6;
      if (way >= least) continue;
      least = way;
      best = action;
    }
    return best;
  }

  const CrowdScene& scene_;
  CrowdModel model_;
};

// Nobody gets to the goal in less than the table says, and nobody who is clear of the obstacles
// gets into their margin on the way.
TEST_P(UpperBoundTest, NoDriveAroundWallsIsShorterThanTheTable) {
  ModelParams model = GetParam().model;
  if (model.upper_bound != UpperBoundKind::kTight) return;
  model.horizon = model.step;  // of roll-outs, which do not matter here
  const CrowdScene scene(model, {0, 1, false, 6, true});
  const CornerCutter cutter(scene);
  std::mt19937_64 random(3);
  int arrivals = 0;
  double closest = 100.0;
  for (int i = 0; i < 3000; ++i) {
    const auto drive = cutter.drive(scene.randomState(random), random);
    double way = 0.0;
    for (size_t k = drive.size(); k-- > 0;) {
      if (k + 1 < drive.size()) {
        way += lengthOf(model, drive[k], drive[k + 1]);
        ASSERT_TRUE(!isClear(scene, drive[k]) || isClear(scene, drive[k + 1]));
      }
      const float least = scene.shortestWay()->lengthFrom(drive[k].x, drive[k].y);
      ASSERT_LE(least, way) << i << ", step " << k;
      if (least > straightWay(scene, drive[k]) + 4.0F) closest = std::min(closest, way - least);
    }
    arrivals += drive.size() > 10 ? 1 : 0;
  }
  EXPECT_GT(arrivals, isCar(model) ? 500 : 1000);
  EXPECT_LT(closest, 2.6) << "of all that went round a wall";
}

TEST(UpperBound, KnowsWallsGivenTheTable) {
  for (const ModelParams& model : {paperModel(), rampedModel()}) {
    const CrowdScene scene(model, {0, 1, false, 6, true});
    const UpperBound blind(model, scene.field().goal());
    const UpperBound seeing(model, scene.field().goal(), scene.shortestWay());
    std::mt19937_64 random(5);
    double drop = 0.0;
    int behind = 0;
    for (int i = 0; i < 20000; ++i) {
      const RobotState state = scene.randomState(random);
      ASSERT_LE(seeing.value(state), blind.value(state));
      if (state.x > 9.0F || state.y > 9.0F || !isClear(scene, state)) continue;
      drop += blind.value(state) - seeing.value(state);
      ++behind;
    }
    EXPECT_GT(behind, 500);
    EXPECT_GT(drop / behind, 80.0);
  }
}

TEST(UpperBound, OfALongerWayIsThatOfARobotFartherAway) {
  for (const UpperBoundKind kind : {UpperBoundKind::kPaper, UpperBoundKind::kTight}) {
    const UpperBound bound(withBound(ModelParams(), kind), {10.0, 0.0});
    EXPECT_EQ(bound.value(robotAt(3.5, 1.0), 12.5F), bound.value(robotAt(-2.5, 1.0)));
    EXPECT_EQ(bound.value(robotAt(3.5, 1.0), 1.0F), bound.value(robotAt(3.5, 1.0)));
  }
}

TEST(UpperBound, HasATableOnlyWhereItHelps) {
  const CrowdScene open(paperModel(), {0, 1, false, 1});
  EXPECT_EQ(open.shortestWay(), nullptr);
  const CrowdScene paper(withBound(paperModel(), UpperBoundKind::kPaper), {0, 1, true, 1});
  EXPECT_EQ(paper.shortestWay(), nullptr);
  EXPECT_NE(CrowdScene(paperModel(), {0, 1, true, 1}).shortestWay(), nullptr);
}

INSTANTIATE_TEST_SUITE_P(EverySetting, UpperBoundTest, testing::ValuesIn(settings()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace pomdp_crowd_nav
