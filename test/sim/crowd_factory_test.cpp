// SPDX-License-Identifier: BSD-3-Clause
// What every generated crowd must do, run over every name in the table.
#include "pomdp_crowd_nav/sim/crowd_factory.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kFastestStep = 0.3;  // [m] in a tick, a run

World field() {
  World world;
  world.bounds = {{0.0, 0.0}, {30.0, 20.0}};
  world.start = {{2.0, 10.0}, 0.0};
  world.goal = {28.0, 10.0};
  world.destinations = {{0.0, 0.0}, {30.0, 0.0}, {30.0, 20.0}, {0.0, 20.0}};
  return world;
}

class CrowdContract : public testing::TestWithParam<std::string> {
 protected:
  static std::unique_ptr<Crowd> make(std::uint64_t seed = 1, int pedestrians = 12) {
    return makeCrowd(GetParam(), field(), {pedestrians, false, seed});
  }
};

TEST_P(CrowdContract, IsOnTheFieldAndAsLargeAsAskedFor) {
  const auto crowd = make();
  EXPECT_EQ(crowd->walkers().size(), 12U);
  for (int i = 0; i < 600; ++i) {
    crowd->tick();
    EXPECT_LE(crowd->walkers().size(), 12U);
    for (const Walker& walker : crowd->walkers()) {
      ASSERT_TRUE(field().bounds.contains(walker.position)) << walker.position.transpose();
    }
  }
  EXPECT_TRUE(make(1, 0)->walkers().empty());
}

TEST_P(CrowdContract, IsAFunctionOfItsSeed) {
  const auto one = make(7), same = make(7), other = make(8);
  bool differs = false;
  for (int i = 0; i < 100; ++i) {
    for (const auto& crowd : {one.get(), same.get(), other.get()}) crowd->tick();
    ASSERT_EQ(one->walkers().size(), same->walkers().size());
    for (size_t k = 0; k < one->walkers().size(); ++k) {
      EXPECT_EQ(one->walkers()[k].id, same->walkers()[k].id);
      EXPECT_EQ(one->walkers()[k].position, same->walkers()[k].position);
    }
    differs = differs || other->walkers().size() != one->walkers().size() ||
              other->walkers()[0].position != one->walkers()[0].position;
  }
  EXPECT_TRUE(differs);
}

TEST_P(CrowdContract, NobodyJumpsUnderOneId) {
  const auto crowd = make();
  std::map<std::int64_t, Point> last;
  for (int i = 0; i < 600; ++i) {
    std::set<std::int64_t> ids;
    for (const Walker& walker : crowd->walkers()) {
      EXPECT_TRUE(ids.insert(walker.id).second) << walker.id << " is there twice";
      const auto known = last.find(walker.id);
      if (known != last.end()) {
        ASSERT_LT((walker.position - known->second).norm(), kFastestStep) << walker.id;
      }
      last[walker.id] = walker.position;
    }
    crowd->tick();
  }
  EXPECT_GT(last.size(), 12U) << "people come and go";
}

INSTANTIATE_TEST_SUITE_P(EveryName, CrowdContract, testing::ValuesIn(crowdNames()),
                         [](const auto& test) { return test.param; });

TEST(CrowdFactory, AnUnknownNameListsTheKnown) {
  try {
    makeCrowd("corner", field(), {});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "crowd must be one of corners, got 'corner', did you mean 'corners'?");
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
