// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "pomdp_crowd_nav/control/velocity_guard.h"
#include "pomdp_crowd_nav/sim/base.h"

namespace pomdp_crowd_nav {

constexpr double kPeriod = 0.02;  // [s]

inline VehicleParams movo() {
  VehicleParams vehicle;
  vehicle.radius = 0.5;
  vehicle.max_speed = 1.0;
  vehicle.acceleration = 1.0;
  vehicle.lateral_acceleration = 1.0;
  vehicle.brake_deceleration = 1.0;
  vehicle.instant_velocity = false;
  return vehicle;
}

inline VelocityGuard::Params params() {
  VelocityGuard::Params guard;
  guard.margin = 0.3;
  return guard;
}

// A base behind a guard, a planner in front of it, and people; any of them may fall silent.
class GuardedDrive : public testing::Test {
 protected:
  void run(double duration) {
    const double end = now_ + duration;
    for (; now_ < end; now_ += kPeriod, ++ticks_) {
      if (has_command_ && ticks_ % 2 == 0) guard_.takeCommand(command_, now_);
      if (has_odometry_) {
        const Point velocity = Eigen::Rotation2Dd(-base_.pose().heading) * base_.velocity();
        guard_.takeMotion(base_.pose(), {velocity, base_.yawRate()}, now_);
      }
      if (has_people_ && ticks_ % 5 == 0) guard_.takePeople(people_, now_);
      output_ = guard_.tick(now_);
      if (output_.command) sent_ = *output_.command;
      base_.follow(sent_, kPeriod);
      for (Track& person : people_.tracks) person.position += kPeriod * person.velocity;
      nearest_ = std::min(nearest_, distanceToPeople());
    }
  }

  void driveAtFullSpeed() {
    command_ = {{1.0, 0.0}, 0.0};
    has_command_ = true;
    run(2.0);
    ASSERT_NEAR(base_.velocity().x(), 1.0, 1e-3);
    ASSERT_EQ(output_.cause, GuardCause::kNone);
  }

  // From now on; fails if it takes longer than the bound.
  void expectRest(double bound, GuardCause cause) {
    bool named = false;
    const double begin = now_;
    while (base_.velocity().norm() > 0.0 && now_ - begin < bound + 1.0) {
      run(kPeriod);
      named = named || output_.cause == cause;
    }
    EXPECT_LE(now_ - begin, bound);
    EXPECT_TRUE(named) << "expected: " << describe(cause) << ", got: " << describe(output_.cause);
  }

  double distanceToPeople() const {
    double distance = std::numeric_limits<double>::infinity();
    for (const Track& person : people_.tracks) {
      distance = std::min(distance, (person.position - base_.pose().position).norm());
    }
    return distance;
  }

  VelocityGuard guard_{params(), movo()};
  SimulatedBase base_{movo(), Pose{{3.0, 2.0}, 0.0}};
  BaseCommand command_;
  BaseCommand sent_;
  VelocityGuard::Output output_;
  TrackList people_;
  bool has_command_ = false;
  bool has_odometry_ = true;
  bool has_people_ = true;
  double now_ = 100.0;  // [s]
  int ticks_ = 0;
  double nearest_ = std::numeric_limits<double>::infinity();
};

}  // namespace pomdp_crowd_nav
