// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "pomdp_crowd_nav/despot/exogenous_table.h"
#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/despot/search_params.h"
#include "pomdp_crowd_nav/despot/search_result.h"
#include "pomdp_crowd_nav/despot/tree_growth.h"
#include "pomdp_crowd_nav/despot/tree_values.h"

namespace pomdp_crowd_nav {

// Regularised DESPOT (Ye et al. 2017), anytime: trials refine the tree until the limit.
// doc/solver.md shows it at work on a small problem.
//
// A Model has
//   types   State, Action
//   static constexpr bool kSharesState   all scenarios of a belief are in one state
//   void expand(const State* states, const int* scenarios, int count, int depth,
//               Expansion<Model>&) const
//   void rootBounds(const State* states, const int* scenarios, int count, double& lower,
//                   double& upper) const        means over the scenarios
//   Action defaultAction(const State*) const    a legal action of the default policy
// and may have
//   void drawExogenous(int scenarios, int depth)   called once at the start of each search
// Everything random comes from noise addressed by (scenario, depth): same seed, same tree.
//
// With several threads, each runs trials on the one tree: it holds the tree's lock but while the
// model expands a node (then the model's const functions run at the same time in several threads).
// Trials under way lower the attraction of what they went through, which sends the next one
// elsewhere (virtual loss, in the manner of HyP-DESPOT, Cai et al. 2018). Trees of several threads
// are not reproducible.
//
// One search object serves many searches and keeps its memory. Not thread-safe itself.
template <class Model>
class Search {
 public:
  using State = typename Model::State;
  using Action = typename Model::Action;

  // Throws std::invalid_argument when a parameter is out of range.
  explicit Search(const SearchParams& params)
      : params_(validated(params)),
        values_(tree_, params_),
        growth_(tree_, values_, params_),
        workers_(static_cast<size_t>(params_.threads)) {
    tree_.reserve(params_, Model::kSharesState);
  }
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  // `states`: one state where the model shares it, else one per scenario.
  SearchResult<Action> run(const Model& model, const std::vector<State>& states,
                           const SearchLimit& limit) {
    static_assert(!HasExogenous<Model>::value, "a model that draws tables must not be const");
    return search(model, states, limit);
  }

  SearchResult<Action> run(Model& model, const std::vector<State>& states,
                           const SearchLimit& limit) {
    if constexpr (HasExogenous<Model>::value) {
      model.drawExogenous(params_.scenarios, params_.max_depth);
    }
    return search(model, states, limit);
  }

  const Tree<State, Action>& tree() const { return tree_; }
  const SearchParams& params() const { return params_; }

 private:
  // What a thread works with while it does not hold the tree.
  struct Worker {
    Expansion<Model> expansion;
    std::vector<State> states;
    std::vector<int> scenarios;
  };

  enum class Trial {
    kDone,
    kMetAnother,     // gave way to another thread's
    kNothingToGain,  // the bounds differ by no more than the rounding of their sums
    kNoRoom
  };

  SearchResult<Action> search(const Model& model, const std::vector<State>& states,
                              const SearchLimit& limit) {
    plantRoot(model, states);
    // Even a closed root is expanded: which action attains its bounds is not known before.
    if (params_.max_depth > 0) {
      std::unique_lock<std::mutex> lock = lockTree();
      expand(model, 0, workers_[0], lock);
      backUp(0);
    }
    std::vector<std::thread> helpers;
    for (size_t i = 1; i < workers_.size(); ++i) {
      helpers.emplace_back([this, &model, &limit, i] { runTrials(model, limit, workers_[i]); });
    }
    runTrials(model, limit, workers_[0]);
    for (std::thread& helper : helpers) helper.join();
    return collectResult(model);
  }

  void plantRoot(const Model& model, const std::vector<State>& states) {
    tree_.clear();
    statistics_ = {};
    is_stopped_ = false;
    longest_trial_ = {};
    tree_.states.assign(states.begin(), states.end());
    for (int k = 0; k < params_.scenarios; ++k) tree_.scenarios.push_back(k);
    double lower = 0.0;
    double upper = 0.0;
    model.rootBounds(tree_.states.data(), tree_.scenarios.data(), params_.scenarios, lower, upper);
    BeliefNode root;
    root.scenario_count = static_cast<std::uint16_t>(params_.scenarios);
    if (!values_.setInitialBounds(root, static_cast<float>(lower), static_cast<float>(upper),
                                  1.0F)) {
      ++statistics_.bound_violations;
    }
    tree_.beliefs.push_back(root);
    statistics_.initial_lower_bound = root.lower;
    statistics_.initial_upper_bound = root.upper;
  }

  // Held for about a microsecond at a time, so that waiting for it awake is shorter than a sleep.
  std::unique_lock<std::mutex> lockTree() {
    for (int i = 0; i < 1000; ++i) {
      if (tree_mutex_.try_lock()) return {tree_mutex_, std::adopt_lock};
    }
    return std::unique_lock<std::mutex>(tree_mutex_);
  }

  void runTrials(const Model& model, const SearchLimit& limit, Worker& worker) {
    using Clock = SearchLimit::Clock;
    const bool timed = limit.deadline != Clock::time_point::max();
    Clock::time_point now = timed ? Clock::now() : Clock::time_point();
    std::unique_lock<std::mutex> lock = lockTree();
    while (!isEnough(limit) && !is_stopped_) {
      if (timed && now + longest_trial_ >= limit.deadline) {
        stop(SearchStop::kDeadline);
        break;
      }
      ++statistics_.trials;
      const Trial trial = explore(model, worker, lock);
      if (trial == Trial::kNoRoom) stop(SearchStop::kNodeLimit);
      if (trial == Trial::kNothingToGain) stop(SearchStop::kGapClosed);
      if (trial != Trial::kDone) --statistics_.trials;
      if (trial == Trial::kMetAnother) {
        lock.unlock();
        std::this_thread::yield();
        lock = lockTree();
      }
      if (!timed) continue;
      const Clock::time_point then = Clock::now();
      longest_trial_ = std::max(longest_trial_, then - now);
      now = then;
    }
  }

  bool isEnough(const SearchLimit& limit) {
    if (values_.rootGap() <= 0.0F) {
      stop(SearchStop::kGapClosed);
    } else if (tree_.beliefs[0].lower >= limit.lower_bound) {
      stop(SearchStop::kLowerBound);
    } else if (statistics_.trials >= limit.max_trials) {
      stop(SearchStop::kTrialLimit);
    }
    return is_stopped_;
  }

  void stop(SearchStop reason) {
    if (!is_stopped_) statistics_.stop = reason;
    is_stopped_ = true;
  }

  // One trial: descends along the most promising action and the least certain observation.
  Trial explore(const Model& model, Worker& worker, std::unique_lock<std::mutex>& lock) {
    // Unless it finds something to do; another trial like it would not either.
    Trial outcome = tree_.beliefs[0].visitors > 0 ? Trial::kMetAnother : Trial::kNothingToGain;
    int belief = 0;
    float allowance = std::numeric_limits<float>::max();
    while (true) {
      ++tree_.beliefs[belief].visitors;
      if (tree_.beliefs[belief].depth >= params_.max_depth || allowance <= 0.0F) {
        if (values_.makeDefault(belief)) outcome = Trial::kDone;
        break;
      }
      if (values_.excessUncertainty(belief) <= 0.0F) break;
      if (tree_.beliefs[belief].isBeingExpanded()) break;
      if (tree_.beliefs[belief].isLeaf()) {
        outcome = hasRoom() ? Trial::kDone : Trial::kNoRoom;
        if (outcome == Trial::kNoRoom) break;
        expand(model, belief, worker, lock);
      }
      const int child = values_.leastCertainChild(values_.mostPromisingAction(belief));
      if (child < 0) break;
      allowance = values_.allowanceBelow(belief, allowance);
      belief = child;
    }
    for (int b = belief; b >= 0; b = tree_.parentBelief(b)) --tree_.beliefs[b].visitors;
    if (outcome != Trial::kMetAnother) backUp(belief);
    return outcome;
  }

  void backUp(int belief) { statistics_.bound_violations += values_.backUp(belief); }

  bool hasRoom() const {
    return static_cast<int>(tree_.beliefs.size()) < params_.max_nodes &&
           static_cast<double>(tree_.bytes()) < params_.max_memory * 1e6;
  }

  // Lets go of the tree while the model is at work.
  void expand(const Model& model, int belief, Worker& worker, std::unique_lock<std::mutex>& lock) {
    BeliefNode& node = tree_.beliefs[belief];
    const int count = node.scenario_count;
    const int depth = node.depth;
    const auto state = tree_.states.begin() + node.first_state;
    const auto scenario = tree_.scenarios.begin() + node.first_scenario;
    worker.states.assign(state, state + (Model::kSharesState ? 1 : count));
    worker.scenarios.assign(scenario, scenario + count);
    node.first_action = BeliefNode::kIsBeingExpanded;
    lock.unlock();
    model.expand(worker.states.data(), worker.scenarios.data(), count, depth, worker.expansion);
    lock = lockTree();
    growth_.addActions(belief, worker.expansion, statistics_);
  }

  SearchResult<Action> collectResult(const Model& model) {
    const BeliefNode& root = tree_.beliefs[0];
    statistics_.lower_bound = root.lower;
    statistics_.upper_bound = root.upper;
    statistics_.tree_bytes = static_cast<long>(tree_.bytes());
    SearchResult<Action> result{model.defaultAction(tree_.states.data()), true, {}, statistics_};
    for (int belief = 0; belief >= 0 && !tree_.beliefs[belief].isLeaf();) {
      const int action = values_.bestAction(belief);
      result.plan.push_back(tree_.actions[action]);
      belief = values_.likeliestChild(action);
    }
    if (result.plan.empty()) {
      result.plan.push_back(result.action);
    } else {
      result.action = result.plan.front();
      result.from_default = false;
    }
    return result;
  }

  SearchParams params_;
  Tree<State, Action> tree_;
  TreeValues values_;
  TreeGrowth<Model> growth_;
  SearchStatistics statistics_;
  bool is_stopped_ = false;
  SearchLimit::Clock::duration longest_trial_{0};
  std::mutex tree_mutex_;  // guards all of the above while trials run
  std::vector<Worker> workers_;
};

}  // namespace pomdp_crowd_nav
