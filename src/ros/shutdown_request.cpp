// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/shutdown_request.h"

#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>

namespace pomdp_crowd_nav {
namespace {

// From a signal or from another thread.
std::atomic<bool> is_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a handler of signals may not wait");

void request(int) { is_requested = true; }

// As roscpp answers `rosnode kill` and the master.
void onShutdown(XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& result) {
  is_requested = true;
  result = ros::xmlrpc::responseInt(1, "", 0);
}

}  // namespace

void catchShutdownRequests() {
  std::signal(SIGINT, request);
  std::signal(SIGTERM, request);
  if (std::signal(SIGHUP, request) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // started by nohup
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", onShutdown);
}

bool isShutdownRequested() { return is_requested; }

}  // namespace pomdp_crowd_nav
