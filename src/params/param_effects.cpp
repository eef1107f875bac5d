// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/param_effects.h"

#include <algorithm>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/params/param_values.h"

namespace pomdp_crowd_nav {
namespace {

// Beginnings of keys of which the planner, or what it knows of map and goal, knows nothing.
const std::vector<std::string> kNotOfPlanner = {"search_time", "emergency/", "display/"};
const std::vector<std::string> kNotOfTables = {"search_time",
                                               "emergency/",
                                               "display/",
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

bool concernsPlanner(const NavigationParams& from, const NavigationParams& to) {
  return differ(from, to, kNotOfPlanner);
}

bool concernsTables(const NavigationParams& from, const NavigationParams& to) {
  return differ(from, to, kNotOfTables);
}

}  // namespace pomdp_crowd_nav
