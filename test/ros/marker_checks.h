// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <string>

#include "pomdp_crowd_nav/ros/markers.h"

namespace pomdp_crowd_nav {

inline size_t cornersOf(const visualization_msgs::Marker& list) {
  if (list.type == visualization_msgs::Marker::LINE_LIST) return 2;
  return list.type == visualization_msgs::Marker::TRIANGLE_LIST ? 3 : 1;
}

// What holds of a list, whatever is in it.
inline void expectSoundList(const visualization_msgs::Marker& list) {
  using visualization_msgs::Marker;
  EXPECT_LT(list.points.size(), kMaxPoints) << list.ns;
  const bool is_empty = list.points.empty() && list.text.empty();
  EXPECT_EQ(list.action, is_empty ? Marker::DELETE : Marker::ADD)
      << "RViz takes no empty list for " << list.ns;
  EXPECT_EQ(list.points.size(), list.colors.size()) << list.ns;
  EXPECT_GT(list.scale.x, 0.0) << list.ns;
  EXPECT_DOUBLE_EQ(list.pose.orientation.w, 1.0) << list.ns;
  EXPECT_EQ(list.points.size() % cornersOf(list), 0u) << list.ns;
  for (const auto& point : list.points) {
    EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y)) << list.ns;
  }
}

// DELETEALL first, then a few lists.
inline void expectSound(const visualization_msgs::MarkerArray& array) {
  ASSERT_FALSE(array.markers.empty());
  EXPECT_EQ(array.markers.front().action, visualization_msgs::Marker::DELETEALL);
  EXPECT_LE(array.markers.size(), 7u);
  for (size_t i = 1; i < array.markers.size(); ++i) expectSoundList(array.markers[i]);
}

// The list of that name; an empty marker where there is none.
inline visualization_msgs::Marker listOf(const visualization_msgs::MarkerArray& array,
                                         const std::string& name) {
  for (const visualization_msgs::Marker& marker : array.markers) {
    if (marker.ns == name) return marker;
  }
  ADD_FAILURE() << "there is no list " << name;
  return {};
}

}  // namespace pomdp_crowd_nav
