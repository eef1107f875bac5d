// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/simulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pomdp_crowd_nav/sim/crowd_factory.h"
#include "pomdp_crowd_nav/sim/recorded_crowd.h"
#include "pomdp_crowd_nav/sim/tracks_file.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kMaxPedestrians = 10000;
constexpr double kTimeSlack = 1.0e-9;                         // [s], rounding in sums of durations
constexpr std::uint64_t kSensorStream = 0x9e3779b97f4a7c15u;  // sensor and crowd draw apart

const Simulator::Params& validated(const Simulator::Params& params) {
  if (params.pedestrians < 0 || params.pedestrians > kMaxPedestrians) {
    throw std::invalid_argument(fmt::format("pedestrians must be between 0 and {}, got {}",
                                            kMaxPedestrians, params.pedestrians));
  }
  if (!(params.command_timeout > 0.0)) {
    throw std::invalid_argument(
        fmt::format("command_timeout must be positive, got {}", params.command_timeout));
  }
  requireKnownCrowd(params.crowd);
  return params;
}

// A recording of another place shows nobody, which would pass for an empty one.
std::vector<TrackSample> recordingIn(const World& world) {
  std::vector<TrackSample> recording = readTracksFile(world.tracks_file);
  const bool is_of_here = std::any_of(
      recording.begin(), recording.end(),
      [&](const TrackSample& sample) { return world.bounds.contains(sample.position); });
  if (is_of_here) return recording;
  throw std::invalid_argument(
      fmt::format("{}: nobody in it walks on the field of {}", world.tracks_file, world.name));
}

std::unique_ptr<Crowd> crowdOf(const World& world, const Simulator::Params& params) {
  if (world.tracks_file.empty()) {
    return makeCrowd(params.crowd, world,
                     {params.pedestrians, params.uniform_respawn, params.seed});
  }
  return std::make_unique<RecordedCrowd>(
      recordingIn(world), RecordedCrowd::Params{world.tracks_start_time, world.left_out});
}

}  // namespace

Simulator::Simulator(const World& world, const Params& params)
    : world_(world),
      params_(validated(params)),
      base_(params.vehicle, world.start),
      sensor_(params.sensor, params.seed ^ kSensorStream),
      crowd_(crowdOf(world, params)) {}

void Simulator::setCommand(const BaseCommand& command) {
  command_ = command;
  command_time_ = time_;
}

void Simulator::advance(double duration) {
  if (!(duration >= 0.0) || !std::isfinite(duration)) {
    throw std::invalid_argument(fmt::format("cannot advance by {} s", duration));
  }
  const double end = time_ + duration;
  while (true) {
    const double next_tick = Crowd::kTick * static_cast<double>(crowd_ticks_ + 1);
    if (next_tick > end + kTimeSlack) break;
    moveBase(next_tick);
    crowd_->tick();
    ++crowd_ticks_;
  }
  if (end > time_) moveBase(end);
}

void Simulator::moveBase(double until) {
  const double expiry = command_time_ + params_.command_timeout + kTimeSlack;
  const double held_until = std::clamp(expiry, time_, std::max(time_, until));
  base_.follow(command_, held_until - time_);
  base_.follow({}, until - held_until);
  time_ = until;
}

void Simulator::placeRobot(const Pose& pose) {
  base_.place(pose);
  command_ = {};
}

TrackList Simulator::sense() {
  const double stamp = Crowd::kTick * static_cast<double>(crowd_ticks_) - crowd_->sightingAge();
  return sensor_.sweep(base_.pose().position, crowd_->sighted(), stamp);
}

}  // namespace pomdp_crowd_nav
