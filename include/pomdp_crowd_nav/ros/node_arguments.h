// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace pomdp_crowd_nav {

// What is left of a node's command line after ros::init: answers --help and refuses the rest, with
// the exit status with which the node then ends; none when nothing is left.
std::optional<int> answerArguments(const std::string& node, const std::string& purpose, int argc,
                                   char** argv);

}  // namespace pomdp_crowd_nav
