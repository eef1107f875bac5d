// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/belief_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <random>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kEnds = {{0.0, 0.0}, {10.0, 0.0}};
const double kNan = std::numeric_limits<double>::quiet_NaN();

Track track(std::int64_t id, double x, double vx = 0.0) { return {id, {x, 0.0}, {vx, 0.0}}; }

double probabilityOfRight(const BeliefTracker& tracker, size_t person = 0) {
  return tracker.belief().people.at(person).intention.probabilities().at(1);
}

BeliefTracker withOwnSpeeds() {
  BeliefTracker::Params params;
  params.walking_speed = 0.0;
  return BeliefTracker(kEnds, params);
}

std::string messageFor(const BeliefTracker::Params& params) {
  try {
    BeliefTracker tracker(kEnds, params);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BeliefTracker, UpdatesTwiceASecond) {
  // Ten sweeps a second at 1 m/s, so a belief moves at 0.5 s (p = -0.5, 0.5; w = 1, 2) and at 1 s.
  BeliefTracker tracker(kEnds, {});
  for (int i = 0; i <= 10; ++i) {
    tracker.update({0.1 * i, {track(7, 4.0 + 0.1 * i)}});
    const double expected = i < 5 ? 1.0 / 2.0 : i < 10 ? 2.0 / 3.0 : 4.0 / 5.0;
    EXPECT_NEAR(probabilityOfRight(tracker), expected, 1e-9) << "sweep " << i;
    EXPECT_DOUBLE_EQ(tracker.belief().people[0].position.x(), 4.0 + 0.1 * i);
  }
  EXPECT_DOUBLE_EQ(tracker.belief().stamp, 1.0);
}

TEST(BeliefTracker, RoundsStampsOfTheYear2020) {
  BeliefTracker tracker(kEnds, {});
  for (int i = 0; i <= 5; ++i) tracker.update({1.6e9 + 0.1 * i, {track(7, 4.0 + 0.1 * i)}});
  EXPECT_NEAR(probabilityOfRight(tracker), 2.0 / 3.0, 1e-6);
}

TEST(BeliefTracker, ForgetsWhoLeaves) {
  BeliefTracker tracker(kEnds, {});
  tracker.update({0.0, {track(1, 4.0), track(2, 4.0)}});
  tracker.update({0.5, {track(2, 4.5)}});
  ASSERT_EQ(tracker.belief().people.size(), 1u);
  EXPECT_EQ(tracker.belief().people[0].id, 2);
  EXPECT_NEAR(probabilityOfRight(tracker), 2.0 / 3.0, 1e-9);

  tracker.update({1.0, {track(1, 5.0), track(2, 4.5)}});  // back again: uniform
  ASSERT_EQ(tracker.belief().people.size(), 2u);
  EXPECT_DOUBLE_EQ(probabilityOfRight(tracker, 0), 0.5);
  EXPECT_NEAR(probabilityOfRight(tracker, 1), 2.0 / 3.0, 1e-9);
}

TEST(BeliefTracker, SortsByIdAndKeepsTheLastOfTwo) {
  BeliefTracker tracker(kEnds, {});
  tracker.update({0.0, {track(9, 1.0), track(-3, 2.0), track(9, 3.0)}});
  const auto& people = tracker.belief().people;
  ASSERT_EQ(people.size(), 2u);
  EXPECT_EQ(people[0].id, -3);
  EXPECT_EQ(people[1].id, 9);
  EXPECT_DOUBLE_EQ(people[1].position.x(), 3.0);
}

TEST(BeliefTracker, StartsAgainWhenTheClockJumpsBack) {
  BeliefTracker tracker(kEnds, {});
  tracker.update({10.0, {track(1, 4.0)}});
  tracker.update({10.5, {track(1, 4.5)}});
  tracker.update({3.0, {track(1, 5.0)}});
  EXPECT_DOUBLE_EQ(probabilityOfRight(tracker), 0.5);
  EXPECT_DOUBLE_EQ(tracker.belief().stamp, 3.0);
  tracker.update({3.5, {track(1, 5.5)}});  // and goes on from there
  EXPECT_NEAR(probabilityOfRight(tracker), 2.0 / 3.0, 1e-9);
}

TEST(BeliefTracker, SameStampChangesPositionsOnly) {
  BeliefTracker tracker(kEnds, {});
  tracker.update({0.0, {track(1, 4.0)}});
  tracker.update({0.5, {track(1, 4.5)}});
  tracker.update({0.5, {track(1, 9.0)}});
  EXPECT_NEAR(probabilityOfRight(tracker), 2.0 / 3.0, 1e-9);
  EXPECT_DOUBLE_EQ(tracker.belief().people[0].position.x(), 9.0);
}

TEST(BeliefTracker, IgnoresWhatIsNotFinite) {
  BeliefTracker tracker(kEnds, {});
  tracker.update({0.0, {track(1, 4.0), {2, {0.0, kNan}, {0.0, 0.0}}}});
  EXPECT_EQ(tracker.belief().people.size(), 1u);

  tracker.update({kNan, {}});
  EXPECT_EQ(tracker.belief().people.size(), 1u);
  EXPECT_DOUBLE_EQ(tracker.belief().stamp, 0.0);

  tracker.update({0.1, {track(1, 4.1, kNan)}});
  EXPECT_DOUBLE_EQ(tracker.belief().people[0].velocity.norm(), 0.0);
}

TEST(BeliefTracker, StandingPersonStaysUniform) {
  BeliefTracker tracker(kEnds, {});
  for (int i = 0; i < 50; ++i) tracker.update({0.5 * i, {track(1, 3.0)}});
  EXPECT_DOUBLE_EQ(probabilityOfRight(tracker), 0.5);
  EXPECT_DOUBLE_EQ(tracker.belief().people[0].speed, 1.0);  // one speed for everybody
}

TEST(BeliefTracker, SmoothsOwnSpeeds) {
  // First seen without a velocity: 1 m/s. Then 0.8 m in 0.5 s is 1.6 m/s, smoothed by one half:
  // 1 + (1.6 - 1) / 2 = 1.3; then standing still: 0.65, 0.325.
  BeliefTracker tracker = withOwnSpeeds();
  tracker.update({0.0, {track(1, 4.0)}});
  EXPECT_DOUBLE_EQ(tracker.belief().people[0].speed, 1.0);
  tracker.update({0.5, {track(1, 4.8)}});
  EXPECT_NEAR(tracker.belief().people[0].speed, 1.3, 1e-12);
  tracker.update({0.7, {track(1, 4.8)}});  // no update is due
  EXPECT_NEAR(tracker.belief().people[0].speed, 1.3, 1e-12);
  tracker.update({1.0, {track(1, 4.8)}});
  EXPECT_NEAR(tracker.belief().people[0].speed, 0.65, 1e-12);
  tracker.update({1.5, {track(1, 4.8)}});
  EXPECT_NEAR(tracker.belief().people[0].speed, 0.325, 1e-12);
}

TEST(BeliefTracker, OwnSpeedStartsAtTheTrackAndIsThatOfAPerson) {
  BeliefTracker tracker = withOwnSpeeds();
  tracker.update({0.0, {track(1, 4.0, -1.4), track(2, 0.0)}});
  EXPECT_DOUBLE_EQ(tracker.belief().people[0].speed, 1.4);
  EXPECT_DOUBLE_EQ(tracker.belief().people[0].velocity.x(), -1.4);
  tracker.update({0.5, {track(1, 4.0, -1.4), track(2, 50.0)}});  // 100 m/s counts as 3
  EXPECT_DOUBLE_EQ(tracker.belief().people[1].speed, 2.0);
}

TEST(BeliefTracker, ClearForgetsEverybody) {
  BeliefTracker tracker(kEnds, {});
  tracker.update({5.0, {track(1, 4.0)}});
  tracker.clear();
  EXPECT_TRUE(tracker.belief().people.empty());
}

TEST(BeliefTracker, NamesAWrongParameter) {
  BeliefTracker::Params params;
  params.update_period = -0.5;
  EXPECT_EQ(messageFor(params), "belief.update_period must be positive, got -0.5");
  params = {};
  params.walking_speed = -1.5;
  EXPECT_EQ(messageFor(params), "belief.walking_speed must not be negative, got -1.5");
  params = {};
  params.speed_smoothing = 1.5;
  EXPECT_EQ(messageFor(params), "belief.speed_smoothing must be in (0, 1], got 1.5");
  params = {};
  params.inherit_distance = -0.5;
  EXPECT_EQ(messageFor(params), "belief.inherit_distance must not be negative, got -0.5");
  EXPECT_THROW(BeliefTracker({}, {}), std::invalid_argument);
  EXPECT_THROW(BeliefTracker({{kNan, 0.0}}, {}), std::invalid_argument);
}

TEST(BeliefTracker, RemembersWhoIsMissingFromASweep) {
  BeliefTracker::Params params;
  params.memory = 0.5;
  BeliefTracker tracker({{0.0, 0.0}, {10.0, 0.0}}, params);
  const Point velocity(1.0, 0.0);
  tracker.update({0.0, {{1, {2.0, 0.0}, velocity}, {2, {5.0, 5.0}, {0.0, 0.0}}}});
  tracker.update({0.5, {{1, {2.5, 0.0}, velocity}, {2, {5.0, 5.0}, {0.0, 0.0}}}});
  const double learnt = tracker.belief().people[0].intention.probabilities()[1];
  tracker.update({0.8, {{2, {5.0, 5.0}, {0.0, 0.0}}}});
  ASSERT_EQ(tracker.belief().people.size(), 2U);
  EXPECT_NEAR(tracker.belief().people[0].position.x(), 2.8, 1e-12);
  EXPECT_EQ(tracker.belief().people[0].intention.probabilities()[1], learnt);
  const TrackList tracks = tracksOf(tracker.belief());
  ASSERT_EQ(tracks.tracks.size(), 2U);
  EXPECT_EQ(tracks.tracks[0].velocity, velocity);
  tracker.update({1.1, {{2, {5.0, 5.0}, {0.0, 0.0}}}});
  ASSERT_EQ(tracker.belief().people.size(), 1U);
  EXPECT_EQ(tracker.belief().people[0].id, 2);
}

BeliefTracker withHeirs(double memory = 0.0) {
  BeliefTracker::Params params;
  params.walking_speed = 0.0;
  params.inherit_distance = 0.5;
  params.memory = memory;
  return BeliefTracker(kEnds, params);
}

// From 2 m at 1 m/s for 2 s, five sweeps.
void walkAs(std::int64_t id, BeliefTracker& tracker) {
  for (int i = 0; i < 5; ++i) tracker.update({0.5 * i, {track(id, 2.0 + 0.5 * i, 1.0)}});
}

TEST(BeliefTracker, ANewIdInThePlaceOfAnOldOneInheritsAllThatIsKnown) {
  BeliefTracker same = withHeirs();
  BeliefTracker other = withHeirs();
  walkAs(7, same);
  walkAs(7, other);
  same.update({2.5, {track(7, 4.6, 1.1)}});
  other.update({2.5, {track(3, 4.6, 1.1)}});
  ASSERT_EQ(other.belief().people.size(), 1U);
  const PersonBelief& known = same.belief().people[0];
  const PersonBelief& heir = other.belief().people[0];
  EXPECT_EQ(heir.id, 3);
  EXPECT_EQ(heir.position, known.position);
  EXPECT_EQ(heir.velocity, known.velocity);
  EXPECT_EQ(heir.speed, known.speed);
  EXPECT_EQ(heir.intention.probabilities(), known.intention.probabilities());
  EXPECT_GT(heir.intention.probabilities()[1], 0.9);
}

TEST(BeliefTracker, ANewIdElsewhereIsANewPerson) {
  BeliefTracker tracker = withHeirs();
  walkAs(7, tracker);
  tracker.update({2.5, {track(3, 5.1, 1.0)}});  // 0.6 m beyond the 4.5 m where 7 should be
  EXPECT_DOUBLE_EQ(probabilityOfRight(tracker), 0.5);
  BeliefTracker without = withOwnSpeeds();
  walkAs(7, without);
  without.update({2.5, {track(3, 4.5, 1.0)}});
  EXPECT_DOUBLE_EQ(probabilityOfRight(without), 0.5);
}

TEST(BeliefTracker, AnHeirLeavesNoGhost) {
  BeliefTracker tracker = withHeirs(1.0);
  walkAs(7, tracker);
  tracker.update({2.5, {}});
  ASSERT_EQ(tracker.belief().people.size(), 1U);
  const double learnt = probabilityOfRight(tracker);
  tracker.update({2.9, {track(9, 5.0, 1.0), track(10, 5.3, 1.0)}});  // 4.9 m are expected
  ASSERT_EQ(tracker.belief().people.size(), 2U);
  EXPECT_EQ(tracker.belief().people[0].id, 9);
  EXPECT_GT(probabilityOfRight(tracker, 0), learnt);
  EXPECT_DOUBLE_EQ(probabilityOfRight(tracker, 1), 0.5) << "a belief has one heir";
}

TEST(BeliefTracker, NobodyInheritsFromLongAgo) {
  BeliefTracker tracker = withHeirs();
  walkAs(7, tracker);
  tracker.update({3.0, {track(9, 5.0, 1.0)}});  // 1 s later, without memory
  EXPECT_DOUBLE_EQ(probabilityOfRight(tracker), 0.5);
}

TEST(BeliefTracker, PeopleWhoSwapIdsKeepTheirBeliefs) {
  for (const double memory : {0.0, 1.0}) {
    BeliefTracker tracker = withHeirs(memory);
    for (int i = 0; i < 5; ++i) {
      tracker.update({0.5 * i, {track(1, 2.0 + 0.5 * i, 1.0), track(2, 9.0 - 0.5 * i, -1.0)}});
    }
    tracker.update({2.5, {track(1, 6.5, -1.0), track(2, 4.5, 1.0)}});  // 2.5 m are too far to run
    ASSERT_EQ(tracker.belief().people.size(), 2U);
    EXPECT_LT(probabilityOfRight(tracker, 0), 0.1);
    EXPECT_GT(probabilityOfRight(tracker, 1), 0.9);
    tracker.update({3.0, {track(1, 100.0), track(2, 5.0, 1.0)}});  // somebody else's id now
    ASSERT_EQ(tracker.belief().people.size(), 2U) << "ids are given once";
    EXPECT_DOUBLE_EQ(tracker.belief().people[0].position.x(), 100.0);
    EXPECT_DOUBLE_EQ(probabilityOfRight(tracker, 0), 0.5);
  }
}

BeliefTracker expectingElsewhere() {
  BeliefTracker::Params params;
  params.walking_speed = 0.0;
  params.expect_elsewhere = true;
  return BeliefTracker(kEnds, params);
}

TEST(BeliefTracker, AStopMakesNobodySlow) {
  BeliefTracker tracker = expectingElsewhere();
  for (int i = 0; i < 60; ++i) tracker.update({0.5 * i, {track(1, 2.0 + std::min(0.6 * i, 6.0))}});
  const PersonBelief& person = tracker.belief().people[0];
  EXPECT_EQ(person.intention.mostLikely(), IntentionBelief::kStanding);
  EXPECT_GT(person.speed, 0.7) << "1.2 m/s before the stop";
  EXPECT_NEAR(person.walk.norm(), 0.0, 1e-6);
}

TEST(BeliefTracker, WhoTurnsRoundIsExpectedOnTheWayBack) {
  BeliefTracker tracker = expectingElsewhere();
  for (int i = 0; i <= 6; ++i) tracker.update({0.5 * i, {track(1, 4.0 + 0.5 * i)}});
  const auto& intention = tracker.belief().people[0].intention;
  EXPECT_LT(intention.probabilities()[0], 0.05);
  for (int i = 1; i <= 3; ++i) tracker.update({3.0 + 0.5 * i, {track(1, 7.0 - 0.5 * i)}});
  EXPECT_LT(tracker.belief().people[0].intention.probabilities()[1], 0.05);
  EXPECT_LT(tracker.belief().people[0].walk.x(), -0.5);
}

// At 10 Hz, with 0.1 m of noise on each axis.
TEST(BeliefTracker, JitterOfStandingPeopleIsNoWalk) {
  BeliefTracker::Params params;
  params.walking_speed = 0.0;
  params.expect_elsewhere = true;
  BeliefTracker tracker(kEnds, params);
  std::mt19937 random(2);
  std::normal_distribution<double> jitter(0.0, 0.1);
  double standing = 0.0;
  int count = 0, poisoned = 0;
  for (int i = 0; i < 600; ++i) {
    TrackList sweep{0.1 * i, {}};
    for (int id = 0; id < 20; ++id) {
      sweep.tracks.push_back({id, {5.0 + jitter(random), jitter(random)}, {0.0, 0.0}});
    }
    tracker.update(sweep);
    if (i < 50) continue;
    for (const PersonBelief& person : tracker.belief().people) {
      standing += person.intention.standing();
      poisoned += person.intention.mostLikely() < kEnds.size() ? 1 : 0;
      ++count;
    }
  }
  EXPECT_GT(standing / count, 0.85);
  EXPECT_LT(poisoned, 0.005 * count);
}

// The limits leave room for a busy machine; figures in doc/measurements.md.
TEST(BeliefTracker, TenThousandPeopleAreCheapEvenIfAllIdsChange) {
  BeliefTracker::Params params;
  params.walking_speed = 0.0;
  params.memory = 0.6;
  params.expect_elsewhere = true;
  params.inherit_distance = 0.5;
  BeliefTracker tracker({{0.0, 0.0}, {100.0, 0.0}, {0.0, 100.0}, {100.0, 100.0}}, params);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  TrackList sweep;
  for (int i = 0; i < 10000; ++i) {
    sweep.tracks.push_back({i, {place(random), place(random)}, {1.0, 0.0}});
  }
  double slowest = 0.0;
  for (int i = 0; i < 6; ++i) {
    sweep.stamp = 0.5 * i;
    for (Track& one : sweep.tracks) {
      one.id += i < 3 ? 0 : 10000;
      one.position.x() += 0.5;
    }
    const std::clock_t start = std::clock();  // of the processor
    tracker.update(sweep);
    const double time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    RecordProperty("update_" + std::to_string(i) + "_ms", std::to_string(1e3 * time));
    slowest = std::max(slowest, time);
  }
  EXPECT_LT(slowest, 0.2);
  const IntentionBelief& belief = tracker.belief().people[0].intention;
  EXPECT_LT(belief.standing(), 0.01) << "six updates, under three ids";
}

}  // namespace
}  // namespace pomdp_crowd_nav
