// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace pomdp_crowd_nav {

struct CallResult {
  bool is_done = false;  // what was asked for
  std::string text;      // for people to read; may be empty
};

// Runs one call at a time in a thread of its own, so that whoever asks never waits. A call that
// lasts too long is given up: it is interrupted, and others can follow when its thread has ended.
class CallRunner {
 public:
  struct Call {
    std::string whom;                  // is asked, for the text when no answer comes
    double time_limit = 3.0;           // [s]
    std::function<CallResult()> work;  // its exceptions become texts
    std::function<void()> interrupt;   // makes `work` return, from another thread; may be empty
  };

  CallRunner() = default;
  CallRunner(const CallRunner&) = delete;
  CallRunner& operator=(const CallRunner&) = delete;
  // Interrupts and waits for a second at most; a thread that still hangs is left to itself.
  ~CallRunner();

  // Does nothing and returns false while another call is under way. `now` [s], steady clock.
  bool start(Call call, double now);

  bool isBusy() const { return thread_.joinable(); }

  // Interrupts what is under way; its result is dropped.
  void giveUp();

  // The result, once, when it is there or the time is over.
  std::optional<CallResult> poll(double now);

 private:
  struct Answer;

  std::shared_ptr<Answer> answer_;
  std::thread thread_;
  Call call_;
  double give_up_ = 0.0;  // [s], steady clock
  bool is_given_up_ = false;
};

}  // namespace pomdp_crowd_nav
