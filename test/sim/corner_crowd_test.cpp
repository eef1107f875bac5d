// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/corner_crowd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

// The field of the paper.
World field() {
  World world;
  world.start = {{1.0, 25.0}, 0.0};
  world.goal = {100.0, 75.0};
  world.destinations = {{0.0, 0.0}, {0.0, 100.0}, {100.0, 100.0}, {100.0, 0.0}};
  return world;
}

CornerCrowd crowdOf(int pedestrians, std::uint64_t seed, bool uniform_respawn = false) {
  return CornerCrowd(field(), {pedestrians, uniform_respawn, seed});
}

// Somebody who appeared at an edge.
struct Arrival {
  Point position;
  Point destination;
};

// People who appear in `seconds`, as they are before their first step.
std::vector<Arrival> respawned(bool uniform_respawn, int seconds) {
  CornerCrowd crowd = crowdOf(400, 3, uniform_respawn);
  std::vector<Arrival> arrivals;
  std::int64_t newest = crowd.walkers().back().id;
  for (int i = 1; i <= 10 * seconds; ++i) {
    crowd.tick();
    for (size_t k = 0; k < crowd.walkers().size(); ++k) {
      if (crowd.walkers()[k].id <= newest) continue;
      EXPECT_EQ(i % 10, 0) << "people are replaced at whole seconds";
      arrivals.push_back({crowd.walkers()[k].position, crowd.destinations()[k]});
    }
    newest = std::max(newest, crowd.walkers().empty() ? 0 : crowd.walkers().back().id);
  }
  return arrivals;
}

bool isBetween(double value, double low, double high) { return value >= low && value <= high; }

TEST(CornerCrowd, SameSeedSamePeople) {
  CornerCrowd a = crowdOf(50, 7), b = crowdOf(50, 7), other = crowdOf(50, 8);
  for (int i = 0; i < 1500; ++i) {
    a.tick();
    b.tick();
    other.tick();
  }
  ASSERT_EQ(a.walkers().size(), b.walkers().size());
  for (size_t k = 0; k < a.walkers().size(); ++k) {
    EXPECT_EQ(a.walkers()[k].id, b.walkers()[k].id);
    EXPECT_EQ(a.walkers()[k].position, b.walkers()[k].position);
  }
  EXPECT_NE(a.walkers()[0].position, other.walkers()[0].position);
}

TEST(CornerCrowd, StartsOnWholeMetresAwayFromTheRobot) {
  const CornerCrowd crowd = crowdOf(2000, 1);
  ASSERT_EQ(crowd.walkers().size(), 2000u);
  std::map<std::pair<double, double>, int> destinations;
  for (size_t k = 0; k < 2000; ++k) {
    const Point& position = crowd.walkers()[k].position;
    EXPECT_EQ(crowd.walkers()[k].id, static_cast<std::int64_t>(k) + 1);
    EXPECT_EQ(position.x(), std::floor(position.x()));
    EXPECT_EQ(position.y(), std::floor(position.y()));
    EXPECT_TRUE(isBetween(position.x(), 0.0, 99.0) && isBetween(position.y(), 0.0, 99.0));
    EXPECT_GT((position - Point(1.0, 25.0)).norm(), 5.0);
    ++destinations[{crowd.destinations()[k].x(), crowd.destinations()[k].y()}];
  }
  // 2000 draws of probability 1/4: 500 with a standard deviation of 19.4.
  ASSERT_EQ(destinations.size(), 4u);
  for (const auto& entry : destinations) EXPECT_NEAR(entry.second, 500, 97);
}

TEST(CornerCrowd, WalksStraightAtAMetrePerSecond) {
  CornerCrowd crowd = crowdOf(20, 5);
  const std::vector<Walker> before = crowd.walkers();
  const std::vector<Point> destinations = crowd.destinations();
  crowd.tick();
  ASSERT_EQ(crowd.walkers().size(), before.size());  // nobody starts at a corner with this seed
  for (size_t k = 0; k < before.size(); ++k) {
    const Point step = crowd.walkers()[k].position - before[k].position;
    EXPECT_TRUE(isBetween(step.norm(), 0.05, 0.15));
    const Point direction = (destinations[k] - before[k].position).normalized();
    EXPECT_NEAR(step.normalized().dot(direction), 1.0, 1e-9);
  }
}

TEST(CornerCrowd, ReplacesWhoArrivedOnceASecond) {
  CornerCrowd crowd = crowdOf(300, 2);
  std::set<std::int64_t> seen;
  size_t fewest = 300;
  for (int i = 1; i <= 600; ++i) {
    crowd.tick();
    fewest = std::min(fewest, crowd.walkers().size());
    if (i % 10 == 0) {
      EXPECT_EQ(crowd.walkers().size(), 300u);
    }
    for (const Walker& walker : crowd.walkers()) {
      seen.insert(walker.id);
      ASSERT_TRUE(field().bounds.contains(walker.position));
    }
  }
  EXPECT_LT(fewest, 300u);                                            // some arrived
  EXPECT_EQ(*seen.rbegin(), static_cast<std::int64_t>(seen.size()));  // ids without a gap
}

TEST(CornerCrowd, WhoArrivedIsGoneFromTheNextTickOn) {
  CornerCrowd crowd = crowdOf(300, 2);
  for (int i = 0; i < 200; ++i) {
    std::set<std::int64_t> arriving;
    for (size_t k = 0; k < crowd.walkers().size(); ++k) {
      const double left = (crowd.destinations()[k] - crowd.walkers()[k].position).norm();
      if (left <= 1.0) arriving.insert(crowd.walkers()[k].id);
    }
    crowd.tick();
    for (const Walker& walker : crowd.walkers()) EXPECT_EQ(arriving.count(walker.id), 0u);
  }
}

TEST(CornerCrowd, AppearsWhereTheAuthorsCodeLetsPeopleAppear) {
  std::map<char, int> sides;
  int busy_right = 0;
  const std::vector<Arrival> arrivals = respawned(false, 600);
  for (const auto& [position, destination] : arrivals) {
    const double x = position.x(), y = position.y();
    if (x == 0.0) {
      ++sides['l'];
      EXPECT_TRUE(isBetween(y, 0.0, 24.0)) << y;
      EXPECT_EQ(destination.x(), 100.0);
    } else if (y == 100.0) {
      ++sides['t'];
      EXPECT_TRUE(isBetween(x, 25.0, 49.0)) << x;
      EXPECT_EQ(destination.y(), 0.0);
    } else if (x == 100.0) {
      ++sides['r'];
      EXPECT_TRUE(isBetween(y, 0.0, 59.0) || isBetween(y, 91.0, 99.0)) << y;
      EXPECT_EQ(destination.x(), 0.0);
      busy_right += isBetween(y, 50.0, 59.0);
    } else {
      ++sides['b'];
      EXPECT_EQ(y, 0.0);
      EXPECT_TRUE(isBetween(x, 75.0, 99.0)) << x;
      EXPECT_EQ(destination.y(), 100.0);
    }
  }
  const double n = static_cast<double>(arrivals.size());
  ASSERT_GT(n, 2000.0);
  for (const auto& entry : sides) EXPECT_NEAR(entry.second / n, 0.25, 0.04);
  // On the right 10 of 25 first draws fall into [50, 59]; of the 15 others redrawn over the 69
  // places left, 10/69 do: 0.4 + 0.6 * 10 / 69 = 0.487.
  EXPECT_NEAR(busy_right / static_cast<double>(sides['r']), 0.487, 0.06);
}

TEST(CornerCrowd, UniformRespawnUsesWholeEdgesAwayFromStartAndGoal) {
  int upper_left = 0, lower_top = 0;
  for (const auto& [position, destination] : respawned(true, 300)) {
    EXPECT_GT((position - Point(1.0, 25.0)).norm(), 15.0);
    EXPECT_GT((position - Point(100.0, 75.0)).norm(), 15.0);
    EXPECT_GE((position - destination).norm(), 1.0);
    upper_left += position.x() == 0.0 && position.y() > 50.0;
    lower_top += position.y() == 100.0 && position.x() < 25.0;
  }
  EXPECT_GT(upper_left, 20);
  EXPECT_GT(lower_top, 20);
}

TEST(CornerCrowd, FieldTooSmallForTheExclusionsStillFills) {
  World world = field();
  world.bounds.max = {4.0, 4.0};
  world.start.position = {1.0, 1.0};
  world.goal = {3.0, 3.0};
  world.destinations = {{2.0, 2.0}};
  CornerCrowd crowd(world, {10, false, 1});
  for (int i = 0; i < 100; ++i) crowd.tick();
  EXPECT_EQ(crowd.walkers().size(), 10u);
}

TEST(CornerCrowd, EmptyCrowdAndNoDestinations) {
  CornerCrowd empty = crowdOf(0, 1);
  for (int i = 0; i < 20; ++i) empty.tick();
  EXPECT_TRUE(empty.walkers().empty());
  World world = field();
  world.destinations.clear();
  EXPECT_THROW(CornerCrowd(world, {}), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
