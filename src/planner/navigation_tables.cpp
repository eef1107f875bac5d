// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/navigation_tables.h"

#include <utility>

#include "pomdp_crowd_nav/pomdp/upper_bound.h"

namespace pomdp_crowd_nav {

// Braces, unlike parentheses, have their arguments made from left to right.
NavigationTables::NavigationTables(const PriorMaker& make_prior, const ClearanceGrid& map,
                                   const Point& goal, const ModelParams& model)
    : NavigationTables{std::async(std::launch::async | std::launch::deferred, makeShortestWay,
                                  std::cref(model), std::cref(map), goal),
                       make_prior(), map} {}

NavigationTables::NavigationTables(std::future<std::optional<ShortestWay>> way,
                                   std::shared_ptr<const RolloutPrior> prior_of_map,
                                   const ClearanceGrid& map)
    : prior(std::move(prior_of_map)), field(*prior, map), shortest_way(way.get()) {}

SharedTables::Pointer SharedTables::of(const std::string& prior,
                                       const std::function<Pointer()>& make) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Pointer& tables = tables_[prior];
  if (!tables) tables = make();
  return tables;
}

}  // namespace pomdp_crowd_nav
