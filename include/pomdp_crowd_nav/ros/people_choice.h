// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pomdp_crowd_nav {

// Which of several topics says where people are: the first that speaks, until it has been silent
// for a while. All times [s], steady clock.
class PeopleChoice {
 public:
  explicit PeopleChoice(double timeout) : timeout_(timeout) {}

  enum class Answer {
    kUse,
    kUseAfresh,  // it was another one before, or nobody
    kIgnore
  };

  // A message of `topic` that can be used.
  Answer hear(size_t topic, double now) {
    const bool is_free = last_ < 0.0 || now - last_ > timeout_;
    if (topic != topic_ && !is_free) return Answer::kIgnore;
    const bool is_new = topic != topic_ || last_ < 0.0;
    topic_ = topic;
    last_ = now;
    return is_new ? Answer::kUseAfresh : Answer::kUse;
  }

 private:
  double timeout_;
  size_t topic_ = 0;
  double last_ = -1.0;  // of the present topic
};

}  // namespace pomdp_crowd_nav
