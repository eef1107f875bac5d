// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/trip_planner.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "pomdp_crowd_nav/params/param_values.h"

namespace pomdp_crowd_nav {
namespace {

// Beginnings of keys of which the planner, or what it knows of map and goal, knows nothing.
const std::vector<std::string> kNotOfPlanner = {"search_time", "emergency/"};
const std::vector<std::string> kNotOfTables = {"search_time",
                                               "emergency/",
                                               "reward/",
                                               "search/",
                                               "attended_pedestrians",
                                               "model/pedestrian_distance",
                                               "model/near_distance",
                                               "model/far_distance",
                                               "model/bold_"};

bool differ(const NavigationParams& a, const NavigationParams& b,
            const std::vector<std::string>& but_for) {
  const std::vector<std::string> keys = changedKeys(a, b);
  return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) {
    return std::none_of(but_for.begin(), but_for.end(), [&](const std::string& beginning) {
      return key.compare(0, beginning.size(), beginning) == 0;
    });
  });
}

}  // namespace

void TripPlanner::start(const Point& goal, const std::shared_ptr<const StaticMap>& map,
                        const Params& params) {
  next_ = {};  // waits for one that is being made
  next_tables_.reset();
  planner_.reset();
  goal_ = goal;
  map_ = map;
  params_ = params;
  tables_ = std::make_unique<SharedTables>();
  planner_ = make(*params, *tables_);
}

bool TripPlanner::follow(const Params& params) {
  if (next_.valid()) {
    if (next_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    params_ = next_params_;
    if (next_tables_) tables_ = std::move(next_tables_);
    planner_ = next_.get();
    return true;
  }
  if (params == params_) return false;
  if (!differ(*params_, *params, kNotOfPlanner)) {
    params_ = params;
    return false;
  }
  next_params_ = params;
  if (differ(*params_, *params, kNotOfTables)) next_tables_ = std::make_unique<SharedTables>();
  SharedTables& tables = next_tables_ ? *next_tables_ : *tables_;
  next_ = std::async(std::launch::async, [this, params, &tables] { return make(*params, tables); });
  return false;
}

std::unique_ptr<Planner> TripPlanner::make(const NavigationParams& params,
                                           SharedTables& tables) const {
  Task task{*map_, goal_, destinations_};
  task.shared_tables = &tables;
  return makePlanner(params.planner, task, params.planning);
}

}  // namespace pomdp_crowd_nav
