// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/roadmap_prior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

constexpr double kRounding = 1e-6;  // [m]
constexpr double kLookAhead = 1.0;  // [m]

Roadmap::Params roadmapParams(const PriorParams& params) {
  return {params.milestones, params.neighbours, params.milestone_spacing,
          params.clearance + params.extra_clearance, params.seed};
}

// The goal and the milestones that reach it, by their way over the edges.
std::vector<Waypoint> connectedWaypoints(const Roadmap& roadmap, const Point& goal) {
  const std::vector<double> distances = roadmap.distancesTo(goal);
  std::vector<Waypoint> waypoints{{goal, 0.0}};
  for (size_t i = 0; i < distances.size(); ++i) {
    if (std::isfinite(distances[i])) waypoints.push_back({roadmap.milestones()[i], distances[i]});
  }
  std::stable_sort(waypoints.begin(), waypoints.end(), [](const Waypoint& a, const Waypoint& b) {
    return a.distance_to_goal < b.distance_to_goal;
  });
  return waypoints;
}

// Edges join near neighbours only, so their paths are jagged. Pulls them straight: each milestone
// goes on to the best one in sight among those nearer to the goal.
std::vector<Waypoint> straightened(std::vector<Waypoint> waypoints, const LineOfSight& sight) {
  for (size_t i = 1; i < waypoints.size(); ++i) {
    Waypoint& here = waypoints[i];
    for (size_t next = 0; next < i; ++next) {
      const double way =
          (waypoints[next].position - here.position).norm() + waypoints[next].distance_to_goal;
      if (way < here.distance_to_goal && sight.isClear(here.position, waypoints[next].position)) {
        here.distance_to_goal = way;
      }
    }
  }
  return waypoints;
}

}  // namespace

std::shared_ptr<const Roadmap> roadmapOf(const StaticMap& map, const PriorParams& params) {
  static std::mutex mutex;
  static std::shared_ptr<const Roadmap> last;
  const Roadmap::Params wanted = roadmapParams(params);
  const std::lock_guard<std::mutex> lock(mutex);
  if (!last || !last->isOf(map, wanted)) last = std::make_shared<const Roadmap>(map, wanted);
  return last;
}

RoadmapPrior::RoadmapPrior(const StaticMap& map, const Point& goal, const PriorParams& params)
    : RoadmapPrior(roadmapOf(map, params), goal) {}

RoadmapPrior::RoadmapPrior(std::shared_ptr<const Roadmap> roadmap, const Point& goal)
    : roadmap_(std::move(roadmap)),
      goal_(goal),
      index_(roadmap_->sight(),
             straightened(connectedWaypoints(*roadmap_, goal), roadmap_->sight())),
      goal_is_free_(roadmap_->sight().isFree(goal)) {}

// Rounding may leave a robot that drives along the border beyond it.
std::optional<RoadmapPrior::Way> RoadmapPrior::wayFrom(const Point& position) const {
  const Bounds& bounds = roadmap_->sight().map().bounds();
  const Point place = position.cwiseMax(bounds.min).cwiseMin(bounds.max);
  if (!((place - position).norm() <= kRounding)) return std::nullopt;
  if (!roadmap_->sight().isFree(place, LineOfSight::kShortfall)) return wayOutFrom(place);
  const std::optional<int> best = index_.bestFrom(place);
  if (!best) return std::nullopt;
  const Waypoint& next = waypoints()[*best];
  return Way{next.position, (next.position - place).norm() + next.distance_to_goal};
}

// Straight to a goal in the same margin, else out of it and a little on in the direction there:
// close to the edge that is nearly along it.
std::optional<RoadmapPrior::Way> RoadmapPrior::wayOutFrom(const Point& place) const {
  const LineOfSight& sight = roadmap_->sight();
  if (!goal_is_free_ && sight.isClear(place, goal_)) return Way{goal_, (goal_ - place).norm()};
  const std::optional<Point> out = roadmap_->wayOut().nearestFree(place);
  if (!out) return std::nullopt;
  const std::optional<int> best = index_.bestFrom(*out);
  if (!best) return std::nullopt;
  const Waypoint& next = waypoints()[*best];
  const Point onward = next.position - *out;
  const Point ahead = onward * std::min(1.0, kLookAhead / std::max(onward.norm(), kRounding));
  return Way{*out + ahead, (*out - place).norm() + onward.norm() + next.distance_to_goal};
}

std::optional<double> RoadmapPrior::directionAt(const Pose& pose) const {
  const std::optional<Way> way = wayFrom(pose.position);
  if (!way) return std::nullopt;
  return bearing(pose.position, way->target);
}

double RoadmapPrior::distanceToGoal(const Point& position) const {
  const std::optional<Way> way = wayFrom(position);
  return way ? way->length : std::numeric_limits<double>::infinity();
}

Course RoadmapPrior::courseAt(const Pose& pose) const {
  const std::optional<Way> way = wayFrom(pose.position);
  if (!way) return {Point(0.0, 0.0), std::numeric_limits<double>::infinity()};
  return {unitVector(bearing(pose.position, way->target)), way->length};
}

}  // namespace pomdp_crowd_nav
