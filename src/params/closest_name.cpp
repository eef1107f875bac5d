// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/closest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace pomdp_crowd_nav {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

// Levenshtein distance: letters to insert, delete or replace to turn `a` into `b`.
size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

// "astar" may mean "1d_astar".
std::string shortestAround(const std::string& part, const std::vector<std::string>& known) {
  constexpr size_t kShortestPart = 3;
  std::string best;
  if (part.size() < kShortestPart) return best;
  for (const std::string& candidate : known) {
    if (candidate.find(part) == std::string::npos) continue;
    if (best.empty() || candidate.size() < best.size()) best = candidate;
  }
  return best;
}

}  // namespace

std::string closestName(const std::string& name, const std::vector<std::string>& known) {
  std::string best;
  size_t best_distance = std::max<size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : known) {
    const size_t distance = editDistance(name, candidate);
    if (distance >= std::min(best_distance, candidate.size())) continue;
    best_distance = distance;
    best = candidate;
  }
  return best.empty() ? shortestAround(name, known) : best;
}

std::string didYouMean(const std::string& name, const std::vector<std::string>& known) {
  const std::string meant = closestName(name, known);
  return meant.empty() ? "" : fmt::format(", did you mean '{}'?", meant);
}

std::string commaSeparated(const std::vector<std::string>& names) {
  std::string line;
  for (const std::string& name : names) line += (line.empty() ? "" : ", ") + name;
  return line;
}

}  // namespace pomdp_crowd_nav
