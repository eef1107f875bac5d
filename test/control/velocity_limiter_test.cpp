// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/velocity_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <limits>
#include <random>

#include "pomdp_crowd_nav/control/command_generator.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kPeriod = 0.02;  // [s]
constexpr double kRounding = 1e-9;

VehicleParams rampedBase() {
  VehicleParams vehicle;
  vehicle.max_speed = 1.0;
  vehicle.acceleration = 1.0;
  vehicle.lateral_acceleration = 0.5;
  vehicle.brake_deceleration = 2.0;
  vehicle.max_yaw_rate = 0.8;
  vehicle.yaw_acceleration = 1.6;
  vehicle.instant_velocity = false;
  return vehicle;
}

VehicleParams instantBase() {
  VehicleParams vehicle = rampedBase();
  vehicle.instant_velocity = true;
  return vehicle;
}

VehicleParams rampedCar() {
  VehicleParams vehicle = rampedBase();
  vehicle.kind = VehicleKind::kCar;
  return vehicle;
}

TEST(VelocityLimiter, CutsTheResultantSpeedAndKeepsTheDirection) {
  VelocityLimiter limiter(instantBase());
  const BaseCommand out = limiter.limit({{3.0, 4.0}, 2.0}, {}, kPeriod);
  EXPECT_NEAR(out.velocity.x(), 0.6, kRounding);
  EXPECT_NEAR(out.velocity.y(), 0.8, kRounding);
  EXPECT_NEAR(out.yaw_rate, 0.8, kRounding);
}

TEST(VelocityLimiter, ForwardsWhatIsWithinTheLimits) {
  VelocityLimiter limiter(instantBase());
  const BaseCommand in{{-0.3, 0.4}, -0.7};
  const BaseCommand out = limiter.limit(in, {}, kPeriod);
  EXPECT_EQ(out.velocity, in.velocity);
  EXPECT_EQ(out.yaw_rate, in.yaw_rate);
}

TEST(VelocityLimiter, GrowsNoFasterThanTheVehicle) {
  VelocityLimiter limiter(rampedBase());
  const BaseCommand in{{1.0, 0.0}, 0.8};
  EXPECT_LE(limiter.limit(in, {}, kPeriod).velocity.x(), 1.5 * 0.1 + kRounding);
  double time = kPeriod;
  while (limiter.limit(in, {}, kPeriod).velocity.x() < 0.99) time += kPeriod;
  EXPECT_NEAR(time, 0.64, 0.05) << "1 m/s at 1 + 0.5 m/s^2";
}

TEST(VelocityLimiter, GrowsOnFromWhatTheBaseDrivesAlready) {
  VelocityLimiter limiter(rampedBase());
  EXPECT_GE(limiter.limit({{1.0, 0.0}, 0.0}, {}, kPeriod, {0.8, 0.0}).velocity.x(), 0.8);
}

TEST(VelocityLimiter, SlowerCommandsPassAtOnce) {
  VelocityLimiter limiter(rampedBase());
  for (int i = 0; i < 100; ++i) limiter.limit({{1.0, 0.0}, 0.0}, {}, kPeriod);
  EXPECT_NEAR(limiter.last().velocity.x(), 1.0, kRounding);
  EXPECT_EQ(limiter.limit({{0.1, 0.0}, 0.0}, {}, kPeriod).velocity.x(), 0.1);
}

TEST(VelocityLimiter, ACarKeepsItsCurve) {
  VelocityLimiter limiter(rampedCar());
  for (int i = 0; i < 100; ++i) {
    const BaseCommand out = limiter.limit({{2.0, 0.0}, 1.2}, {}, kPeriod);
    EXPECT_NEAR(out.yaw_rate, 0.6 * out.velocity.x(), kRounding);
    EXPECT_LE(out.yaw_rate, 0.8 + kRounding);
  }
  EXPECT_NEAR(limiter.last().velocity.x(), 1.0, kRounding);
}

TEST(VelocityLimiter, BrakesWithTheDeceleration) {
  VelocityLimiter limiter(rampedBase());
  for (int i = 0; i < 100; ++i) limiter.limit({{0.0, 1.0}, 0.0}, {}, kPeriod);
  double time = 0.0;
  while (limiter.last().velocity.norm() > 0.0) {
    const double before = limiter.last().velocity.norm();
    limiter.limit(limiter.last(), limiter.brakingCaps(kPeriod), kPeriod);
    EXPECT_LE(limiter.last().velocity.norm(), std::max(0.0, before - 2.0 * kPeriod) + kRounding);
    time += kPeriod;
  }
  EXPECT_NEAR(time, 0.5, 0.03);
  EXPECT_EQ(limiter.last().velocity, Point(0.0, 0.0));
}

TEST(VelocityLimiter, BrakesFromTheMeasuredSpeedWhereThatIsLower) {
  VelocityLimiter limiter(rampedBase());
  for (int i = 0; i < 100; ++i) limiter.limit({{1.0, 0.0}, 0.0}, {}, kPeriod);
  EXPECT_NEAR(limiter.brakingCaps(kPeriod, 0.5).speed, 0.46, kRounding);
  EXPECT_NEAR(limiter.brakingCaps(kPeriod, 3.0).speed, 0.96, kRounding);
}

// Whatever comes in, in whatever rhythm.
TEST(VelocityLimiter, PropertiesHoldForRandomCommands) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double extremes[] = {0.0, 1e-310, 1e-12, 1e300, std::numeric_limits<double>::max()};
  for (const VehicleParams& vehicle : {rampedBase(), instantBase(), rampedCar()}) {
    VelocityLimiter limiter(vehicle);
    for (int i = 0; i < 20000; ++i) {
      const double size = i % 50 == 0 ? extremes[(i / 50) % 5] : std::exp(3.0 * uniform(random));
      const BaseCommand in{{size * uniform(random), size * uniform(random)},
                           size * uniform(random)};
      const double period = 0.05 * std::abs(uniform(random));
      const Point measured(2.0 * uniform(random), uniform(random));
      const BaseCommand out = limiter.limit(in, {}, period, measured);
      ASSERT_TRUE(out.velocity.allFinite() && std::isfinite(out.yaw_rate));
      ASSERT_LE(std::abs(out.velocity.x()), std::abs(in.velocity.x()));
      ASSERT_LE(std::abs(out.velocity.y()), std::abs(in.velocity.y()));
      ASSERT_LE(std::abs(out.yaw_rate), std::abs(in.yaw_rate));
      ASSERT_GE(out.velocity.x() * in.velocity.x(), 0.0);
      ASSERT_GE(out.velocity.y() * in.velocity.y(), 0.0);
      ASSERT_GE(out.yaw_rate * in.yaw_rate, 0.0);
      ASSERT_LE(out.velocity.norm(), vehicle.max_speed + kRounding);
      ASSERT_LE(std::abs(out.yaw_rate), vehicle.max_yaw_rate + kRounding);
      if (in.velocity.allFinite() && size < 1e100 && in.velocity.norm() > 1e-6) {
        const double cross =
            in.velocity.x() * out.velocity.y() - in.velocity.y() * out.velocity.x();
        ASSERT_NEAR(cross / in.velocity.norm(), 0.0, 1e-9) << "the direction is kept";
      }
    }
  }
}

// Over any while the speed grows by no more than acceleration allows, plus what is saved up.
TEST(VelocityLimiter, GrowthIsBoundedOverAnyWhile) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  VelocityLimiter limiter(rampedBase());
  std::deque<double> speeds;
  for (int i = 0; i < 20000; ++i) {
    speeds.push_back(limiter.limit({{2.0 * uniform(random), 0.0}, 0.0}, {}, kPeriod).velocity.x());
    if (speeds.size() > 20) speeds.pop_front();
    for (size_t ago = 1; ago < speeds.size(); ++ago) {
      const double growth = speeds.back() - speeds[speeds.size() - 1 - ago];
      ASSERT_LE(growth, 1.5 * (static_cast<double>(ago) * kPeriod + 0.1) + kRounding);
    }
  }
}

// What the planner's own commands ask for is let through as it is, at another rate than theirs.
TEST(VelocityLimiter, CommandsOfPlannedMotionsPassUnchanged) {
  const VehicleParams vehicle = rampedBase();
  CommandGenerator generator({}, vehicle);
  VelocityLimiter limiter(vehicle);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  VehicleState state;
  double yaw = 0.0;
  BaseCommand in;
  constexpr double kStep = 0.5;  // [s]
  for (int tick = 0; tick < 20000; ++tick) {
    const double now = tick * kPeriod;
    if (tick % 25 == 0) {
      const double speed = speedAfter(vehicle, state.speed, uniform(random) > -0.3 ? 0.5 : -0.5);
      const StepMotion motion =
          stepMotion(vehicle, state, state.heading + 3.0 * uniform(random), speed, kStep);
      generator.follow(motion, now);
      state = motion.end();
    }
    if (tick % 2 == 0) in = generator.commandAt(now, yaw, state.velocity());
    const BaseCommand out = limiter.limit(in, {}, kPeriod);
    ASSERT_NEAR((out.velocity - in.velocity).norm(), 0.0, 1e-9) << tick;
    yaw = wrapAngle(yaw + kPeriod * out.yaw_rate);
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
