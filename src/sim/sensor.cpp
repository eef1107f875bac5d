// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/sensor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <unordered_set>

#include "pomdp_crowd_nav/sim/random_draws.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kShortestMemory = 1.0;  // [s], so that slow sweeps have velocities too
constexpr double kTimeSlack = 1.0e-9;    // [s], rounding in differences of stamps

void require(bool fits, const char* name, const char* expected, double value) {
  if (fits) return;
  throw std::invalid_argument(fmt::format("sensor.{} must {}, got {}", name, expected, value));
}

}  // namespace

PersonSensor::PersonSensor(const Params& params, std::uint64_t seed)
    : params_(params), random_(seed) {
  require(params.range > 0.0, "range", "be positive", params.range);
  require(params.position_noise >= 0.0 && std::isfinite(params.position_noise), "position_noise",
          "be finite and not negative", params.position_noise);
  require(params.dropout >= 0.0 && params.dropout <= 1.0, "dropout", "be in [0, 1]",
          params.dropout);
  require(params.velocity_window > 0.0 && std::isfinite(params.velocity_window), "velocity_window",
          "be positive and finite", params.velocity_window);
}

TrackList PersonSensor::sweep(const Point& from, const std::vector<Walker>& sighted, double stamp) {
  forget(sighted, stamp);
  TrackList list;
  list.stamp = stamp;
  for (const Walker& walker : sighted) {
    if ((walker.position - from).norm() > params_.range) continue;
    if (params_.dropout > 0.0 && drawUniform(random_) < params_.dropout) continue;
    const Point position = measured(walker.position);
    std::vector<Sighting>& history = history_[walker.id];
    list.tracks.push_back({walker.id, position, velocity(history, position, stamp)});
    history.push_back({stamp, position});
  }
  return list;
}

void PersonSensor::reset() { history_.clear(); }

// Forgets people who are gone, sightings too old to say how fast somebody is now, and those at
// `stamp` or later, which this sweep replaces.
void PersonSensor::forget(const std::vector<Walker>& sighted, double stamp) {
  std::unordered_set<std::int64_t> present;
  for (const Walker& walker : sighted) present.insert(walker.id);
  const double memory = std::max(2.0 * params_.velocity_window, kShortestMemory);
  const auto isUseless = [&](const Sighting& sighting) {
    const double age = stamp - sighting.stamp;
    return age < kTimeSlack || age > memory + kTimeSlack;
  };
  for (auto entry = history_.begin(); entry != history_.end();) {
    std::vector<Sighting>& history = entry->second;
    history.erase(std::remove_if(history.begin(), history.end(), isUseless), history.end());
    const bool gone = history.empty() || present.count(entry->first) == 0;
    entry = gone ? history_.erase(entry) : std::next(entry);
  }
}

Point PersonSensor::measured(const Point& position) {
  if (params_.position_noise == 0.0) return position;
  const double error_x = params_.position_noise * drawNormal(random_);
  const double error_y = params_.position_noise * drawNormal(random_);
  return position + Point(error_x, error_y);
}

// Mean velocity since the sighting whose age is nearest to the window; zero without one.
Point PersonSensor::velocity(const std::vector<Sighting>& history, const Point& position,
                             double stamp) const {
  const auto distance = [&](const Sighting& sighting) {
    return std::abs(stamp - sighting.stamp - params_.velocity_window);
  };
  const auto reference = std::min_element(
      history.begin(), history.end(),
      [&](const Sighting& a, const Sighting& b) { return distance(a) < distance(b); });
  if (reference == history.end()) return Point(0.0, 0.0);
  return (position - reference->position) / (stamp - reference->stamp);
}

}  // namespace pomdp_crowd_nav
