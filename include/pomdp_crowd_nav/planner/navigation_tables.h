// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"
#include "pomdp_crowd_nav/prior/shortest_way.h"

namespace pomdp_crowd_nav {

// What an ES planner knows of a map and a goal before it meets anybody. Immutable, thread-safe.
struct NavigationTables {
  NavigationTables(std::shared_ptr<const RolloutPrior> prior_of_map, const ClearanceGrid& map,
                   const ModelParams& model);
  NavigationTables(std::shared_ptr<const RolloutPrior> prior_of_map, const StaticMap& map,
                   const ModelParams& model, double resolution)
      : NavigationTables(std::move(prior_of_map), ClearanceGrid(map, resolution), model) {}
  NavigationTables(const NavigationTables&) = delete;  // shortest_way refers to field
  NavigationTables& operator=(const NavigationTables&) = delete;

  std::shared_ptr<const RolloutPrior> prior;
  NavigationField field;
  std::optional<ShortestWay> shortest_way;
};

// Tables that planners of one map, one goal and the same parameters share, whatever seeds and
// people tell them apart. Thread-safe.
class SharedTables {
 public:
  using Pointer = std::shared_ptr<const NavigationTables>;

  // Those of a prior, made once.
  Pointer of(const std::string& prior, const std::function<Pointer()>& make);

 private:
  std::mutex mutex_;
  std::map<std::string, Pointer> tables_;
};

}  // namespace pomdp_crowd_nav
