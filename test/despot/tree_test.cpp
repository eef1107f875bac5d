// SPDX-License-Identifier: BSD-3-Clause
// What holds at every node of a search tree, after every trial.
#include "pomdp_crowd_nav/despot/tree.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <type_traits>

#include "models/corridor.h"
#include "models/tiger.h"
#include "pomdp_crowd_nav/despot/search.h"

namespace pomdp_crowd_nav {
namespace {

SearchParams testParams(double lambda) {
  SearchParams params;
  params.scenarios = 40;
  params.max_depth = 6;
  params.discount = 0.9;
  params.regularization = lambda;
  return params;
}

// The first scenarios have the tiger on the left.
std::vector<Tiger::State> startOf(const Tiger&) {
  std::vector<Tiger::State> states(40, Tiger::kTigerLeft);
  for (int k = 20; k < 40; ++k) states[k] = Tiger::kTigerRight;
  return states;
}
std::vector<Corridor::State> startOf(const Corridor&) { return {{0}}; }

template <class Model>
Model makeModel() {
  typename Model::Params params;
  params.discount = 0.9;
  params.horizon = 6;
  // Bounds that widen with depth would widen their parents' if these did not keep their own.
  if constexpr (std::is_same_v<Model, Corridor>) params.looser_by = 5.0F;
  return Model(params);
}

template <class Model>
Tree<typename Model::State, typename Model::Action> treeAfter(long trials, double lambda) {
  const Model model = makeModel<Model>();
  Search<Model> search(testParams(lambda));
  search.run(model, startOf(model), SearchLimit::trials(trials));
  return search.tree();
}

template <class State, class Action>
void expectSameBytes(const Tree<State, Action>& a, const Tree<State, Action>& b) {
  ASSERT_EQ(a.beliefs.size(), b.beliefs.size());
  ASSERT_EQ(a.action_nodes.size(), b.action_nodes.size());
  EXPECT_EQ(a.actions, b.actions);
  EXPECT_EQ(a.scenarios, b.scenarios);
  EXPECT_EQ(a.states.size(), b.states.size());
  for (size_t i = 0; i < a.beliefs.size(); ++i) {
    const BeliefNode& p = a.beliefs[i];
    const BeliefNode& q = b.beliefs[i];
    EXPECT_EQ(std::memcmp(&p.lower, &q.lower, sizeof(float)), 0);
    EXPECT_EQ(std::memcmp(&p.upper, &q.upper, sizeof(float)), 0);
    EXPECT_EQ(std::memcmp(&p.utility_upper, &q.utility_upper, sizeof(float)), 0);
    EXPECT_EQ(std::memcmp(&p.default_value, &q.default_value, sizeof(float)), 0);
    EXPECT_EQ(p.first_action, q.first_action);
    EXPECT_EQ(p.blocked, q.blocked);
  }
}

template <class Model>
class SearchTree : public testing::Test {};
using Models = testing::Types<Tiger, Corridor>;
TYPED_TEST_SUITE(SearchTree, Models);

TYPED_TEST(SearchTree, BoundsAreOrderedAndOnlyMoveInward) {
  for (const double lambda : {0.0, 0.05, 0.5}) {
    auto before = treeAfter<TypeParam>(0, lambda);
    for (long trials = 1; trials <= 120; ++trials) {
      const auto now = treeAfter<TypeParam>(trials, lambda);
      ASSERT_GE(now.beliefs.size(), before.beliefs.size());
      for (size_t i = 0; i < now.beliefs.size(); ++i) {
        const BeliefNode& node = now.beliefs[i];
        ASSERT_LE(node.lower, node.upper) << "node " << i << " after " << trials;
        ASSERT_LE(node.default_value, node.lower);
        ASSERT_LE(node.default_value, node.utility_upper);
        if (i >= before.beliefs.size()) continue;
        const BeliefNode& was = before.beliefs[i];
        ASSERT_GE(node.lower, was.lower) << "node " << i << " after " << trials;
        ASSERT_LE(node.upper, was.upper) << "node " << i << " after " << trials;
        ASSERT_LE(node.utility_upper, was.utility_upper);
        ASSERT_EQ(node.default_value, was.default_value);
        ASSERT_EQ(node.parent, was.parent);
        ASSERT_EQ(node.depth, was.depth);
        ASSERT_TRUE(node.blocked || !was.blocked) << "nothing unblocks a node";
      }
      before = now;
    }
  }
}

TYPED_TEST(SearchTree, TrialsGrowIt) {
  const auto none = treeAfter<TypeParam>(0, 0.0);
  const auto many = treeAfter<TypeParam>(30, 0.0);
  EXPECT_GT(many.beliefs.size(), none.beliefs.size());
  const float gap_before = none.beliefs[0].upper - none.beliefs[0].lower;
  EXPECT_LT(many.beliefs[0].upper - many.beliefs[0].lower, gap_before);
}

TYPED_TEST(SearchTree, LinksAgree) {
  const auto tree = treeAfter<TypeParam>(60, 0.05);
  EXPECT_EQ(tree.actions.size(), tree.action_nodes.size());
  EXPECT_EQ(tree.parentBelief(0), -1);
  std::set<int> children;
  for (size_t b = 0; b < tree.beliefs.size(); ++b) {
    const BeliefNode& node = tree.beliefs[b];
    ASSERT_GT(node.scenario_count, 0);
    for (int a = node.first_action; a >= 0 && a < node.first_action + node.action_count; ++a) {
      const ActionNode& action = tree.action_nodes[a];
      ASSERT_EQ(action.parent, static_cast<int>(b));
      std::multiset<int> kept;
      for (int c = action.first_child; c < action.first_child + action.child_count; ++c) {
        const BeliefNode& child = tree.beliefs[c];
        ASSERT_EQ(child.parent, a);
        ASSERT_EQ(child.depth, node.depth + 1);
        ASSERT_EQ(tree.parentBelief(c), static_cast<int>(b));
        ASSERT_TRUE(children.insert(c).second) << "a belief with two parents";
        const auto* first = &tree.scenarios[child.first_scenario];
        kept.insert(first, first + child.scenario_count);
      }
      // The children share out the parent's scenarios; what is missing has ended.
      const auto* first = &tree.scenarios[node.first_scenario];
      const std::set<int> all(first, first + node.scenario_count);
      ASSERT_EQ(all.size(), node.scenario_count);
      ASSERT_LE(kept.size(), all.size());
      for (int scenario : kept) {
        ASSERT_EQ(all.count(scenario), 1U);
        ASSERT_EQ(kept.count(scenario), 1U);
      }
    }
  }
  EXPECT_EQ(children.size() + 1, tree.beliefs.size()) << "all but the root are somebody's child";
}

TYPED_TEST(SearchTree, ScenariosEndOnlyWhereTheModelSaysSo) {
  const TypeParam model = makeModel<TypeParam>();
  const auto tree = treeAfter<TypeParam>(60, 0.05);
  for (const BeliefNode& node : tree.beliefs) {
    if (node.isLeaf()) continue;
    for (int a = node.first_action; a < node.first_action + node.action_count; ++a) {
      const ActionNode& action = tree.action_nodes[a];
      int ended = 0;
      for (int i = 0; i < node.scenario_count; ++i) {
        const auto& state = tree.states[node.first_state + (TypeParam::kSharesState ? 0 : i)];
        auto next = state;
        const int scenario = tree.scenarios[node.first_scenario + i];
        if (model.step(state, scenario, node.depth, tree.actions[a], next).terminal) ++ended;
      }
      int kept = 0;
      for (int c = 0; c < action.child_count; ++c) {
        kept += tree.beliefs[action.first_child + c].scenario_count;
      }
      ASSERT_EQ(kept + ended, node.scenario_count);
    }
  }
}

TYPED_TEST(SearchTree, ValuesAreBackedUp) {
  constexpr double kLambda = 0.05;
  const auto tree = treeAfter<TypeParam>(60, kLambda);
  for (const ActionNode& action : tree.action_nodes) {
    double lower = action.reward, upper = action.reward, utility = action.reward + kLambda;
    for (int c = action.first_child; c < action.first_child + action.child_count; ++c) {
      lower += tree.beliefs[c].lower;
      upper += tree.beliefs[c].upper;
      utility += tree.beliefs[c].utility_upper;
    }
    EXPECT_NEAR(action.lower, lower, 1e-4);
    EXPECT_NEAR(action.upper, upper, 1e-4);
    EXPECT_NEAR(action.utility_upper, utility, 1e-4);
  }
  for (const BeliefNode& node : tree.beliefs) {
    if (node.isLeaf()) {
      EXPECT_EQ(node.lower, node.default_value);
      EXPECT_TRUE(!node.blocked || node.upper == node.default_value);
      continue;
    }
    float best_lower = node.default_value;
    float best_upper = node.default_value;
    for (int a = node.first_action; a < node.first_action + node.action_count; ++a) {
      best_lower = std::max(best_lower, tree.action_nodes[a].lower);
      best_upper = std::max(best_upper, tree.action_nodes[a].upper);
    }
    EXPECT_EQ(node.lower, best_lower);
    EXPECT_LE(node.upper, std::max(best_upper, best_lower));
  }
}

TYPED_TEST(SearchTree, SameSeedSameTreeBitForBit) {
  expectSameBytes(treeAfter<TypeParam>(50, 0.05), treeAfter<TypeParam>(50, 0.05));
}

TYPED_TEST(SearchTree, AReusedSearchGrowsTheTreeOfAFreshOne) {
  const TypeParam model = makeModel<TypeParam>();
  Search<TypeParam> search(testParams(0.05));
  search.run(model, startOf(model), SearchLimit::trials(200));
  search.run(model, startOf(model), SearchLimit::trials(30));
  expectSameBytes(search.tree(), treeAfter<TypeParam>(30, 0.05));
}

TEST(BlockedNodes, HaveAnAncestorThatCannotPayForThem) {
  constexpr double kLambda = 0.8;
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Corridor::Params corridor;
    corridor.horizon = 6;
    corridor.seed = seed;
    SearchParams params = testParams(kLambda);
    params.scenarios = 5;
    Search<Corridor> search(params);
    search.run(Corridor(corridor), {{0}}, SearchLimit::trials(1000));
    const auto& tree = search.tree();
    for (size_t b = 0; b < tree.beliefs.size(); ++b) {
      const BeliefNode& node = tree.beliefs[b];
      if (!node.blocked) continue;
      EXPECT_EQ(node.upper, node.lower);
      if (node.depth == params.max_depth) continue;
      ++blocked;
      bool found = false;
      double cost = 0.0;
      for (int p = tree.parentBelief(static_cast<int>(b)); p >= 0; p = tree.parentBelief(p)) {
        cost += kLambda;
        const BeliefNode& ancestor = tree.beliefs[p];
        found = found || ancestor.utility_upper - ancestor.default_value <= cost + 1e-4;
      }
      EXPECT_TRUE(found) << "node " << b << ", seed " << seed;
    }
  }
  EXPECT_GT(blocked, 0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
