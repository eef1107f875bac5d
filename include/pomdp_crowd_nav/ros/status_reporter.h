// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <mutex>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/ros/input_health.h"
#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {

// Publishes `~status` and, from the newest status and the health of each input, `/diagnostics`.
// Thread-safe.
class StatusReporter {
 public:
  StatusReporter(ros::NodeHandle& node, ros::NodeHandle& private_node,
                 const std::string& hardware_id);

  // Stamps and sends it.
  void publish(PlannerStatus status);

  void publishDiagnostics(std::vector<InputHealth> inputs);

 private:
  void diagnoseState(diagnostic_updater::DiagnosticStatusWrapper& out);
  void diagnoseTiming(diagnostic_updater::DiagnosticStatusWrapper& out);
  void diagnoseInput(size_t index, diagnostic_updater::DiagnosticStatusWrapper& out);
  PlannerStatus newest();

  std::mutex mutex_;
  PlannerStatus status_;
  std::vector<InputHealth> inputs_;
  ros::Publisher publisher_;
  diagnostic_updater::Updater updater_;
};

}  // namespace pomdp_crowd_nav
