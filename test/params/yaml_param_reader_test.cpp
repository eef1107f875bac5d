// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/yaml_param_reader.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

YamlParamReader reading(const std::string& text) {
  return YamlParamReader::fromText(text, "planner.yaml");
}

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

template <typename T>
std::string messageFor(const std::string& text) {
  return messageOf([&] {
    T value{};
    reading(text).read("a", value);
  });
}

TEST(YamlParamReader, ReadsEveryType) {
  YamlParamReader reader = reading(
      "speed: 1.5\n"
      "whole: 2\n"
      "count: -3\n"
      "on: true\n"
      "name: walk\n"
      "reward: {goal: 1.0e+3}\n"
      "numbers: [1, -2.5]\n"
      "circles: [[1, 2, 3], [4, 5, 6]]\n"
      "points: [[1, 2], [3, 4.5]]\n"
      "polygons:\n"
      "  - {closed: false}\n"
      "  - {closed: true}\n");
  double speed = 0.0, whole = 0.0, goal = 0.0;
  int count = 0;
  bool on = false, first = true, second = false;
  std::string name;
  std::vector<double> numbers;
  std::vector<std::vector<double>> circles;
  std::vector<Point> points;
  EXPECT_TRUE(reader.read("speed", speed));
  EXPECT_TRUE(reader.read("whole", whole));
  EXPECT_TRUE(reader.read("count", count));
  EXPECT_TRUE(reader.read("on", on));
  EXPECT_TRUE(reader.read("name", name));
  EXPECT_TRUE(reader.read("reward/goal", goal));
  EXPECT_TRUE(reader.read("numbers", numbers));
  EXPECT_TRUE(reader.read("circles", circles));
  EXPECT_TRUE(reader.read("points", points));
  EXPECT_TRUE(reader.read("polygons/0/closed", first));
  EXPECT_TRUE(reader.read("polygons/1/closed", second));
  reader.requireAllUsed();
  EXPECT_EQ(speed, 1.5);
  EXPECT_EQ(whole, 2.0);
  EXPECT_EQ(count, -3);
  EXPECT_TRUE(on);
  EXPECT_EQ(name, "walk");
  EXPECT_EQ(goal, 1000.0);
  EXPECT_EQ(numbers, (std::vector<double>{1.0, -2.5}));
  EXPECT_EQ(circles, (std::vector<std::vector<double>>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(points, (std::vector<Point>{{1.0, 2.0}, {3.0, 4.5}}));
  EXPECT_FALSE(first);
  EXPECT_TRUE(second);
}

TEST(YamlParamReader, AbsentKeyLeavesTheDefault) {
  double speed = 1.25;
  std::vector<Point> points = {{1.0, 1.0}};
  YamlParamReader empty = reading("");
  EXPECT_FALSE(empty.read("speed", speed));
  EXPECT_FALSE(empty.read("points", points));
  empty.requireAllUsed();
  EXPECT_EQ(speed, 1.25);
  EXPECT_EQ(points.size(), 1u);
}

TEST(YamlParamReader, RejectsWhatIsNoNumber) {
  const std::string expected = "planner.yaml: a: expected a finite number, got ";
  EXPECT_EQ(messageFor<double>("a: abc"), expected + "'abc'");
  EXPECT_EQ(messageFor<double>("a: 1.0.0"), expected + "'1.0.0'");
  EXPECT_EQ(messageFor<double>("a: 0,5"), expected + "'0,5'");
  EXPECT_EQ(messageFor<double>("a: .nan"), expected + "'.nan'");
  EXPECT_EQ(messageFor<double>("a: nan"), expected + "'nan'");
  EXPECT_EQ(messageFor<double>("a: -.inf"), expected + "'-.inf'");
  EXPECT_EQ(messageFor<double>("a: 1e999"), expected + "'1e999'");
  EXPECT_EQ(messageFor<double>("a: true"), expected + "'true'");
  EXPECT_EQ(messageFor<double>("a: \"1.5\""), expected + "'1.5'");
  EXPECT_EQ(messageFor<double>("a:"), expected + "''");
  EXPECT_EQ(messageFor<double>("a: [1, 2]"), expected + "'[1, 2]'");
}

TEST(YamlParamReader, RejectsWhatIsNoInteger) {
  const std::string expected =
      "planner.yaml: a: expected an integer from -2147483648 to 2147483647, got ";
  EXPECT_EQ(messageFor<int>("a: 1.5"), expected + "'1.5'");
  EXPECT_EQ(messageFor<int>("a: 5.0"), expected + "'5.0'");
  EXPECT_EQ(messageFor<int>("a: 2147483648"), expected + "'2147483648'");
  EXPECT_EQ(messageFor<int>("a: 99999999999999999999"), expected + "'99999999999999999999'");
  EXPECT_EQ(messageFor<int>("a: false"), expected + "'false'");
  EXPECT_EQ(messageFor<int>("a: -2147483648"), "no error");
}

TEST(YamlParamReader, RejectsWhatIsNoTruthValueNoTextNoList) {
  EXPECT_EQ(messageFor<bool>("a: 1"), "planner.yaml: a: expected true or false, got '1'");
  EXPECT_EQ(messageFor<bool>("a: 'true'"), "planner.yaml: a: expected true or false, got 'true'");
  EXPECT_EQ(messageFor<std::string>("a: [b, c]"), "planner.yaml: a: expected a text, got '[b, c]'");
  EXPECT_EQ(messageFor<std::vector<double>>("a: [1, x]"),
            "planner.yaml: a: expected a list of finite numbers, got '[1, x]'");
  EXPECT_EQ(messageFor<std::vector<Point>>("a: [[1, 2], [3, 4, 5]]"),
            "planner.yaml: a: expected a list of [x, y], got '[3, 4, 5]'");
  EXPECT_EQ(messageFor<std::vector<Point>>("a: [1, 2]"),
            "planner.yaml: a: expected a list of lists of finite numbers, got '1'");
}

TEST(YamlParamReader, SuggestsTheKeyThatWasMeant) {
  double value = 0.0;
  YamlParamReader reader = reading("max_vel_tran: 1.0");
  reader.read("max_vel_trans", value);
  reader.read("max_vel_theta", value);
  EXPECT_EQ(messageOf([&] { reader.requireAllUsed(); }),
            "planner.yaml: unknown key 'max_vel_tran', did you mean 'max_vel_trans'?");

  YamlParamReader nested = reading("reward: {gaol: 1.0}");
  nested.read("reward/goal", value);
  EXPECT_EQ(messageOf([&] { nested.requireAllUsed(); }),
            "planner.yaml: unknown key 'reward/gaol', did you mean 'reward/goal'?");

  YamlParamReader strange = reading("colour: red");
  strange.read("max_vel_trans", value);
  EXPECT_EQ(messageOf([&] { strange.requireAllUsed(); }), "planner.yaml: unknown key 'colour'");
}

TEST(YamlParamReader, NamesTheLineOfASyntaxError) {
  const std::string message = messageOf([] { reading("a: 1\nb: [1, 2\nc: 3\n"); });
  EXPECT_EQ(message.find("planner.yaml:3: "), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_EQ(messageOf([] { reading("- 1\n- 2\n"); }),
            "planner.yaml:1: expected 'key: value' lines");
  EXPECT_EQ(messageOf([] { reading("a: 1\nb: 2\na: 3\n"); }),
            "planner.yaml:3: key 'a' is given twice");
}

TEST(YamlParamReader, RejectsWhatGrowsWithoutEnd) {
  const std::string excess = "planner.yaml: nested more than 16 deep or more than 1000000 values";
  EXPECT_EQ(messageOf([] { reading("a: &a {b: *a}\n"); }), excess);
  EXPECT_EQ(messageOf([] { reading("a: &a [1, *a]\n"); }), excess);
  std::string laughs = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i) {
    laughs += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int j = 0; j < 10; ++j) laughs += "*a" + std::to_string(i - 1) + (j < 9 ? ", " : "]\n");
  }
  EXPECT_EQ(messageOf([&] { reading(laughs); }), excess);
}

TEST(YamlParamReader, NamesAFileThatCannotBeRead) {
  EXPECT_EQ(messageOf([] { YamlParamReader::fromFile("/nowhere/p.yaml"); }),
            "/nowhere/p.yaml: the file cannot be read");
  EXPECT_EQ(messageOf([] { YamlParamReader::fromFile(SOURCE_DIR); }),
            SOURCE_DIR ": the file cannot be read");
}

TEST(YamlParamReader, AValueIsReplacedAndKeepsItsType) {
  auto reader = YamlParamReader::fromText("a: {b: 1, c: true}\nd: [1, 2]\n", "p.yaml");
  reader.replace("a/b=7");
  reader.replace("e/f=0.5");
  int b = 0;
  EXPECT_TRUE(reader.read("a/b", b));
  EXPECT_EQ(b, 7);
  double f = 0.0;
  EXPECT_TRUE(reader.read("e/f", f));
  EXPECT_EQ(f, 0.5);
  const std::map<std::string, std::string> expected{
      {"a/b", "7"}, {"a/c", "true"}, {"d", "[1, 2]"}, {"e/f", "0.5"}};
  EXPECT_EQ(reader.texts(), expected);
}

TEST(YamlParamReader, AReplacementThatIsWrongIsNamed) {
  auto reader = YamlParamReader::fromText("a: 1\n", "p.yaml");
  for (const char* text : {"a", "=1", "a=", ""}) {
    EXPECT_THROW(reader.replace(text), std::runtime_error) << text;
  }
  EXPECT_THROW(reader.replace("a=[1"), std::runtime_error);
  auto other = YamlParamReader::fromText("a: 1\n", "p.yaml");
  other.replace("a=many");
  try {
    int a = 0;
    other.read("a", a);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("p.yaml with a=many: a: expected an integer", 0), 0U)
        << error.what();
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
