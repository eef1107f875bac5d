// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "pomdp_crowd_nav/path/hybrid_astar.h"

namespace pomdp_crowd_nav {

// Hybrid A* once more, from the paper and the facts sheet: maps and sets, headings in degrees,
// people walked on step by step, clearances asked of the map. Shares with the fast one the way to
// the goal and the rule for ties.
class NaiveAstar {
 public:
  struct Result {
    bool found = false;
    double cost = 0.0;
    long expansions = 0;
    std::vector<Point> places;
  };

  NaiveAstar(const StaticMap& map, const NavigationField& field, const HybridAstar::Params& params,
             std::vector<PersonBelief> people, std::vector<Point> destinations)
      : map_(map),
        field_(field),
        p_(params),
        people_(std::move(people)),
        destinations_(std::move(destinations)) {}

  Result find(const Pose& start, long max_expansions) const {
    using Key = std::tuple<int, int, int>;  // column, row, degrees of turn since the start
    struct Node {
      Point place;
      int degrees;
      int time;
      double cost;
      Key parent;
      long order;
      bool closed;
    };
    std::map<Key, Node> nodes;
    std::set<std::tuple<double, long, Key>> open;  // value, newest first
    const auto keyOf = [&](const Point& place, int degrees) {
      const Point low = map_.bounds().min;
      const Point size = map_.bounds().max - low;
      const auto bin = [&](double offset, double extent) {
        return std::clamp(static_cast<int>(offset / p_.cell), 0,
                          static_cast<int>(extent / p_.cell));
      };
      return Key(bin(place.x() - low.x(), size.x()), bin(place.y() - low.y(), size.y()), degrees);
    };
    long order = 0;
    const Key root = keyOf(start.position, 0);
    nodes[root] = {start.position, 0, 0, 0.0, root, order, false};
    open.insert({0.0, 0, root});
    Result result;
    while (!open.empty()) {
      const Key key = std::get<2>(*open.begin());
      open.erase(open.begin());
      nodes[key].closed = true;
      const Node parent = nodes[key];
      if ((parent.place - field_.goal()).norm() < p_.goal_tolerance - 1e-6) {
        result.found = true;
        result.cost = parent.cost;
        for (Key k = key; k != root; k = nodes[k].parent) result.places.push_back(nodes[k].place);
        result.places.push_back(start.position);
        std::reverse(result.places.begin(), result.places.end());
        return result;
      }
      if (result.expansions >= max_expansions) return result;
      ++result.expansions;
      for (const int turn : turns()) {
        const int degrees = ((parent.degrees + turn) % 360 + 360) % 360;
        const Point middle = drive(start, parent.place, parent.degrees, turn, 0.5);
        const Point end = drive(start, parent.place, parent.degrees, turn, 1.0);
        const double step = 1.0 + staticCost(start.position, parent.place, middle, end) +
                            peopleCost(start.position, end, parent.time + 1);
        if (std::isinf(step)) continue;
        const double cost = parent.cost + std::pow(p_.cost_discount, parent.time + 1) * step;
        const Key child = keyOf(end, degrees);
        const auto known = nodes.find(child);
        if (known != nodes.end()) {
          if (known->second.closed || known->second.cost <= cost) continue;
          for (auto it = open.begin(); it != open.end(); ++it) {
            if (std::get<2>(*it) != child) continue;
            open.erase(it);
            break;
          }
        }
        --order;
        nodes[child] = {end, degrees, parent.time + 1, cost, key, order, false};
        open.insert({cost + wayToGo(start, end, degrees), order, child});
      }
    }
    return result;
  }

 private:
  bool isCar() const { return p_.vehicle == VehicleKind::kCar; }

  std::vector<int> turns() const {
    std::vector<int> turns{0};
    for (int d = isCar() ? 5 : 10; d <= (isCar() ? 45 : 180); d += isCar() ? 5 : 10) {
      turns.push_back(d);
      if (d != 180) turns.push_back(-d);
    }
    return turns;
  }

  static double headingOf(const Pose& start, int degrees) {
    return start.heading + degrees * M_PI / 180.0;
  }

  // The place after a share of an element: a line after a turn in place, or an arc.
  Point drive(const Pose& start, const Point& from, int degrees, int turn, double share) const {
    const double heading = headingOf(start, degrees);
    const double angle = turn * M_PI / 180.0;
    if (!isCar()) {
      return from + share * Point(std::cos(heading + angle), std::sin(heading + angle));
    }
    if (turn == 0) return from + share * Point(std::cos(heading), std::sin(heading));
    const double radius = 1.0 / angle;
    const double after = heading + share * angle;
    return from +
           radius * Point(std::sin(after) - std::sin(heading), std::cos(heading) - std::cos(after));
  }

  double outside(const Point& p) const {
    const Bounds& b = map_.bounds();
    return std::max({b.min.x() - p.x(), p.x() - b.max.x(), b.min.y() - p.y(), p.y() - b.max.y()});
  }

  double staticCost(const Point& start, const Point& from, const Point& middle,
                    const Point& end) const {
    const double infinite = std::numeric_limits<double>::infinity();
    if (outside(end) >= 0.0 && (outside(from) < 0.0 || outside(end) >= outside(from))) {
      return infinite;
    }
    const double near = std::min(map_.clearance(middle), map_.clearance(end));
    if (near >= p_.clearance) return 0.0;
    const double here = map_.clearance(from);
    const bool leaves = map_.clearance(start) < p_.clearance && here < p_.clearance;
    return leaves && near >= here - 1e-3 ? 0.0 : infinite;
  }

  double peopleCost(const Point& start, const Point& place, int time) const {
    double cost = 0.0;
    for (const PersonBelief& person : people_) {
      Point where = person.position;
      const auto& odds = person.intention.probabilities();
      const double best = *std::max_element(odds.begin(), odds.end());
      const bool sure = best >= p_.crowd.sure_belief;
      if (sure) {
        const Point goal = destinations_[std::max_element(odds.begin(), odds.end()) - odds.begin()];
        const double walked = person.speed * time / p_.crowd.pace;
        const double way = (goal - where).norm();
        where = walked >= way ? goal : Point(where + walked / way * (goal - where));
      }
      const double kept = std::min(p_.crowd.clearance, (person.position - start).norm() - 1e-3);
      const double distance = (where - place).norm();
      if (distance <= kept) return std::numeric_limits<double>::infinity();
      if (!sure && distance < p_.crowd.field_radius) cost += p_.crowd.field_strength / distance;
    }
    return cost;
  }

  double wayToGo(const Pose& start, const Point& place, int degrees) const {
    const double heading = headingOf(start, degrees);
    const Point facing(std::cos(heading), std::sin(heading));
    const Point to_goal = field_.goal() - place;
    if (!map_.hasObstacles()) {
      return p_.way_weight * to_goal.norm() -
             p_.heading_weight * facing.dot(to_goal) / to_goal.norm();
    }
    const NavigationCell cell =
        field_.at(static_cast<float>(place.x()), static_cast<float>(place.y()));
    const double way = std::max<double>(to_goal.norm(), cell.distance_to_goal);
    return p_.way_weight * way -
           p_.heading_weight * (facing.x() * cell.direction_x + facing.y() * cell.direction_y);
  }

  const StaticMap& map_;
  const NavigationField& field_;
  HybridAstar::Params p_;
  std::vector<PersonBelief> people_;
  std::vector<Point> destinations_;
};

}  // namespace pomdp_crowd_nav
