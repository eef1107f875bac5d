// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/call_runner.h"

#include <chrono>
#include <exception>
#include <future>
#include <utility>

namespace pomdp_crowd_nav {

struct CallRunner::Answer {
  std::promise<CallResult> promise;
  std::future<CallResult> future = promise.get_future();

  bool isThere(std::chrono::milliseconds patience = std::chrono::milliseconds(0)) const {
    return future.wait_for(patience) == std::future_status::ready;
  }
};

CallRunner::~CallRunner() {
  if (!thread_.joinable()) return;
  if (!is_given_up_ && call_.interrupt) call_.interrupt();
  if (answer_->isThere(std::chrono::milliseconds(1000))) {
    thread_.join();
  } else {
    thread_.detach();
  }
}

bool CallRunner::start(Call call, double now) {
  if (isBusy()) return false;
  call_ = std::move(call);
  give_up_ = now + call_.time_limit;
  is_given_up_ = false;
  answer_ = std::make_shared<Answer>();
  thread_ = std::thread([work = call_.work, answer = answer_]() mutable {
    CallResult result;
    try {
      result = work();
    } catch (const std::exception& error) {
      result = {false, error.what()};
    }
    work = nullptr;  // what it holds is let go of here, not by who polls
    answer->promise.set_value(std::move(result));
  });
  call_.work = nullptr;
  return true;
}

std::optional<CallResult> CallRunner::poll(double now) {
  if (!isBusy()) return std::nullopt;
  if (answer_->isThere()) {
    thread_.join();
    const CallResult result = answer_->future.get();
    if (is_given_up_) return std::nullopt;
    return result;
  }
  if (is_given_up_ || now < give_up_) return std::nullopt;
  giveUp();
  return CallResult{false, call_.whom + " does not answer"};
}

void CallRunner::giveUp() {
  if (!isBusy() || is_given_up_) return;
  is_given_up_ = true;
  if (call_.interrupt) call_.interrupt();
}

}  // namespace pomdp_crowd_nav
