// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/prediction_score.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "pomdp_crowd_nav/pomdp/crowd_futures.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kTimeSlack = 1e-6;  // [s]

using Walks = std::map<std::int64_t, std::vector<TrackSample>>;

Walks walksOf(const std::vector<TrackSample>& recording) {
  Walks walks;
  for (const TrackSample& sample : recording) walks[sample.id].push_back(sample);
  return walks;
}

// Between two samples people go straight.
std::optional<Point> positionAt(const std::vector<TrackSample>& walk, double time) {
  const auto after =
      std::lower_bound(walk.begin(), walk.end(), time - kTimeSlack,
                       [](const TrackSample& sample, double t) { return sample.time < t; });
  if (after == walk.end()) return std::nullopt;
  if (after->time <= time + kTimeSlack) return after->position;
  if (after == walk.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double share = (time - before->time) / (after->time - before->time);
  return before->position + share * (after->position - before->position);
}

// What a sensor would report at the time of one sweep, velocities by difference.
TrackList sweepOf(const std::vector<TrackSample>& recording, size_t begin, size_t end,
                  std::map<std::int64_t, TrackSample>& last) {
  TrackList tracks;
  tracks.stamp = recording[begin].time;
  for (size_t i = begin; i < end; ++i) {
    const TrackSample& now = recording[i];
    const auto before = last.find(now.id);
    Point velocity(0.0, 0.0);
    if (before != last.end()) {
      velocity = (now.position - before->second.position) / (now.time - before->second.time);
    }
    tracks.tracks.push_back({now.id, now.position, velocity});
    last[now.id] = now;
  }
  return tracks;
}

class Scorer {
 public:
  Scorer(const std::vector<TrackSample>& recording, const Bounds& bounds,
         const PredictionParams& params)
      : walks_(walksOf(recording)), bounds_(bounds), params_(params), scores_(params.horizons) {
    for (int h = 0; h < params.horizons; ++h) scores_[h].horizon = h + 1.0;
  }

  void add(const CrowdBelief& crowd, const CrowdFutures& futures) {
    for (size_t i = 0; i < crowd.people.size(); ++i) {
      const std::vector<TrackSample>& walk = walks_.at(crowd.people[i].id);
      const auto before = positionAt(walk, crowd.stamp - params_.history);
      const auto here = positionAt(walk, crowd.stamp);
      if (!before || !here) continue;
      const bool is_slow = (*here - *before).norm() < params_.slow_speed * params_.history;
      for (PredictionScores& scores : scores_) {
        const auto truth = positionAt(walk, crowd.stamp + scores.horizon);
        if (!truth) break;
        const PredictionScore one = compare(futures, i, scores.horizon, *truth);
        addTo(scores.all, one);
        if (is_slow) addTo(scores.slow, one);
      }
    }
  }

  std::vector<PredictionScores> means() const {
    std::vector<PredictionScores> means = scores_;
    for (PredictionScores& scores : means) {
      for (PredictionScore* score : {&scores.all, &scores.slow}) {
        if (score->count == 0) continue;
        score->log_density /= score->count;
        score->error /= score->count;
        score->near_share /= score->count;
      }
    }
    return means;
  }

 private:
  PredictionScore compare(const CrowdFutures& futures, size_t person, double horizon,
                          const Point& truth) const {
    PredictionScore score{1, 0.0, 0.0, 0.0};
    const double variance = params_.kernel * params_.kernel;
    double density = 0.0;
    for (int k = 0; k < params_.scenarios; ++k) {
      const CrowdFutures::Place& place = futures.at(k, static_cast<int>(horizon))[person];
      const double off = (Point(place.x, place.y) - truth).norm();
      density += std::exp(-0.5 * off * off / variance);
      score.error += off;
      if (off < params_.near) score.near_share += 1.0;
    }
    const Point size = bounds_.max - bounds_.min;
    density /= 2.0 * M_PI * variance * params_.scenarios;
    score.log_density =
        std::log((1.0 - params_.floor) * density + params_.floor / (size.x() * size.y()));
    score.error /= params_.scenarios;
    score.near_share /= params_.scenarios;
    return score;
  }

  static void addTo(PredictionScore& sum, const PredictionScore& one) {
    sum.count += one.count;
    sum.log_density += one.log_density;
    sum.error += one.error;
    sum.near_share += one.near_share;
  }

  Walks walks_;
  Bounds bounds_;
  PredictionParams params_;
  std::vector<PredictionScores> scores_;  // sums
};

void addWeighted(PredictionScore& sum, const PredictionScore& mean) {
  const double count = static_cast<double>(sum.count + mean.count);
  if (mean.count == 0) return;
  const double share = static_cast<double>(mean.count) / count;
  sum.log_density += share * (mean.log_density - sum.log_density);
  sum.error += share * (mean.error - sum.error);
  sum.near_share += share * (mean.near_share - sum.near_share);
  sum.count += mean.count;
}

}  // namespace

std::vector<PredictionScores> scorePredictions(const std::vector<TrackSample>& recording,
                                               const std::vector<Point>& destinations,
                                               const Bounds& bounds,
                                               const PredictionParams& params) {
  Scorer scorer(recording, bounds, params);
  BeliefTracker tracker(destinations, params.belief);
  const StraightLinePedestrian model({params.pedestrian_noise});
  CrowdFutures futures;
  std::map<std::int64_t, TrackSample> last;
  std::uint64_t seed = params.seed;
  for (size_t begin = 0, end = 0; begin < recording.size(); begin = end) {
    while (end < recording.size() && recording[end].time <= recording[begin].time) ++end;
    tracker.update(sweepOf(recording, begin, end, last));
    futures.draw({params.scenarios, params.horizons, 1.0, bounds}, tracker.belief().people,
                 destinations, model, NoiseStreams(seed++));
    scorer.add(tracker.belief(), futures);
  }
  return scorer.means();
}

PredictionScores overall(const std::vector<PredictionScores>& scores) {
  PredictionScores sum;
  for (const PredictionScores& one : scores) {
    addWeighted(sum.all, one.all);
    addWeighted(sum.slow, one.slow);
  }
  return sum;
}

}  // namespace pomdp_crowd_nav
