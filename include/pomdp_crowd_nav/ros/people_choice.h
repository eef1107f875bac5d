// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pomdp_crowd_nav {

// Which of several topics says where people are: the first that speaks, until it has been silent
// for a while, or has reported nobody for as long while another reports somebody. All times [s],
// steady clock.
class PeopleChoice {
 public:
  explicit PeopleChoice(double timeout) : timeout_(timeout) {}

  enum class Answer {
    kUse,
    kUseAfresh,  // it was another one before, or nobody
    kIgnore
  };

  // A message of `topic` that can be used; `people` are in it.
  Answer hear(size_t topic, size_t people, double now) {
    const bool is_other = last_ >= 0.0 && topic != topic_;
    const bool is_silent = now - last_ > timeout_;
    const bool is_empty = people > 0 && now - somebody_ > timeout_;
    if (is_other && !is_silent && !is_empty) return Answer::kIgnore;
    const bool is_new = topic != topic_ || last_ < 0.0;
    topic_ = topic;
    last_ = now;
    if (people > 0 || is_new) somebody_ = now;
    return is_new ? Answer::kUseAfresh : Answer::kUse;
  }

 private:
  double timeout_;
  size_t topic_ = 0;
  double last_ = -1.0;     // message of the present topic
  double somebody_ = 0.0;  // the present topic reported somebody, or began
};

}  // namespace pomdp_crowd_nav
