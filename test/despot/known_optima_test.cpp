// SPDX-License-Identifier: BSD-3-Clause
// Problems whose optimum is known: by value iteration, or over the scenarios by trying every
// policy.
#include <gtest/gtest.h>

#include "models/corridor.h"
#include "models/every_policy.h"
#include "models/tiger.h"
#include "plain_search.h"
#include "pomdp_crowd_nav/despot/search.h"

namespace pomdp_crowd_nav {
namespace {

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
  Search<Tiger> search(plainSearch(scenarios, 5, 0.95));
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
    Search<Tiger> search(plainSearch(1000, 5, 0.95));
    const auto result = search.run(tiger, tigers(1000, 0.5), SearchLimit::trials(kEnough));
    mean += result.statistics.lower_bound / 10.0;
  }
  EXPECT_NEAR(mean, exact, 0.8);
  EXPECT_GT(exact, 2.0) << "listening for ever is worth -4.5";
}

TEST(SearchOnTiger, ClosedBoundsAreTheOptimumOverTheScenarios) {
  for (const double lambda : {0.0, 0.01, 0.1, 0.5, 2.0, 20.0}) {
    for (const double left : {0.5, 0.7, 0.97}) {
      SearchParams params = plainSearch(60, 5, 0.95);
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
      SearchParams params = plainSearch(seed < 4 ? 20 : 3, 5, 0.9);
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
  SearchParams params = plainSearch(20, 5, 0.9);
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
  SearchParams params = plainSearch(20, 5, 0.9);
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
  SearchParams params = plainSearch(1, corridor.horizon, 0.9);
  const Corridor model(corridor);
  Search<Corridor> search(params);
  const auto result = search.run(model, {{Corridor::kGoal}}, SearchLimit::trials(kEnough));
  EXPECT_NEAR(result.statistics.lower_bound, Corridor::kArrival + Corridor::kWaiting, 1e-4);
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);

  // One cell before it with a single step left, arriving is worth nothing more than standing.
  SearchParams short_params = plainSearch(1, 1, 0.9);
  corridor.horizon = 1;
  Search<Corridor> short_search(short_params);
  const auto late =
      short_search.run(Corridor(corridor), {{Corridor::kGoal - 1}}, SearchLimit::trials(kEnough));
  EXPECT_LT(late.statistics.lower_bound, 0.0);
  EXPECT_EQ(late.statistics.bound_violations, 0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
