// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/sim/crowd.h"
#include "pomdp_crowd_nav/sim/tracks_file.h"

namespace pomdp_crowd_nav {

// People who really walked there, replayed. After the recording nobody is there.
//
// The truth runs straight between two samples of a person; a sensor sees the last sample at or
// before now, for at most 1.5 sample periods, and so nothing of what comes later.
class RecordedCrowd : public Crowd {
 public:
  struct Params {
    double start_time = 0.0;             // [s], time in the recording at which the replay starts
    std::vector<std::int64_t> left_out;  // people who are not replayed
  };

  // `recording` is in order of time. Throws std::invalid_argument when somebody to leave out is
  // not in it.
  RecordedCrowd(const std::vector<TrackSample>& recording, const Params& params);

  void tick() override;
  const std::vector<Walker>& walkers() const override { return walkers_; }
  const std::vector<Walker>& sighted() const override { return sighted_; }
  double sightingAge() const override { return sighting_age_; }

 private:
  struct Walk {
    std::int64_t id = 0;
    std::vector<TrackSample> samples;  // by increasing time, at least one
  };

  double now() const;  // [s], in the recording
  void place();
  void place(const Walk& walk);

  double start_time_;
  double sample_period_;     // [s], the median over all people
  std::vector<Walk> walks_;  // by increasing id
  long ticks_ = 0;
  std::vector<Walker> walkers_;
  std::vector<Walker> sighted_;
  double sighting_age_ = 0.0;
};

}  // namespace pomdp_crowd_nav
