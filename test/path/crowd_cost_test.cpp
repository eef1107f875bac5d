// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/path/crowd_cost.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kDestinations{{0.0, 0.0}, {0.0, 40.0}, {40.0, 40.0}, {40.0, 0.0}};
const Bounds kField{{0.0, 0.0}, {40.0, 40.0}};

PersonBelief uncertain(const Point& place) {
  return {1, place, {0.0, 0.0}, 1.0, IntentionBelief(4)};
}

// Has been seen to walk towards destination 2 for long enough.
PersonBelief sure(const Point& place) {
  PersonBelief person = uncertain(place);
  for (int i = 0; i < 10; ++i) {
    person.intention.update(place - Point(0.4, 0.4), place, kDestinations);
  }
  return person;
}

double costAt(const CrowdCost::Params& params, const PersonBelief& person, const Point& place,
              int element, const Point& start = {0.0, 20.0}) {
  CrowdCost cost(params);
  cost.predict(start, {person}, kDestinations, kField);
  return cost.at(place.x(), place.y(), element);
}

TEST(CrowdCost, UncertainPeopleStandInAPotentialField) {
  const PersonBelief person = uncertain({20.0, 20.0});
  for (const int element : {1, 10, 90}) {
    EXPECT_DOUBLE_EQ(costAt({}, person, {25.0, 20.0}, element), 2.0);
    EXPECT_DOUBLE_EQ(costAt({}, person, {20.0, 1.0}, element), 10.0 / 19.0);
    EXPECT_EQ(costAt({}, person, {40.0, 20.0}, element), 0.0) << "20 m away";
    EXPECT_TRUE(std::isinf(costAt({}, person, {22.0, 20.0}, element)));
  }
}

TEST(CrowdCost, SurePeopleAreDiscsThatWalk) {
  const PersonBelief person = sure({20.0, 20.0});
  ASSERT_GE(person.intention.probabilities()[2], 0.5);
  const double diagonal = std::sqrt(0.5);
  EXPECT_EQ(costAt({}, person, {20.0, 20.0}, 10), 0.0) << "gone from there";
  const Point after_ten = Point(20.0, 20.0) + 10.0 * Point(diagonal, diagonal);
  EXPECT_TRUE(std::isinf(costAt({}, person, after_ten, 10)));
  EXPECT_TRUE(std::isinf(costAt({}, person, after_ten + Point(1.99, 0.0), 10)));
  EXPECT_EQ(costAt({}, person, after_ten + Point(2.01, 0.0), 10), 0.0);
  EXPECT_TRUE(std::isinf(costAt({}, person, {40.0, 40.0}, 200))) << "stays at the destination";
  CrowdCost::Params fast;
  fast.pace = 2.0;
  EXPECT_TRUE(std::isinf(costAt(fast, person, after_ten, 20)));
  CrowdCost::Params with_field;
  with_field.field_on_way = true;
  EXPECT_DOUBLE_EQ(costAt(with_field, person, after_ten + Point(5.0, 0.0), 10), 2.0);
}

TEST(CrowdCost, WhoStartsInADiscMayLeaveIt) {
  const PersonBelief person = uncertain({20.0, 20.0});
  const Point start(21.0, 20.0);
  EXPECT_TRUE(std::isfinite(costAt({}, person, {21.5, 20.0}, 1, start)));
  EXPECT_TRUE(std::isinf(costAt({}, person, {20.5, 20.0}, 1, start)));
}

TEST(CrowdCost, SumsUpAndOfNobodyIsNothing) {
  CrowdCost cost({});
  cost.predict({0.0, 0.0}, {uncertain({20.0, 20.0}), uncertain({20.0, 30.0})}, kDestinations,
               kField);
  EXPECT_DOUBLE_EQ(cost.at(20.0, 25.0, 3), 4.0);
  cost.predict({0.0, 0.0}, {}, kDestinations, kField);
  EXPECT_EQ(cost.at(20.0, 20.0, 3), 0.0);
}

TEST(CrowdCost, WhoStandsOrWalksElsewhereIsAvoidedThere) {
  PersonBelief person = uncertain({20.0, 20.0});
  person.walk = Point(0.0, 1.0);
  person.intention.assign(std::vector<double>(kDestinations.size(), 0.0), 0.9, 0.1);
  CrowdCost::Params params;
  EXPECT_TRUE(std::isinf(costAt(params, person, {20.0, 21.5}, 10)));
  EXPECT_EQ(costAt(params, person, {20.0, 23.0}, 10), 0.0);
  person.intention.assign(std::vector<double>(kDestinations.size(), 0.0), 0.1, 0.9);
  EXPECT_TRUE(std::isinf(costAt(params, person, {20.0, 30.0}, 10)));
  EXPECT_EQ(costAt(params, person, {20.0, 20.0}, 10), 0.0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
