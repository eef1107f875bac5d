// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "models/every_policy.h"
#include "models/rock_sample_belief.h"
#include "tree_checks.h"

namespace pomdp_crowd_nav {
namespace {

using Action = RockSampleAction;
using State = RockSample::State;

const RockSampleTables& sevenEight() {
  static const RockSampleTables tables{RockSampleMap()};
  return tables;
}

RockSampleMap smallMap() {
  RockSampleMap map;
  map.size = 4;
  map.start = {0, 1};
  map.rocks = {{1, 3}, {2, 1}, {3, 0}};
  map.half_efficiency_distance = 2.0;
  return map;
}

const RockSampleTables& small() {
  static const RockSampleTables tables{smallMap()};
  return tables;
}

SearchParams paramsFor(int scenarios, int depth, double regularization = 0.01) {
  SearchParams params;
  params.scenarios = scenarios;
  params.max_depth = depth;
  params.discount = 0.95;
  params.regularization = regularization;
  return params;
}

State at(const RockSampleMap& map, int x, int y, int good = 0) {
  State state;
  state.cell = static_cast<std::uint8_t>(map.index({x, y}));
  state.good = static_cast<std::uint8_t>(good);
  return state;
}

Branch take(const RockSample& model, State& state, int action, int scenario = 0, int depth = 0) {
  const State before = state;
  return model.step(before, scenario, depth, action, state);
}

TEST(RockSampleModel, OffersWhatIsLegal) {
  const RockSample model(sevenEight(), 1);
  std::vector<int> actions;
  model.actions(at(model.map(), 0, 3), actions);
  EXPECT_EQ(actions, (std::vector<int>{0, 1, 2, 5, 6, 7, 8, 9, 10, 11, 12}));
  model.actions(at(model.map(), 2, 0), actions);  // a rock at the south edge
  EXPECT_EQ(actions, (std::vector<int>{0, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  model.actions(at(model.map(), 6, 6), actions);
  EXPECT_EQ(actions, (std::vector<int>{1, 2, 3, 5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST(RockSampleModel, PaysForGoodRocksAndForLeaving) {
  const RockSample model(sevenEight(), 1);
  State state = at(model.map(), 6, 3, 1 << 3);
  EXPECT_EQ(take(model, state, Action::kSample).reward, 10.0F);
  EXPECT_EQ(state.good, 0) << "a sampled rock is worth nothing";
  EXPECT_EQ(take(model, state, Action::kSample).reward, -10.0F);
  State on_bad = at(model.map(), 3, 1, 0xFB);
  EXPECT_EQ(take(model, on_bad, Action::kSample).reward, -10.0F);
  EXPECT_EQ(take(model, state, Action::kCheck).reward, 0.0F);
  const Branch leaves = take(model, state, Action::kEast);
  EXPECT_EQ(leaves.reward, 10.0F);
  EXPECT_TRUE(leaves.terminal);
}

TEST(RockSampleModel, IllegalActionsCostAndDoNothing) {
  const RockSample model(sevenEight(), 1);
  State state = at(model.map(), 0, 0, 0xFF);
  for (const int action : {Action::kWest, Action::kSouth, Action::kSample}) {
    const Branch branch = take(model, state, action);
    EXPECT_EQ(branch.reward, -100.0F);
    EXPECT_FALSE(branch.terminal);
    EXPECT_EQ(state.cell, 0);
    EXPECT_EQ(state.good, 0xFF);
  }
  EXPECT_EQ(take(model, state, Action::kNorth).reward, 0.0F);
  EXPECT_EQ(state.cell, model.map().index({0, 1}));
}

TEST(RockSampleModel, TheSensorErrsMoreFromAfar) {
  const RockSampleMap map;
  EXPECT_DOUBLE_EQ(map.accuracy(map.index({2, 0}), 0), 1.0);
  EXPECT_NEAR(map.accuracy(map.index({6, 3}), 0), 0.5 * (1.0 + std::pow(0.5, 0.25)), 1e-12);
  EXPECT_NEAR(map.accuracy(map.index({3, 1}), 3), 0.9412, 1e-4);  // sqrt(13) cells
}

TEST(RockSampleModel, ChecksTellTheTruthAsOftenAsTheSensorDoes) {
  const RockSample model(small(), 5);
  constexpr int kDraws = 40000;
  for (const int good : {0, 1}) {
    int truths = 0;
    for (int k = 0; k < kDraws; ++k) {
      State state = at(model.map(), 3, 0, good);
      const Branch branch = take(model, state, Action::kCheck, k, 7);
      truths += (branch.observation == RockSample::kLooksGood) == (good == 1) ? 1 : 0;
    }
    const double truth = model.map().accuracy(3, 0);  // sqrt(13) cells away
    EXPECT_NEAR(truth, 0.6433, 1e-4);
    EXPECT_NEAR(truths / static_cast<double>(kDraws), truth, 0.01);
  }
}

// Best value of fetching rocks of `good` in any order and leaving, by trying every order.
double bestTour(const RockSampleMap& map, int x, int y, int good) {
  double best = 10.0 * std::pow(map.discount, map.size - 1 - x);
  for (int r = 0; r < map.rockCount(); ++r) {
    if ((good >> r & 1) == 0) continue;
    const int way = std::abs(map.rocks[r].x - x) + std::abs(map.rocks[r].y - y);
    const double rest = bestTour(map, map.rocks[r].x, map.rocks[r].y, good & ~(1 << r));
    best = std::max(best, std::pow(map.discount, way) * (10.0 + map.discount * rest));
  }
  return best;
}

TEST(RockSampleBounds, TheUpperBoundIsTheBestOfAllTours) {
  const RockSampleMap map = smallMap();
  for (int cell = 0; cell < map.cellCount(); ++cell) {
    for (int good = 0; good < 8; ++good) {
      const double best = bestTour(map, cell % map.size, cell / map.size, good);
      ASSERT_NEAR(small().plans.value(cell, good), best, 1e-4) << cell << ", " << good;
    }
  }
  EXPECT_NEAR(sevenEight().plans.value(21, 0xFF), bestTour(RockSampleMap(), 0, 3, 0xFF), 1e-4);
}

// Discounted return of fetching (or inspecting) `wanted` with the model's own steps.
double rollOut(const RockSampleTables& tables, State state, int wanted, bool inspects) {
  const RockSample model(tables, 1);
  double value = 0.0;
  double discount = 1.0;
  for (int depth = 0; depth < 100; ++depth, discount *= model.map().discount) {
    const int cell = state.cell;
    int action =
        inspects ? tables.inspection.action(cell, wanted) : tables.plans.action(cell, wanted);
    if (action == Action::kSample) {
      const int rock = model.map().rockAt(cell);
      wanted &= ~(1 << rock);
      if (inspects) {
        const bool good =
            take(model, state, Action::kCheck + rock).observation == RockSample::kLooksGood;
        discount *= model.map().discount;
        if (!good) {
          discount /= model.map().discount;
          continue;
        }
      }
    }
    const Branch branch = take(model, state, action);
    value += discount * static_cast<double>(branch.reward);
    if (branch.terminal) return value;
  }
  return -1e9;
}

TEST(RockSampleBounds, ALowerBoundIsWhatItsPolicyEarns) {
  const RockSampleMap map = smallMap();
  for (int i = 0; i < map.cellCount() * 64; ++i) {
    const int cell = i / 64;
    const int wanted = i / 8 % 8;
    const int good = i % 8;
    const State state = at(map, cell % map.size, cell / map.size, good);
    ASSERT_NEAR(small().plans.valueIf(cell, wanted, good), rollOut(small(), state, wanted, false),
                1e-4);
    ASSERT_NEAR(small().inspection.value(cell, wanted, good), rollOut(small(), state, wanted, true),
                1e-4);
  }
}

TEST(RockSampleBounds, NoLowerBoundIsAboveTheUpper) {
  const RockSample model(sevenEight(), 1);
  const NoiseStreams noise(3);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = noise.bits(i, 0, 0);
    State state = at(model.map(), static_cast<int>(bits % 7), static_cast<int>(bits / 7 % 7),
                     static_cast<int>(bits >> 32 & 0xFF));
    for (int r = 0; r < 8; ++r) {
      state.log_odds[r] = static_cast<std::int8_t>((noise.bits(i, 1, r) >> 20) % 21) - 10;
    }
    Branch branch;
    model.bound(state, 0, 0, branch);
    for (const float lower : branch.lower) ASSERT_LE(lower, branch.upper + 1e-4F);
  }
}

TEST(RockSampleBelief, FollowsBayes) {
  const RockSample model(small(), 1);
  RockSampleBelief belief(model);
  belief.update(model, Action::kEast, RockSample::kNothing);
  EXPECT_EQ(belief.cell(), model.map().index({1, 1}));
  belief.update(model, Action::kCheck + 1, RockSample::kLooksGood);  // one cell away
  const double near = 0.5 * (1.0 + std::sqrt(0.5));
  EXPECT_NEAR(belief.probabilityOfGood(1), near, 1e-12);
  belief.update(model, Action::kCheck + 1, RockSample::kLooksGood);
  EXPECT_NEAR(belief.probabilityOfGood(1), near * near / (near * near + (1 - near) * (1 - near)),
              1e-12);
  belief.update(model, Action::kCheck, RockSample::kLooksBad);  // two cells away
  EXPECT_NEAR(belief.probabilityOfGood(0), 0.25, 1e-12);
  EXPECT_EQ(belief.probabilityOfGood(2), 0.5);
  double sum = 0.0;
  double both_good = 0.0;
  for (const auto& entry : belief.states()) {
    sum += entry.weight;
    if ((entry.state.good & 3) == 3) both_good += entry.weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(both_good, 0.25 * belief.probabilityOfGood(1), 1e-12);
  belief.update(model, Action::kEast, RockSample::kNothing);
  belief.update(model, Action::kSample, RockSample::kNothing);
  EXPECT_EQ(belief.probabilityOfGood(1), 0.0);
}

// What a scenario's state remembers of its history is the belief, rounded.
TEST(RockSampleBelief, AgreesWithTheHistoryInTheState) {
  const RockSample model(sevenEight(), 1);
  const NoiseStreams noise(11);
  RockSampleBelief belief(model);
  State state = belief.states()[0xA5].state;
  for (int depth = 0; depth < 40; ++depth) {
    std::vector<int> actions;
    model.actions(state, actions);
    const int action = actions[noise.bits(0, depth, 0) % actions.size()];
    const Branch branch = take(model, state, action, 0, depth);
    if (branch.terminal) break;
    belief.update(model, action, branch.observation);
    ASSERT_EQ(state.cell, belief.cell());
    for (int r = 0; r < 8; ++r) {
      const double odds = belief.probabilityOfGood(r) / (1.0 - belief.probabilityOfGood(r));
      const double limit = RockSample::kCertain * RockSample::kEvidenceUnit;
      const double exact = std::clamp(std::log(odds), -limit, limit);
      ASSERT_NEAR(state.log_odds[r] * RockSample::kEvidenceUnit, exact, 2.0) << r;
    }
  }
}

std::vector<State> startStates(const RockSample& model, int count) {
  return drawStates(RockSampleBelief(model).states(), count, 0.5);
}

TEST(SearchOnRockSample, FindsTheOptimumOverAllPolicies) {
  for (const double regularization : {0.0, 0.05}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const RockSample model(small(), seed, Defaults::kPlain);
      const SearchParams params = paramsFor(16, 4, regularization);
      Search<RockSample> search(params);
      const auto states = startStates(model, params.scenarios);
      const auto result = search.run(model, states, SearchLimit::trials(100000));
      EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
      EXPECT_NEAR(result.statistics.lower_bound,
                  EveryPolicy<RockSample>(model, params).optimum(states), 1e-4);
      EXPECT_GT(result.statistics.lower_bound, result.statistics.initial_lower_bound + 0.5);
    }
  }
}

struct Bracket {
  double lower;
  double upper;
};

Bracket valueOf(const RockSample& model, const RockSampleBelief& belief, int steps);

// Of an action, by the exact belief and not by scenarios. The observation is that of a check.
Bracket valueAfter(const RockSample& model, const RockSampleBelief& belief, int action, int steps) {
  double reward = 0.0;
  bool terminal = false;
  for (const auto& entry : belief.states()) {
    State state = entry.state;
    const Branch branch = take(model, state, action);
    reward += entry.weight * static_cast<double>(branch.reward);
    terminal = branch.terminal;
  }
  if (terminal) return {reward, reward};
  Bracket value{reward, reward};
  const int rock = action - Action::kCheck;
  const double truth = rock < 0 ? 1.0 : model.map().accuracy(belief.cell(), rock);
  const double good = rock < 0 ? 1.0 : belief.probabilityOfGood(rock);
  const double looks_good = good * truth + (1.0 - good) * (1.0 - truth);
  for (const bool looks : {true, false}) {
    const double share = looks ? looks_good : 1.0 - looks_good;
    if (share <= 0.0) continue;
    RockSampleBelief next = belief;
    next.update(model, action, looks ? RockSample::kLooksGood : RockSample::kLooksBad);
    const Bracket later = valueOf(model, next, steps - 1);
    value.lower += model.map().discount * share * later.lower;
    value.upper += model.map().discount * share * later.upper;
  }
  return value;
}

// What the best policy earns lies between the two.
Bracket valueOf(const RockSample& model, const RockSampleBelief& belief, int steps) {
  Bracket best{0.0, 0.0};
  if (steps == 0) {
    std::array<double, kDefaultPolicies> lower{};
    for (const auto& entry : belief.states()) {
      Branch branch;
      model.bound(entry.state, 0, 0, branch);
      for (int p = 0; p < kDefaultPolicies; ++p) lower[p] += entry.weight * branch.lower[p];
      best.upper += entry.weight * branch.upper;
    }
    best.lower = *std::max_element(lower.begin(), lower.end());
    return best;
  }
  std::vector<int> actions;
  model.actions(belief.states()[0].state, actions);
  for (const int action : actions) {
    const Bracket value = valueAfter(model, belief, action, steps);
    best.lower = std::max(best.lower, value.lower);
    best.upper = std::max(best.upper, value.upper);
  }
  return best;
}

// With the depth of the recursion and more scenarios than it has histories.
TEST(SearchOnRockSample, FindsTheValueOfTheExactBelief) {
  const RockSample model(small(), 1, Defaults::kPlain);
  const Bracket exact = valueOf(model, RockSampleBelief(model), 5);
  Search<RockSample> search(paramsFor(4000, 5, 0.0));
  const auto states = startStates(model, 4000);
  const auto start = search.run(model, states, SearchLimit::trials(0)).statistics;
  EXPECT_LT(start.initial_lower_bound, exact.lower - 1.0);
  EXPECT_GT(start.initial_upper_bound, exact.upper + 1.0);
  const auto end = search.run(model, states, SearchLimit::trials(1000)).statistics;
  EXPECT_NEAR(end.lower_bound, exact.lower, 0.15);
  EXPECT_GT(end.upper_bound, exact.lower);
  EXPECT_LT(end.upper_bound, exact.upper);
}

TEST(SearchOnRockSample, KeepsItsBoundsInOrder) {
  for (const Defaults defaults : {Defaults::kPlain, Defaults::kSmart}) {
    const RockSample model(sevenEight(), 2, defaults);
    Search<RockSample> search(paramsFor(200, 90));
    const auto result = search.run(model, startStates(model, 200), SearchLimit::trials(100));
    EXPECT_EQ(result.statistics.bound_violations, 0);
    EXPECT_GT(result.statistics.lower_bound, result.statistics.initial_lower_bound);
    EXPECT_LT(result.statistics.upper_bound, result.statistics.initial_upper_bound);
    expectOrderedBounds(search);
    expectOneDefaultActionInEachBelief(search, model);
  }
}

TEST(SearchOnRockSample, SameSeedSameTree) {
  std::vector<std::vector<std::vector<float>>> trees;
  Search<RockSample> search(paramsFor(200, 90));
  for (const std::uint64_t seed : {4, 5, 4}) {
    const RockSample model(sevenEight(), seed);
    search.run(model, startStates(model, 200), SearchLimit::trials(50));
    trees.push_back(describeTree(search));
  }
  EXPECT_EQ(trees[0], trees[2]);
  EXPECT_NE(trees[0], trees[1]);
}

// Leaving straight away, which is all that the plain default policies know, earns 7.35; the
// published optimum is about 21.5.
TEST(SearchOnRockSample, EarnsMuchMoreThanItsDefaultPolicies) {
  const auto make = [](std::uint64_t seed) {
    return RockSample(sevenEight(), seed, Defaults::kPlain);
  };
  Search<RockSample> search(paramsFor(100, 90));
  const Episodes episodes = playEpisodes<RockSampleBelief>(search, make, 20, 15);
  EXPECT_GT(episodes.mean_return, 16.0);
  EXPECT_EQ(episodes.bound_violations, 0);
  EXPECT_EQ(episodes.unfinished, 0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
