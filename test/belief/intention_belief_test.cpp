// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/intention_belief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kCorners = {{0.0, 0.0}, {0.0, 100.0}, {100.0, 100.0}, {100.0, 0.0}};

TEST(IntentionBelief, StartsUniform) {
  const IntentionBelief belief(4);
  EXPECT_EQ(belief.probabilities(), std::vector<double>(4, 0.25));
}

TEST(IntentionBelief, NeedsADestination) {
  EXPECT_THROW(IntentionBelief(0), std::invalid_argument);
}

TEST(IntentionBelief, UpdateAlongALine) {
  // Destinations at 0 and 10; walking from 5 to 6 makes p = (-1, +1), so |min p| = 1 and
  // w = (-1 + 1 + 1, 1 + 1 + 1) = (1, 3), and the belief is (1/4, 3/4).
  const std::vector<Point> ends = {{0.0, 0.0}, {10.0, 0.0}};
  IntentionBelief belief(2);
  belief.update({5.0, 0.0}, {6.0, 0.0}, ends);
  EXPECT_DOUBLE_EQ(belief.probabilities()[0], 0.25);
  EXPECT_DOUBLE_EQ(belief.probabilities()[1], 0.75);

  // Again by 0.5: p = (-0.5, 0.5), w = (1, 2), b ~ (1/4 * 1, 3/4 * 2) = (1/7, 6/7).
  belief.update({6.0, 0.0}, {6.5, 0.0}, ends);
  EXPECT_NEAR(belief.probabilities()[0], 1.0 / 7.0, 1e-12);
  EXPECT_NEAR(belief.probabilities()[1], 6.0 / 7.0, 1e-12);
}

TEST(IntentionBelief, ProgressTowardAllDestinationsAddsTheSmallest) {
  // Two destinations straight ahead: p = (1, 1), |min p| = 1, w = (3, 3), nothing changes.
  IntentionBelief belief(2);
  belief.update({0.0, 0.0}, {1.0, 0.0}, {{10.0, 0.0}, {20.0, 0.0}});
  EXPECT_DOUBLE_EQ(belief.probabilities()[0], 0.5);

  // Ahead by different amounts: (0, 0) -> (3, 0) with destinations (10, 0) and (3, 4).
  // p = (10 - 7, 5 - 4) = (3, 1), |min p| = 1, w = (5, 3), b = (5/8, 3/8).
  IntentionBelief other(2);
  other.update({0.0, 0.0}, {3.0, 0.0}, {{10.0, 0.0}, {3.0, 4.0}});
  EXPECT_DOUBLE_EQ(other.probabilities()[0], 0.625);
  EXPECT_DOUBLE_EQ(other.probabilities()[1], 0.375);
}

TEST(IntentionBelief, CornersOfTheSquare) {
  // On the axis of symmetry from (50, 50) to (50, 49.5):
  // near corners (0,0), (100,0): p = sqrt(50^2 + 50^2) - sqrt(50^2 + 49.5^2) = 0.352665...
  // far corners (0,100), (100,100): p = sqrt(50^2 + 50^2) - sqrt(50^2 + 50.5^2) = -0.354442...
  const double near = std::hypot(50.0, 50.0) - std::hypot(50.0, 49.5);
  const double far = std::hypot(50.0, 50.0) - std::hypot(50.0, 50.5);
  EXPECT_NEAR(near, 0.3527, 1e-3);
  const double near_weight = near - far + 1.0;  // |min p| = -far
  const double total = 2.0 * near_weight + 2.0 * 1.0;

  IntentionBelief belief(4);
  belief.update({50.0, 50.0}, {50.0, 49.5}, kCorners);
  EXPECT_NEAR(belief.probabilities()[0], near_weight / total, 1e-12);
  EXPECT_NEAR(belief.probabilities()[1], 1.0 / total, 1e-12);
  EXPECT_NEAR(belief.probabilities()[2], 1.0 / total, 1e-12);
  EXPECT_NEAR(belief.probabilities()[3], near_weight / total, 1e-12);
}

TEST(IntentionBelief, StandingStillChangesNothing) {
  IntentionBelief belief(4);
  belief.update({50.0, 50.0}, {49.6, 49.6}, kCorners);
  const std::vector<double> before = belief.probabilities();
  for (int i = 0; i < 100; ++i) belief.update({49.6, 49.6}, {49.6, 49.6}, kCorners);
  for (size_t j = 0; j < 4; ++j) EXPECT_NEAR(belief.probabilities()[j], before[j], 1e-12);
}

TEST(IntentionBelief, FindsTheDestinationOfASteadyWalk) {
  IntentionBelief belief(4);
  Point at(50.0, 20.0);
  for (int i = 0; i < 40; ++i) {
    const Point next = at + 0.5 * (kCorners[2] - at).normalized();
    belief.update(at, next, kCorners);
    at = next;
  }
  const auto& p = belief.probabilities();
  EXPECT_EQ(belief.mostLikely(), 2u);
  EXPECT_GT(p[2], 0.9);
  EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-12);
}

TEST(IntentionBelief, IgnoresAStepBeyondTheRangeOfDouble) {
  IntentionBelief belief(4);
  belief.update({0.0, 0.0}, {1e300, 1e300}, kCorners);
  EXPECT_EQ(belief.probabilities(), std::vector<double>(4, 0.25));
}

TEST(IntentionBelief, RejectsAnotherNumberOfDestinations) {
  IntentionBelief belief(3);
  EXPECT_THROW(belief.update({0.0, 0.0}, {1.0, 0.0}, kCorners), std::invalid_argument);
}

TEST(IntentionBelief, SamplesByQuantile) {
  IntentionBelief belief(2);
  belief.update({5.0, 0.0}, {6.0, 0.0}, {{0.0, 0.0}, {10.0, 0.0}});  // (1/4, 3/4), see above
  EXPECT_EQ(belief.sample(0.0), 0u);
  EXPECT_EQ(belief.sample(0.2499), 0u);
  EXPECT_EQ(belief.sample(0.25), 1u);
  EXPECT_EQ(belief.sample(0.9999), 1u);
  EXPECT_EQ(belief.sample(std::nextafter(1.0, 0.0)), 1u);
}

TEST(IntentionBelief, StandingAndElsewhereAreHypothesesToo) {
  IntentionBelief belief(2, 0.2, 0.3);
  EXPECT_EQ(belief.probabilities(), std::vector<double>(2, 0.25));
  EXPECT_EQ(belief.mostLikely(), IntentionBelief::kElsewhere);
  belief.assign({1.0, 2.0}, 4.0, 1.0);
  EXPECT_DOUBLE_EQ(belief.probabilities()[1], 0.25);
  EXPECT_DOUBLE_EQ(belief.standing(), 0.5);
  EXPECT_DOUBLE_EQ(belief.elsewhere(), 0.125);
  EXPECT_DOUBLE_EQ(belief.probability(0), 0.125);
  EXPECT_DOUBLE_EQ(belief.probability(IntentionBelief::kStanding), 0.5);
  EXPECT_EQ(belief.mostLikely(), IntentionBelief::kStanding);
  EXPECT_EQ(belief.sample(0.374), 1u);
  EXPECT_EQ(belief.sample(0.376), IntentionBelief::kStanding);
  EXPECT_EQ(belief.sample(0.874), IntentionBelief::kStanding);
  EXPECT_EQ(belief.sample(0.876), IntentionBelief::kElsewhere);
}

TEST(IntentionBelief, IgnoresWeightsThatAreNone) {
  IntentionBelief belief(2, 0.2, 0.3);
  belief.assign({0.0, 0.0}, 0.0, 0.0);
  belief.assign({1.0, std::nan("")}, 1.0, 1.0);
  EXPECT_DOUBLE_EQ(belief.standing(), 0.2);
  EXPECT_EQ(belief.probabilities(), std::vector<double>(2, 0.25));
}

}  // namespace
}  // namespace pomdp_crowd_nav
