// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/call_runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stdexcept>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

std::optional<CallResult> pollUntilThere(CallRunner& runner, double now) {
  const double give_up = steadySeconds() + 10.0;
  while (steadySeconds() < give_up) {
    if (auto result = runner.poll(now)) return result;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return std::nullopt;
}

void waitUntilFree(CallRunner& runner, double now) {
  const double give_up = steadySeconds() + 10.0;
  while (runner.isBusy() && steadySeconds() < give_up) {
    EXPECT_FALSE(runner.poll(now)) << "a call has one result";
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(CallRunner, HandsTheResultOverOnce) {
  CallRunner runner;
  EXPECT_FALSE(runner.poll(0.0));
  ASSERT_TRUE(runner.start({"node", 3.0, [] { return CallResult{true, "done"}; }, nullptr}, 0.0));
  const auto result = pollUntilThere(runner, 1.0);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->is_done);
  EXPECT_EQ(result->text, "done");
  EXPECT_FALSE(runner.isBusy());
  EXPECT_FALSE(runner.poll(1.0));
}

TEST(CallRunner, OneCallAtATime) {
  CallRunner runner;
  std::promise<void> end;
  runner.start({"node", 3.0,
                [&] {
                  end.get_future().wait();
                  return CallResult{true, "first"};
                },
                nullptr},
               0.0);
  EXPECT_TRUE(runner.isBusy());
  EXPECT_FALSE(runner.poll(2.9)) << "within the limit";
  EXPECT_FALSE(runner.start({"node", 3.0, [] { return CallResult(); }, nullptr}, 1.0));
  end.set_value();
  EXPECT_EQ(pollUntilThere(runner, 1.0)->text, "first");
}

TEST(CallRunner, GivesUpInterruptsAndIsFreeAgain) {
  CallRunner runner;
  std::promise<void> interrupted;
  int interrupts = 0;
  runner.start({"planner_node", 3.0,
                [&] {
                  interrupted.get_future().wait();
                  return CallResult{true, "too late"};
                },
                [&] {
                  ++interrupts;
                  interrupted.set_value();
                }},
               10.0);
  EXPECT_FALSE(runner.poll(12.9));
  const auto result = runner.poll(13.1);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->is_done);
  EXPECT_EQ(result->text, "planner_node does not answer");
  waitUntilFree(runner, 20.0);
  EXPECT_EQ(interrupts, 1);
  EXPECT_TRUE(runner.start({"node", 3.0, [] { return CallResult{true, "next"}; }, nullptr}, 20.0));
  EXPECT_EQ(pollUntilThere(runner, 20.0)->text, "next");
}

TEST(CallRunner, WhatIsGivenUpIsInterruptedAndHasNoResult) {
  CallRunner runner;
  std::promise<void> interrupted;
  runner.giveUp();  // nothing is under way
  runner.start({"planner_node", 3.0,
                [&] {
                  interrupted.get_future().wait();
                  return CallResult{true, "late"};
                },
                [&] { interrupted.set_value(); }},
               0.0);
  runner.giveUp();
  runner.giveUp();
  while (runner.isBusy()) EXPECT_FALSE(runner.poll(1.0));
}

TEST(CallRunner, AnExceptionIsATextToo) {
  CallRunner runner;
  runner.start({"node", 3.0, []() -> CallResult { throw std::runtime_error("no such file"); }, {}},
               0.0);
  const auto result = pollUntilThere(runner, 0.0);
  EXPECT_FALSE(result->is_done);
  EXPECT_EQ(result->text, "no such file");
}

TEST(CallRunner, TheEndDoesNotWaitForACallThatHangs) {
  auto end = std::make_shared<std::promise<void>>();
  const double begin = steadySeconds();
  {
    CallRunner runner;
    runner.start({"node", 3.0,
                  [end] {
                    end->get_future().wait();
                    return CallResult();
                  },
                  nullptr},
                 0.0);
  }
  EXPECT_LT(steadySeconds() - begin, 5.0);
  end->set_value();
}

}  // namespace
}  // namespace pomdp_crowd_nav
