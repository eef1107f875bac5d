// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/param_reader.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "pomdp_crowd_nav/params/closest_name.h"
#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {
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
    const std::string hint = didYouMean(key, {known_.begin(), known_.end()});
    throw std::runtime_error(fmt::format("{}: unknown key '{}'{}", source(), key, hint));
  }
}

void ParamReader::fail(const std::string& key, const std::string& expected,
                       const std::string& value) const {
  throw std::runtime_error(
      fmt::format("{}: {}: expected {}, got '{}'", source(), key, expected, value));
}

}  // namespace pomdp_crowd_nav
