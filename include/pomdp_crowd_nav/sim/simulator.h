// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "pomdp_crowd_nav/sim/base.h"
#include "pomdp_crowd_nav/sim/crowd.h"
#include "pomdp_crowd_nav/sim/sensor.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {

// The world outside the robot: its base, the crowd and the sensor, on one clock.
class Simulator {
 public:
  struct Params {
    VehicleParams vehicle;
    PersonSensor::Params sensor;
    double command_timeout = 0.5;   // [s], an older command brings the base to rest
    std::string crowd = "corners";  // how people walk who are generated, see crowdNames()
    int pedestrians = 100;          // people in a generated crowd
    bool uniform_respawn = false;   // false: the paper's rule (facts sheet, section 1)
    std::uint64_t seed = 1;
  };

  // Throws std::invalid_argument for a parameter out of range, std::runtime_error for a tracks
  // file that cannot be read.
  Simulator(const World& world, const Params& params);

  // Holds from now until it is replaced or command_timeout has passed.
  void setCommand(const BaseCommand& command);

  // Moves the base on by `duration` seconds and the crowd by the ticks that fall into it: at each
  // multiple of Crowd::kTick the base moves first, then people (facts sheet, section 1).
  void advance(double duration);

  void placeRobot(const Pose& pose);  // at rest

  // Stamped with the time of the sightings, which can be earlier than `time`: with the last tick
  // of a generated crowd, with the last sample of a recorded one.
  TrackList sense();

  double time() const { return time_; }  // [s] since the start
  const SimulatedBase& base() const { return base_; }
  const Crowd& crowd() const { return *crowd_; }
  const World& world() const { return world_; }

 private:
  void moveBase(double until);

  World world_;
  Params params_;
  SimulatedBase base_;
  PersonSensor sensor_;
  std::unique_ptr<Crowd> crowd_;
  BaseCommand command_;
  double command_time_ = 0.0;
  double time_ = 0.0;
  long crowd_ticks_ = 0;
};

}  // namespace pomdp_crowd_nav
