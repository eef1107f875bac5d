// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "pomdp_crowd_nav/ros/panel/call_runner.h"
#include "pomdp_crowd_nav/ros/panel/panel_names.h"
#include "pomdp_crowd_nav/ros/panel/robot_calls.h"
#include "pomdp_crowd_nav/ros/panel/robot_link.h"

namespace pomdp_crowd_nav {

// Keeps a link to the robot. All that asks the master happens in a thread of its own.
//
// While the planner is silent the link is made anew every few seconds, so that nodes are found
// under a master that has been started again. Without a master the old link stays: its connections
// still work.
class RobotConnection {
 public:
  explicit RobotConnection(const PanelNames& names) : names_(names) {}
  ~RobotConnection();
  RobotConnection(const RobotConnection&) = delete;
  RobotConnection& operator=(const RobotConnection&) = delete;

  void setNames(const PanelNames& names);

  // `now` [s], steady clock; `is_silent`: the planner is not heard.
  void tick(double now, bool is_silent);

  // None at the start, under other names and for a moment whenever it is made anew.
  std::shared_ptr<RobotLink> link() const { return is_renamed_ ? nullptr : link_; }
  const PlannerFacts& facts() const { return facts_; }
  bool hasMaster() const { return has_master_; }  // when it was last asked

 private:
  struct Outcome;

  void askMaster(double now);
  void makeLink(double now);
  void finish(const CallResult& result);

  PanelNames names_;
  std::shared_ptr<RobotLink> link_;
  std::shared_ptr<Outcome> outcome_;  // of the thread, to be read when it has ended
  CallRunner runner_;
  PlannerFacts facts_;
  double next_ = 0.0;  // [s], steady clock, when the master is asked again
  bool has_master_ = true;
  bool has_fresh_facts_ = false;
  bool wants_facts_ = true;
  bool is_renamed_ = false;  // the link is another robot's
};

}  // namespace pomdp_crowd_nav
