// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// A map server of square fields from (0, 0) on, in cells of 0.1 m, to which boxes are added.
class MapPublisher {
 public:
  MapPublisher() : publisher_(node_.advertise<nav_msgs::OccupancyGrid>("map", 1, true)) {}

  // `side` [m]
  void begin(double side) {
    grid_ = nav_msgs::OccupancyGrid();
    grid_.header.frame_id = "map";
    grid_.info.resolution = 0.1F;
    grid_.info.width = grid_.info.height = static_cast<unsigned>(std::lround(side / kCell));
    grid_.info.origin.orientation.w = 1.0;
    grid_.data.assign(static_cast<size_t>(grid_.info.width) * grid_.info.height, 0);
  }

  // What of the box lies on the field; 100 is an obstacle.
  void add(const Point& min, const Point& max, std::int8_t value = 100) {
    const auto index = [&](double place) {
      return std::clamp<long>(std::lround(place / kCell), 0, grid_.info.width);
    };
    for (long row = index(min.y()); row < index(max.y()); ++row) {
      for (long column = index(min.x()); column < index(max.x()); ++column) {
        grid_.data[static_cast<size_t>(row) * grid_.info.width + column] = value;
      }
    }
  }

  void publish() {
    grid_.header.stamp = ros::Time::now();
    publisher_.publish(grid_);
  }

 private:
  static constexpr double kCell = 0.1;  // [m]

  ros::NodeHandle node_;
  ros::Publisher publisher_;
  nav_msgs::OccupancyGrid grid_;
};

}  // namespace pomdp_crowd_nav
