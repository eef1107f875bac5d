// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/belief/crowd_belief.h"
#include "pomdp_crowd_nav/despot/noise_streams.h"
#include "pomdp_crowd_nav/world/pedestrian.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Where the attended people will be: for every scenario, depth and person, drawn once per decision.
//
// People do not react to the robot, so this table holds everything that is random in the POMDP; a
// step of the model then is a robot move and a few distance tests. In each scenario every person
// does one thing, drawn from its belief: walk to a destination, stand, but for the noise of the
// model to and fro, or walk on straight ahead. Positions are clamped to the field.
class CrowdFutures {
 public:
  struct Shape {
    int scenarios = 100;  // K
    int depth = 100;      // D
    double step = 1.0;    // [s]
    Bounds bounds;
  };
  struct Place {
    float x = 0.0F;  // [m]
    float y = 0.0F;
    float mid_x = 0.0F;  // half a step later, on the straight way to the next place
    float mid_y = 0.0F;
  };

  // Draws the table, reusing memory. `start` is where the people are when the first step begins.
  void draw(const Shape& shape, const std::vector<PersonBelief>& people,
            const std::vector<Point>& destinations, const PedestrianModel& model,
            const NoiseStreams& noise);

  int personCount() const { return person_count_; }
  int depth() const { return depth_; }
  int scenarioCount() const { return scenario_count_; }
  // [m], of anybody in one step but the first, in which who is off the field is moved onto it.
  float longestStride() const { return longest_stride_; }

  // personCount() places, depth 0 is now.
  const Place* at(int scenario, int depth) const {
    return places_.data() + (static_cast<size_t>(scenario) * (depth_ + 1) + depth) * person_count_;
  }

  // Key of what is observed at a depth: everybody's cell on a 1 m grid (paper, section
  // Observation Modeling; the vehicle's pose is known and needs no part in it).
  std::uint64_t observation(int scenario, int depth) const {
    return observations_[static_cast<size_t>(scenario) * (depth_ + 1) + depth];
  }

 private:
  int scenario_count_ = 0;
  int depth_ = 0;
  int person_count_ = 0;
  float longest_stride_ = 0.0F;
  std::vector<Place> places_;
  std::vector<std::uint64_t> observations_;
};

}  // namespace pomdp_crowd_nav
