// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {

// The planner of one trip, and the next one while it is made with other parameters. Without ROS;
// belongs to the planning thread.
class TripPlanner {
 public:
  using Params = std::shared_ptr<const NavigationParams>;

  // Where people may be heading, [m].
  explicit TripPlanner(const std::vector<Point>& destinations) : destinations_(destinations) {}

  // Makes the planner of another trip. Throws as makePlanner does, and then has none.
  void start(const Point& goal, const std::shared_ptr<const StaticMap>& map, const Params& params);

  // Between two decisions: goes over to other parameters. The planner that stands decides until
  // one is made, in another thread; then true is returned, once. What follows from map and goal is
  // made anew only where the change concerns it. Throws as makePlanner does.
  bool follow(const Params& params);

  // Of the trip; only where it is ready.
  bool isReady() const { return planner_ != nullptr; }
  Planner& planner() const { return *planner_; }
  const NavigationParams& params() const { return *params_; }

 private:
  std::unique_ptr<Planner> make(const NavigationParams& params, SharedTables& tables) const;

  std::vector<Point> destinations_;
  Point goal_{0.0, 0.0};
  std::shared_ptr<const StaticMap> map_;
  Params params_, next_params_;
  std::unique_ptr<SharedTables> tables_, next_tables_;
  std::unique_ptr<Planner> planner_;
  std::future<std::unique_ptr<Planner>> next_;  // last: it reads the others until it is done
};

}  // namespace pomdp_crowd_nav
