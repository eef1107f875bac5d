// SPDX-License-Identifier: BSD-3-Clause
// Several threads on one tree.
#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "models/corridor.h"
#include "models/every_policy.h"
#include "models/tiger.h"
#include "pomdp_crowd_nav/despot/search.h"

namespace pomdp_crowd_nav {
namespace {

SearchParams paramsFor(int threads) {
  SearchParams params;
  params.scenarios = 60;
  params.max_depth = 5;
  params.discount = 0.9;
  params.regularization = 0.01;
  params.threads = threads;
  return params;
}

Corridor corridor(std::uint64_t seed, int horizon = 5) {
  Corridor::Params params;
  params.seed = seed;
  params.horizon = horizon;
  return Corridor(params);
}

TEST(SearchThreads, CloseTheGapAtTheOptimum) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SearchParams params = paramsFor(1);
    params.scenarios = 10;
    const Corridor model = corridor(seed);
    const double optimum = EveryPolicy<Corridor>(model, params).optimum({{0}});
    for (const int threads : {2, 3, 8}) {
      params.threads = threads;
      Search<Corridor> search(params);
      const auto result = search.run(model, {{0}}, SearchLimit::trials(100000));
      EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
      EXPECT_NEAR(result.statistics.lower_bound, optimum, 1e-4) << seed << ", " << threads;
      EXPECT_NEAR(result.statistics.upper_bound, optimum, 1e-4) << seed << ", " << threads;
    }
  }
}

TEST(SearchThreads, WorkOnModelsWithAStateForEachScenario) {
  SearchParams params = paramsFor(4);
  std::vector<Tiger::State> states(60, Tiger::kTigerLeft);
  for (int k = 0; k < 30; ++k) states[k] = Tiger::kTigerRight;
  const Tiger model{Tiger::Params{0.9, 5, 1}};
  Search<Tiger> search(params);
  const auto several = search.run(model, states, SearchLimit::trials(100000));
  params.threads = 1;
  Search<Tiger> alone(params);
  const auto one = alone.run(model, states, SearchLimit::trials(100000));
  EXPECT_EQ(several.action, one.action);
  EXPECT_NEAR(several.statistics.lower_bound, one.statistics.lower_bound, 1e-4);
}

// What must hold of a finished tree, however its trials were interleaved.
TEST(SearchThreads, LeaveAProperTree) {
  const Corridor model = corridor(3, 20);
  SearchParams params = paramsFor(4);
  params.scenarios = 200;
  params.max_depth = 20;
  Search<Corridor> search(params);
  for (int repetition = 0; repetition < 20; ++repetition) {
    const auto result = search.run(model, {{0}}, SearchLimit::trials(300));
    EXPECT_GT(result.statistics.trials, 100);
    EXPECT_LE(result.statistics.trials, 300);
    EXPECT_EQ(result.statistics.bound_violations, 0);
    const auto& tree = search.tree();
    long expanded = 0;
    for (size_t b = 0; b < tree.beliefs.size(); ++b) {
      const BeliefNode& node = tree.beliefs[b];
      ASSERT_EQ(node.visitors, 0);
      ASSERT_FALSE(node.isBeingExpanded());
      ASSERT_LE(node.lower, node.upper);
      if (node.isLeaf()) continue;
      ++expanded;
      for (int a = node.first_action; a < node.first_action + node.action_count; ++a) {
        const ActionNode& action = tree.action_nodes[a];
        ASSERT_EQ(action.parent, static_cast<int>(b));
        float lower = action.reward;
        for (int c = action.first_child; c < action.first_child + action.child_count; ++c) {
          ASSERT_EQ(tree.beliefs[c].parent, a);
          lower += tree.beliefs[c].lower;
        }
        ASSERT_NEAR(action.lower, lower, 1e-4);
        ASSERT_GE(node.lower, action.lower - 1e-4);
      }
    }
    EXPECT_EQ(expanded, result.statistics.expansions);
  }
}

TEST(SearchThreads, EndTogetherAtTheDeadline) {
  Corridor::Params corridor_params;
  corridor_params.horizon = 25;
  corridor_params.discount = 0.99;
  const Corridor model(corridor_params);
  SearchParams params = paramsFor(4);
  params.scenarios = 500;
  params.max_depth = 25;
  params.discount = 0.99;
  params.regularization = 0.0;
  Search<Corridor> search(params);
  const auto start = SearchLimit::Clock::now();
  const auto result =
      search.run(model, {{0}}, SearchLimit::until(start + std::chrono::milliseconds(50)));
  const double elapsed = std::chrono::duration<double>(SearchLimit::Clock::now() - start).count();
  EXPECT_EQ(result.statistics.stop, SearchStop::kDeadline);
  EXPECT_LT(elapsed, 0.05 + 1.0) << "a second for a busy machine";
}

// Its expansions wait for each other, all but the root's: a search gets on only if its threads are
// inside the model at the same time, hence at different beliefs.
class Meeting : public Corridor {
 public:
  using Corridor::Corridor;
  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<Meeting>& out) const {
    if (depth > 0) meet();
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }
  bool haveMet() const { return have_met_; }

 private:
  void meet() const {
    std::unique_lock<std::mutex> lock(mutex_);
    ++present_;
    have_met_ = have_met_ || present_ == 2;
    changed_.notify_all();
    changed_.wait_for(lock, std::chrono::seconds(20), [this] { return have_met_; });
    --present_;
  }

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  mutable int present_ = 0;
  mutable bool have_met_ = false;
};

TEST(SearchThreads, WorkAtDifferentBeliefsAtTheSameTime) {
  const Meeting model{Corridor::Params()};
  Search<Meeting> search(paramsFor(2));
  const auto start = SearchLimit::Clock::now();
  search.run(model, {{0}}, SearchLimit::trials(50));
  EXPECT_TRUE(model.haveMet());
  EXPECT_LT(SearchLimit::Clock::now() - start, std::chrono::seconds(15));
}

// A trial that finds another at work on its leaf gives way and is not counted.
TEST(SearchThreads, OutnumberTheLeaves) {
  SearchParams params = paramsFor(16);
  params.scenarios = 1;
  params.max_depth = 4;
  const Corridor model = corridor(2);
  Search<Corridor> search(params);
  const auto result = search.run(model, {{0}}, SearchLimit::trials(100000));
  EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
}

}  // namespace
}  // namespace pomdp_crowd_nav
