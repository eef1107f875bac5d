// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/omniscient_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;  // [m], [s]

void requirePositive(const char* name, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("bound.{} must be positive, got {}", name, value));
}

const OmniscientBound::Params& validated(const OmniscientBound::Params& params) {
  requirePositive("max_speed", params.max_speed);
  requirePositive("spacing", params.spacing);
  requirePositive("wait", params.wait);
  requirePositive("reach", params.reach);
  return params;
}

}  // namespace

// A* with ways that are looked at when it is their turn: the next one may be taken later than
// planned, never earlier.
class OmniscientBound::Search {
 public:
  Search(const OmniscientBound& bound, CrowdHistory& people)
      : bound_(bound),
        people_(people),
        goal_offset_(static_cast<int>(bound.offsets_.size())),
        arrivals_(bound.clearances_.size(), kInfinity),
        came_by_(bound.clearances_.size()) {}

  std::optional<Plan> run() {
    settle(bound_.start_node_, bound_.params_.start_delay);
    while (!candidates_.empty()) {
      const Candidate next = candidates_.top();
      if (next.time > bound_.params_.time_limit) break;
      candidates_.pop();
      if (next.offset == goal_offset_) {
        if (bound_.isClear(bound_.place(next.node), goalOf(next), next.departure, people_)) {
          return planTo(next);
        }
        if (lengthOf(next) <= bound_.params_.reach * bound_.params_.spacing) putOff(next);
        continue;
      }
      const Offset& offset = bound_.offsets_[next.offset];
      const size_t node = *bound_.neighbour(next.node, offset);
      if (std::isfinite(arrivals_[node])) continue;
      const Point from = bound_.place(next.node);
      if (!bound_.isClear(from, from + offset.way, next.departure, people_)) {
        putOff(next);
        continue;
      }
      came_by_[node] = next;
      settle(node, next.departure + offset.length / bound_.params_.max_speed);
    }
    return std::nullopt;
  }

 private:
  struct Candidate {
    double time = 0.0;  // [s], of the arrival at the goal, at least
    double departure = 0.0;
    size_t node = 0;
    int offset = 0;
    bool operator<(const Candidate& other) const { return time > other.time; }
  };

  Point goalOf(const Candidate& shot) const { return bound_.arrivalFrom(bound_.place(shot.node)); }
  double lengthOf(const Candidate& shot) const {
    return bound_.distanceToGoal(bound_.place(shot.node));
  }

  void putOff(Candidate candidate) {
    candidate.time += bound_.params_.wait;
    candidate.departure += bound_.params_.wait;
    candidates_.push(candidate);
  }

  void settle(size_t node, double arrival) {
    arrivals_[node] = arrival;
    const double speed = bound_.params_.max_speed;
    if (bound_.sees_goal_[node]) {
      candidates_.push({arrival + bound_.ways_[node] / speed, arrival, node, goal_offset_});
    }
    for (int i = 0; i < goal_offset_; ++i) {
      const Offset& offset = bound_.offsets_[i];
      const auto other = bound_.neighbour(node, offset);
      if (!other || std::isfinite(arrivals_[*other]) || std::isinf(bound_.ways_[*other])) continue;
      if (!bound_.isOpen(node, offset, *other)) continue;
      const double time = arrival + (offset.length + bound_.ways_[*other]) / speed;
      candidates_.push({time, arrival, node, i});
    }
  }

  Plan planTo(const Candidate& shot) const {
    Plan plan;
    const double speed = bound_.params_.max_speed;
    const auto add = [&](const Point& from, const Point& to, double departure) {
      plan.legs.push_back({from, to, departure, departure + (to - from).norm() / speed});
    };
    add(bound_.place(shot.node), goalOf(shot), shot.departure);
    plan.arrival = plan.legs.front().arrival;
    for (size_t node = shot.node; node != bound_.start_node_; node = came_by_[node].node) {
      const Candidate& way = came_by_[node];
      add(bound_.place(way.node), bound_.place(node), way.departure);
    }
    std::reverse(plan.legs.begin(), plan.legs.end());
    return plan;
  }

  const OmniscientBound& bound_;
  CrowdHistory& people_;
  int goal_offset_;
  std::vector<double> arrivals_;  // [s], per node; infinite where it is not known yet
  std::vector<Candidate> came_by_;
  std::priority_queue<Candidate> candidates_;
};

OmniscientBound::OmniscientBound(const World& world, const Params& params)
    : params_(validated(params)),
      sight_(world.map(), params.obstacle_clearance),
      start_(world.start.position),
      goal_(world.goal) {
  layLattice();
  listOffsets();
  measureWays();
}

// Along the beeline, with the start on a node; nodes off the field and in the clearance are left
// out.
void OmniscientBound::layLattice() {
  const Point way = goal_ - start_;
  along_ = way.norm() > kRounding ? Point(way.normalized()) : Point(1.0, 0.0);
  across_ = {-along_.y(), along_.x()};
  const Bounds& bounds = sight_.map().bounds();
  Eigen::Array2d low = Eigen::Array2d::Constant(kInfinity);
  Eigen::Array2d high = -low;
  for (const double x : {bounds.min.x(), bounds.max.x()}) {
    for (const double y : {bounds.min.y(), bounds.max.y()}) {
      const Point corner = Point(x, y) - start_;
      const Eigen::Array2d turned(corner.dot(along_), corner.dot(across_));
      low = low.min(turned);
      high = high.max(turned);
    }
  }
  const Eigen::Array2d first = (low / params_.spacing).ceil().min(0.0);
  const Eigen::Array2d last = (high / params_.spacing).floor().max(0.0);
  columns_ = static_cast<int>(last.x() - first.x()) + 1;
  rows_ = static_cast<int>(last.y() - first.y()) + 1;
  corner_ = start_ + params_.spacing * (first.x() * along_ + first.y() * across_);
  start_node_ = static_cast<size_t>(-first.y()) * columns_ + static_cast<size_t>(-first.x());
  const auto size = static_cast<size_t>(columns_) * rows_;
  clearances_.assign(size, -1.0F);
  for (size_t node = 0; node < size; ++node) {
    const Point here = place(node);
    const bool is_start = node == start_node_;
    if (!is_start && (!bounds.contains(here) || !sight_.isFree(here))) continue;
    clearances_[node] = static_cast<float>(std::max(0.0, sight_.map().clearance(here)));
  }
}

// One way in each direction.
void OmniscientBound::listOffsets() {
  const int reach = params_.reach;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      if (std::gcd(row, column) != 1 || row * row + column * column > reach * reach) continue;
      const Point way = params_.spacing * (column * along_ + row * across_);
      offsets_.push_back({column, row, way, way.norm()});
    }
  }
}

// Dijkstra's search from the goal: the exact length of every way that the lattice has without
// people, so that the heuristic of the search among them is consistent.
void OmniscientBound::measureWays() {
  using Item = std::pair<double, size_t>;  // length, node
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  ways_.assign(clearances_.size(), kInfinity);
  sees_goal_.assign(clearances_.size(), 0);
  for (size_t node = 0; node < ways_.size(); ++node) {
    if (clearances_[node] < 0.0F) continue;
    const Point here = place(node);
    if (!sight_.isClear(here, arrivalFrom(here))) continue;
    sees_goal_[node] = 1;
    ways_[node] = distanceToGoal(here);
    queue.emplace(ways_[node], node);
  }
  while (!queue.empty()) {
    const auto [length, node] = queue.top();
    queue.pop();
    if (length > ways_[node]) continue;
    for (const Offset& offset : offsets_) {
      const auto other = neighbour(node, offset);
      if (!other || length + offset.length >= ways_[*other] - kRounding) continue;
      if (!isOpen(node, offset, *other)) continue;
      ways_[*other] = length + offset.length;
      queue.emplace(ways_[*other], *other);
    }
  }
}

Point OmniscientBound::place(size_t node) const {
  const auto column = static_cast<double>(node % static_cast<size_t>(columns_));
  const auto row = static_cast<double>(node / static_cast<size_t>(columns_));
  return corner_ + params_.spacing * (column * along_ + row * across_);
}

std::optional<size_t> OmniscientBound::neighbour(size_t node, const Offset& offset) const {
  const int column = static_cast<int>(node % static_cast<size_t>(columns_)) + offset.columns;
  const int row = static_cast<int>(node / static_cast<size_t>(columns_)) + offset.rows;
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return std::nullopt;
  const size_t other = static_cast<size_t>(row) * columns_ + column;
  if (clearances_[other] < 0.0F) return std::nullopt;
  return other;
}

// Far from obstacles nothing needs to be looked at.
bool OmniscientBound::isOpen(size_t node, const Offset& offset, size_t other) const {
  const double spare = 0.5 * (clearances_[node] + clearances_[other]) - sight_.clearance();
  if (spare > 0.5 * offset.length) return true;
  return sight_.isClear(place(node), place(other));
}

double OmniscientBound::distanceToGoal(const Point& place) const {
  return std::max(0.0, (goal_ - place).norm() - params_.goal_tolerance + kRounding);
}

Point OmniscientBound::arrivalFrom(const Point& place) const {
  const double length = (goal_ - place).norm();
  return length > kRounding ? place + (goal_ - place) * (distanceToGoal(place) / length) : place;
}

bool OmniscientBound::isClear(const Point& from, const Point& to, double departure,
                              CrowdHistory& people) const {
  const double length = (to - from).norm();
  if (length <= kRounding) return true;
  return people.isClear(from, (to - from) * (params_.max_speed / length), departure,
                        length / params_.max_speed, params_.person_distance);
}

std::optional<OmniscientBound::Plan> OmniscientBound::plan(CrowdHistory& people) const {
  std::optional<Plan> plan = Search(*this, people).run();
  if (plan && params_.pull_straight) {
    constexpr int kMaxPasses = 10;
    constexpr double kGain = 1e-3;  // [s], worth another pass
    for (int i = 0; i < kMaxPasses; ++i) {
      const double before = plan->arrival;
      plan = pulledStraight(*plan, people);
      if (plan->arrival > before - kGain) break;
    }
  }
  return plan;
}

// Each place goes on to the last one that is reached from it straight and no later than now.
OmniscientBound::Plan OmniscientBound::pulledStraight(const Plan& plan,
                                                      CrowdHistory& people) const {
  Plan pulled;
  double ready = params_.start_delay;
  for (size_t i = 0; i < plan.legs.size();) {
    const Point& from = plan.legs[i].from;
    std::optional<Leg> leg;
    size_t last = plan.legs.size();
    while (!leg && --last > i) {
      const bool is_end = last + 1 == plan.legs.size();
      const Point to = is_end ? arrivalFrom(from) : plan.legs[last].to;
      if (sight_.isClear(from, to)) {
        leg = earliestLeg(from, to, ready, plan.legs[last].arrival, people);
      }
    }
    // The way it is: if not earlier, then as before.
    if (!leg) leg = earliestLeg(from, plan.legs[i].to, ready, plan.legs[i].arrival, people);
    pulled.legs.push_back(leg ? *leg : plan.legs[i]);
    ready = pulled.legs.back().arrival;
    i = last + 1;
  }
  pulled.arrival = ready;
  return pulled;
}

std::optional<OmniscientBound::Leg> OmniscientBound::earliestLeg(const Point& from, const Point& to,
                                                                 double ready,
                                                                 double latest_arrival,
                                                                 CrowdHistory& people) const {
  const double duration = (to - from).norm() / params_.max_speed;
  for (double departure = ready; departure + duration <= latest_arrival + kRounding;
       departure += 0.25 * params_.wait) {
    if (!isClear(from, to, departure, people)) continue;
    return Leg{from, to, departure, departure + duration};
  }
  return std::nullopt;
}

double OmniscientBound::beelineTime() const {
  return params_.start_delay + distanceToGoal(start_) / params_.max_speed;
}

double OmniscientBound::emptyDriveTime() const {
  return params_.start_delay + ways_[start_node_] / params_.max_speed;
}

}  // namespace pomdp_crowd_nav
