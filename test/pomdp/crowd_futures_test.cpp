// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/crowd_futures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace pomdp_crowd_nav {
namespace {

using Cells = std::vector<std::pair<int, int>>;

const std::vector<Point> kCorners{{0.0, 0.0}, {0.0, 100.0}, {100.0, 100.0}, {100.0, 0.0}};

PersonBelief person(std::int64_t id, const Point& position, double speed = 1.0) {
  return {id, position, {0.0, 0.0}, speed, IntentionBelief(4)};
}

// A belief that is all but certain.
PersonBelief personBoundFor(size_t destination, const Point& position, double speed = 1.0) {
  PersonBelief sure = person(1, position, speed);
  for (int i = 0; i < 200; ++i) {
    const Point away = position + 10.0 * (kCorners[destination] - position).normalized();
    sure.intention.update(position, away, kCorners);
  }
  return sure;
}

CrowdFutures drawn(const CrowdFutures::Shape& shape, const std::vector<PersonBelief>& people,
                   std::uint64_t seed = 1, double noise = 0.1) {
  CrowdFutures futures;
  futures.draw(shape, people, kCorners, StraightLinePedestrian({noise * shape.step}),
               NoiseStreams(seed));
  return futures;
}

Cells cellsAt(const CrowdFutures& futures, int scenario, int depth) {
  Cells cells;
  for (int i = 0; i < futures.personCount(); ++i) {
    const auto& place = futures.at(scenario, depth)[i];
    cells.emplace_back(static_cast<int>(std::floor(place.x)),
                       static_cast<int>(std::floor(place.y)));
  }
  return cells;
}

bool samePlaces(const CrowdFutures& a, const CrowdFutures& b, int scenarios, int depths) {
  for (int k = 0; k < scenarios; ++k) {
    for (int d = 0; d <= depths; ++d) {
      for (int i = 0; i < a.personCount(); ++i) {
        if (a.at(k, d)[i].x != b.at(k, d)[i].x || a.at(k, d)[i].y != b.at(k, d)[i].y) return false;
      }
      if (a.observation(k, d) != b.observation(k, d)) return false;
    }
  }
  return true;
}

TEST(CrowdFutures, StartsWherePeopleAre) {
  const CrowdFutures futures =
      drawn({5, 3, 1.0, Bounds()}, {person(1, {10.5, 20.25}), person(2, {70.0, 3.0})});
  EXPECT_EQ(futures.personCount(), 2);
  EXPECT_EQ(futures.depth(), 3);
  EXPECT_EQ(futures.scenarioCount(), 5);
  for (int k = 0; k < 5; ++k) {
    EXPECT_FLOAT_EQ(futures.at(k, 0)[0].x, 10.5F);
    EXPECT_FLOAT_EQ(futures.at(k, 0)[0].y, 20.25F);
    EXPECT_FLOAT_EQ(futures.at(k, 0)[1].x, 70.0F);
  }
}

TEST(CrowdFutures, PeopleWalkStraightToOneDestination) {
  const Point start(50.0, 50.0);
  const CrowdFutures futures =
      drawn({20, 30, 0.5, Bounds()}, {personBoundFor(2, start, 1.4)}, 1, 0.0);
  const Point way = (kCorners[2] - start).normalized();
  for (int k = 0; k < 20; ++k) {
    for (int d = 0; d <= 30; ++d) {
      const Point expected = start + 0.5 * 1.4 * d * way;
      ASSERT_NEAR(futures.at(k, d)[0].x, expected.x(), 1e-4);
      ASSERT_NEAR(futures.at(k, d)[0].y, expected.y(), 1e-4);
    }
  }
}

TEST(CrowdFutures, NoiseChangesTheLengthOfStepsOnly) {
  const CrowdFutures futures = drawn({50, 20, 1.0, Bounds()}, {personBoundFor(0, {90.0, 90.0})}, 4);
  double shortest = 10.0;
  double longest = 0.0;
  for (int k = 0; k < 50; ++k) {
    for (int d = 1; d <= 20; ++d) {
      const auto& from = futures.at(k, d - 1)[0];
      const auto& to = futures.at(k, d)[0];
      ASSERT_NEAR(from.x - to.x, from.y - to.y, 1e-4) << "along the diagonal";
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
  }
  EXPECT_NEAR(shortest, 0.9, 0.005);
  EXPECT_NEAR(longest, 1.1, 0.005);
  EXPECT_GE(shortest, 0.9 - 1e-4);
  EXPECT_LE(longest, 1.1 + 1e-4);
}

TEST(CrowdFutures, NobodyLeavesTheField) {
  const Bounds bounds{{-5.0, -2.0}, {20.0, 10.0}};
  CrowdFutures futures;
  futures.draw({100, 60, 1.0, bounds}, {person(1, {15.0, 5.0}), person(2, {-4.0, -1.0}, 3.0)},
               {{40.0, 5.0}, {-20.0, -20.0}, {3.0, 30.0}, {3.0, -9.0}},
               StraightLinePedestrian({0.1}), NoiseStreams(1));
  bool reached_wall = false;
  for (int k = 0; k < 100; ++k) {
    for (int d = 0; d <= 60; ++d) {
      for (int i = 0; i < 2; ++i) {
        const auto& place = futures.at(k, d)[i];
        ASSERT_TRUE(bounds.contains(Point(place.x, place.y)));
        reached_wall = reached_wall || place.x == 20.0F;
      }
    }
  }
  EXPECT_TRUE(reached_wall);
}

TEST(CrowdFutures, DestinationsFollowTheBelief) {
  constexpr int kScenarios = 20000;
  PersonBelief left_or_up = person(1, {50.0, 50.0});
  for (int i = 0; i < 3; ++i) {
    left_or_up.intention.update({50.0, 50.0}, {49.5, 50.3}, kCorners);
  }
  const auto futures =
      drawn({kScenarios, 1, 1.0, Bounds()}, {person(9, {20.0, 20.0}), left_or_up}, 7, 0.0);
  for (int i = 0; i < 2; ++i) {
    std::vector<int> counts(4);
    for (int k = 0; k < kScenarios; ++k) {
      const double dx = futures.at(k, 1)[i].x - futures.at(k, 0)[i].x;
      const double dy = futures.at(k, 1)[i].y - futures.at(k, 0)[i].y;
      size_t best = 0;
      double least = 10.0;
      const Point at(futures.at(k, 0)[i].x, futures.at(k, 0)[i].y);
      for (size_t j = 0; j < 4; ++j) {
        const double off = ((kCorners[j] - at).normalized() - Point(dx, dy)).norm();
        if (off < least) best = j;
        least = std::min(least, off);
      }
      ASSERT_LT(least, 1e-3);
      ++counts[best];
    }
    const PersonBelief uniform = person(9, {0.0, 0.0});
    const auto& expected =
        i == 0 ? uniform.intention.probabilities() : left_or_up.intention.probabilities();
    for (size_t j = 0; j < 4; ++j) {
      const double p = expected[j];
      EXPECT_NEAR(counts[j] / static_cast<double>(kScenarios), p,
                  4.0 * std::sqrt(p * (1.0 - p) / kScenarios))
          << "destination " << j << " of person " << i;
    }
  }
}

TEST(CrowdFutures, ObservationsAreEqualIffAllCellsAre) {
  const auto futures = drawn({40, 12, 1.0, Bounds()},
                             {person(1, {50.2, 50.7}, 0.4), person(2, {51.9, 50.1}, 0.3)}, 3);
  std::map<Cells, std::uint64_t> key_of;
  std::map<std::uint64_t, Cells> cells_of;
  int repeated = 0;
  for (int k = 0; k < 40; ++k) {
    for (int d = 0; d <= 12; ++d) {
      const Cells cells = cellsAt(futures, k, d);
      const std::uint64_t key = futures.observation(k, d);
      repeated += key_of.count(cells) != 0 ? 1 : 0;
      ASSERT_EQ(key_of.emplace(cells, key).first->second, key);
      ASSERT_EQ(cells_of.emplace(key, cells).first->second, cells);
    }
  }
  EXPECT_GT(key_of.size(), 20U);
  EXPECT_GT(repeated, 20);
}

TEST(CrowdFutures, ObservationsTellPeopleApart) {
  const auto one_way = drawn({1, 1, 1.0, Bounds()}, {person(1, {5.5, 5.5}), person(2, {9.5, 9.5})});
  const auto other_way =
      drawn({1, 1, 1.0, Bounds()}, {person(1, {9.5, 9.5}), person(2, {5.5, 5.5})});
  EXPECT_NE(one_way.observation(0, 0), other_way.observation(0, 0));
}

TEST(CrowdFutures, NegativeCellsAreCellsToo) {
  const CrowdFutures::Shape shape{1, 1, 1.0, {{-10.0, -10.0}, {10.0, 10.0}}};
  const auto inside = drawn(shape, {person(1, {-0.5, 0.5})});
  const auto same = drawn(shape, {person(1, {-0.9, 0.1})});
  const auto mirrored = drawn(shape, {person(1, {0.5, 0.5})});
  EXPECT_EQ(inside.observation(0, 0), same.observation(0, 0));
  EXPECT_NE(inside.observation(0, 0), mirrored.observation(0, 0));
}

TEST(CrowdFutures, SameSeedSameFutures) {
  const CrowdFutures::Shape shape{30, 20, 1.0, Bounds()};
  const std::vector<PersonBelief> people{person(1, {30.0, 30.0}), person(2, {60.0, 40.0})};
  const CrowdFutures futures = drawn(shape, people, 5);
  EXPECT_TRUE(samePlaces(futures, drawn(shape, people, 5), 30, 20));
  EXPECT_FALSE(samePlaces(futures, drawn(shape, people, 6), 30, 20));
}

// A scenario is the same whatever is drawn beside it.
TEST(CrowdFutures, AScenarioDoesNotDependOnHowMuchIsDrawn) {
  const std::vector<PersonBelief> people{person(1, {30.0, 30.0}), person(2, {60.0, 40.0})};
  const CrowdFutures small = drawn({10, 8, 1.0, Bounds()}, people, 5);
  const CrowdFutures large = drawn({100, 50, 1.0, Bounds()}, people, 5);
  EXPECT_TRUE(samePlaces(small, large, 10, 8));
}

TEST(CrowdFutures, ReusingTheTableLeavesNothingBehind) {
  const std::vector<PersonBelief> few{person(1, {30.0, 30.0})};
  const std::vector<PersonBelief> many{person(1, {10.0, 30.0}), person(2, {60.0, 40.0})};
  CrowdFutures futures;
  const StraightLinePedestrian model({0.1});
  futures.draw({100, 50, 1.0, Bounds()}, many, kCorners, model, NoiseStreams(2));
  futures.draw({10, 8, 1.0, Bounds()}, few, kCorners, model, NoiseStreams(5));
  EXPECT_EQ(futures.personCount(), 1);
  EXPECT_TRUE(samePlaces(futures, drawn({10, 8, 1.0, Bounds()}, few, 5), 10, 8));
}

TEST(CrowdFutures, NobodyIsFine) {
  const CrowdFutures futures = drawn({4, 6, 1.0, Bounds()}, {});
  EXPECT_EQ(futures.personCount(), 0);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(futures.observation(k, 6), futures.observation(0, 0));
  EXPECT_NO_THROW(futures.at(3, 6));
}

PersonBelief personWho(double stands, double walks_on) {
  PersonBelief person{1, {50.0, 50.0}, {0.0, 0.0}, 1.2, IntentionBelief(4), {0.3, -0.4}};
  person.intention.assign(std::vector<double>(4, 0.25 * (1.0 - stands - walks_on)), stands,
                          walks_on);
  return person;
}

TEST(CrowdFutures, WhoStandsStaysButForNoise) {
  const CrowdFutures still = drawn({20, 30, 1.0, Bounds()}, {personWho(1.0, 0.0)}, 1, 0.0);
  const CrowdFutures swaying = drawn({200, 10, 1.0, Bounds()}, {personWho(1.0, 0.0)}, 1, 0.1);
  for (int k = 0; k < 20; ++k) {
    ASSERT_FLOAT_EQ(still.at(k, 30)[0].x, 50.0F);
    ASSERT_FLOAT_EQ(still.at(k, 30)[0].y, 50.0F);
  }
  double mean_x = 0.0, variance = 0.0;
  for (int k = 0; k < 200; ++k) {
    const double dx = swaying.at(k, 10)[0].x - 50.0;
    const double dy = swaying.at(k, 10)[0].y - 50.0;
    mean_x += dx / 200.0;
    variance += (dx * dx + dy * dy) / 200.0;
    ASSERT_LE(std::hypot(dx, dy), 1.0 + 1e-4) << "ten steps of at most 0.1 m";
  }
  EXPECT_NEAR(mean_x, 0.0, 0.06);
  EXPECT_NEAR(variance, 10.0 * 0.1 * 0.1 / 3.0, 0.01);  // of ten uniform draws
}

TEST(CrowdFutures, WhoWalksElsewhereGoesStraightOnUpToTheBorder) {
  const CrowdFutures futures = drawn({5, 200, 1.0, Bounds()}, {personWho(0.0, 1.0)}, 1, 0.0);
  for (int k = 0; k < 5; ++k) {
    for (int d = 0; d <= 100; ++d) {
      ASSERT_NEAR(futures.at(k, d)[0].x, 50.0 + 0.3 * d, 1e-3);
      ASSERT_NEAR(futures.at(k, d)[0].y, 50.0 - 0.4 * d, 1e-3);
    }
    EXPECT_EQ(futures.at(k, 200)[0].y, 0.0F);
    EXPECT_LE(futures.at(k, 200)[0].x, 100.0F);
  }
}

TEST(CrowdFutures, HypothesesAreDrawnAsOftenAsTheyAreLikely) {
  constexpr int kScenarios = 20000;
  const auto futures = drawn({kScenarios, 1, 1.0, Bounds()}, {personWho(0.5, 0.3)}, 3, 0.0);
  int standing = 0, elsewhere = 0;
  for (int k = 0; k < kScenarios; ++k) {
    const double dx = futures.at(k, 1)[0].x - 50.0;
    const double dy = futures.at(k, 1)[0].y - 50.0;
    if (std::hypot(dx, dy) < 1e-3) ++standing;
    if (std::hypot(dx - 0.3, dy + 0.4) < 1e-3) ++elsewhere;
  }
  EXPECT_NEAR(standing / static_cast<double>(kScenarios), 0.5, 0.015);
  EXPECT_NEAR(elsewhere / static_cast<double>(kScenarios), 0.3, 0.015);
}

}  // namespace
}  // namespace pomdp_crowd_nav
