// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pomdp_crowd_nav {

// From now on a terminal or pipe that takes nothing up holds up nobody who writes a log: standard
// output and standard error lead to a process of their own that passes them on, and what does not
// fit in between is lost. That process ends when this one has, and nothing is left to pass on.
//
// To be called once, before there is any other thread. Does nothing where the system refuses.
void relayOutput();

}  // namespace pomdp_crowd_nav
