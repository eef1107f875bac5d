// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "pomdp_crowd_nav/planner/map_work.h"
#include "pomdp_crowd_nav/planner/navigation_tables.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/guarded.h"

namespace pomdp_crowd_nav {

// A planner, and what it is for.
struct ReadyPlanner {
  Goal goal;
  std::shared_ptr<const StaticMap> map;
  std::unique_ptr<Planner> planner;
};

// Makes the planner of the newest goal, map and parameters in a thread of its own, while decisions
// go on with the one before. What is overtaken while it waits for its turn is never begun, and what
// a change does not concern is kept.
class PlannerBuilder {
 public:
  // Called from the builder's thread, without the lock, when the newest trip cannot be: its goal is
  // in an obstacle of the newest map, or no way leads to it.
  using Failed = std::function<void(const Goal&, const std::string& reason)>;

  // `destinations` [m], of people. `drive` and `map_work` must outlive the builder.
  PlannerBuilder(std::vector<Point> destinations, Guarded<Drive>& drive, MapWork& map_work,
                 Failed failed);
  ~PlannerBuilder();

  // The planner that was made last, unless it was taken before.
  std::optional<ReadyPlanner> take();

 private:
  struct Order {
    Goal goal;
    std::shared_ptr<const StaticMap> map;
    std::shared_ptr<const NavigationParams> params;
    Point robot{0.0, 0.0};   // [m]
    bool is_change = false;  // of the parameters only, on a trip that is under way

    bool isOfTrip(const Order& other) const {
      return goal.number == other.goal.number && map == other.map;
    }
  };

  void run();
  std::optional<Order> present() const;
  std::optional<Order> nextOrder();
  bool isNewest(const Order& order) const;
  std::string make(const Order& order);

  std::vector<Point> destinations_;
  Guarded<Drive>& drive_;
  MapWork& map_work_;
  Failed failed_;
  // Both touched by the builder's thread only.
  Order last_;
  std::shared_ptr<SharedTables> tables_;  // of last_

  Guarded<std::optional<ReadyPlanner>> ready_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace pomdp_crowd_nav
