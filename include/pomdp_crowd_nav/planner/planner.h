// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/belief/belief_tracker.h"
#include "pomdp_crowd_nav/despot/search_params.h"
#include "pomdp_crowd_nav/despot/search_result.h"
#include "pomdp_crowd_nav/path/hybrid_astar.h"
#include "pomdp_crowd_nav/pomdp/action.h"
#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"
#include "pomdp_crowd_nav/prior/prior_factory.h"
#include "pomdp_crowd_nav/prior/rollout_prior.h"

namespace pomdp_crowd_nav {

// What the planner of speed along a path needs beside the model.
struct LimitedSpaceParams {
  // Vehicle, distances, tolerance and pace are taken from the model and from here.
  HybridAstar::Params path;
  double pace = 0.0;               // [m/s], at which people are predicted for the path; 0: v_max
  double time_share = 0.3;         // of a decision's time, for the path
  int max_expansions = 75000;      // of a path search in a decision without a deadline
  double pedestrian_noise = 0.05;  // [m], half width of the noise on a step of 1 s, in the search
};

// What every planner may need; each takes its part.
struct PlannerParams {
  ModelParams model;
  // Depth and discount are taken from the model.
  SearchParams search;
  PriorParams prior;
  LimitedSpaceParams limited_space;
  int pedestrians = 6;               // n_ped, people whose future is searched
  double attention_angle = M_PI;     // [rad], half angle of the cone around the direction of travel
  double attention_lookahead = 1.0;  // [s], see AttentionParams
  std::uint64_t seed = 1;            // of the sampled futures
};

// Throw std::invalid_argument naming the first field that is out of range.
void validate(const LimitedSpaceParams& params);
void validate(const PlannerParams& params);

// The world at the moment a decision takes effect.
struct Situation {
  VehicleState vehicle;
  CrowdBelief crowd;
};

struct Decision {
  Action action;
  StepMotion motion;               // what the action does in the next step
  std::vector<VehicleState> plan;  // states at the steps of the planned branch, from the start
  // The way to the goal along which speed was searched, the place alone where there was none; empty
  // where heading was searched too.
  std::vector<Point> path;
  std::vector<std::int64_t> attended;  // ids of the people whose futures were searched
  SearchStatistics search;
  bool has_fresh_path = true;  // false: drives on along an older one, or rests for want of any
  long path_expansions = 0;
  double wall_time = 0.0;  // [s], of the whole decision
};

// A search tree to look at: an edge is one step of the robot in one belief.
struct TreeEdge {
  Point from{0.0, 0.0};
  Point to{0.0, 0.0};
  float value = 0.0F;   // lower bound of the belief at `to`, per scenario, as seen from that belief
  float weight = 0.0F;  // share of the scenarios
  int depth = 0;        // of `to`
};
struct TreeView {
  std::vector<TreeEdge> edges;
  std::vector<std::vector<Point>> rollouts;  // paths of the default policy from the best leaves
};

// How much of a tree is viewed; a cut leaves one tree.
struct TreeLimits {
  int edges = 0;
  int depth = std::numeric_limits<int>::max();
};

// What a planner knows of a map and a goal before it meets anybody. Immutable, thread-safe, and
// outlives the planner.
struct Guidance {
  std::shared_ptr<const NavigationField> field;  // null where there is none: RViz shows no layer
  std::shared_ptr<const RolloutPrior> prior;     // of which it was made; null where not kept
};

// Chooses what the robot does in the next step. One planner serves one map and one goal.
// Not thread-safe: one thread decides and views.
class Planner {
 public:
  virtual ~Planner() = default;

  // Ends by the limit's deadline. A planner with the same seed that meets the same situations under
  // the same trial limits takes the same decisions; each of them samples new futures.
  virtual Decision decide(const Situation& situation, const SearchLimit& limit) = 0;

  // The tree of the last decision, the beliefs with most scenarios first.
  virtual TreeView viewTree(const TreeLimits& limits) const = 0;

  // Path to the goal if nobody were about; starts at `from`, ends at the goal or where no way on
  // is known.
  virtual std::vector<Point> globalPath(const Point& from) const = 0;

  // The same in brief: direction and length of the way on from a place.
  virtual NavigationCell guidanceAt(const Point& place) const = 0;

  virtual Guidance guidance() const = 0;

  // False where that path is the beeline, of whatever stands in its way only the search knows.
  virtual bool pathAvoidsObstacles() const { return true; }
};

}  // namespace pomdp_crowd_nav
