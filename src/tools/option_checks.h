// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/params/closest_name.h"
#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {

// Checks of command line options; what they answer is one line that fits behind the option's name.

inline CLI::Validator wholeNumber(std::int64_t lowest, std::int64_t highest) {
  const auto check = [=](std::string& text) -> std::string {
    const auto value = parseInteger(text);
    if (value && *value >= lowest && *value <= highest) return "";
    return fmt::format("expected a whole number from {} to {}, got '{}'", lowest, highest, text);
  };
  return CLI::Validator(check, fmt::format("{} to {}", lowest, highest));
}

// Greater than 0, at most a million.
inline CLI::Validator positiveNumber() {
  constexpr double kHighest = 1.0e6;
  const auto check = [=](std::string& text) -> std::string {
    const auto value = parseDouble(text);
    if (value && *value > 0.0 && *value <= kHighest) return "";
    return fmt::format("expected a number above 0, at most {:.0f}, got '{}'", kHighest, text);
  };
  return CLI::Validator(check, "above 0");
}

inline CLI::Validator oneOf(const std::vector<std::string>& names) {
  const auto check = [=](std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return "";
    return fmt::format("expected one of {}, got '{}'{}", commaSeparated(names), text,
                       didYouMean(text, names));
  };
  return CLI::Validator(check, "one of " + commaSeparated(names));
}

// Of an option with several values.
template <typename T>
void requireDifferent(const char* option, std::vector<T> values) {
  std::sort(values.begin(), values.end());
  const auto twice = std::adjacent_find(values.begin(), values.end());
  if (twice == values.end()) return;
  throw std::runtime_error(fmt::format("{}: {} is named twice", option, *twice));
}

// Names that stand in a cell of a CSV file, each once.
inline void requireWorlds(const std::vector<std::string>& worlds) {
  requireDifferent("--worlds", worlds);
  for (const std::string& world : worlds) {
    if (world.find_first_of(",\"\n\r") == std::string::npos) continue;
    throw std::runtime_error(
        fmt::format("--worlds: '{}' has a character that a CSV file cannot hold", world));
  }
}

}  // namespace pomdp_crowd_nav
