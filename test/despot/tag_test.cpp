// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "models/tag_belief.h"
#include "tree_checks.h"

namespace pomdp_crowd_nav {
namespace {

using State = Tag::State;

constexpr double kDiscount = 0.95;

const TagValues& values() {
  static const TagValues tables(kDiscount);
  return tables;
}

int cellAt(int x, int y) { return TagFloor::cellAt(x, y); }

State at(int robot, int opponent) {
  return {static_cast<std::int8_t>(robot), static_cast<std::int8_t>(opponent), true};
}

SearchParams paramsFor(int scenarios) {
  SearchParams params;
  params.scenarios = scenarios;
  params.max_depth = 90;
  params.discount = kDiscount;
  params.regularization = 0.01;
  return params;
}

TEST(TagFloor, HasTwentyNineCellsInACorridorAndARoom) {
  std::vector<int> seen;
  for (int y = -1; y < 6; ++y) {
    for (int x = -1; x < 11; ++x) {
      const int cell = cellAt(x, y);
      if (cell < 0) continue;
      EXPECT_EQ(TagFloor::x(cell), x);
      EXPECT_EQ(TagFloor::y(cell), y);
      seen.push_back(cell);
    }
  }
  std::sort(seen.begin(), seen.end());
  ASSERT_EQ(seen.size(), 29U);
  for (int cell = 0; cell < 29; ++cell) EXPECT_EQ(seen[cell], cell);
}

TEST(TagFloor, HasWalls) {
  EXPECT_EQ(TagFloor::moved(cellAt(4, 1), TagFloor::kNorth), cellAt(4, 1));
  EXPECT_EQ(TagFloor::moved(cellAt(5, 1), TagFloor::kNorth), cellAt(5, 2));
  EXPECT_EQ(TagFloor::moved(cellAt(7, 1), TagFloor::kNorth), cellAt(7, 2));
  EXPECT_EQ(TagFloor::moved(cellAt(8, 1), TagFloor::kNorth), cellAt(8, 1));
  EXPECT_EQ(TagFloor::moved(cellAt(7, 3), TagFloor::kEast), cellAt(7, 3));
  EXPECT_EQ(TagFloor::moved(cellAt(6, 4), TagFloor::kNorth), cellAt(6, 4));
  EXPECT_EQ(TagFloor::moved(cellAt(9, 0), TagFloor::kEast), cellAt(9, 0));
  EXPECT_EQ(TagFloor::moved(cellAt(0, 1), TagFloor::kSouth), cellAt(0, 0));
  EXPECT_EQ(TagFloor::moved(cellAt(3, 0), TagFloor::kWest), cellAt(2, 0));
}

void expectMoves(int robot, int opponent, const std::array<double, 5>& expected) {
  const auto moves = opponentMoves(robot, opponent);
  for (int d = 0; d < 5; ++d) EXPECT_NEAR(moves[d], expected[d], 1e-12) << "direction " << d;
}

// By north, east, south, west, stay.
TEST(TagOpponent, RunsAway) {
  expectMoves(cellAt(5, 1), cellAt(6, 3), {0.4, 0.4, 0.0, 0.0, 0.2});
  expectMoves(cellAt(2, 0), cellAt(4, 1), {0.0, 0.4, 0.0, 0.0, 0.6});  // a wall in the north
  expectMoves(cellAt(6, 4), cellAt(6, 1), {0.0, 0.2, 0.4, 0.2, 0.2});  // level in x
  expectMoves(cellAt(8, 0), cellAt(3, 0), {0.2, 0.0, 0.0, 0.4, 0.4});  // level in y, by a wall
  expectMoves(cellAt(6, 3), cellAt(6, 3), {0.2, 0.2, 0.2, 0.2, 0.2});
  expectMoves(cellAt(9, 1), cellAt(0, 0), {0.0, 0.0, 0.0, 0.0, 1.0});  // cornered
}

TEST(TagOpponent, NeverComesNearer) {
  for (int i = 0; i < 29 * 29; ++i) {
    const auto moves = opponentMoves(i / 29, i % 29);
    double sum = 0.0;
    const auto distance = [robot = i / 29](int cell) {
      return std::abs(TagFloor::x(cell) - TagFloor::x(robot)) +
             std::abs(TagFloor::y(cell) - TagFloor::y(robot));
    };
    for (int d = 0; d < 5; ++d) {
      sum += moves[d];
      ASSERT_GE(moves[d], 0.0);
      const int to = moves[d] > 0.0 ? TagFloor::moved(i % 29, d) : i % 29;
      ASSERT_GE(distance(to), distance(i % 29));
    }
    ASSERT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(TagModel, StepsAsOftenAsTheOpponentMoves) {
  const Tag model(values(), 9);
  const State state = at(cellAt(5, 1), cellAt(6, 3));
  constexpr int kDraws = 40000;
  std::array<int, 29> counts{};
  for (int k = 0; k < kDraws; ++k) {
    State next;
    model.step(state, k, 3, Tag::kWest, next);
    EXPECT_EQ(next.robot, cellAt(4, 1));
    ++counts[next.opponent];
  }
  EXPECT_NEAR(counts[cellAt(6, 4)] / static_cast<double>(kDraws), 0.4, 0.01);
  EXPECT_NEAR(counts[cellAt(7, 3)] / static_cast<double>(kDraws), 0.4, 0.01);
  EXPECT_NEAR(counts[cellAt(6, 3)] / static_cast<double>(kDraws), 0.2, 0.01);
}

TEST(TagModel, PaysForTheTag) {
  const Tag model(values(), 9);
  State next;
  const Branch hit = model.step(at(4, 4), 0, 0, Tag::kTag, next);
  EXPECT_EQ(hit.reward, 10.0F);
  EXPECT_TRUE(hit.terminal);
  const Branch miss = model.step(at(4, 5), 0, 0, Tag::kTag, next);
  EXPECT_EQ(miss.reward, -10.0F);
  EXPECT_FALSE(miss.terminal);
  EXPECT_EQ(next.robot, 4);
  for (const auto action : {Tag::kNorth, Tag::kEast, Tag::kSouth, Tag::kWest}) {
    EXPECT_EQ(model.step(at(4, 4), 0, 0, action, next).reward, -1.0F);
  }
}

TEST(TagModel, SeesTheOpponentInItsOwnCellOnly) {
  const Tag model(values(), 9);
  // The opponent is cornered and the robot next to it.
  State next;
  const State state = at(cellAt(1, 0), cellAt(0, 0));
  int seen = 0;
  for (int k = 0; k < 1000; ++k) {
    const Branch branch = model.step(state, k, 0, Tag::kWest, next);
    if (next.opponent == 0) {
      EXPECT_EQ(branch.observation, Tag::kSeen);
      ++seen;
    } else {
      EXPECT_EQ(branch.observation, 0U) << "the robot's cell";
    }
  }
  EXPECT_NEAR(seen, 800, 50);
}

// The upper bound solves Bellman's equation of the game with the opponent in full view.
TEST(TagValues, TheChaseIsOptimal) {
  for (int robot = 0; robot < 29; ++robot) {
    for (int opponent = 0; opponent < 29; ++opponent) {
      const auto moves = opponentMoves(robot, opponent);
      const auto later = [&](int to) {
        double sum = 0.0;
        for (int d = 0; d < 5; ++d) {
          sum += kDiscount * moves[d] * values().chase(to, TagFloor::moved(opponent, d));
        }
        return sum;
      };
      double best = robot == opponent ? 10.0 : -10.0 + later(robot);
      for (int d = 0; d < 4; ++d) best = std::max(best, -1.0 + later(TagFloor::moved(robot, d)));
      ASSERT_NEAR(values().chase(robot, opponent), best, 1e-6);
      ASSERT_LE(values().round(0, robot, opponent), values().chase(robot, opponent));
      ASSERT_LE(values().round(1, robot, opponent), values().chase(robot, opponent));
    }
  }
}

double playRound(const Tag& model, State state, int which, int scenario) {
  double value = 0.0;
  double discount = 1.0;
  for (int depth = 0; depth < 250; ++depth, discount *= kDiscount) {
    const bool tags = state.robot == state.opponent;
    const auto action =
        tags ? Tag::kTag : static_cast<Tag::Action>(TagValues::directionOf(which, state.robot));
    State next;
    value +=
        discount * static_cast<double>(model.step(state, scenario, depth, action, next).reward);
    if (tags) break;
    state = next;
  }
  return value;
}

TEST(TagValues, ARoundEarnsWhatItIsSaidTo) {
  const Tag model(values(), 21);
  constexpr int kPlays = 20000;
  for (const int which : {0, 1}) {
    for (const State& state : {at(cellAt(4, 0), cellAt(8, 1)), at(cellAt(6, 3), cellAt(0, 0))}) {
      double mean = 0.0;
      for (int k = 0; k < kPlays; ++k) mean += playRound(model, state, which, k) / kPlays;
      EXPECT_NEAR(mean, values().round(which, state.robot, state.opponent), 0.2);
    }
  }
}

TEST(TagValues, ARoundVisitsTheWholeFloorButTwoCells) {
  for (const int which : {0, 1}) {
    std::vector<bool> visited(29, false);
    int cell = 0;
    for (int step = 0; step < 60; ++step) {
      visited[cell] = true;
      const int next = TagFloor::moved(cell, TagValues::directionOf(which, cell));
      ASSERT_NE(next, cell) << "ran into a wall";
      cell = next;
    }
    EXPECT_GE(std::count(visited.begin(), visited.end(), true), 26) << which;
  }
}

// The exact belief against what random plays with the same observations end in.
TEST(TagBelief, IsTheShareOfPlaysWithThatHistory) {
  const Tag model(values(), 33);
  TagBelief belief(model);
  EXPECT_NEAR(belief.probability(3, 17), 1.0 / 841.0, 1e-12);
  const std::vector<Tag::Action> actions = {Tag::kEast, Tag::kNorth, Tag::kTag};
  const std::vector<std::uint64_t> observations = {5, 15, 15};
  for (int depth = 0; depth < 3; ++depth) belief.update(model, actions[depth], observations[depth]);
  std::array<double, 29> shares{};
  int matches = 0;
  for (int k = 0; k < 841 * 1000; ++k) {
    State state = at(k % 841 / 29, k % 29);
    bool matched = true;
    for (int depth = 0; depth < 3 && matched; ++depth) {
      const State before = state;
      const Branch branch = model.step(before, k, depth, actions[depth], state);
      matched = !branch.terminal && branch.observation == observations[depth];
    }
    if (!matched) continue;
    ++matches;
    shares[state.opponent] += 1.0;
  }
  ASSERT_GT(matches, 10000);
  double sum = 0.0;
  for (int cell = 0; cell < 29; ++cell) {
    EXPECT_NEAR(belief.probability(15, cell), shares[cell] / matches, 0.01) << cell;
    sum += belief.probability(15, cell);
  }
  EXPECT_NEAR(sum, 1.0, 1e-12) << "the robot is where it saw itself";
}

TEST(TagBelief, KnowsWhenTheOpponentIsSeen) {
  const Tag model(values(), 1);
  TagBelief belief(model);
  EXPECT_FALSE(belief.states()[0].state.located);
  belief.update(model, Tag::kEast, Tag::kSeen);
  for (const auto& entry : belief.states()) {
    EXPECT_EQ(entry.state.robot, entry.state.opponent);
    EXPECT_TRUE(entry.state.located);
  }
  EXPECT_EQ(model.defaultAction(&belief.states()[0].state), Tag::kTag);
}

std::vector<State> startStates(const Tag& model, int count) {
  return drawStates(TagBelief(model).states(), count, 0.5);
}

TEST(SearchOnTag, TagsOnSight) {
  const Tag model(values(), 1, Defaults::kPlain);
  TagBelief belief(model);
  belief.update(model, Tag::kEast, Tag::kSeen);
  Search<Tag> search(paramsFor(100));
  const auto result =
      search.run(model, drawStates(belief.states(), 100, 0.5), SearchLimit::trials(50));
  EXPECT_EQ(result.action, Tag::kTag);
  EXPECT_NEAR(result.statistics.lower_bound, 10.0, 0.02);
}

TEST(SearchOnTag, KeepsItsBoundsInOrder) {
  for (const Defaults defaults : {Defaults::kPlain, Defaults::kSmart}) {
    const Tag model(values(), 2, defaults);
    Search<Tag> search(paramsFor(200));
    const auto result = search.run(model, startStates(model, 200), SearchLimit::trials(200));
    EXPECT_EQ(result.statistics.bound_violations, 0);
    EXPECT_GT(result.statistics.lower_bound, result.statistics.initial_lower_bound);
    EXPECT_LT(result.statistics.upper_bound, result.statistics.initial_upper_bound);
    expectOrderedBounds(search);
    expectOneDefaultActionInEachBelief(search, model);
  }
}

TEST(SearchOnTag, SameSeedSameTree) {
  std::vector<std::vector<std::vector<float>>> trees;
  Search<Tag> search(paramsFor(200));
  for (const std::uint64_t seed : {4, 5, 4}) {
    const Tag model(values(), seed);
    search.run(model, startStates(model, 200), SearchLimit::trials(50));
    trees.push_back(describeTree(search));
  }
  EXPECT_EQ(trees[0], trees[2]);
  EXPECT_NE(trees[0], trees[1]);
}

// The plain default policy earns -20; the published optimum is about -6.
TEST(SearchOnTag, EarnsMuchMoreThanItsDefaultPolicies) {
  const auto make = [](std::uint64_t seed) { return Tag(values(), seed, Defaults::kPlain); };
  Search<Tag> search(paramsFor(100));
  const Episodes episodes = playEpisodes<TagBelief>(search, make, 40, 20);
  EXPECT_GT(episodes.mean_return, -10.0);
  // The leaves are bounded by expectations, which a sampled future may exceed: a few violations
  // are the model's own.
  EXPECT_LT(episodes.bound_violations, 100);
}

}  // namespace
}  // namespace pomdp_crowd_nav
