// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/param_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {
namespace {

// Levenshtein distance: letters to insert, delete or replace to turn `a` into `b`.
size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

// The known key that is nearest to `key`, empty when none is near enough to be meant.
std::string closest(const std::string& key, const std::set<std::string>& known) {
  std::string best;
  size_t best_distance = std::max<size_t>(2, key.size() / 3) + 1;
  for (const std::string& candidate : known) {
    const size_t distance = editDistance(key, candidate);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = candidate;
  }
  return best;
}

}  // namespace

template <typename T>
bool ParamReader::readAs(const std::string& key, T& field) {
  known_.insert(key);
  T value = field;
  if (!get(key, value)) return false;
  field = std::move(value);
  return true;
}

bool ParamReader::read(const std::string& key, double& field) { return readAs(key, field); }
bool ParamReader::read(const std::string& key, int& field) { return readAs(key, field); }
bool ParamReader::read(const std::string& key, bool& field) { return readAs(key, field); }
bool ParamReader::read(const std::string& key, std::string& field) { return readAs(key, field); }

bool ParamReader::read(const std::string& key, std::vector<double>& field) {
  return readAs(key, field);
}

bool ParamReader::read(const std::string& key, std::vector<std::vector<double>>& field) {
  return readAs(key, field);
}

bool ParamReader::read(const std::string& key, std::vector<Point>& field) {
  std::vector<std::vector<double>> rows;
  if (!readAs(key, rows)) return false;
  std::vector<Point> points;
  for (const auto& row : rows) {
    if (row.size() != 2) fail(key, "a list of [x, y]", toText(row));
    points.emplace_back(row[0], row[1]);
  }
  field = std::move(points);
  return true;
}

void ParamReader::requireAllUsed() const {
  for (const std::string& key : keys()) {
    if (known_.count(key) > 0) continue;
    const std::string meant = closest(key, known_);
    const std::string hint = meant.empty() ? "" : fmt::format(", did you mean '{}'?", meant);
    throw std::runtime_error(fmt::format("{}: unknown key '{}'{}", source(), key, hint));
  }
}

void ParamReader::fail(const std::string& key, const std::string& expected,
                       const std::string& value) const {
  throw std::runtime_error(
      fmt::format("{}: {}: expected {}, got '{}'", source(), key, expected, value));
}

}  // namespace pomdp_crowd_nav
