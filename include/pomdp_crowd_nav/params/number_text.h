// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pomdp_crowd_nav {

// The number that the whole of `text` spells, whatever the locale; none for anything else, for a
// number that is not finite and for one that does not fit the type.
std::optional<double> parseDouble(const std::string& text);
std::optional<std::int64_t> parseInteger(const std::string& text);

// "[1, 2.5]", for messages.
std::string toText(const std::vector<double>& numbers);

}  // namespace pomdp_crowd_nav
