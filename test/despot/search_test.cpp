// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/despot/search.h"

#include <gtest/gtest.h>

#include "models/corridor.h"
#include "models/every_policy.h"
#include "models/tiger.h"

namespace pomdp_crowd_nav {
namespace {

constexpr long kEnough = 20000;  // trials

SearchParams paramsFor(int scenarios, int depth, double discount) {
  SearchParams params;
  params.scenarios = scenarios;
  params.max_depth = depth;
  params.discount = discount;
  params.regularization = 0.0;
  return params;
}

// The first scenarios have the tiger on the left.
std::vector<Tiger::State> tigers(int count, double left_share) {
  std::vector<Tiger::State> states;
  for (int k = 0; k < count; ++k) {
    states.push_back(k < left_share * count - 0.5 ? Tiger::kTigerLeft : Tiger::kTigerRight);
  }
  return states;
}

// Value of an action of the tiger problem at belief `left` with `steps` left and the best actions
// to follow, by value iteration over exact beliefs.
double tigerActionValue(Tiger::Action action, double left, int steps, double discount);

double tigerValue(double left, int steps, double discount) {
  if (steps == 0) return 0.0;
  return std::max({tigerActionValue(Tiger::kListen, left, steps, discount),
                   tigerActionValue(Tiger::kOpenLeft, left, steps, discount),
                   tigerActionValue(Tiger::kOpenRight, left, steps, discount)});
}

double tigerActionValue(Tiger::Action action, double left, int steps, double discount) {
  if (action == Tiger::kOpenLeft) return left * Tiger::kMauled + (1.0 - left) * Tiger::kTreasure;
  if (action == Tiger::kOpenRight) return (1.0 - left) * Tiger::kMauled + left * Tiger::kTreasure;
  double value = Tiger::kListening;
  for (const double hears_left : {Tiger::kHearsRight, 1.0 - Tiger::kHearsRight}) {
    const double heard = left * hears_left + (1.0 - left) * (1.0 - hears_left);
    value += discount * heard * tigerValue(left * hears_left / heard, steps - 1, discount);
  }
  return value;
}

Tiger::Action bestOnTiger(double left) {
  Tiger::Action best = Tiger::kListen;
  for (const auto action : {Tiger::kOpenLeft, Tiger::kOpenRight}) {
    if (tigerActionValue(action, left, 5, 0.95) > tigerActionValue(best, left, 5, 0.95)) {
      best = action;
    }
  }
  return best;
}

SearchResult<Tiger::Action> searchTiger(double left_share, int scenarios = 400) {
  const Tiger tiger{Tiger::Params()};
  Search<Tiger> search(paramsFor(scenarios, 5, 0.95));
  return search.run(tiger, tigers(scenarios, left_share), SearchLimit::trials(kEnough));
}

TEST(SearchOnTiger, ListensWhileTheTigerMayBeAnywhere) {
  const auto result = searchTiger(0.5);
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
  EXPECT_EQ(result.action, Tiger::kListen);
  EXPECT_FALSE(result.from_default);
  ASSERT_GE(result.plan.size(), 2U);
  EXPECT_EQ(result.plan.front(), Tiger::kListen);
}

TEST(SearchOnTiger, OpensTheOtherDoorWhenSure) {
  EXPECT_EQ(searchTiger(0.99).action, Tiger::kOpenRight);
  EXPECT_EQ(searchTiger(0.01).action, Tiger::kOpenLeft);
  EXPECT_EQ(searchTiger(1.0).action, Tiger::kOpenRight);
  EXPECT_EQ(searchTiger(0.0).action, Tiger::kOpenLeft);
}

TEST(SearchOnTiger, DoesWhatValueIterationDoes) {
  for (const double left : {0.01, 0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.95, 0.99}) {
    EXPECT_EQ(searchTiger(left).action, bestOnTiger(left)) << "tiger left with " << left;
  }
  EXPECT_EQ(bestOnTiger(0.5), Tiger::kListen);
  EXPECT_EQ(bestOnTiger(0.99), Tiger::kOpenRight);
}

// Ten sets of scenarios: the mean of their optima is near the problem's, a little above it,
// because each policy is fitted to its scenarios.
TEST(SearchOnTiger, ValueIsThatOfExactValueIteration) {
  const double exact = tigerValue(0.5, 5, 0.95);
  double mean = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Tiger tiger({0.95, 5, seed});
    Search<Tiger> search(paramsFor(1000, 5, 0.95));
    const auto result = search.run(tiger, tigers(1000, 0.5), SearchLimit::trials(kEnough));
    mean += result.statistics.lower_bound / 10.0;
  }
  EXPECT_NEAR(mean, exact, 0.8);
  EXPECT_GT(exact, 2.0) << "listening for ever is worth -4.5";
}

TEST(SearchOnTiger, ClosedBoundsAreTheOptimumOverTheScenarios) {
  for (const double lambda : {0.0, 0.01, 0.1, 0.5, 2.0, 20.0}) {
    for (const double left : {0.5, 0.7, 0.97}) {
      SearchParams params = paramsFor(60, 5, 0.95);
      params.regularization = lambda;
      const Tiger tiger{Tiger::Params()};
      const double optimum = EveryPolicy<Tiger>(tiger, params).optimum(tigers(60, left));
      Search<Tiger> search(params);
      const auto result = search.run(tiger, tigers(60, left), SearchLimit::trials(kEnough));
      EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed) << lambda << ", " << left;
      EXPECT_NEAR(result.statistics.lower_bound, optimum, 1e-4) << lambda << ", " << left;
      EXPECT_NEAR(result.statistics.upper_bound, optimum, 1e-4) << lambda << ", " << left;
    }
  }
}

TEST(SearchOnCorridor, ClosedBoundsAreTheOptimumOverTheScenarios) {
  for (const double lambda : {0.0, 0.01, 0.1, 0.4, 0.8, 1.2, 2.0, 20.0}) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SearchParams params = paramsFor(seed < 4 ? 20 : 3, 5, 0.9);
      params.regularization = lambda;
      Corridor::Params corridor;
      corridor.seed = seed;
      const Corridor model(corridor);
      const EveryPolicy<Corridor> every_policy(model, params);
      const double optimum = every_policy.optimum({{0}});
      Search<Corridor> search(params);
      const auto result = search.run(model, {{0}}, SearchLimit::trials(kEnough));
      EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed) << lambda << ", " << seed;
      EXPECT_NEAR(result.statistics.lower_bound, optimum, 1e-4) << lambda << ", " << seed;
      EXPECT_NEAR(result.statistics.upper_bound, optimum, 1e-4) << lambda << ", " << seed;
      if (lambda == 0.0) {
        EXPECT_NEAR(every_policy.valueOf(result.action, {{0}}), optimum, 1e-4) << seed;
      }
    }
  }
}

TEST(SearchOnCorridor, BoundsEncloseTheOptimumAfterEveryTrial) {
  SearchParams params = paramsFor(20, 5, 0.9);
  params.regularization = 0.05;
  const Corridor model{Corridor::Params()};
  const double optimum = EveryPolicy<Corridor>(model, params).optimum({{0}});
  Search<Corridor> search(params);
  for (long trials = 0; trials < 60; ++trials) {
    const auto result = search.run(model, {{0}}, SearchLimit::trials(trials));
    EXPECT_LE(result.statistics.lower_bound, optimum + 1e-4) << trials;
    EXPECT_GE(result.statistics.upper_bound, optimum - 1e-4) << trials;
  }
}

TEST(SearchOnCorridor, ABeliefIsWorthItsBetterDefaultPolicy) {
  Corridor::Params one;
  one.has_second_policy = false;
  SearchParams params = paramsFor(20, 5, 0.9);
  params.regularization = 50.0;  // no policy of its own pays
  Search<Corridor> search(params);
  const auto stays = search.run(Corridor(one), {{0}}, SearchLimit::trials(kEnough));
  const auto walks = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(kEnough));
  const double standing = -(1.0 - std::pow(0.9, 5)) / 0.1;
  EXPECT_LE(stays.statistics.lower_bound, standing + 1e-4);
  EXPECT_GT(walks.statistics.lower_bound, stays.statistics.lower_bound + 1.0);
}

// A bound that allows for the reward one step late only: the search must not stop before it has
// seen that the step after arrival pays.
TEST(SearchOnCorridor, TheGoalPaysTheStepAfterArrival) {
  Corridor::Params corridor;
  corridor.horizon = Corridor::kGoal + 1;
  SearchParams params = paramsFor(1, corridor.horizon, 0.9);
  const Corridor model(corridor);
  Search<Corridor> search(params);
  const auto result = search.run(model, {{Corridor::kGoal}}, SearchLimit::trials(kEnough));
  EXPECT_NEAR(result.statistics.lower_bound, Corridor::kArrival + Corridor::kWaiting, 1e-4);
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);

  // One cell before it with a single step left, arriving is worth nothing more than standing.
  SearchParams short_params = paramsFor(1, 1, 0.9);
  corridor.horizon = 1;
  Search<Corridor> short_search(short_params);
  const auto late =
      short_search.run(Corridor(corridor), {{Corridor::kGoal - 1}}, SearchLimit::trials(kEnough));
  EXPECT_LT(late.statistics.lower_bound, 0.0);
  EXPECT_EQ(late.statistics.bound_violations, 0);
}

// ---- What a search must do at the edges of its parameters ------------------------------------

TEST(Search, UtilityBoundIsFormedWithoutRegularisation) {
  SearchParams params = paramsFor(20, 5, 0.9);
  params.regularization = 0.2;
  const Corridor model{Corridor::Params()};
  Search<Corridor> search(params);
  search.run(model, {{0}}, SearchLimit::trials(kEnough));
  SearchParams plain = params;
  plain.regularization = 0.0;
  const double best_utility = EveryPolicy<Corridor>(model, plain).optimum({{0}});
  const double best_regularised = EveryPolicy<Corridor>(model, params).optimum({{0}});
  ASSERT_GT(best_utility, best_regularised + 0.4);
  EXPECT_GE(search.tree().beliefs[0].utility_upper, best_utility - 1e-4)
      << "U must not carry the cost of policy nodes";
}

TEST(Search, OverwhelmingRegularisationKeepsTheDefaultPolicy) {
  SearchParams params = paramsFor(20, 5, 0.9);
  params.regularization = 1000.0;
  Search<Corridor> search(params);
  const Corridor model{Corridor::Params()};
  const auto result = search.run(model, {{0}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
  EXPECT_EQ(result.statistics.lower_bound, result.statistics.initial_lower_bound);
  EXPECT_EQ(result.statistics.upper_bound, result.statistics.initial_lower_bound);
}

TEST(Search, WithoutATrialTheRootIsExpandedOnce) {
  Search<Corridor> search(paramsFor(20, 5, 0.9));
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(0));
  EXPECT_EQ(result.statistics.trials, 0);
  EXPECT_EQ(result.statistics.expansions, 1);
  EXPECT_EQ(result.statistics.stop, SearchStop::kTrialLimit);
  EXPECT_FALSE(result.from_default);
  EXPECT_NE(result.action, Corridor::kBack) << "not legal in the first cell";
}

// Lower bounds are what a policy is known to earn.
TEST(Search, TakesTheActionOfTheBestLowerBound) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Corridor::Params corridor;
    corridor.seed = seed;
    Search<Corridor> search(paramsFor(20, 5, 0.9));
    for (long trials = 0; trials < 20; ++trials) {
      const auto result = search.run(Corridor(corridor), {{1}}, SearchLimit::trials(trials));
      const auto& tree = search.tree();
      const BeliefNode& root = tree.beliefs[0];
      float best = -1e9F;
      float taken = 0.0F;
      for (int a = root.first_action; a < root.first_action + root.action_count; ++a) {
        best = std::max(best, tree.action_nodes[a].lower);
        if (tree.actions[a] == result.action) taken = tree.action_nodes[a].lower;
      }
      ASSERT_EQ(taken, best) << "seed " << seed << ", trial " << trials;
    }
  }
}

TEST(Search, WithoutDepthTheDefaultActionIsTaken) {
  Search<Corridor> search(paramsFor(20, 0, 0.9));
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(kEnough));
  EXPECT_TRUE(result.from_default);
  EXPECT_EQ(result.action, Corridor::kStay);
  EXPECT_EQ(result.plan, std::vector<Corridor::Action>{Corridor::kStay});
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
  EXPECT_EQ(result.statistics.expansions, 0);
}

TEST(Search, DeadlineInThePastStillGivesALegalAction) {
  Search<Corridor> search(paramsFor(20, 5, 0.9));
  const auto past = SearchLimit::Clock::now() - std::chrono::seconds(1);
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::until(past));
  EXPECT_EQ(result.statistics.stop, SearchStop::kDeadline);
  EXPECT_EQ(result.statistics.trials, 0);
  EXPECT_NE(result.action, Corridor::kBack);
}

TEST(Search, AClosedRootIsExpandedToFindItsAction) {
  Corridor::Params corridor;
  corridor.upper = -100.0F;  // below the default policy: the root's bounds meet at once
  Search<Corridor> search(paramsFor(1, 5, 0.9));
  const auto result =
      search.run(Corridor(corridor), {{Corridor::kGoal}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
  EXPECT_EQ(result.statistics.trials, 0);
  EXPECT_FALSE(result.from_default);
}

TEST(Search, BoundViolationsAreCounted) {
  Corridor::Params corridor;
  corridor.upper = -3.0F;
  SearchParams params = paramsFor(20, 5, 0.9);
  Search<Corridor> search(params);
  const auto result = search.run(Corridor(corridor), {{0}}, SearchLimit::trials(50));
  EXPECT_GT(result.statistics.bound_violations, 0);
  for (const BeliefNode& node : search.tree().beliefs) EXPECT_LE(node.lower, node.upper);

  const auto honest = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(50));
  EXPECT_EQ(honest.statistics.bound_violations, 0);
}

// One action, after which every scenario is told from the others and claims too much.
struct Overrated {
  struct State {};
  struct Action {};
  static constexpr bool kSharesState = true;
  void actions(const State&, std::vector<Action>& out) const { out.resize(1); }
  Branch step(const State&, int scenario, int, const Action&, State&) const {
    Branch branch;
    branch.observation = static_cast<std::uint64_t>(scenario);
    return branch;
  }
  void bound(const State&, int, int, Branch& branch) const { branch.upper = -0.01F; }
  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<Overrated>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }
  void rootBounds(const State*, const int*, int, double&, double& upper) const { upper = 1.0; }
  Action defaultAction(const State*) const { return {}; }
};

// However small the leaf's share in the root's value.
TEST(Search, SmallBoundViolationsOfSmallLeavesAreCounted) {
  Search<Overrated> search(paramsFor(1000, 10, 0.5));
  const auto result = search.run(Overrated(), {{}}, SearchLimit::trials(0));
  EXPECT_EQ(result.statistics.bound_violations, 1000);
}

// Claims to be worth no more than 0 at the start, which the steps below it refute.
class Understated : public Corridor {
 public:
  using Corridor::Corridor;
  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<Understated>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }
  void rootBounds(const State* states, const int* scenarios, int count, double& lower,
                  double& upper) const {
    Corridor::rootBounds(states, scenarios, count, lower, upper);
    upper = lower + 0.5;
  }
};

TEST(Search, BoundViolationsThatComeUpLaterAreCounted) {
  const Understated model{Corridor::Params()};
  Search<Understated> search(paramsFor(20, 5, 0.9));
  const auto result = search.run(model, {{0}}, SearchLimit::trials(kEnough));
  EXPECT_GE(result.statistics.bound_violations, 1);
  EXPECT_LE(result.statistics.lower_bound, result.statistics.upper_bound);
  Search<Corridor> sound(paramsFor(20, 5, 0.9));
  const auto right = sound.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(right.statistics.bound_violations, 0);
}

TEST(Search, StopsAtTheNodeLimit) {
  SearchParams params = paramsFor(50, 5, 0.9);
  params.max_nodes = 100;
  Search<Corridor> search(params);
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(result.statistics.stop, SearchStop::kNodeLimit);
  // Three actions and four observations.
  EXPECT_LE(search.tree().beliefs.size(), 100U + 12U);
  EXPECT_EQ(result.statistics.belief_nodes + 1, static_cast<long>(search.tree().beliefs.size()));
  EXPECT_LT(result.statistics.lower_bound, result.statistics.upper_bound);
}

TEST(Search, ANodeLimitOfOneStillGivesAnAction) {
  SearchParams params = paramsFor(50, 5, 0.9);
  params.max_nodes = 1;
  Search<Corridor> search(params);
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(result.statistics.stop, SearchStop::kNodeLimit);
  EXPECT_EQ(result.statistics.trials, 0);
}

TEST(Search, StopsAtTheMemoryLimit) {
  Corridor::Params corridor;
  corridor.horizon = 25;
  SearchParams params = paramsFor(200, 25, 0.9);
  params.max_memory = 0.05;
  Search<Corridor> search(params);
  const auto result = search.run(Corridor(corridor), {{0}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(result.statistics.stop, SearchStop::kNodeLimit);
  EXPECT_GE(result.statistics.tree_bytes, 50000);
  EXPECT_LE(result.statistics.tree_bytes, 70000) << "one expansion more";
  EXPECT_EQ(result.statistics.tree_bytes, static_cast<long>(search.tree().bytes()));
}

TEST(Search, StopsAtTheLowerBoundThatWasAskedFor) {
  SearchLimit limit = SearchLimit::trials(kEnough);
  Search<Corridor> search(paramsFor(50, 5, 0.9));
  const Corridor model{Corridor::Params()};
  const double best = search.run(model, {{0}}, limit).statistics.lower_bound;
  limit.lower_bound = best - 0.5;
  const auto result = search.run(model, {{0}}, limit);
  EXPECT_EQ(result.statistics.stop, SearchStop::kLowerBound);
  EXPECT_GE(result.statistics.lower_bound, best - 0.5);
  EXPECT_LT(result.statistics.lower_bound, best);
}

TEST(Search, EndsByTheDeadline) {
  // Too many histories to close in the time.
  Corridor::Params corridor;
  corridor.horizon = 25;
  corridor.discount = 0.99;
  const Corridor model(corridor);
  Search<Corridor> search(paramsFor(500, 25, 0.99));
  const auto start = SearchLimit::Clock::now();
  const auto result =
      search.run(model, {{0}}, SearchLimit::until(start + std::chrono::milliseconds(100)));
  const double elapsed = std::chrono::duration<double>(SearchLimit::Clock::now() - start).count();
  EXPECT_EQ(result.statistics.stop, SearchStop::kDeadline);
  EXPECT_GT(result.statistics.trials, 1);
  EXPECT_LT(elapsed, 0.120 + 0.5) << "half a second for a busy machine";
}

TEST(Search, StopsAtTheTrialLimit) {
  Search<Corridor> search(paramsFor(20, 5, 0.9));
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(17));
  EXPECT_EQ(result.statistics.stop, SearchStop::kTrialLimit);
  EXPECT_EQ(result.statistics.trials, 17);
}

// A trial that changes nothing would be repeated for ever.
TEST(Search, WithoutALimitItEndsWithAClosedGap) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Corridor::Params corridor;
    corridor.seed = seed;
    SearchParams params = paramsFor(30, 5, 0.9);
    params.regularization = 0.01;
    Search<Corridor> search(params);
    const auto result = search.run(Corridor(corridor), {{0}}, SearchLimit::trials(1000000));
    ASSERT_EQ(result.statistics.stop, SearchStop::kGapClosed) << seed;
    EXPECT_EQ(result.statistics.gap(), 0.0);
  }
}

TEST(Search, CountsItsModelSteps) {
  Search<Corridor> search(paramsFor(20, 5, 0.9));
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(40));
  long steps = 0;
  for (const BeliefNode& node : search.tree().beliefs) {
    if (!node.isLeaf()) steps += static_cast<long>(node.action_count) * node.scenario_count;
  }
  EXPECT_EQ(result.statistics.model_steps, steps);
}

TEST(Search, RejectsParametersOutOfRange) {
  EXPECT_THROW(Search<Tiger>(paramsFor(0, 5, 0.9)), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
