// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/crowd_futures.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr int kDestinationDepth = 0;    // noise depth that draws destinations; steps start at 1
constexpr int kHeadingDepth = 1 << 19;  // beyond all steps, draws where who stands sways to
constexpr double kSwayAhead = 1000.0;   // [m], so far that nobody who sways gets there

Point clampTo(const Bounds& bounds, const Point& p) {
  return p.cwiseMax(bounds.min).cwiseMin(bounds.max);
}

// One round of FNV-1a over a cell index of the 1 m grid.
std::uint64_t addCell(std::uint64_t key, const CrowdFutures::Place& place) {
  const auto cell_x = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(place.x)));
  const auto cell_y = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(place.y)));
  const std::uint64_t cell = (static_cast<std::uint64_t>(cell_x) << 32) | cell_y;
  key = (key ^ cell) * 0x9E3779B97F4A7C15ULL;
  return key ^ (key >> 29);
}

CrowdFutures::Place placeAt(const Point& position) {
  const auto x = static_cast<float>(position.x());
  const auto y = static_cast<float>(position.y());
  return {x, y, x, y};
}

void setMiddle(CrowdFutures::Place& from, const CrowdFutures::Place& to) {
  from.mid_x = 0.5F * (from.x + to.x);
  from.mid_y = 0.5F * (from.y + to.y);
}

Pedestrian drawWalker(const PersonBelief& person, const std::vector<Point>& destinations,
                      const NoiseStreams& noise, int scenario, int index) {
  const size_t hypothesis =
      person.intention.sample(noise.uniform(scenario, kDestinationDepth, index));
  Pedestrian walker = walkerOf(person, hypothesis, destinations);
  if (hypothesis == IntentionBelief::kStanding) {
    const double angle = 2.0 * M_PI * noise.uniform(scenario, kHeadingDepth, index);
    walker.destination = walker.position + kSwayAhead * unitVector(angle);
  }
  return walker;
}

float distanceSq(const CrowdFutures::Place& a, const CrowdFutures::Place& b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

}  // namespace

void CrowdFutures::draw(const Shape& shape, const std::vector<PersonBelief>& people,
                        const std::vector<Point>& destinations, const PedestrianModel& model,
                        const NoiseStreams& noise) {
  scenario_count_ = shape.scenarios;
  depth_ = shape.depth;
  person_count_ = static_cast<int>(people.size());
  const size_t moments = static_cast<size_t>(scenario_count_) * (depth_ + 1);
  places_.resize(moments * person_count_);
  observations_.assign(moments, 0xCBF29CE484222325ULL);

  float longest_stride_sq = 0.0F;
  for (int k = 0; k < scenario_count_; ++k) {
    for (int i = 0; i < person_count_; ++i) {
      Pedestrian walker = drawWalker(people[i], destinations, noise, k, i);
      Place* last = nullptr;
      for (int d = 0; d <= depth_; ++d) {
        const size_t moment = static_cast<size_t>(k) * (depth_ + 1) + d;
        Place& place = places_[moment * person_count_ + i];
        place = placeAt(walker.position);
        if (last != nullptr) {
          if (d > 1) longest_stride_sq = std::max(longest_stride_sq, distanceSq(*last, place));
          setMiddle(*last, place);
        }
        last = &place;
        observations_[moment] = addCell(observations_[moment], place);
        const double draw = 2.0 * noise.uniform(k, d + 1, i) - 1.0;
        walker.position = clampTo(shape.bounds, model.advance(walker, shape.step, draw));
      }
    }
  }
  longest_stride_ = std::sqrt(longest_stride_sq);
}

}  // namespace pomdp_crowd_nav
