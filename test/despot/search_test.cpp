// SPDX-License-Identifier: BSD-3-Clause
// What a search must do at the edges of its parameters.
#include "pomdp_crowd_nav/despot/search.h"

#include <gtest/gtest.h>

#include "models/corridor.h"
#include "models/every_policy.h"
#include "models/tiger.h"
#include "plain_search.h"

namespace pomdp_crowd_nav {
namespace {

TEST(Search, UtilityBoundIsFormedWithoutRegularisation) {
  SearchParams params = plainSearch(20, 5, 0.9);
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
  SearchParams params = plainSearch(20, 5, 0.9);
  params.regularization = 1000.0;
  Search<Corridor> search(params);
  const Corridor model{Corridor::Params()};
  const auto result = search.run(model, {{0}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
  EXPECT_EQ(result.statistics.lower_bound, result.statistics.initial_lower_bound);
  EXPECT_EQ(result.statistics.upper_bound, result.statistics.initial_lower_bound);
}

TEST(Search, WithoutATrialTheRootIsExpandedOnce) {
  Search<Corridor> search(plainSearch(20, 5, 0.9));
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
    Search<Corridor> search(plainSearch(20, 5, 0.9));
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
  Search<Corridor> search(plainSearch(20, 0, 0.9));
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(kEnough));
  EXPECT_TRUE(result.from_default);
  EXPECT_EQ(result.action, Corridor::kStay);
  EXPECT_EQ(result.plan, std::vector<Corridor::Action>{Corridor::kStay});
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
  EXPECT_EQ(result.statistics.expansions, 0);
}

TEST(Search, DeadlineInThePastStillGivesALegalAction) {
  Search<Corridor> search(plainSearch(20, 5, 0.9));
  const auto past = SearchLimit::Clock::now() - std::chrono::seconds(1);
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::until(past));
  EXPECT_EQ(result.statistics.stop, SearchStop::kDeadline);
  EXPECT_EQ(result.statistics.trials, 0);
  EXPECT_NE(result.action, Corridor::kBack);
}

TEST(Search, AClosedRootIsExpandedToFindItsAction) {
  Corridor::Params corridor;
  corridor.upper = -100.0F;  // below the default policy: the root's bounds meet at once
  Search<Corridor> search(plainSearch(1, 5, 0.9));
  const auto result =
      search.run(Corridor(corridor), {{Corridor::kGoal}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
  EXPECT_EQ(result.statistics.trials, 0);
  EXPECT_FALSE(result.from_default);
}

TEST(Search, BoundViolationsAreCounted) {
  Corridor::Params corridor;
  corridor.upper = -3.0F;
  SearchParams params = plainSearch(20, 5, 0.9);
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
  Search<Overrated> search(plainSearch(1000, 10, 0.5));
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
  Search<Understated> search(plainSearch(20, 5, 0.9));
  const auto result = search.run(model, {{0}}, SearchLimit::trials(kEnough));
  EXPECT_GE(result.statistics.bound_violations, 1);
  EXPECT_LE(result.statistics.lower_bound, result.statistics.upper_bound);
  Search<Corridor> sound(plainSearch(20, 5, 0.9));
  const auto right = sound.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(right.statistics.bound_violations, 0);
}

TEST(Search, StopsAtTheNodeLimit) {
  SearchParams params = plainSearch(50, 5, 0.9);
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
  SearchParams params = plainSearch(50, 5, 0.9);
  params.max_nodes = 1;
  Search<Corridor> search(params);
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(kEnough));
  EXPECT_EQ(result.statistics.stop, SearchStop::kNodeLimit);
  EXPECT_EQ(result.statistics.trials, 0);
}

TEST(Search, StopsAtTheMemoryLimit) {
  Corridor::Params corridor;
  corridor.horizon = 25;
  SearchParams params = plainSearch(200, 25, 0.9);
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
  Search<Corridor> search(plainSearch(50, 5, 0.9));
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
  Search<Corridor> search(plainSearch(500, 25, 0.99));
  const auto start = SearchLimit::Clock::now();
  const auto result =
      search.run(model, {{0}}, SearchLimit::until(start + std::chrono::milliseconds(100)));
  const double elapsed = std::chrono::duration<double>(SearchLimit::Clock::now() - start).count();
  EXPECT_EQ(result.statistics.stop, SearchStop::kDeadline);
  EXPECT_GT(result.statistics.trials, 1);
  EXPECT_LT(elapsed, 0.120 + 0.5) << "half a second for a busy machine";
}

TEST(Search, StopsAtTheTrialLimit) {
  Search<Corridor> search(plainSearch(20, 5, 0.9));
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(17));
  EXPECT_EQ(result.statistics.stop, SearchStop::kTrialLimit);
  EXPECT_EQ(result.statistics.trials, 17);
}

// A trial that changes nothing would be repeated for ever.
TEST(Search, WithoutALimitItEndsWithAClosedGap) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Corridor::Params corridor;
    corridor.seed = seed;
    SearchParams params = plainSearch(30, 5, 0.9);
    params.regularization = 0.01;
    Search<Corridor> search(params);
    const auto result = search.run(Corridor(corridor), {{0}}, SearchLimit::trials(1000000));
    ASSERT_EQ(result.statistics.stop, SearchStop::kGapClosed) << seed;
    EXPECT_EQ(result.statistics.gap(), 0.0);
  }
}

TEST(Search, CountsItsModelSteps) {
  Search<Corridor> search(plainSearch(20, 5, 0.9));
  const auto result = search.run(Corridor(Corridor::Params()), {{0}}, SearchLimit::trials(40));
  long steps = 0;
  for (const BeliefNode& node : search.tree().beliefs) {
    if (!node.isLeaf()) steps += static_cast<long>(node.action_count) * node.scenario_count;
  }
  EXPECT_EQ(result.statistics.model_steps, steps);
}

TEST(Search, RejectsParametersOutOfRange) {
  EXPECT_THROW(Search<Tiger>(plainSearch(0, 5, 0.9)), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
