// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>

#include "pomdp_crowd_nav/prior/clearance_grid.h"

namespace pomdp_crowd_nav {

// What planners of one map share whatever their goals, made once per map; that of the map that was
// asked for last is kept. Thread-safe.
class MapWork {
 public:
  // `resolution` [m] of the prior.
  explicit MapWork(double resolution) : resolution_(resolution) {}

  std::shared_ptr<const ClearanceGrid> of(const std::shared_ptr<const StaticMap>& map);

 private:
  double resolution_;
  std::mutex mutex_;
  std::shared_ptr<const StaticMap> map_;
  std::shared_ptr<const ClearanceGrid> clearances_;
};

}  // namespace pomdp_crowd_nav
