// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/prior/clearance_grid.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"
#include "pomdp_crowd_nav/prior/shortest_way.h"

namespace pomdp_crowd_nav {

// What an ES planner knows of a map and a goal before it meets anybody. Immutable, thread-safe.
struct NavigationTables {
  using PriorMaker = std::function<std::shared_ptr<const RolloutPrior>()>;

  // The shortest way is found in a thread of its own beside the prior, of this map and goal. Throws
  // what `make_prior` and makeShortestWay throw, once both have ended.
  NavigationTables(const PriorMaker& make_prior, const ClearanceGrid& map, const Point& goal,
                   const ModelParams& model);

  std::shared_ptr<const RolloutPrior> prior;
  NavigationField field;
  std::optional<ShortestWay> shortest_way;

 private:
  NavigationTables(std::future<std::optional<ShortestWay>> way,
                   std::shared_ptr<const RolloutPrior> prior_of_map, const ClearanceGrid& map);
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
