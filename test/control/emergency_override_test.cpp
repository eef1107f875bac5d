// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/emergency_override.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

VehicleParams rampedBase() {
  VehicleParams vehicle;
  vehicle.max_speed = 2.0;
  vehicle.brake_deceleration = 2.0;
  vehicle.instant_velocity = false;
  return vehicle;
}

TrackList seeing(const Point& position, const Point& velocity = {0.0, 0.0}) {
  return {1.0, {{7, position, velocity}}};
}

VehicleState drivingEast(double speed) { return {{10.0, 5.0}, 0.0, speed}; }

TEST(EmergencyOverride, LeavesTheDecisionWhenNobodyIsClose) {
  const EmergencyOverride override({}, VehicleParams(), 1.0);
  EXPECT_FALSE(override.replace(drivingEast(2.0), {}));
  EXPECT_FALSE(override.replace(drivingEast(2.0), seeing({12.01, 5.0})));
  EXPECT_TRUE(override.replace(drivingEast(2.0), seeing({12.0, 5.0})));
  EXPECT_TRUE(override.replace(drivingEast(2.0), seeing({8.5, 5.0}))) << "behind counts too";
}

// Facts sheet, section 3: stay, slow down by the step that stops, else brake.
TEST(EmergencyOverride, ReplacesTheActionBySpeed) {
  const EmergencyOverride override({}, VehicleParams(), 1.0);
  const TrackList close = seeing({11.0, 5.0});
  EXPECT_EQ(override.replace(drivingEast(0.0), close), Action::turnBy(0.0, 0));
  EXPECT_EQ(override.replace(drivingEast(1.0), close), Action::turnBy(0.0, -1));
  EXPECT_EQ(override.replace(drivingEast(0.4), close), Action::turnBy(0.0, -1));
  EXPECT_EQ(override.replace(drivingEast(1.1), close), Action::suddenBrake());
  EXPECT_EQ(override.replace(drivingEast(2.0), close), Action::suddenBrake());
}

TEST(EmergencyOverride, AFastCarBrakesSuddenly) {
  VehicleParams car;
  car.kind = VehicleKind::kCar;
  car.max_speed = 4.0;
  const EmergencyOverride override({}, car, 1.0);
  const TrackList close = seeing({11.0, 5.0});
  EXPECT_EQ(override.replace(drivingEast(0.0), close), Action::turnBy(0.0, 0));
  EXPECT_EQ(override.replace(drivingEast(1.0), close), Action::turnBy(0.0, -1));
  for (const double speed : {2.0, 3.0, 4.0}) {
    EXPECT_EQ(override.replace(drivingEast(speed), close), Action::suddenBrake()) << speed;
  }
  EXPECT_TRUE(override.reflex(drivingEast(4.0), seeing({11.9, 5.0}))) << "0.2 s and 1.2 m ahead";
  EXPECT_FALSE(override.reflex(drivingEast(4.0), seeing({12.1, 5.0})));
}

TEST(EmergencyOverride, AShorterStepStopsFromALowerSpeed) {
  const EmergencyOverride override({}, rampedBase(), 0.5);
  const TrackList close = seeing({11.0, 5.0});
  EXPECT_EQ(override.replace(drivingEast(0.5), close), Action::turnBy(0.0, -1));
  EXPECT_EQ(override.replace(drivingEast(0.6), close), Action::suddenBrake());
}

TEST(EmergencyOverride, OneOfManyIsEnough) {
  const EmergencyOverride override({}, VehicleParams(), 1.0);
  TrackList crowd = seeing({40.0, 5.0});
  for (int i = 0; i < 20; ++i) crowd.tracks.push_back({100 + i, {20.0 + i, 9.0}, {0.0, 0.0}});
  EXPECT_FALSE(override.replace(drivingEast(2.0), crowd));
  crowd.tracks.push_back({200, {10.0, 6.5}, {0.0, 0.0}});
  EXPECT_TRUE(override.replace(drivingEast(2.0), crowd));
}

TEST(EmergencyOverride, CanBeSwitchedOff) {
  EmergencyOverride::Params params;
  params.enabled = false;
  const EmergencyOverride override(params, VehicleParams(), 1.0);
  EXPECT_FALSE(override.replace(drivingEast(2.0), seeing({10.0, 5.0})));
  EXPECT_FALSE(override.reflex(drivingEast(2.0), seeing({10.5, 5.0})));
}

// At 2 m/s, 2 m/s^2 and 0.2 s of reaction, the robot looks 1.2 s ahead: 2.4 m of its own way.
TEST(EmergencyOverride, ReflexLooksAheadUntilTheRobotCouldRest) {
  const EmergencyOverride override({true, 2.0, 1.2, 0.2}, rampedBase(), 0.5);
  EXPECT_EQ(override.reflex(drivingEast(2.0), seeing({10.0 + 2.4 + 1.19, 5.0})), 7);
  EXPECT_FALSE(override.reflex(drivingEast(2.0), seeing({10.0 + 2.4 + 1.21, 5.0})));
  // At 1 m/s: 0.7 s and 0.7 m.
  EXPECT_TRUE(override.reflex(drivingEast(1.0), seeing({10.0 + 0.7 + 1.19, 5.0})));
  EXPECT_FALSE(override.reflex(drivingEast(1.0), seeing({10.0 + 0.7 + 1.21, 5.0})));
}

TEST(EmergencyOverride, ReflexOfAnInstantBaseLooksAheadForTheReactionOnly) {
  const EmergencyOverride override({true, 2.0, 1.2, 0.2}, VehicleParams(), 1.0);
  EXPECT_TRUE(override.reflex(drivingEast(2.0), seeing({10.0 + 0.4 + 1.19, 5.0})));
  EXPECT_FALSE(override.reflex(drivingEast(2.0), seeing({10.0 + 0.4 + 1.21, 5.0})));
}

TEST(EmergencyOverride, ReflexCountsHowThePersonMoves) {
  const EmergencyOverride override({true, 2.0, 1.2, 0.2}, rampedBase(), 0.5);
  const Point ahead(14.0, 5.0);
  EXPECT_FALSE(override.reflex(drivingEast(2.0), seeing(ahead)));
  EXPECT_TRUE(override.reflex(drivingEast(2.0), seeing(ahead, {-1.0, 0.0}))) << "comes nearer";
  EXPECT_FALSE(override.reflex(drivingEast(2.0), seeing({12.0, 5.0}, {3.0, 0.0})))
      << "walks away faster than the robot comes";
  // Crosses the way: at (12, 5) when the robot is there, one second from now.
  EXPECT_TRUE(override.reflex(drivingEast(2.0), seeing({12.0, 3.0}, {0.0, 2.0})));
  // Passes abeam with 1.3 m between, at best.
  EXPECT_FALSE(override.reflex(drivingEast(2.0), seeing({12.0, 6.3})));
  EXPECT_TRUE(override.reflex(drivingEast(2.0), seeing({12.0, 6.1})));
}

TEST(EmergencyOverride, NoReflexForWhoFallsBehindOrWhileAtRest) {
  const EmergencyOverride override({true, 2.0, 1.2, 0.2}, rampedBase(), 0.5);
  EXPECT_FALSE(override.reflex(drivingEast(2.0), seeing({9.5, 5.0})));
  EXPECT_FALSE(override.reflex(drivingEast(0.0), seeing({10.5, 5.0}, {-1.0, 0.0})));
}

VehicleParams rampedCar() {
  VehicleParams car = rampedBase();
  car.kind = VehicleKind::kCar;
  return car;
}

// At 2 m/s and 1 rad/s it is a quarter of a circle of 2 m on by 1.57 s; it could rest in 1.2 s.
TEST(EmergencyOverride, ARampedCarLooksAlongItsCurve) {
  const EmergencyOverride override({true, 2.0, 0.5, 0.2}, rampedCar(), 0.5);
  const VehicleState car = drivingEast(2.0);
  const auto onCurve = [&](double angle) {
    return Point(car.position + 2.0 * Point(std::sin(angle), 1.0 - std::cos(angle)));
  };
  for (const double side : {1.0, -1.0}) {
    const auto mirrored = [&](Point place) {
      place.y() = 5.0 + side * (place.y() - 5.0);
      return seeing(place);
    };
    EXPECT_TRUE(override.reflex(car, mirrored(onCurve(1.2)), side));
    EXPECT_FALSE(override.reflex(car, mirrored(onCurve(1.2)), 0.0)) << "0.7 m beside the tangent";
    EXPECT_FALSE(override.reflex(car, mirrored(onCurve(1.2)), -side)) << "on the other side";
    EXPECT_FALSE(override.reflex(car, mirrored(onCurve(1.5)), side)) << "rests before";
    EXPECT_FALSE(override.reflex(car, seeing({12.4, 5.0}), side)) << "it turns away in time";
    EXPECT_TRUE(override.reflex(car, seeing({12.4, 5.0}), 0.0));
  }
  EXPECT_FALSE(override.reflex(car, seeing({9.8, 5.0}), 1.0)) << "falls behind";
}

TEST(EmergencyOverride, OnNearlyNoCurveARampedCarDoesAsOnNone) {
  const EmergencyOverride override({true, 2.0, 1.2, 0.2}, rampedCar(), 0.5);
  int braked = 0;
  for (double x = 7.05; x < 15.0; x += 0.1) {
    for (double y = 2.05; y < 8.0; y += 0.1) {
      const TrackList tracks = seeing({x, y}, {-0.3, 0.4});
      const bool brakes = override.reflex(drivingEast(2.0), tracks).has_value();
      EXPECT_EQ(override.reflex(drivingEast(2.0), tracks, 1e-7).has_value(), brakes)
          << x << ' ' << y;
      braked += brakes ? 1 : 0;
    }
  }
  EXPECT_GT(braked, 100);
}

TEST(EmergencyOverride, TheYawRateOfAnotherBaseIsNoCurve) {
  const EmergencyOverride ramped({true, 2.0, 0.5, 0.2}, rampedBase(), 0.5);
  EXPECT_TRUE(ramped.reflex(drivingEast(2.0), seeing({12.4, 5.0}), 1.0)) << "its body turns";
}

TEST(EmergencyOverride, AppliedMotionIsWhatTheBaseCanDo) {
  const EmergencyOverride override({}, rampedBase(), 0.5);
  Decision decision;
  override.apply(Action::suddenBrake(), drivingEast(2.0), decision);
  EXPECT_EQ(decision.action, Action::suddenBrake());
  EXPECT_NEAR(decision.motion.end().speed, 1.0, 1e-12);
  EXPECT_NEAR(decision.motion.end().position.x(), 10.0 + 0.75, 1e-12);
  ASSERT_EQ(decision.plan.size(), 2U);
  EXPECT_EQ(decision.plan.front().position, Point(10.0, 5.0));
  EXPECT_NEAR(decision.plan.back().speed, 1.0, 1e-12);

  override.apply(Action::turnBy(0.0, -1), drivingEast(0.5), decision);
  EXPECT_NEAR(decision.motion.end().speed, 0.0, 1e-12);

  const EmergencyOverride instant({}, VehicleParams(), 1.0);
  instant.apply(Action::suddenBrake(), drivingEast(2.0), decision);
  EXPECT_EQ(decision.motion.end().speed, 0.0);
  EXPECT_EQ(decision.motion.end().position, Point(10.0, 5.0));
  EXPECT_EQ(decision.motion.end_heading, 0.0) << "the heading is kept";
}

TEST(EmergencyOverride, RejectsParametersOutOfRange) {
  for (double EmergencyOverride::Params::*field :
       {&EmergencyOverride::Params::decision_distance, &EmergencyOverride::Params::reflex_distance,
        &EmergencyOverride::Params::reaction_time}) {
    for (const double value : {-0.1, std::nan("")}) {
      EmergencyOverride::Params params;
      params.*field = value;
      EXPECT_THROW(EmergencyOverride(params, VehicleParams(), 1.0), std::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
