// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/robot_markers.h"

#include <fmt/format.h>

#include "pomdp_crowd_nav/ros/marker_shapes.h"
#include "pomdp_crowd_nav/ros/markers.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

void drawTrail(const Trail& trail, Marker& lines) {
  const auto& places = trail.places();
  const double count = static_cast<double>(places.size());
  for (size_t i = 1; i < places.size(); ++i) {
    const double alpha = 0.35 + 0.65 * static_cast<double>(i) / count;
    addLine(places[i - 1], places[i], paled(color(0.15, 0.35, 0.95), alpha), lines);
  }
}

// Nothing while it drives or has nothing to do.
std::string whyAtRest(const PlannerStatus& status) {
  const bool is_plain =
      status.state == PlannerStatus::IDLE || status.state == PlannerStatus::DRIVING;
  if (is_plain && status.stop_cause.empty()) return "";
  return status.stop_cause.empty() ? status.state_name : status.stop_cause;
}

}  // namespace

std::string statusText(const PlannerStatus& status) {
  std::string text = status.state_name;
  if (!status.stop_cause.empty()) text += ": " + status.stop_cause;
  if (status.decisions == 0) return text;
  return text + fmt::format("\ndecision {} in {:.2f} s, {} trials, {} beliefs, {}",
                            status.decisions, status.cycle_time, status.trials, status.tree_size,
                            status.action);
}

MarkerArray robotMarkers(const RobotScene& scene, const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  const double size = scene.symbol_size;
  drawTrail(scene.trail, builder.beginList("driven", Marker::LINE_LIST, 0.35 * size, 0.03));
  const auto blue = color(0.1, 0.2, 0.7);
  Marker& disc = builder.beginList("disc", Marker::LINE_LIST, 0.25 * size, 0.05);
  fixTo(scene.base_frame, disc);
  addCircle(Point(0.0, 0.0), scene.radius, blue, disc);
  addLine(Point(0.0, 0.0), Point(scene.radius, 0.0), blue, disc);
  Marker& distance = builder.beginList("emergency_distance", Marker::LINE_LIST, 0.15 * size, 0.05);
  fixTo(scene.base_frame, distance);
  if (scene.emergency_distance > 0.0) {
    addCircle(Point(0.0, 0.0), scene.emergency_distance, color(0.95, 0.45, 0.0), distance);
  }
  const Point beside = scene.robot + Point(0.0, scene.emergency_distance + 2.5 * size);
  builder.addText("cause", whyAtRest(scene.status), 0.8 * scene.letter_size, beside);
  builder.addText("status", statusText(scene.status), scene.letter_size, scene.headline);
  return builder.take();
}

}  // namespace pomdp_crowd_nav
