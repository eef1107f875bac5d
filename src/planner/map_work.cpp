// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/map_work.h"

namespace pomdp_crowd_nav {

std::shared_ptr<const ClearanceGrid> MapWork::of(const std::shared_ptr<const StaticMap>& map) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (map_ != map) {
    clearances_ = std::make_shared<const ClearanceGrid>(*map, resolution_);
    map_ = map;
  }
  return clearances_;
}

}  // namespace pomdp_crowd_nav
