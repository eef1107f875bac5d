// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/panel_controls.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {
namespace {

ControlInputs inState(std::uint8_t state) {
  ControlInputs inputs;
  inputs.state = state;
  inputs.has_goal = inputs.has_simulator = true;
  inputs.has_trip = state != PlannerStatus::IDLE;
  return inputs;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(PanelControls, AnIdlePlannerCanBeChangedAndStarted) {
  const PanelControls controls = controlsFor(inState(PlannerStatus::IDLE));
  EXPECT_TRUE(controls.planner.is_enabled);
  EXPECT_TRUE(controls.start.is_enabled);
  EXPECT_TRUE(controls.reset.is_enabled);
  EXPECT_FALSE(controls.pause.is_enabled);
  EXPECT_FALSE(controls.stop.is_enabled);
}

TEST(PanelControls, OnATripThePlannerIsGreyAndSaysWhy) {
  for (const auto state :
       {PlannerStatus::PREPARING, PlannerStatus::WAITING_FOR_INPUT, PlannerStatus::DRIVING,
        PlannerStatus::WAITING_FOR_PEOPLE, PlannerStatus::BLOCKED}) {
    const PanelControls controls = controlsFor(inState(state));
    EXPECT_FALSE(controls.planner.is_enabled);
    EXPECT_EQ(controls.planner.tooltip,
              "the planner can be changed only while no trip is under way");
    EXPECT_FALSE(controls.start.is_enabled);
    EXPECT_TRUE(controls.pause.is_enabled);
    EXPECT_TRUE(controls.stop.is_enabled);
    EXPECT_TRUE(controls.reset.is_enabled);
  }
}

TEST(PanelControls, APauseOnATripIsResumedOrStopped) {
  const PanelControls controls = controlsFor(inState(PlannerStatus::PAUSED));
  EXPECT_TRUE(controls.is_resume);
  EXPECT_TRUE(controls.start.is_enabled);
  EXPECT_FALSE(controls.pause.is_enabled);
  EXPECT_TRUE(controls.stop.is_enabled);
  EXPECT_FALSE(controls.planner.is_enabled);
}

TEST(PanelControls, APauseThatOutlastsItsTripIsAsIdle) {
  ControlInputs inputs = inState(PlannerStatus::PAUSED);
  inputs.has_trip = false;
  const PanelControls controls = controlsFor(inputs);
  EXPECT_FALSE(controls.is_resume);
  EXPECT_TRUE(controls.start.is_enabled);
  EXPECT_TRUE(controls.planner.is_enabled);
  EXPECT_FALSE(controls.stop.is_enabled);
}

TEST(PanelControls, NothingIsStartedWhileTheBaseComesToRest) {
  const PanelControls controls = controlsFor(inState(PlannerStatus::STOPPING));
  for (const Control& control : {controls.start, controls.pause, controls.stop}) {
    EXPECT_FALSE(control.is_enabled);
    EXPECT_EQ(control.tooltip, "the base comes to rest");
  }
  EXPECT_FALSE(controls.planner.is_enabled);
}

TEST(PanelControls, WithoutGoalOrSimulatorTheirButtonsAreGrey) {
  ControlInputs inputs = inState(PlannerStatus::IDLE);
  inputs.has_goal = inputs.has_simulator = false;
  const PanelControls controls = controlsFor(inputs);
  EXPECT_FALSE(controls.start.is_enabled);
  EXPECT_EQ(controls.start.tooltip, "there is no goal yet: set one with '2D Nav Goal'");
  EXPECT_FALSE(controls.reset.is_enabled);
  EXPECT_EQ(controls.reset.tooltip, "there is no sim_node: nothing to reset");
}

TEST(PanelControls, WhoIsNotHeardCanOnlyBeAskedToStop) {
  ControlInputs inputs = inState(PlannerStatus::DRIVING);
  inputs.state.reset();
  const PanelControls controls = controlsFor(inputs);
  EXPECT_FALSE(controls.planner.is_enabled);
  EXPECT_FALSE(controls.start.is_enabled);
  EXPECT_FALSE(controls.pause.is_enabled);
  EXPECT_EQ(controls.pause.tooltip, "planner_node is not heard");
  EXPECT_TRUE(controls.stop.is_enabled);
  EXPECT_TRUE(controls.reset.is_enabled);
}

TEST(PanelControls, StopNeverWaitsForAnAnswer) {
  ControlInputs inputs = inState(PlannerStatus::DRIVING);
  inputs.is_busy = true;
  const PanelControls controls = controlsFor(inputs);
  EXPECT_TRUE(controls.stop.is_enabled);
  EXPECT_FALSE(controls.pause.is_enabled);
  EXPECT_FALSE(controls.reset.is_enabled);
  EXPECT_EQ(controls.pause.tooltip, "waiting for an answer");
  EXPECT_EQ(controls.start.tooltip, "a trip is under way") << "the reason that lasts";
}

TEST(PanelControls, AStartThatWaitsForAnAnswerCanBeStopped) {
  ControlInputs inputs = inState(PlannerStatus::IDLE);
  EXPECT_FALSE(controlsFor(inputs).stop.is_enabled);
  inputs.is_busy = true;
  EXPECT_TRUE(controlsFor(inputs).stop.is_enabled);
}

TEST(PlannersFor, AreThoseThatDriveTheVehicle) {
  EXPECT_TRUE(has(plannersFor("holonomic"), "2d_fmm"));
  EXPECT_FALSE(has(plannersFor("holonomic"), "2d_nhv"));
  EXPECT_TRUE(has(plannersFor("car"), "2d_nhv"));
  EXPECT_FALSE(has(plannersFor("car"), "2d_fmm"));
  EXPECT_TRUE(has(plannersFor("another word"), "2d_fmm"));
  EXPECT_TRUE(has(plannersFor("another word"), "2d_nhv"));
}

}  // namespace
}  // namespace pomdp_crowd_nav
