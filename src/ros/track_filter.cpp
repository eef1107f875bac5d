// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/track_filter.h"

#include <algorithm>

namespace pomdp_crowd_nav {
namespace {

bool isById(const Track& a, const Track& b) { return a.id < b.id; }

void leaveOutBad(const TrackRange& range, std::vector<Track>& tracks) {
  const auto is_bad = [&](const Track& track) {
    return !(track.position.cwiseAbs().maxCoeff() <= range.position) || !track.position.allFinite();
  };
  tracks.erase(std::remove_if(tracks.begin(), tracks.end(), is_bad), tracks.end());
  for (Track& track : tracks) {
    if (!(track.velocity.norm() <= range.speed)) track.velocity = Point(0.0, 0.0);
  }
}

// Leaves the last track of each id; sorts by id.
void leaveOutDuplicates(std::vector<Track>& tracks) {
  std::reverse(tracks.begin(), tracks.end());
  std::stable_sort(tracks.begin(), tracks.end(), isById);
  const auto has_same_id = [](const Track& a, const Track& b) { return a.id == b.id; };
  tracks.erase(std::unique(tracks.begin(), tracks.end(), has_same_id), tracks.end());
}

void leaveOutFarthest(size_t count, const std::optional<Point>& robot, std::vector<Track>& tracks) {
  if (tracks.size() <= count) return;
  if (robot) {
    const auto is_nearer = [&](const Track& a, const Track& b) {
      return (a.position - *robot).squaredNorm() < (b.position - *robot).squaredNorm();
    };
    std::nth_element(tracks.begin(), tracks.begin() + static_cast<std::ptrdiff_t>(count),
                     tracks.end(), is_nearer);
  }
  tracks.resize(count);
  std::sort(tracks.begin(), tracks.end(), isById);
}

}  // namespace

void LeftOut::add(const LeftOut& other) {
  bad += other.bad;
  duplicates += other.duplicates;
  surplus += other.surplus;
}

LeftOut filterTracks(const TrackRange& range, const std::optional<Point>& robot, TrackList& list) {
  std::vector<Track>& tracks = list.tracks;
  LeftOut left_out;
  size_t before = tracks.size();
  const auto countLost = [&] {
    const size_t lost = before - tracks.size();
    before = tracks.size();
    return static_cast<unsigned>(lost);
  };
  leaveOutBad(range, tracks);
  left_out.bad = countLost();
  leaveOutDuplicates(tracks);
  left_out.duplicates = countLost();
  leaveOutFarthest(range.max_people, robot, tracks);
  left_out.surplus = countLost();
  return left_out;
}

}  // namespace pomdp_crowd_nav
