// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/path_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "crowd_scene.h"
#include "pomdp_crowd_nav/despot/search.h"

namespace pomdp_crowd_nav {
namespace {

// From the middle of the field, in legs of 1 m that turn a little each.
Path windingPath(double length) {
  std::vector<PathLeg> legs;
  for (int i = 0; i < static_cast<int>(length); ++i) {
    legs.push_back({0.2 + 0.3 * std::sin(0.8 * i), 0.0, 1.0});
  }
  return Path({12.0, 11.0}, legs);
}

struct Outcome {
  double reward = 0.0;
  bool terminal = false;
  double way = 0.0;
  double margin = std::numeric_limits<double>::infinity();  // [m], of the closest distance test
};

// The step as the facts sheet tells it, in double and with the path itself.
class Reference {
 public:
  Reference(const ModelParams& params, const Path& path, const CrowdFutures& futures)
      : p_(params), path_(path), futures_(futures) {}

  double speedAfter(double speed, const Action& action) const {
    const VehicleParams& v = p_.vehicle;
    if (action.sudden_brake) {
      return v.instant_velocity ? 0.0 : std::max(0.0, speed - v.brake_deceleration * p_.step);
    }
    return std::clamp(speed + action.speed_steps * p_.speedStep(), 0.0, v.max_speed);
  }

  Outcome step(double way, double speed, int scenario, int depth, const Action& action) const {
    return advance(way, speed, scenario, depth, speedAfter(speed, action),
                   action.sudden_brake ? p_.reward.sudden_brake : 0.0);
  }

  double rollOut(double way, double speed, int scenario, int depth, int policy,
                 double& margin) const {
    const double slow = policy == 0 ? p_.near_distance : p_.bold_distance;
    const double fast = policy == 0 ? p_.far_distance : p_.bold_distance;
    if (depth == futures_.depth()) return 0.0;
    const double distance = nearest(way, scenario, depth, 0.0);
    margin = std::min({margin, std::abs(distance - slow), std::abs(distance - fast)});
    double next = speed;
    if (distance < slow) next = std::max(0.0, speed - p_.speedStep());
    if (distance > fast) next = std::min(p_.vehicle.max_speed, speed + p_.speedStep());
    const Outcome outcome = advance(way, speed, scenario, depth, next, 0.0);
    margin = std::min(margin, outcome.margin);
    if (outcome.terminal) return outcome.reward;
    return outcome.reward +
           p_.discount() * rollOut(outcome.way, next, scenario, depth + 1, policy, margin);
  }

 private:
  double nearest(double way, int scenario, int depth, double share) const {
    double nearest = std::numeric_limits<double>::infinity();
    const auto* from = futures_.at(scenario, depth);
    const auto* to = futures_.at(scenario, depth + (share > 0.0 ? 1 : 0));
    for (int i = 0; i < futures_.personCount(); ++i) {
      const Point place =
          (1.0 - share) * Point(from[i].x, from[i].y) + share * Point(to[i].x, to[i].y);
      nearest = std::min(nearest, (place - path_.positionAt(way)).norm());
    }
    return nearest;
  }

  Outcome advance(double way, double speed, int scenario, int depth, double next,
                  double penalty) const {
    Outcome outcome;
    const double v_max = p_.vehicle.max_speed;
    outcome.reward =
        penalty + p_.step * (p_.reward.time + p_.reward.low_speed * (v_max - speed) / v_max);
    const auto driven = [&](double share) {
      const double mean = p_.vehicle.instant_velocity ? next : speed + 0.5 * share * (next - speed);
      return std::min(way + share * p_.step * mean, path_.length());
    };
    outcome.way = driven(1.0);
    if (way >= path_.length() - 1e-4) {
      outcome.reward += p_.reward.goal;
      outcome.terminal = true;
      return outcome;
    }
    const double clearance = p_.pedestrianClearance();
    bool collides = false;
    const auto look = [&](double at, double share) {
      const double distance = nearest(at, scenario, depth, share);
      outcome.margin = std::min(outcome.margin, std::abs(distance - clearance));
      collides = collides || distance <= clearance;
    };
    if (speed > 0.0) look(way, 0.0);
    const int tests = static_cast<int>(std::ceil(outcome.way - way - 1e-4));
    for (int k = 1; k <= tests; ++k) {
      const double share = static_cast<double>(k) / tests;
      look(driven(share), share);
    }
    outcome.terminal = collides;
    if (collides) outcome.reward += p_.reward.pedestrian;
    return outcome;
  }

  ModelParams p_;
  const Path& path_;
  const CrowdFutures& futures_;
};

class PathModelOfBothBases : public testing::TestWithParam<bool> {
 protected:
  ModelParams params_ = GetParam() ? paperModel() : rampedModel();
};

INSTANTIATE_TEST_SUITE_P(Bases, PathModelOfBothBases, testing::Bool(),
                         [](const auto& test) { return test.param ? "instant" : "ramped"; });

TEST_P(PathModelOfBothBases, StepsAndRollOutsAreThoseOfTheReference) {
  const CrowdScene scene(params_, {12, 8, false, 3});
  const Path path = windingPath(20.0);
  PathModel model(params_, scene.futures());
  model.setPath(path);
  const Reference reference(params_, path, scene.futures());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int collisions = 0;
  int arrivals = 0;
  int compared = 0;
  std::vector<Action> actions;
  for (int i = 0; i < 3000; ++i) {
    const bool is_whole = i % 2 == 0;
    const double way = is_whole ? std::floor(21.0 * unit(random)) : 20.0 * unit(random);
    const double speed = params_.speedStep() * std::floor(3.0 * unit(random));
    const int scenario = i % 8;
    const int depth = static_cast<int>(10.0 * unit(random));
    const PathState state{static_cast<float>(way), static_cast<float>(speed)};
    model.actions(state, actions);
    for (const Action& action : actions) {
      const Outcome expected = reference.step(way, speed, scenario, depth, action);
      if (expected.margin < 2e-2) continue;
      ++compared;
      PathState next;
      Branch branch = model.step(state, scenario, depth, action, next);
      ASSERT_NEAR(branch.reward, expected.reward, 1e-3);
      ASSERT_EQ(branch.terminal, expected.terminal);
      ASSERT_NEAR(next.way, expected.way, 1e-4);
      if (branch.terminal) {
        ++(branch.reward > 0.0F ? arrivals : collisions);
        continue;
      }
      EXPECT_EQ(branch.observation, scene.futures().observation(scenario, depth + 1));
      model.bound(next, scenario, depth + 1, branch);
      for (int p = 0; p < 2; ++p) {
        double margin = std::numeric_limits<double>::infinity();
        const double value = reference.rollOut(expected.way, reference.speedAfter(speed, action),
                                               scenario, depth + 1, p, margin);
        if (margin > 2e-2) {
          EXPECT_NEAR(branch.lower[p], value, 0.05 + 1e-4 * std::abs(value));
        }
        EXPECT_LE(value, branch.upper + 0.05);
      }
    }
  }
  EXPECT_GT(compared, 5000);
  EXPECT_GT(collisions, 100);
  EXPECT_GT(arrivals, 100);
}

// The best that can be done in one scenario whose future is known: all sequences of speeds.
double bestOf(const PathModel& model, const PathState& state, int scenario, int depth,
              const CrowdFutures& futures, double discount) {
  if (depth == futures.depth()) return 0.0;
  std::vector<Action> actions;
  model.actions(state, actions);
  double best = std::numeric_limits<double>::lowest();
  for (const Action& action : actions) {
    PathState next;
    const Branch branch = model.step(state, scenario, depth, action, next);
    double value = branch.reward;
    if (!branch.terminal) {
      value += discount * bestOf(model, next, scenario, depth + 1, futures, discount);
    }
    best = std::max(best, value);
  }
  return best;
}

TEST_P(PathModelOfBothBases, NoPolicyEarnsMoreThanTheUpperBound) {
  params_.horizon = 10.0 * params_.step;
  for (const UpperBoundKind kind : {UpperBoundKind::kPaper, UpperBoundKind::kTight}) {
    params_.upper_bound = kind;
    const CrowdScene scene(params_, {3, 4, false, 5});
    PathModel model(params_, scene.futures());
    for (const double length : {1.0, 3.0, 7.0}) {
      model.setPath(windingPath(length));
      for (const float speed : {0.0F, static_cast<float>(params_.speedStep())}) {
        Branch branch;
        model.bound({0.0F, speed}, 1, 0, branch);
        const double best = bestOf(model, {0.0F, speed}, 1, 0, scene.futures(), params_.discount());
        EXPECT_LE(best, branch.upper + 1e-2) << length;
        EXPECT_GE(best, std::max(branch.lower[0], branch.lower[1]) - 1e-2);
      }
    }
  }
}

// With one scenario the future is known, so the search can be compared with enumeration.
TEST_P(PathModelOfBothBases, TheSearchFindsTheBestSpeeds) {
  params_.horizon = 8.0 * params_.step;
  SearchParams search_params;
  search_params.scenarios = 1;
  search_params.max_depth = params_.depth();
  search_params.discount = params_.discount();
  search_params.regularization = 0.0;
  int different = 0;
  for (int seed = 1; seed <= 12; ++seed) {
    const CrowdScene scene(params_, {14, 1, false, static_cast<std::uint64_t>(seed)});
    PathModel model(params_, scene.futures());
    model.setPath(windingPath(4.0));
    Search<PathModel> search(search_params);
    const auto result = search.run(model, {PathState{}}, SearchLimit::trials(20000));
    const double best = bestOf(model, PathState{}, 0, 0, scene.futures(), params_.discount());
    EXPECT_NEAR(result.statistics.lower_bound, best, 0.05) << seed;
    EXPECT_EQ(result.statistics.bound_violations, 0);
    if (best > result.statistics.initial_lower_bound + 1.0) ++different;
  }
  EXPECT_GE(different, 1) << "the roll-outs alone are not the best in some scene";
}

TEST(PathModel, OffersEachChangeOfSpeedOnce) {
  const CrowdScene scene(paperModel(), {});
  PathModel model(paperModel(), scene.futures());
  model.setPath(windingPath(10.0));
  std::vector<Action> actions;
  model.actions({0.0F, 0.0F}, actions);
  EXPECT_EQ(actions, (std::vector<Action>{Action::followPrior(1), Action::followPrior(0)}));
  model.actions({0.0F, 1.0F}, actions);
  EXPECT_EQ(actions, (std::vector<Action>{Action::followPrior(1), Action::followPrior(0),
                                          Action::followPrior(-1)}));
  model.actions({0.0F, 2.0F}, actions);
  EXPECT_EQ(actions, (std::vector<Action>{Action::followPrior(0), Action::followPrior(-1),
                                          Action::suddenBrake()}));
}

// Somebody walks across the path just where a robot that starts now would be: waiting is right, and
// with nobody about it is not.
TEST(PathModel, TheSearchWaitsForWhoCrossesThePath) {
  ModelParams params = paperModel();
  CrowdScene scene(params, {0, 50, false, 1});
  SearchParams search_params;
  search_params.scenarios = 50;
  search_params.max_depth = params.depth();
  search_params.discount = params.discount();
  PathModel model(params, scene.futures());
  const Path path({12.0, 12.0}, std::vector<PathLeg>(20, PathLeg{0.0, 0.0, 1.0}));
  Search<PathModel> search(search_params);
  model.setPath(path);
  scene.draw({});
  EXPECT_EQ(search.run(model, {PathState{}}, SearchLimit::trials(200)).action.speed_steps, 1);
  IntentionBelief down(4);
  for (int i = 0; i < 200; ++i) {
    down.update({13.0, 15.0}, {12.7, 14.6}, {{0.0, 0.0}, {0.0, 30.0}, {40.0, 30.0}, {40.0, 0.0}});
  }
  scene.draw({{1, {14.0, 14.0}, {-0.7, -0.7}, 1.0, down}});
  EXPECT_EQ(search.run(model, {PathState{}}, SearchLimit::trials(200)).action.speed_steps, 0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
