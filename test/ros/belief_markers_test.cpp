// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/belief_markers.h"

#include <gtest/gtest.h>

#include <limits>

#include "marker_checks.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const std::vector<Point> kDestinations = {Point(0.0, 5.0), Point(100.0, 5.0)};

IntentionBelief believed(double first, double second, double standing = 0.0,
                         double elsewhere = 0.0) {
  IntentionBelief belief(2, 0.25, 0.25);
  belief.assign({first, second}, standing, elsewhere);
  return belief;
}

PersonBelief personAt(std::int64_t id, const Point& position, const IntentionBelief& intention) {
  return {id, position, Point(0.0, 0.0), 1.0, intention, Point(0.0, 0.0)};
}

class BeliefMarkers : public testing::Test {
 protected:
  MarkerArray draw() {
    return beliefMarkers(
        {crowd_, kDestinations, attended_, trails_, Point(50.0, 0.0), blocker_, 1.0},
        std_msgs::Header());
  }

  CrowdBelief crowd_;
  std::vector<std::int64_t> attended_;
  CrowdTrails trails_;
  std::int64_t blocker_ = -1;
};

double width(const Marker& arrows, size_t arrow) {
  const auto& corners = arrows.points;  // of an arrow: six of the shaft and three of the head
  return std::abs(corners[9 * arrow].y - corners[9 * arrow + 1].y);
}

TEST_F(BeliefMarkers, AreEmptyWithoutPeople) { expectSound(draw()); }

TEST_F(BeliefMarkers, AnArrowIsAsWideAsItsDestinationIsLikely) {
  crowd_.people.push_back(personAt(1, Point(50.0, 5.0), believed(0.25, 0.75)));
  const MarkerArray array = draw();
  expectSound(array);
  const Marker arrows = listOf(array, "belief");
  ASSERT_EQ(arrows.points.size(), 18u);
  EXPECT_NEAR(width(arrows, 1) / width(arrows, 0), 3.0, 1e-6);
  EXPECT_LT(arrows.points[8].x, 50.0) << "the first points to the first destination";
  EXPECT_GT(arrows.points[17].x, 50.0);
  EXPECT_EQ(arrows.colors[0].r, destinationColor(0, 1.0).r);
  EXPECT_EQ(arrows.colors[9].r, destinationColor(1, 1.0).r);
}

TEST_F(BeliefMarkers, UnlikelyDestinationsHaveNoArrow) {
  crowd_.people.push_back(personAt(1, Point(50.0, 5.0), believed(0.02, 0.98)));
  EXPECT_EQ(listOf(draw(), "belief").points.size(), 9u);
}

TEST_F(BeliefMarkers, PeopleArePalerTheLessSure) {
  crowd_.people = {personAt(1, Point(51.0, 5.0), believed(0.05, 0.95)),
                   personAt(2, Point(60.0, 5.0), believed(0.5, 0.5))};
  const Marker people = listOf(draw(), "people");
  ASSERT_EQ(people.colors.size(), 2u);
  EXPECT_LT(people.colors[0].b, people.colors[1].b);
  EXPECT_NEAR(people.colors[0].b, destinationColor(1, 1.0).b, 0.1);
}

TEST_F(BeliefMarkers, TellWhoStandsAndWhoWalksElsewhere) {
  crowd_.people = {personAt(1, Point(50.0, 5.0), believed(0.05, 0.05, 0.9)),
                   personAt(2, Point(60.0, 5.0), believed(0.05, 0.05, 0.0, 0.9))};
  crowd_.people[1].walk = Point(0.0, 1.0);
  const MarkerArray array = draw();
  expectSound(array);
  const Marker people = listOf(array, "people");
  EXPECT_LT(people.colors[0].r + 0.2F, people.colors[1].r);
  EXPECT_EQ(people.colors[1].r, people.colors[1].g);
  const Marker arrows = listOf(array, "belief");
  ASSERT_EQ(arrows.points.size(), 9u) << "who stands has no way";
  EXPECT_DOUBLE_EQ(arrows.points[8].x, 60.0);
  EXPECT_GT(arrows.points[8].y, 5.0);
}

TEST_F(BeliefMarkers, RingsAndWaysAreOfTheAttendedAlone) {
  crowd_.people = {personAt(1, Point(50.0, 5.0), believed(0.0, 1.0)),
                   personAt(2, Point(90.0, 5.0), believed(0.0, 1.0))};
  attended_ = {2};
  const MarkerArray array = draw();
  expectSound(array);
  for (const auto& point : listOf(array, "attended").points) EXPECT_NEAR(point.x, 90.0, 1.0);
  const Marker ways = listOf(array, "ways");
  ASSERT_EQ(ways.points.size(), 6u);
  EXPECT_DOUBLE_EQ(ways.points[0].x, 90.0);
  EXPECT_DOUBLE_EQ(ways.points[2].x, 100.0);
}

TEST_F(BeliefMarkers, WhoBlocksTheWayIsJoinedToTheRobot) {
  crowd_.people = {personAt(7, Point(52.0, 0.0), believed(0.5, 0.5))};
  EXPECT_TRUE(listOf(draw(), "blocking").points.empty());
  blocker_ = 7;
  const Marker blocking = listOf(draw(), "blocking");
  ASSERT_GT(blocking.points.size(), 2u);
  EXPECT_DOUBLE_EQ(blocking.points[0].x, 50.0);
  EXPECT_DOUBLE_EQ(blocking.points[1].x, 52.0);
  blocker_ = 8;
  EXPECT_TRUE(listOf(draw(), "blocking").points.empty()) << "nobody sees that person";
}

TEST_F(BeliefMarkers, OlderTracksArePaler) {
  for (int i = 0; i < 20; ++i) {
    crowd_.stamp = 0.5 * i;
    crowd_.people = {personAt(1, Point(50.0 + 0.5 * i, 5.0), believed(0.0, 1.0))};
    trails_.see(crowd_);
  }
  const MarkerArray array = draw();
  expectSound(array);
  const Marker tracks = listOf(array, "tracks");
  ASSERT_EQ(tracks.points.size(), 2 * (CrowdTrails::kPlaces - 1));
  const auto brightness = [](const std_msgs::ColorRGBA& shade) {
    return shade.r + shade.g + shade.b;
  };
  EXPECT_GT(brightness(tracks.colors.front()), 2.75F) << "nearly white";
  EXPECT_LT(brightness(tracks.colors.back()), brightness(tracks.colors.front()) - 0.3F);
  EXPECT_DOUBLE_EQ(tracks.points.back().x, 59.5);
}

// The node takes 1000 people at most; with destinations of equal probability everybody has four
// arrows, and those of the farthest do not fit.
TEST_F(BeliefMarkers, AThousandPeopleKeepTheLimitAndTheAttendedAreDrawn) {
  for (int step = 0; step < 12; ++step) {
    crowd_.people.clear();
    crowd_.stamp = 0.5 * step;
    for (int i = 0; i < 1000; ++i) {
      crowd_.people.push_back(
          personAt(i, Point(60.0 + i, 5.0 + 0.1 * step), believed(0.3, 0.3, 0.1, 0.3)));
      crowd_.people.back().walk = Point(0.0, 1.0);
    }
    trails_.see(crowd_);
  }
  attended_ = {999};
  const MarkerArray array = draw();
  expectSound(array);
  EXPECT_NEAR(listOf(array, "belief").points[0].x, 1059.0, 0.1) << "attended, though farthest";
  EXPECT_EQ(listOf(array, "tracks").points.size(), 16000u) << "everybody's";
  EXPECT_EQ(listOf(array, "people").points.size(), 1000u);
}

TEST_F(BeliefMarkers, LeaveOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  crowd_.people = {personAt(1, Point(nan, 5.0), believed(0.5, 0.5))};
  attended_ = {1};
  blocker_ = 1;
  expectSound(draw());
}

TEST(CrowdTrails, ForgetWhoIsGoneAndBeginAfreshWhenTheClockJumpsBack) {
  CrowdTrails trails;
  const IntentionBelief any(2);
  const auto see = [&](double stamp, std::int64_t id, double x) {
    trails.see({stamp, {personAt(id, Point(x, 0.0), any)}});
  };
  see(10.0, 1, 0.0);
  see(10.2, 1, 0.2);
  see(10.5, 1, 0.5);
  ASSERT_EQ(trails.trails().count(1), 1u);
  EXPECT_EQ(trails.trails().at(1).places().size(), 2u) << "two of them are too close in time";
  see(11.0, 2, 0.0);
  EXPECT_EQ(trails.trails().count(1), 0u);
  see(3.0, 2, 0.1);
  EXPECT_EQ(trails.trails().at(2).places().size(), 1u);
}

TEST(Trail, IsBoundedSpacedAndBrokenByAJump) {
  Trail trail({5, 0.5, 3.0});
  for (int i = 0; i < 100; ++i) trail.extend(Point(0.1 * i, 0.0));
  ASSERT_EQ(trail.places().size(), 5u);
  EXPECT_NEAR(trail.places()[4].x() - trail.places()[3].x(), 0.5, 1e-6);
  trail.extend(Point(std::numeric_limits<double>::quiet_NaN(), 0.0));
  EXPECT_EQ(trail.places().size(), 5u);
  trail.extend(Point(50.0, 0.0));
  EXPECT_EQ(trail.places().size(), 1u);
}

}  // namespace
}  // namespace pomdp_crowd_nav
