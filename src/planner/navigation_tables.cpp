// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/navigation_tables.h"

#include <utility>

#include "pomdp_crowd_nav/pomdp/upper_bound.h"

namespace pomdp_crowd_nav {

NavigationTables::NavigationTables(std::shared_ptr<const RolloutPrior> prior_of_map,
                                   const ClearanceGrid& map, const ModelParams& model)
    : prior(std::move(prior_of_map)),
      field(*prior, map),
      shortest_way(makeShortestWay(model, field, map.map)) {}

SharedTables::Pointer SharedTables::of(const std::string& prior,
                                       const std::function<Pointer()>& make) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Pointer& tables = tables_[prior];
  if (!tables) tables = make();
  return tables;
}

}  // namespace pomdp_crowd_nav
