// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/destination_learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

constexpr int kMostShifts = 1000;       // a flat kernel converges in a few; this ends rounding
constexpr double kBinsPerDistance = 8;  // of a merge distance, so that bins change no result

struct WalkEnd {
  std::int64_t person = 0;
  Point position{0.0, 0.0};
};

struct Bin {
  Point mean{0.0, 0.0};
  double count = 0.0;
};

void require(bool fits, const char* name, const char* expected, double value) {
  if (fits && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("{} must be {}, got {}", name, expected, value));
}

// Beginnings and ends of the walks that are long enough; `learned` is told how many there are.
std::vector<WalkEnd> walkEnds(const std::vector<TrackSample>& recording,
                              const LearningParams& params, LearnedDestinations& learned) {
  std::map<std::int64_t, std::pair<TrackSample, TrackSample>> walks;
  for (const TrackSample& sample : recording) {
    walks.insert({sample.id, {sample, sample}}).first->second.second = sample;
  }
  std::vector<WalkEnd> ends;
  for (const auto& [person, walk] : walks) {
    const auto& [first, last] = walk;
    if ((last.position - first.position).norm() < params.min_walk) continue;
    ++learned.walks;
    if (first.time > recording.front().time + params.at_edge) {
      ends.push_back({person, first.position});
    }
    if (last.time < recording.back().time - params.at_edge) {
      ends.push_back({person, last.position});
    }
  }
  learned.ends = static_cast<int>(ends.size());
  return ends;
}

// Mean and number of the ends in each square of a fine grid.
class Bins {
 public:
  Bins(const std::vector<WalkEnd>& ends, double size) : size_(size) {
    for (const WalkEnd& end : ends) {
      Bin& bin = bins_[cellOf(end.position)];
      bin.count += 1.0;
      bin.mean += (end.position - bin.mean) / bin.count;
    }
  }

  // Mean and number of the bins within `radius`.
  Bin about(const Point& place, double radius) const {
    Bin sum;
    const auto low = cellOf(place - Point(radius, radius));
    const auto high = cellOf(place + Point(radius, radius));
    for (double x = low.first; x <= high.first; ++x) {
      for (auto cell = bins_.lower_bound({x, low.second});
           cell != bins_.end() && cell->first <= std::make_pair(x, high.second); ++cell) {
        const Bin& bin = cell->second;
        if ((bin.mean - place).norm() > radius) continue;
        sum.count += bin.count;
        sum.mean += bin.count / sum.count * (bin.mean - sum.mean);
      }
    }
    return sum;
  }

  // Uphill from every bin; the densest first.
  std::vector<Bin> modes(double radius) const {
    std::vector<Bin> modes;
    for (const auto& entry : bins_) {
      Bin here = about(entry.second.mean, radius);
      for (int i = 0; i < kMostShifts; ++i) {
        const Bin next = about(here.mean, radius);
        if (next.count == 0.0 || (next.mean - here.mean).norm() < 1e-9) break;
        here = next;
      }
      modes.push_back(here);
    }
    std::stable_sort(modes.begin(), modes.end(),
                     [](const Bin& a, const Bin& b) { return a.count > b.count; });
    return modes;
  }

 private:
  std::pair<double, double> cellOf(const Point& point) const {
    return {std::floor(point.x() / size_), std::floor(point.y() / size_)};
  }

  double size_;
  std::map<std::pair<double, double>, Bin> bins_;
};

// Each end belongs to the nearest place within the distance; places get the mean of theirs.
std::vector<LearnedDestination> destinationsAt(const std::vector<Point>& places,
                                               const std::vector<WalkEnd>& ends, double distance) {
  std::vector<LearnedDestination> destinations(places.size());
  std::vector<std::set<std::int64_t>> people(places.size());
  std::vector<Bin> sums(places.size());
  for (const WalkEnd& end : ends) {
    const auto nearest =
        std::min_element(places.begin(), places.end(), [&](const Point& a, const Point& b) {
          return (a - end.position).squaredNorm() < (b - end.position).squaredNorm();
        });
    if (nearest == places.end() || (*nearest - end.position).norm() > distance) continue;
    const size_t i = static_cast<size_t>(nearest - places.begin());
    people[i].insert(end.person);
    sums[i].count += 1.0;
    sums[i].mean += (end.position - sums[i].mean) / sums[i].count;
  }
  for (size_t i = 0; i < places.size(); ++i) {
    destinations[i] = {sums[i].mean, static_cast<int>(people[i].size())};
  }
  return destinations;
}

}  // namespace

LearnedDestinations learnDestinations(const std::vector<TrackSample>& recording,
                                      const LearningParams& params) {
  require(params.merge_distance > 0.0, "merge_distance", "positive", params.merge_distance);
  require(params.min_people >= 1, "min_people", "at least 1", params.min_people);
  require(params.min_walk >= 0.0, "min_walk", "at least 0", params.min_walk);
  require(params.at_edge >= 0.0, "at_edge", "at least 0", params.at_edge);
  LearnedDestinations learned;
  if (recording.empty()) return learned;
  const std::vector<WalkEnd> ends = walkEnds(recording, params, learned);
  const Bins bins(ends, params.merge_distance / kBinsPerDistance);

  std::vector<Point> places;
  for (const Bin& mode : bins.modes(params.merge_distance)) {
    const bool is_new = std::all_of(places.begin(), places.end(), [&](const Point& place) {
      return (place - mode.mean).norm() > params.merge_distance;
    });
    if (is_new) places.push_back(mode.mean);
  }
  learned.destinations = destinationsAt(places, ends, params.merge_distance);
  auto& found = learned.destinations;
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const LearnedDestination& destination) {
                               return destination.people < params.min_people;
                             }),
              found.end());
  std::stable_sort(
      found.begin(), found.end(),
      [](const LearnedDestination& a, const LearnedDestination& b) { return a.people > b.people; });
  for (const WalkEnd& end : ends) {
    const bool is_near =
        std::any_of(found.begin(), found.end(), [&](const LearnedDestination& destination) {
          return (destination.position - end.position).norm() <= params.merge_distance;
        });
    learned.ends_near += is_near ? 1 : 0;
  }
  return learned;
}

std::string toYaml(const LearnedDestinations& learned) {
  std::string text =
      "# Where people come from and go to, with how many of them; learned from tracks.\n";
  text += learned.destinations.empty() ? "destinations: []\n" : "destinations:\n";
  for (const LearnedDestination& destination : learned.destinations) {
    text += fmt::format("  - [{:.2f}, {:.2f}]  # {}\n", destination.position.x(),
                        destination.position.y(), destination.people);
  }
  return text;
}

}  // namespace pomdp_crowd_nav
