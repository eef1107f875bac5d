// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/roadmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <utility>

#include "grow_roadmap.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void require(bool holds, const char* name, const char* range, double value) {
  if (holds) return;
  throw std::invalid_argument(fmt::format("prior.{} must be {}, got {}", name, range, value));
}

const Roadmap::Params& validated(const Roadmap::Params& params) {
  require(params.milestones >= 1 && params.milestones <= 100000, "milestones",
          "between 1 and 100000", params.milestones);
  require(params.neighbours >= 1 && params.neighbours <= 1000, "neighbours", "between 1 and 1000",
          params.neighbours);
  require(params.spacing >= 0.0, "milestone_spacing", "at least 0", params.spacing);
  require(params.clearance >= 0.0, "clearance", "at least 0", params.clearance);
  require(params.seed >= 0, "seed", "at least 0", params.seed);
  return params;
}

bool same(const StaticMap& a, const StaticMap& b) {
  const auto same_circle = [](const Circle& c, const Circle& d) {
    return c.center == d.center && c.radius == d.radius;
  };
  const auto same_polygon = [](const Polygon& p, const Polygon& q) {
    return p.closed == q.closed && p.vertices == q.vertices;
  };
  const StaticMap::Obstacles& x = a.obstacles();
  const StaticMap::Obstacles& y = b.obstacles();
  if (a.bounds().min != b.bounds().min || a.bounds().max != b.bounds().max) return false;
  if (!std::equal(x.circles.begin(), x.circles.end(), y.circles.begin(), y.circles.end(),
                  same_circle)) {
    return false;
  }
  if (!std::equal(x.polygons.begin(), x.polygons.end(), y.polygons.begin(), y.polygons.end(),
                  same_polygon)) {
    return false;
  }
  if (!x.grid || !y.grid) return x.grid.has_value() == y.grid.has_value();
  return x.grid->origin == y.grid->origin && x.grid->resolution == y.grid->resolution &&
         x.grid->columns == y.grid->columns && x.grid->blocked == y.grid->blocked;
}

// Milestones that are joined, directly or over others.
class Components {
 public:
  explicit Components(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int of(int vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }
  void join(int a, int b) { parent_[of(a)] = of(b); }

 private:
  std::vector<int> parent_;
};

}  // namespace

Roadmap::Roadmap(const StaticMap& map, const Params& params)
    : params_(validated(params)), sight_(map, params.clearance), way_out_(sight_) {
  GrownRoadmap grown = growRoadmap(sight_, params_);
  milestones_ = std::move(grown.milestones);
  edges_ = std::move(grown.edges);
  joinComponents();
}

// The nearest neighbours of a milestone may all be out of its sight, behind a wall. What sees each
// other farther away joins the parts of the roadmap, the nearest first.
void Roadmap::joinComponents() {
  Components components(milestones_.size());
  for (const Edge& edge : edges_) components.join(edge.from, edge.to);
  std::vector<Edge> bridges;
  const int count = static_cast<int>(milestones_.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (components.of(a) == components.of(b)) continue;
      bridges.push_back({a, b, (milestones_[a] - milestones_[b]).norm()});
    }
  }
  std::sort(bridges.begin(), bridges.end(),
            [](const Edge& e, const Edge& f) { return e.length < f.length; });
  for (const Edge& bridge : bridges) {
    if (components.of(bridge.from) == components.of(bridge.to)) continue;
    if (!sight_.isClear(milestones_[bridge.from], milestones_[bridge.to])) continue;
    components.join(bridge.from, bridge.to);
    edges_.push_back(bridge);
  }
}

// As edges whose end `to` is the goal.
std::vector<Roadmap::Edge> Roadmap::waysTo(const Point& goal) const {
  const int count = static_cast<int>(milestones_.size());
  std::vector<Edge> ways;
  for (int i = 0; i < count; ++i) ways.push_back({i, count, (milestones_[i] - goal).norm()});
  std::sort(ways.begin(), ways.end(),
            [](const Edge& e, const Edge& f) { return e.length < f.length; });
  std::vector<Edge> clear;
  for (const Edge& way : ways) {
    if (static_cast<int>(clear.size()) == params_.neighbours) break;
    if (sight_.isClear(milestones_[way.from], goal)) clear.push_back(way);
  }
  return clear;
}

// Dijkstra's algorithm from the goal.
std::vector<double> Roadmap::distancesTo(const Point& goal) const {
  const std::vector<Edge> last_edges = waysTo(goal);
  if (last_edges.empty()) {
    throw std::invalid_argument(
        fmt::format("goal ({}, {}) cannot be joined to the roadmap: none of its {} milestones is "
                    "in sight, {} m clear of obstacles",
                    goal.x(), goal.y(), milestones_.size(), sight_.clearance()));
  }
  std::vector<std::vector<std::pair<int, double>>> neighbours(milestones_.size());
  for (const Edge& edge : edges_) {
    neighbours[edge.from].emplace_back(edge.to, edge.length);
    neighbours[edge.to].emplace_back(edge.from, edge.length);
  }
  using Reached = std::pair<double, int>;  // [m], milestone
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  std::vector<double> distances(milestones_.size(), kInfinity);
  const auto reach = [&](int milestone, double distance) {
    if (!(distance < distances[milestone])) return;
    distances[milestone] = distance;
    queue.push({distance, milestone});
  };
  for (const Edge& edge : last_edges) reach(edge.from, edge.length);
  while (!queue.empty()) {
    const auto [distance, milestone] = queue.top();
    queue.pop();
    if (distance > distances[milestone]) continue;  // outdated
    for (const auto& [next, length] : neighbours[milestone]) reach(next, distance + length);
  }
  return distances;
}

bool Roadmap::isOf(const StaticMap& map, const Params& params) const {
  return params.milestones == params_.milestones && params.neighbours == params_.neighbours &&
         params.spacing == params_.spacing && params.clearance == params_.clearance &&
         params.seed == params_.seed && same(map, sight_.map());
}

}  // namespace pomdp_crowd_nav
