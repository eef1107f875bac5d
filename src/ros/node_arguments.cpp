// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/node_arguments.h"

#include <iostream>

namespace pomdp_crowd_nav {

std::optional<int> answerArguments(const std::string& node, const std::string& purpose, int argc,
                                   char** argv) {
  if (argc < 2) return std::nullopt;
  const std::string argument = argv[1];
  if (argument == "--help" || argument == "-h") {
    std::cout << purpose << "\n"
              << "usage: rosrun pomdp_crowd_nav " << node
              << " [_PARAMETER:=VALUE]... [TOPIC:=OTHER_TOPIC]...\n"
              << "The README lists parameters, topics and services." << std::endl;
    return 0;
  }
  std::cerr << node << ": unknown argument '" << argument
            << "'; parameters are given as _NAME:=VALUE (--help)" << std::endl;
  return 2;
}

}  // namespace pomdp_crowd_nav
