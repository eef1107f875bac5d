// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/shutdown_request.h"

#include <ros/xmlrpc_manager.h>

#include <csignal>

namespace pomdp_crowd_nav {
namespace {

volatile std::sig_atomic_t is_requested = 0;

void request(int) { is_requested = 1; }

// As roscpp answers `rosnode kill` and the master.
void onShutdown(XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& result) {
  is_requested = 1;
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

bool isShutdownRequested() { return is_requested != 0; }

}  // namespace pomdp_crowd_nav
