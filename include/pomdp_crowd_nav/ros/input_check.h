// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/ros/stop_cause.h"

namespace pomdp_crowd_nav {

// What a listener has found out about one input of the planner.
struct HeardInput {
  std::string name;           // as in the node, before remapping
  std::string topic;          // resolved
  std::string expected_type;  // of messages
  std::string type;           // that was announced; empty: none
  std::vector<std::string> publishers;
  std::string frame;  // of the newest message
  std::string global_frame = "map";
  unsigned messages = 0;
  unsigned of_other_layout = 0;
  double duration = 5.0;                     // [s] of listening
  double rate = 0.0;                         // [Hz]
  double age = -1.0;                         // [s] of the newest message when it came
  double limit = 0.0;                        // [s], 0: none
  MessageFault fault = MessageFault::kNone;  // of the newest message
};

struct InputVerdict {
  bool is_fine = true;
  std::string text;    // a word or two
  std::string advice;  // what to do, where it is not fine
};

InputVerdict judge(const HeardInput& input);

// One line for each input, columns aligned, then what to do.
struct CheckedInput {
  HeardInput heard;
  InputVerdict verdict;
};
std::string tableOf(const std::vector<CheckedInput>& inputs);

}  // namespace pomdp_crowd_nav
