// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <unordered_map>

#include "pomdp_crowd_nav/sim/crowd.h"
#include "pomdp_crowd_nav/world/track.h"

namespace pomdp_crowd_nav {

// A lidar with a person tracker behind it.
class PersonSensor {
 public:
  struct Params {
    double range = 30.0;           // [m], people farther than this are not reported
    double position_noise = 0.0;   // [m], standard deviation on each axis
    double dropout = 0.0;          // probability that a person in range is missed in a sweep
    double velocity_window = 0.5;  // [s], velocity is the mean over about this time
  };

  // Throws std::invalid_argument for a parameter out of range.
  PersonSensor(const Params& params, std::uint64_t seed);

  // Everybody in range of `from`; velocities come from this sensor's own earlier sweeps and are
  // zero for somebody new. `stamp` is the time of the sightings.
  TrackList sweep(const Point& from, const std::vector<Walker>& sighted, double stamp);
  void reset();  // forgets earlier sweeps

 private:
  struct Sighting {
    double stamp;
    Point position;
  };

  void forget(const std::vector<Walker>& sighted, double stamp);
  Point measured(const Point& position);
  Point velocity(const std::vector<Sighting>& history, const Point& position, double stamp) const;

  Params params_;
  std::mt19937_64 random_;
  std::unordered_map<std::int64_t, std::vector<Sighting>> history_;
};

}  // namespace pomdp_crowd_nav
