// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/robot_connection.h"

#include <ros/master.h>

#include <thread>
#include <utility>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kRetryPeriod = 5.0;  // [s]
constexpr double kPatience = 10.0;    // [s], with the master
const char* const kMaster = "the ROS master";

}  // namespace

struct RobotConnection::Outcome {
  PanelNames names;
  bool has_master = false;
  PlannerFacts facts;
  std::shared_ptr<RobotLink> link;
};

// To let go of a link takes as long as the master likes; the runner waits for a second.
RobotConnection::~RobotConnection() {
  if (runner_.isBusy()) {  // with a master that may hang: nobody waits for it
    std::thread([link = std::exchange(link_, nullptr)] {}).detach();
    return;
  }
  runner_.start({kMaster, kPatience,
                 [link = std::exchange(link_, nullptr)] { return CallResult(); }, nullptr},
                steadySeconds());
}

void RobotConnection::setNames(const PanelNames& names) {
  names_ = names;
  is_renamed_ = wants_facts_ = true;
  has_fresh_facts_ = false;
  next_ = 0.0;
}

void RobotConnection::tick(double now, bool is_silent) {
  if (const auto result = runner_.poll(now)) finish(*result);
  if (is_silent) wants_facts_ = true;
  if (runner_.isBusy()) return;
  const bool wants_link = !link_ || is_renamed_ || is_silent;
  if (wants_link && has_fresh_facts_) {
    makeLink(now);
  } else if (now >= next_ && (wants_link || wants_facts_)) {
    askMaster(now);
  }
}

void RobotConnection::askMaster(double now) {
  next_ = now + kRetryPeriod;
  outcome_ = std::make_shared<Outcome>();
  outcome_->names = names_;
  const auto work = [outcome = outcome_] {
    outcome->has_master = ros::master::check();
    if (outcome->has_master) outcome->facts = readPlannerFacts(outcome->names);
    return CallResult{true, ""};
  };
  runner_.start({kMaster, kPatience, work, nullptr}, now);
}

// The old link goes first: only then does ROS tell the master again.
void RobotConnection::makeLink(double now) {
  has_fresh_facts_ = false;
  outcome_ = std::make_shared<Outcome>();
  outcome_->names = names_;
  outcome_->has_master = true;
  const auto work = [outcome = outcome_, old = std::exchange(link_, nullptr)]() mutable {
    old.reset();
    outcome->link = std::make_shared<RobotLink>(outcome->names);
    return CallResult{true, ""};
  };
  runner_.start({kMaster, kPatience, work, nullptr}, now);
}

void RobotConnection::finish(const CallResult& result) {
  const auto outcome = std::exchange(outcome_, nullptr);
  has_master_ = result.is_done && outcome->has_master;
  if (!has_master_) return;
  const bool is_of_these_names = outcome->names == names_;
  if (outcome->link) {
    link_ = outcome->link;
    is_renamed_ = !is_of_these_names;
  } else if (is_of_these_names) {
    facts_ = outcome->facts;
    has_fresh_facts_ = true;
    wants_facts_ = false;
  }
}

}  // namespace pomdp_crowd_nav
