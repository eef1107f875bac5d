// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/people_choice.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

using Answer = PeopleChoice::Answer;
constexpr size_t kFirst = 0, kSecond = 1;

TEST(PeopleChoice, TheFirstThatSpeaksIsUsedUntilItIsSilent) {
  PeopleChoice choice(1.0);
  EXPECT_EQ(choice.hear(kSecond, 2, 10.0), Answer::kUseAfresh);
  EXPECT_EQ(choice.hear(kFirst, 2, 10.1), Answer::kIgnore);
  EXPECT_EQ(choice.hear(kSecond, 2, 10.5), Answer::kUse);
  EXPECT_EQ(choice.hear(kFirst, 2, 11.4), Answer::kIgnore);
  EXPECT_EQ(choice.hear(kFirst, 2, 11.6), Answer::kUseAfresh);
  EXPECT_EQ(choice.hear(kSecond, 2, 11.7), Answer::kIgnore);
}

TEST(PeopleChoice, AnEmptyTopicDoesNotHideTheOtherForLong) {
  PeopleChoice choice(1.0);
  EXPECT_EQ(choice.hear(kFirst, 0, 10.0), Answer::kUseAfresh);
  Answer answer = Answer::kIgnore;
  double now = 10.0;
  for (; answer == Answer::kIgnore && now < 20.0; now += 0.1) {
    choice.hear(kFirst, 0, now);
    answer = choice.hear(kSecond, 3, now + 0.05);
  }
  EXPECT_EQ(answer, Answer::kUseAfresh);
  EXPECT_LT(now, 11.3);
  EXPECT_EQ(choice.hear(kFirst, 0, now), Answer::kIgnore);
  EXPECT_EQ(choice.hear(kSecond, 3, now + 0.1), Answer::kUse);
}

TEST(PeopleChoice, NobodyAtAllChangesNothing) {
  PeopleChoice choice(1.0);
  choice.hear(kFirst, 0, 10.0);
  for (double now = 10.1; now < 15.0; now += 0.1) {
    EXPECT_EQ(choice.hear(kFirst, 0, now), Answer::kUse);
    EXPECT_EQ(choice.hear(kSecond, 0, now), Answer::kIgnore);
  }
}

TEST(PeopleChoice, TwoThatReportSomebodyDoNotTakeTurns) {
  PeopleChoice choice(1.0);
  choice.hear(kFirst, 1, 10.0);
  for (double now = 10.1; now < 15.0; now += 0.1) {
    EXPECT_EQ(choice.hear(kFirst, 1, now), Answer::kUse);
    EXPECT_EQ(choice.hear(kSecond, 4, now), Answer::kIgnore);
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
