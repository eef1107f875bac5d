// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pomdp_crowd_nav {

// Notices that a robot gets no nearer to its goal. All times [s], of one clock.
class ProgressWatch {
 public:
  struct Params {
    double distance = 0.5;  // [m], less of the way is no progress
    double blocked_timeout =
        20.0;                    // [s] without progress until the robot counts as blocked, 0: off
    double abort_timeout = 0.0;  // [s] without progress until the trip is given up, 0: never
  };

  ProgressWatch() = default;
  // Throws std::invalid_argument naming the first field that is out of range.
  explicit ProgressWatch(const Params& params);

  void begin(double now);  // of a trip

  // Ways that are seen from now on cannot be compared with those before, as after a new map.
  void takeAnotherWay() { least_ = -1.0; }

  // `way` [m], what is left of it. Progress is measured against the shortest one that was left.
  void see(double way, double now);

  // Time until now in which the robot was not meant to drive counts for nothing.
  void hold(double now);

  double stalledFor(double now) const { return now - since_; }  // [s]
  bool isBlocked(double now) const;
  bool isHopeless(double now) const;

 private:
  Params params_;
  double since_ = 0.0;   // [s], of the last progress
  double least_ = -1.0;  // [m], shortest way left at the last progress; negative: none seen yet
};

}  // namespace pomdp_crowd_nav
