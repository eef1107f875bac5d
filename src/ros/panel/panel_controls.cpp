// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/panel_controls.h"

#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {
namespace {

Control enabled(const std::string& tooltip) { return {true, tooltip}; }
Control disabled(const std::string& tooltip) { return {false, tooltip}; }

// Where the states alone do not say whether there is a trip: a pause may outlast one.
bool hasTrip(const ControlInputs& inputs) {
  if (*inputs.state == PlannerStatus::PAUSED) return inputs.has_trip;
  return *inputs.state != PlannerStatus::IDLE;
}

Control startControl(const ControlInputs& inputs) {
  if (*inputs.state == PlannerStatus::STOPPING) return disabled("the base comes to rest");
  if (hasTrip(inputs)) {
    if (*inputs.state == PlannerStatus::PAUSED) return enabled("go on to the goal");
    return disabled("a trip is under way");
  }
  if (!inputs.has_goal) return disabled("there is no goal yet: set one with '2D Nav Goal'");
  return enabled("drive to the goal, the last one again or else the world's");
}

Control pauseControl(const ControlInputs& inputs) {
  if (*inputs.state == PlannerStatus::PAUSED) return disabled("it is paused");
  if (*inputs.state == PlannerStatus::STOPPING) return disabled("the base comes to rest");
  if (!hasTrip(inputs)) return disabled("no trip is under way");
  return enabled("brake and wait; the goal stays");
}

Control stopControl(const ControlInputs& inputs) {
  if (inputs.is_busy) return enabled("give up what is asked for and the goal");
  if (!hasTrip(inputs)) return disabled("no trip is under way");
  if (*inputs.state == PlannerStatus::STOPPING) return disabled("the base comes to rest");
  return enabled("give up the goal; the base comes to rest");
}

Control plannerControl(const ControlInputs& inputs) {
  if (hasTrip(inputs))
    return disabled("the planner can be changed only while no trip is under way");
  return enabled("what decides on the next trip");
}

Control resetControl(const ControlInputs& inputs) {
  if (!inputs.has_simulator)
    return disabled("there is no " + inputs.sim_node + ": nothing to reset");
  return enabled("begin the simulation anew with this seed and number of people");
}

void disableAsBusy(Control& control) { control = disabled("waiting for an answer"); }

}  // namespace

PanelControls controlsFor(const ControlInputs& inputs) {
  PanelControls controls;
  if (inputs.state) {
    controls.planner = plannerControl(inputs);
    controls.start = startControl(inputs);
    controls.pause = pauseControl(inputs);
    controls.stop = stopControl(inputs);
    controls.is_resume = *inputs.state == PlannerStatus::PAUSED && hasTrip(inputs);
  } else {
    const Control none = disabled(inputs.planner_node + " is not heard");
    controls.planner = controls.start = controls.pause = none;
    // Who wants to stop may always try.
    controls.stop = enabled("ask for a stop, though " + inputs.planner_node + " is not heard");
  }
  controls.reset = resetControl(inputs);
  if (inputs.is_busy) {
    for (Control* control :
         {&controls.planner, &controls.start, &controls.pause, &controls.reset}) {
      if (control->is_enabled) disableAsBusy(*control);
    }
  }
  return controls;
}

std::vector<std::string> plannersFor(const std::string& vehicle) {
  std::vector<std::string> names;
  const bool is_car = vehicle == "car", is_holonomic = vehicle == "holonomic";
  const VehicleKind kind = is_car ? VehicleKind::kCar : VehicleKind::kHolonomic;
  for (const std::string& name : plannerNames()) {
    if (!(is_car || is_holonomic) || drives(name, kind)) names.push_back(name);
  }
  return names;
}

}  // namespace pomdp_crowd_nav
