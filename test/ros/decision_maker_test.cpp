// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/decision_maker.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

// Wants to drive on along x at a speed, whatever the situation.
class SteadyPlanner : public Planner {
 public:
  explicit SteadyPlanner(double speed) : speed_(speed) {}

  Decision decide(const Situation& situation, const SearchLimit&) override {
    Decision decision;
    decision.motion.start = situation.vehicle.position;
    decision.motion.end_velocity = {speed_, 0.0};
    return decision;
  }
  TreeView viewTree(const TreeLimits&) const override { return {}; }
  std::vector<Point> globalPath(const Point& from) const override { return {from}; }
  NavigationCell guidanceAt(const Point&) const override { return {1.0F, 0.0F, 1e6F, 20.0F}; }
  Guidance guidance() const override { return {}; }

 private:
  double speed_;
};

Verdict verdictFor(double speed, const Point& person) {
  const NavigationParams params;
  SteadyPlanner planner(speed);
  Snapshot snapshot;
  snapshot.situation.vehicle.speed = speed;
  snapshot.tracks.tracks.push_back({17, person, Point(0.0, 0.0)});
  return DecisionMaker(params).decide(snapshot, SearchLimit(), planner);
}

TEST(DecisionMakerTest, NamesWhoIsInTheWayOfARobotThatDrivesOrStands) {
  const Verdict driving = verdictFor(0.5, {3.5, 0.0});
  EXPECT_EQ(driving.in_the_way, 17);
  EXPECT_FALSE(driving.stands);
  EXPECT_EQ(driving.way, 20.0F);
  const Verdict standing = verdictFor(0.0, {3.5, 0.0});
  EXPECT_EQ(standing.in_the_way, 17);
  EXPECT_TRUE(standing.stands);
}

TEST(DecisionMakerTest, NamesNobodyWhoIsOffTheWay) {
  EXPECT_FALSE(verdictFor(0.5, {3.5, 30.0}).in_the_way);
  EXPECT_FALSE(verdictFor(0.0, {-20.0, 0.0}).in_the_way);
}

}  // namespace
}  // namespace pomdp_crowd_nav
