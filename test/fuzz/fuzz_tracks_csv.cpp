// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "fuzz_file.h"
#include "pomdp_crowd_nav/sim/recorded_crowd.h"
#include "pomdp_crowd_nav/sim/sensor.h"

namespace pomdp_crowd_nav {
namespace {

void checkSamples(const std::vector<TrackSample>& samples) {
  promise(!samples.empty(), "rows");
  double time = samples.front().time;
  for (const TrackSample& sample : samples) {
    promise(std::isfinite(sample.time) && sample.position.allFinite(), "finite samples");
    promise(sample.time >= time, "samples in order of time");
    time = sample.time;
  }
}

void checkReplay(const std::vector<TrackSample>& samples) {
  RecordedCrowd::Params params;
  params.start_time = samples.front().time;
  RecordedCrowd crowd(samples, params);
  PersonSensor sensor(PersonSensor::Params(), 1);
  for (int i = 0; i < 5; ++i) {
    for (const Walker& walker : crowd.walkers()) promise(walker.position.allFinite(), "walkers");
    const double stamp = Crowd::kTick * i - crowd.sightingAge();
    const TrackList seen = sensor.sweep(samples.front().position, crowd.sighted(), stamp);
    for (const Track& track : seen.tracks) {
      promise(track.position.allFinite() && track.velocity.allFinite(), "finite tracks");
    }
    crowd.tick();
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size) {
  using namespace pomdp_crowd_nav;
  const FuzzFile file(data, size);
  try {
    const std::vector<TrackSample> samples = readTracksFile(file.path());
    checkSamples(samples);
    checkReplay(samples);
  } catch (const std::runtime_error&) {  // refused: file, line and column are named
  }
  return 0;
}
