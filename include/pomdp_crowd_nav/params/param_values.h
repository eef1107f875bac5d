// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "pomdp_crowd_nav/params/load_params.h"

namespace pomdp_crowd_nav {

using ParamValue = std::variant<bool, int, double, std::string>;
using ParamValues = std::map<std::string, ParamValue>;  // by key

// The values of all keys of a profile.
ParamValues valuesOf(const NavigationParams& params);

// The same with some values replaced. Throws as loadNavigationParams does, also for a key that is
// not known.
NavigationParams withValues(const NavigationParams& params, const ParamValues& values);

// Keys whose values differ.
std::vector<std::string> changedKeys(const NavigationParams& from, const NavigationParams& to);

// For messages.
std::string toText(const ParamValue& value);

}  // namespace pomdp_crowd_nav
