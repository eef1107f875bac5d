// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "pomdp_crowd_nav/belief/belief_tracker.h"
#include "pomdp_crowd_nav/path/crowd_cost.h"
#include "pomdp_crowd_nav/path/path.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Hybrid A* over place and heading (paper, section LS planner; Dolgov et al. 2008): places are
// continuous, one node is kept for each cell of x, y and heading. An element of the path is 1 m
// long. A holonomic base turns in place by a multiple of 10 degrees and drives straight; a car
// drives an arc on which its heading changes by a multiple of 5 degrees, 45 at most and no more
// than it can.
//
//   cost of a path  sum over its elements t of lambda^t (1 + C_st + C_ped)
//   order of nodes  least cost so far + way to the goal - heading_weight cos(heading off the way)
//
// C_st is infinite closer to an obstacle than the clearance and off the field, C_ped see CrowdCost.
// Who starts in such a place may leave it. The order is no lower bound (undiscounted way, cosine),
// so that the search is greedy: fast, and not optimal, as in the authors' code.
//
// Keeps its memory between searches. Not thread-safe.
class HybridAstar {
 public:
  struct Params {
    VehicleKind vehicle = VehicleKind::kHolonomic;
    double max_turn = M_PI / 4;   // [rad], of a car on an element
    double cell = 0.5;            // [m], of x and y
    double clearance = 3.0;       // [m], to obstacles, D_obs + L
    double goal_tolerance = 1.0;  // [m], D_g
    double cost_discount = 0.99;  // lambda, per element
    double way_weight = 1.0;      // of the way to the goal, per metre
    double heading_weight = 10.0;
    CrowdCost::Params crowd;
  };

  static constexpr double kElement = 1.0;                // [m]
  static constexpr double kTurnStep = 5.0 * M_PI / 180;  // [rad], of a car

  using Clock = std::chrono::steady_clock;
  struct Limit {
    Clock::time_point deadline = Clock::time_point::max();
    long max_expansions = std::numeric_limits<long>::max();
  };

  enum class Outcome {
    kFound,
    kTimedOut,  // the limit was reached
    kExhausted  // there is no path
  };
  struct Result {
    Outcome outcome = Outcome::kExhausted;
    Path path;  // without a leg for a start within the tolerance
    double cost = 0.0;
    long expansions = 0;
  };

  // Of a car on an element at every speed [rad].
  static double maxTurn(const VehicleParams& vehicle);

  // `field`: the way to the goal and the clearance, of the map and the goal; it must outlive the
  // search. Throws std::invalid_argument when a parameter is out of range.
  HybridAstar(const StaticMap& map, const NavigationField& field, const Params& params);

  Result find(const Pose& start, const std::vector<PersonBelief>& people,
              const std::vector<Point>& destinations, const Limit& limit);

 private:
  struct Node {
    enum class State : std::uint8_t { kNew, kOpen, kClosed };

    double x, y, cost;
    std::int32_t parent;
    std::uint32_t order;  // of its newest entry in the heap
    std::int16_t time;    // elements from the start
    std::uint8_t action;
    State state;
  };
  struct Entry {
    double value;
    std::int32_t node;
    std::uint32_t order;
  };
  // An element in the frame of a vehicle at the origin that faces along x.
  struct Move {
    double turn;        // [rad]
    int heading_steps;  // the same in steps of the grid, not negative
    double x, y;        // [m], end
    double middle_x, middle_y;
  };
  struct Place {
    double x, y;
  };
  // What the children of a node share.
  struct Family {
    Node parent;
    std::int32_t index;
    int heading;
    double clearance;  // [m], at the parent, where it matters
    double border;     // [m], how far the parent is off the field, 0 on it
  };

  void addMoves();
  void begin(const Pose& start, const std::vector<PersonBelief>& people,
             const std::vector<Point>& destinations);
  void expand(std::int32_t index);
  void addChild(const Family& family, const Move& move, int action);
  bool isAllowed(const Family& family, const Place& middle, const Place& end) const;
  bool isClear(const Place& place) const;
  double clearanceAt(const Place& place) const;
  double offField(const Place& place) const;
  bool isAtGoal(const Node& node) const;
  double wayToGo(const Place& place, int heading) const;
  double discountAt(int time) const;

  std::int32_t nodeAt(const Place& place, int heading);
  void open(std::int32_t index, const Node& node, double value);
  std::int32_t popBest();  // -1 where there is none
  Path pathTo(std::int32_t index, const Pose& start) const;

  Params params_;
  StaticMap map_;
  const NavigationField& field_;
  Point goal_;
  double table_error_ = 0.0;  // [m], of clearances read from the field
  int headings_ = 36;
  std::vector<Move> moves_;
  int columns_ = 1;
  int rows_ = 1;

  // Of one search.
  CrowdCost crowd_;
  double start_heading_ = 0.0;
  bool is_squeezed_ = false;  // the start is too close to an obstacle
  std::uint32_t pushes_ = 0;
  std::vector<Place> headings_xy_;     // unit vectors
  std::vector<double> discounts_;      // lambda^t
  std::vector<std::int32_t> blocks_;   // per cell: where its nodes are, -1 none
  std::vector<std::int32_t> touched_;  // cells that have nodes
  std::vector<Node> nodes_;            // blocks of a node for each heading
  std::vector<Entry> heap_;
};

// Throws std::invalid_argument naming the first field that is out of range.
void validate(const HybridAstar::Params& params);

}  // namespace pomdp_crowd_nav
