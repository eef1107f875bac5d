// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/master.h>
#include <ros/names.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <signal.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace pomdp_crowd_nav {

// Process of a node on this machine; 0 when no such node answers.
inline pid_t processOf(const std::string& node) {
  XmlRpc::XmlRpcValue args, result, uri;
  args[0] = ros::this_node::getName();
  args[1] = ros::names::resolve(node);
  if (!ros::master::execute("lookupNode", args, result, uri, false)) return 0;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(static_cast<std::string>(uri), host, port)) return 0;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue question, answer;
  question[0] = ros::this_node::getName();
  if (!client.execute("getPid", question, answer)) return 0;
  return answer.size() == 3 ? static_cast<int>(answer[2]) : 0;
}

// Stops a process for as long as it lives. Throws where there is none.
class StoppedProcess {
 public:
  explicit StoppedProcess(pid_t process) : process_(process) {
    if (process_ <= 0) throw std::runtime_error("there is no such node to stop");
    kill(process_, SIGSTOP);
  }
  ~StoppedProcess() { kill(process_, SIGCONT); }
  StoppedProcess(const StoppedProcess&) = delete;
  StoppedProcess& operator=(const StoppedProcess&) = delete;

 private:
  pid_t process_;
};

}  // namespace pomdp_crowd_nav
