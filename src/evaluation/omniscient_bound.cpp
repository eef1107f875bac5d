// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/omniscient_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
        lattice_(bound.lattice_),
        people_(people),
        goal_offset_(static_cast<int>(lattice_.offsets().size())),
        arrivals_(lattice_.size(), kInfinity),
        came_by_(lattice_.size()) {}

  std::optional<Plan> run() {
    settle(lattice_.startNode(), bound_.params_.start_delay);
    while (!candidates_.empty()) {
      const Candidate next = candidates_.top();
      if (next.time > bound_.params_.time_limit) break;
      candidates_.pop();
      if (next.offset == goal_offset_) {
        if (bound_.isClear(lattice_.place(next.node), goalOf(next), next.departure, people_)) {
          return planTo(next);
        }
        if (lengthOf(next) <= bound_.params_.reach * bound_.params_.spacing) putOff(next);
        continue;
      }
      const BoundLattice::Offset& offset = lattice_.offsets()[next.offset];
      const size_t node = *lattice_.neighbour(next.node, offset);
      if (std::isfinite(arrivals_[node])) continue;
      const Point from = lattice_.place(next.node);
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

  Point goalOf(const Candidate& shot) const {
    return lattice_.arrivalFrom(lattice_.place(shot.node));
  }
  double lengthOf(const Candidate& shot) const {
    return lattice_.distanceToGoal(lattice_.place(shot.node));
  }

  void putOff(Candidate candidate) {
    candidate.time += bound_.params_.wait;
    candidate.departure += bound_.params_.wait;
    candidates_.push(candidate);
  }

  void settle(size_t node, double arrival) {
    arrivals_[node] = arrival;
    const double speed = bound_.params_.max_speed;
    if (lattice_.seesGoal(node)) {
      candidates_.push({arrival + lattice_.wayFrom(node) / speed, arrival, node, goal_offset_});
    }
    for (int i = 0; i < goal_offset_; ++i) {
      const BoundLattice::Offset& offset = lattice_.offsets()[i];
      const auto other = lattice_.neighbour(node, offset);
      if (!other || std::isfinite(arrivals_[*other]) || std::isinf(lattice_.wayFrom(*other)))
        continue;
      if (!lattice_.isOpen(node, offset, *other)) continue;
      const double time = arrival + (offset.length + lattice_.wayFrom(*other)) / speed;
      candidates_.push({time, arrival, node, i});
    }
  }

  Plan planTo(const Candidate& shot) const {
    Plan plan;
    const double speed = bound_.params_.max_speed;
    const auto add = [&](const Point& from, const Point& to, double departure) {
      plan.legs.push_back({from, to, departure, departure + (to - from).norm() / speed});
    };
    add(lattice_.place(shot.node), goalOf(shot), shot.departure);
    plan.arrival = plan.legs.front().arrival;
    for (size_t node = shot.node; node != lattice_.startNode(); node = came_by_[node].node) {
      const Candidate& way = came_by_[node];
      add(lattice_.place(way.node), lattice_.place(node), way.departure);
    }
    std::reverse(plan.legs.begin(), plan.legs.end());
    return plan;
  }

  const OmniscientBound& bound_;
  const BoundLattice& lattice_;
  CrowdHistory& people_;
  int goal_offset_;
  std::vector<double> arrivals_;  // [s], per node; infinite where it is not known yet
  std::vector<Candidate> came_by_;
  std::priority_queue<Candidate> candidates_;
};

OmniscientBound::OmniscientBound(const World& world, const Params& params)
    : params_(validated(params)),
      lattice_(world,
               {params.obstacle_clearance, params.goal_tolerance, params.spacing, params.reach}) {}

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
      const Point to = is_end ? lattice_.arrivalFrom(from) : plan.legs[last].to;
      if (lattice_.sight().isClear(from, to)) {
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
  return params_.start_delay + lattice_.distanceToGoal(lattice_.start()) / params_.max_speed;
}

double OmniscientBound::emptyDriveTime() const {
  return params_.start_delay + lattice_.wayFrom(lattice_.startNode()) / params_.max_speed;
}

}  // namespace pomdp_crowd_nav
