// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pomdp_crowd_nav {

// One line for a file that cannot be read, with the folder in which a relative path was looked for:
// a node that roslaunch starts is in another one than its user.
std::string cannotBeRead(const std::string& path);

}  // namespace pomdp_crowd_nav
