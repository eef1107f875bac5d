// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pomdp_crowd_nav {

// The known name that is nearest to `name` by letters to insert, delete or replace, or else the
// shortest one that it is a part of; empty when none is near enough to be meant.
std::string closestName(const std::string& name, const std::vector<std::string>& known);

// ", did you mean '2d_fmm'?", or nothing: the end of a message about an unknown name.
std::string didYouMean(const std::string& name, const std::vector<std::string>& known);

// "a, b, c"
std::string commaSeparated(const std::vector<std::string>& names);

}  // namespace pomdp_crowd_nav
