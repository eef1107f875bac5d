// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pomdp_crowd_nav {

// For nodes that must stop the base before they go: after this, Ctrl-C, SIGTERM, a terminal that is
// closed (SIGHUP) and `rosnode kill` no longer end the node but are answered by
// `isShutdownRequested`. To be called once, after ros::init with NoSigintHandler and the first node
// handle.
void catchShutdownRequests();

bool isShutdownRequested();

}  // namespace pomdp_crowd_nav
