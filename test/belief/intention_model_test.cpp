// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/intention_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kEnds = {{-100.0, 0.0}, {100.0, 0.0}};

// Noises of 1 m/s and no other, nobody changes their mind: Bayes' rule can be done by hand.
IntentionModel::Params plain() {
  IntentionModel::Params params;
  params.position_noise = 0.0;
  params.change_rate = 0.0;
  params.slowest = 0.0;
  params.sway = params.walking_noise = params.elsewhere_noise = 1.0;
  params.standing = params.elsewhere = 0.25;
  return params;
}

double sumOf(const IntentionBelief& belief) {
  double sum = belief.standing() + belief.elsewhere();
  for (const double probability : belief.probabilities()) sum += probability;
  return sum;
}

TEST(IntentionModel, FollowsBayesRule) {
  // 1 s, 1 m to the right: expected are -1, 1, 0 and, up, (0, 1); squared misses 4, 0, 1 and 2.
  const IntentionModel model(plain());
  IntentionBelief belief = model.firstBelief(2);
  model.update({{0.0, 0.0}, {1.0, 0.0}, 1.0, 1.0, Point(0.0, 1.0)}, kEnds, belief);
  const double total = std::exp(-2.0) + 1.0 + std::exp(-0.5) + std::exp(-1.0);
  EXPECT_NEAR(belief.probabilities()[0], std::exp(-2.0) / total, 1e-12);
  EXPECT_NEAR(belief.probabilities()[1], 1.0 / total, 1e-12);
  EXPECT_NEAR(belief.standing(), std::exp(-0.5) / total, 1e-12);
  EXPECT_NEAR(belief.elsewhere(), std::exp(-1.0) / total, 1e-12);
}

TEST(IntentionModel, WideNormalsAreLow) {
  // At rest where sway has half the width of the rest: density 4 against 1 of a walk elsewhere of
  // which nothing is known (1 m/s); both walks to a destination miss by 2 m in 2 s.
  IntentionModel::Params params = plain();
  params.sway = 0.5;
  const IntentionModel model(params);
  IntentionBelief belief = model.firstBelief(2);
  model.update({{0.0, 0.0}, {0.0, 0.0}, 2.0, 1.0, {}}, kEnds, belief);
  const double total = 4.0 + 1.0 + 2.0 * std::exp(-0.5);
  EXPECT_NEAR(belief.standing(), 4.0 / total, 1e-12);
  EXPECT_NEAR(belief.elsewhere(), 1.0 / total, 1e-12);
}

TEST(IntentionModel, MindsChange) {
  // After a second of a rate of ln 2 half of the old belief is left, then all is as likely.
  IntentionModel::Params params = plain();
  params.change_rate = std::log(2.0);
  const IntentionModel model(params);
  IntentionBelief belief = model.firstBelief(2);
  belief.assign({1.0, 0.0}, 0.0, 0.0);
  model.update({{0.0, 0.0}, {0.0, 0.0}, 1.0, 0.0, {}}, kEnds, belief);
  EXPECT_NEAR(belief.probabilities()[0], 0.5 + 0.125, 1e-12);
  EXPECT_NEAR(belief.probabilities()[1], 0.125, 1e-12);
  EXPECT_NEAR(belief.standing(), 0.125, 1e-12);
  EXPECT_NEAR(belief.elsewhere(), 0.125, 1e-12);
}

TEST(IntentionModel, WhoWalksToADestinationIsExpectedThere) {
  const IntentionModel model({});
  IntentionBelief belief = model.firstBelief(2);
  for (int i = 0; i < 20; ++i) {
    model.update({{0.5 * i, 0.0}, {0.5 * i + 0.5, 0.0}, 0.5, 1.0, Point(1.0, 0.0)}, kEnds, belief);
  }
  EXPECT_LT(belief.probabilities()[0], 0.01);
  EXPECT_LT(belief.standing(), 0.01);
  EXPECT_GT(belief.probabilities()[1] + belief.elsewhere(), 0.98);  // the same way, both
}

TEST(IntentionModel, WhoHeadsForNoDestinationIsElsewhere) {
  const IntentionModel model({});
  IntentionBelief belief = model.firstBelief(2);
  for (int i = 0; i < 10; ++i) {
    model.update({{0.0, 0.5 * i}, {0.0, 0.5 * i + 0.5}, 0.5, 1.0, Point(0.0, 1.0)}, kEnds, belief);
  }
  EXPECT_EQ(belief.mostLikely(), IntentionBelief::kElsewhere);
  EXPECT_GT(belief.elsewhere(), 0.9);
}

TEST(IntentionModel, WhoStopsStandsSoonAndWhoSetsOutWalksSoon) {
  const IntentionModel model({});
  IntentionBelief belief = model.firstBelief(2);
  const auto walk = [&](double from, double to, double before) {
    model.update({{from, 0.0}, {to, 0.0}, 0.5, 1.0, Point(before, 0.0)}, kEnds, belief);
  };
  for (int i = 0; i < 20; ++i) walk(0.5 * i, 0.5 * i + 0.5, 1.0);
  walk(10.0, 10.0, 1.0);
  walk(10.0, 10.0, 0.5);
  EXPECT_EQ(belief.mostLikely(), IntentionBelief::kStanding);
  for (int i = 0; i < 200; ++i) walk(10.0, 10.0, 0.0);
  EXPECT_GT(belief.standing(), 0.8);
  walk(10.0, 10.5, 0.0);
  walk(10.5, 11.0, 0.5);
  EXPECT_EQ(belief.mostLikely(), 1u);
}

// 0.1 m on each axis, as of a good tracker of legs; 100 people for 30 s each.
TEST(IntentionModel, JitterOfWhoStandsPoisonsNothing) {
  const IntentionModel model({});
  const std::vector<Point> corners{{-50.0, -50.0}, {50.0, -50.0}, {50.0, 50.0}, {-50.0, 50.0}};
  std::mt19937 random(5);
  std::normal_distribution<double> jitter(0.0, 0.1);
  double standing = 0.0;
  int poisoned = 0, count = 0;
  for (int person = 0; person < 100; ++person) {
    IntentionBelief belief = model.firstBelief(4);
    Point last(0.0, 0.0);
    for (int i = 0; i < 60; ++i) {
      const Point now(jitter(random), jitter(random));
      model.update({last, now, 0.5, 1.0, Point(0.0, 0.0)}, corners, belief);
      last = now;
      if (i < 10) continue;  // 5 s to learn in
      standing += belief.standing();
      ++count;
      poisoned += belief.mostLikely() < 4 ? 1 : 0;
      ASSERT_NEAR(sumOf(belief), 1.0, 1e-12);
    }
  }
  EXPECT_GT(standing / count, 0.85);
  EXPECT_LT(poisoned, 0.005 * count);
}

TEST(IntentionModel, OutOfReachOfAllStaysABelief) {
  const IntentionModel model({});
  IntentionBelief belief = model.firstBelief(2);
  for (const double far : {1e3, 1e100, 1e300}) {
    model.update({{0.0, 0.0}, {far, far}, 0.5, 1.0, Point(0.0, 0.0)}, kEnds, belief);
    EXPECT_NEAR(sumOf(belief), 1.0, 1e-12) << far;
  }
  model.update({{100.0, 0.0}, {100.0, 0.0}, 0.5, 1.0, {}}, kEnds, belief);  // on a destination
  EXPECT_NEAR(sumOf(belief), 1.0, 1e-12);
}

TEST(IntentionModel, NamesAWrongParameter) {
  const auto messageFor = [](const IntentionModel::Params& params) -> std::string {
    try {
      const IntentionModel model(params);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  IntentionModel::Params params;
  EXPECT_EQ(messageFor(params), "accepted");
  params.position_noise = -0.1;
  EXPECT_EQ(messageFor(params), "belief.position_noise must not be negative, got -0.1");
  params = {};
  params.change_rate = std::nan("");
  EXPECT_EQ(messageFor(params), "belief.change_rate must not be negative, got nan");
  params = {};
  params.standing = 0.7;
  EXPECT_NE(messageFor(params).find("leave something to destinations"), std::string::npos);
  IntentionBelief three(3);
  EXPECT_THROW(IntentionModel({}).update({}, kEnds, three), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
