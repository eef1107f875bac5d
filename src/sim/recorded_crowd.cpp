// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/recorded_crowd.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

constexpr double kTimeSlack = 1.0e-9;        // [s], rounding in the sum of ticks
constexpr double kSightingLifetime = 1.5;    // in sample periods
constexpr double kPeriodOfSinglePoints = 1;  // [s], when nobody has two samples

std::map<std::int64_t, std::vector<TrackSample>> samplesById(
    const std::vector<TrackSample>& recording) {
  std::map<std::int64_t, std::vector<TrackSample>> samples;
  for (const TrackSample& sample : recording) samples[sample.id].push_back(sample);
  return samples;
}

double medianPeriod(const std::map<std::int64_t, std::vector<TrackSample>>& samples_by_id) {
  std::vector<double> periods;
  for (const auto& entry : samples_by_id) {
    const std::vector<TrackSample>& samples = entry.second;
    for (size_t i = 1; i < samples.size(); ++i) {
      periods.push_back(samples[i].time - samples[i - 1].time);
    }
  }
  if (periods.empty()) return kPeriodOfSinglePoints;
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::nth_element(periods.begin(), middle, periods.end());
  return *middle;
}

Point positionBetween(const TrackSample& before, const TrackSample& after, double time) {
  const double share = (time - before.time) / (after.time - before.time);
  return before.position + std::clamp(share, 0.0, 1.0) * (after.position - before.position);
}

}  // namespace

RecordedCrowd::RecordedCrowd(const std::vector<TrackSample>& recording, const Params& params)
    : start_time_(params.start_time) {
  auto samples_by_id = samplesById(recording);
  sample_period_ = medianPeriod(samples_by_id);
  for (std::int64_t id : params.left_out) {
    if (samples_by_id.erase(id) > 0) continue;
    throw std::invalid_argument(
        fmt::format("left_out names person {}, who is not in the recording", id));
  }
  for (auto& entry : samples_by_id) walks_.push_back({entry.first, std::move(entry.second)});
  place();
}

void RecordedCrowd::tick() {
  ++ticks_;
  place();
}

double RecordedCrowd::now() const { return start_time_ + kTick * static_cast<double>(ticks_); }

void RecordedCrowd::place() {
  walkers_.clear();
  sighted_.clear();
  sighting_age_ = std::numeric_limits<double>::infinity();
  for (const Walk& walk : walks_) place(walk);
  if (sighted_.empty()) sighting_age_ = 0.0;
}

void RecordedCrowd::place(const Walk& walk) {
  const auto isLater = [](double time, const TrackSample& sample) { return time < sample.time; };
  const double time = now();
  const auto& samples = walk.samples;
  const auto after = std::upper_bound(samples.begin(), samples.end(), time + kTimeSlack, isLater);
  if (after == samples.begin()) return;
  const TrackSample& before = *std::prev(after);
  const double age = std::max(0.0, time - before.time);

  if (age <= kSightingLifetime * sample_period_ + kTimeSlack) {
    sighted_.push_back({walk.id, before.position});
    sighting_age_ = std::min(sighting_age_, age);
  }
  if (after != samples.end()) {
    walkers_.push_back({walk.id, positionBetween(before, *after, time)});
  } else if (age <= kTimeSlack) {
    walkers_.push_back({walk.id, before.position});
  }
}

}  // namespace pomdp_crowd_nav
