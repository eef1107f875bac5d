// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <csignal>

namespace pomdp_crowd_nav {

// Ctrl-C, SIGTERM and SIGHUP, to be looked for where it is safe to end; a second one ends the
// program at once. One that is ignored, as under nohup, stays ignored.
class Interruption {
 public:
  struct Signal {
    int number = 0;
    int exitStatus() const { return 128 + number; }
  };

  static void listen() {
    struct sigaction action {};
    action.sa_handler = [](int number) { received_ = number; };
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction before {};
      sigaction(number, nullptr, &before);
      if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);
    }
  }

  static void throwIfReceived() {
    if (const int number = received_) throw Signal{number};
  }

 private:
  static inline std::atomic<int> received_{0};
  static_assert(std::atomic<int>::is_always_lock_free);
};

}  // namespace pomdp_crowd_nav
