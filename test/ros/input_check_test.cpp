// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/input_check.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

HeardInput fineOdometry() {
  HeardInput input;
  input.name = "odom";
  input.topic = "/robot/odom";
  input.expected_type = input.type = "nav_msgs/Odometry";
  input.publishers = {"/base"};
  input.frame = "odom";
  input.messages = 100;
  input.rate = 50.0;
  input.age = 0.01;
  input.limit = 0.5;
  return input;
}

void expectAdvice(const HeardInput& input, const std::string& words) {
  const InputVerdict verdict = judge(input);
  EXPECT_FALSE(verdict.is_fine);
  EXPECT_NE(verdict.text, "");
  EXPECT_NE(verdict.advice.find(words), std::string::npos) << verdict.advice;
}

TEST(InputCheck, WhatIsFineIsFine) { EXPECT_TRUE(judge(fineOdometry()).is_fine); }

TEST(InputCheck, SaysWhatToDo) {
  HeardInput input = fineOdometry();
  input.rate = 1.0;
  expectAdvice(input, "comes at 1.00 Hz");
  input = fineOdometry();
  input.age = 3.0;
  expectAdvice(input, "3.00 s old");
  input = fineOdometry();
  input.fault = MessageFault::kNoTransform;
  expectAdvice(input, "from 'odom' to 'map'");
  input.fault = MessageFault::kFuture;
  expectAdvice(input, "stamped in the future");
  input.fault = MessageFault::kUnstamped;
  expectAdvice(input, "/base");
  input = fineOdometry();
  input.messages = 0;
  expectAdvice(input, "published by /base");
  input.type = "geometry_msgs/Twist";
  input.of_other_layout = 3;
  expectAdvice(input, "carries geometry_msgs/Twist");
  input.of_other_layout = 0;
  input.publishers.clear();
  expectAdvice(input, "remap odom:=");
}

TEST(InputCheck, ALatchedMapNeedsNoRate) {
  HeardInput input = fineOdometry();
  input.limit = 0.0;
  input.rate = 0.0;
  input.messages = 1;
  EXPECT_TRUE(judge(input).is_fine);
}

TEST(InputCheck, ColumnsAreAlignedAndAdviceFollows) {
  HeardInput silent = fineOdometry();
  silent.name = "tracked_persons";
  silent.messages = 0;
  const std::string table =
      tableOf({{fineOdometry(), judge(fineOdometry())}, {silent, judge(silent)}});
  EXPECT_EQ(table.find("verdict"), table.find('\n') - 7);
  EXPECT_NE(table.find("NOT OK: silent"), std::string::npos);
  EXPECT_NE(table.find("\n-> "), std::string::npos);
}

}  // namespace
}  // namespace pomdp_crowd_nav
