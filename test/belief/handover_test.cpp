// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/handover.h"

#include <gtest/gtest.h>

#include <ctime>
#include <random>

namespace pomdp_crowd_nav {
namespace {

using Heirs = std::vector<size_t>;

double secondsFor(const std::vector<Point>& vanished, const std::vector<Point>& appeared) {
  const std::clock_t start = std::clock();  // of the processor
  matchVanished(vanished, appeared, 0.5);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(Handover, GoesToWhoAppearedNearby) {
  EXPECT_EQ(matchVanished({{0.0, 0.0}, {5.0, 0.0}}, {{5.3, 0.0}, {0.0, 0.4}, {9.0, 0.0}}, 0.5),
            (Heirs{1, 0, kNobody}));
  EXPECT_EQ(matchVanished({}, {{0.0, 0.0}}, 0.5), Heirs{kNobody});
  EXPECT_EQ(matchVanished({{0.0, 0.0}}, {}, 0.5), Heirs{});
}

TEST(Handover, KeepsToTheDistanceAcrossSquaresToo) {
  for (const double x : {-0.01, 0.01, -7.26, 1234.49}) {
    for (const double off : {-0.499, -0.3, 0.3, 0.499}) {
      EXPECT_EQ(matchVanished({{x, x}}, {{x + off, x}}, 0.5), Heirs{0}) << x << " " << off;
      EXPECT_EQ(matchVanished({{x, x}}, {{x, x + off}}, 0.5), Heirs{0}) << x << " " << off;
    }
    EXPECT_EQ(matchVanished({{x, x}}, {{x + 0.501, x}}, 0.5), Heirs{kNobody});
    EXPECT_EQ(matchVanished({{x, x}}, {{x - 0.4, x - 0.4}}, 0.5), Heirs{kNobody});
  }
}

TEST(Handover, NearestFirstAndEachPersonOnce) {
  // 0.1 m off is served before 0.2 m off, whoever comes first in the list.
  EXPECT_EQ(matchVanished({{0.0, 0.0}}, {{0.2, 0.0}, {-0.1, 0.0}}, 0.5), (Heirs{kNobody, 0}));
  // The one who is left takes the other.
  EXPECT_EQ(matchVanished({{0.0, 0.0}, {0.5, 0.0}}, {{0.2, 0.0}, {0.1, 0.0}}, 0.5), (Heirs{1, 0}));
  // Equal pairs: the lower index.
  EXPECT_EQ(matchVanished({{0.0, 0.0}, {0.2, 0.0}}, {{0.1, 0.0}}, 0.5), Heirs{0});
  EXPECT_EQ(matchVanished({{0.1, 0.0}}, {{0.0, 0.0}, {0.2, 0.0}}, 0.5), (Heirs{0, kNobody}));
}

TEST(Handover, EqualsTheSlowWay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Point> vanished(40), appeared(40);
    for (Point& p : vanished) p = {place(random), place(random)};
    for (Point& p : appeared) p = {place(random), place(random)};
    Heirs expected(appeared.size(), kNobody);
    std::vector<bool> taken(vanished.size());
    while (true) {
      double nearest = 1.0;
      std::pair<size_t, size_t> best{kNobody, kNobody};
      for (size_t i = 0; i < appeared.size(); ++i) {
        for (size_t j = 0; j < vanished.size(); ++j) {
          const double distance = (appeared[i] - vanished[j]).norm();
          if (expected[i] != kNobody || taken[j] || distance >= nearest) continue;
          nearest = distance;
          best = {i, j};
        }
      }
      if (best.first == kNobody) break;
      expected[best.first] = best.second;
      taken[best.second] = true;
    }
    ASSERT_EQ(matchVanished(vanished, appeared, 1.0), expected) << trial;
  }
}

// All pairs of 10 000 would be 10^8. The limits leave room for a busy machine.
TEST(Handover, TenThousandAtOnceTakeMilliseconds) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  std::vector<Point> vanished(10000), appeared(10000);
  for (Point& p : vanished) p = {place(random), place(random)};
  for (Point& p : appeared) p = {place(random), place(random)};
  const double spread = secondsFor(vanished, appeared);
  const std::vector<Point> heap(10000, Point(1.0, 2.0));
  const double heaped = secondsFor(heap, heap);
  RecordProperty("spread_ms", std::to_string(1e3 * spread));
  RecordProperty("heaped_ms", std::to_string(1e3 * heaped));
  EXPECT_LT(spread, 0.2);
  EXPECT_LT(heaped, 0.2);
  size_t heirs = 0;
  for (const size_t heir : matchVanished(heap, heap, 0.5)) heirs += heir != kNobody ? 1 : 0;
  EXPECT_EQ(heirs, kCrowded);
}

}  // namespace
}  // namespace pomdp_crowd_nav
