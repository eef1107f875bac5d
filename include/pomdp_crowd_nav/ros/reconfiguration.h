// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/server.h>
#include <pomdp_crowd_nav/PlannerConfig.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <string>

#include "pomdp_crowd_nav/params/param_values.h"

namespace pomdp_crowd_nav {

// Lets clients of dynamic_reconfigure change parameters of a node that runs: those of
// config/parameters.yaml with `change`. Only there do their names hold underscores for slashes; the
// parameter server keeps the keys of a profile, so that a node that is started again finds the
// newest values.
//
// A change is taken as a whole or, with a warning that says why, not at all: the client and the
// server then get the old values back.
class Reconfiguration {
 public:
  // Takes the parameters, or returns why not. Called from the thread of the service.
  using Adopt = std::function<std::string(const NavigationParams&)>;

  // `params`: what the node started with.
  Reconfiguration(const ros::NodeHandle& private_node, const NavigationParams& params, Adopt adopt);

 private:
  void onChange(PlannerConfig& config, std::uint32_t level);
  std::string change(const PlannerConfig& config);
  ParamValues valuesIn(const PlannerConfig& config) const;
  PlannerConfig present() const;

  NavigationParams params_;
  Adopt adopt_;
  dynamic_reconfigure::Server<PlannerConfig> server_;
};

}  // namespace pomdp_crowd_nav
