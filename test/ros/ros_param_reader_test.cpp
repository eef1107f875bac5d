// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/ros_param_reader.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

XmlRpc::XmlRpcValue parameters() {
  XmlRpc::XmlRpcValue tree;
  tree["planner"] = "2d_fmm";
  tree["speed"] = 1.5;
  tree["count"] = 6;
  tree["instant"] = true;
  tree["reward"]["goal"] = 1000;
  tree["destinations"][0][0] = 1.0;
  tree["destinations"][0][1] = 2;
  return tree;
}

template <class T>
std::string failureOf(const XmlRpc::XmlRpcValue& tree, const std::string& key, T field) {
  RosParamReader reader(tree, "/node");
  try {
    reader.read(key, field);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(RosParamReader, ReadsEveryType) {
  RosParamReader reader(parameters(), "/node");
  std::string planner;
  double speed = 0.0;
  double goal = 0.0;
  int count = 0;
  bool instant = false;
  std::vector<Point> destinations;
  EXPECT_TRUE(reader.read("planner", planner));
  EXPECT_TRUE(reader.read("speed", speed));
  EXPECT_TRUE(reader.read("count", count));
  EXPECT_TRUE(reader.read("instant", instant));
  EXPECT_TRUE(reader.read("reward/goal", goal));
  EXPECT_TRUE(reader.read("destinations", destinations));
  EXPECT_EQ(planner, "2d_fmm");
  EXPECT_EQ(speed, 1.5);
  EXPECT_EQ(goal, 1000.0);
  EXPECT_EQ(count, 6);
  EXPECT_TRUE(instant);
  ASSERT_EQ(destinations.size(), 1u);
  EXPECT_EQ(destinations[0], Point(1.0, 2.0));
  EXPECT_NO_THROW(reader.requireAllUsed());
}

TEST(RosParamReader, LeavesAbsentFieldsAlone) {
  RosParamReader reader(XmlRpc::XmlRpcValue(), "/node");
  double speed = 2.0;
  EXPECT_FALSE(reader.read("speed", speed));
  EXPECT_EQ(speed, 2.0);
  EXPECT_NO_THROW(reader.requireAllUsed());
}

TEST(RosParamReader, NamesAMisspeltKeyAndTheOneMeant) {
  XmlRpc::XmlRpcValue tree;
  tree["reward"]["gaol"] = 1.0;
  RosParamReader reader(tree, "/node");
  double goal = 0.0;
  reader.read("reward/goal", goal);
  try {
    reader.requireAllUsed();
    FAIL() << "the misspelt key went unnoticed";
  } catch (const std::runtime_error& error) {
    const std::string line = error.what();
    EXPECT_NE(line.find("reward/gaol"), std::string::npos) << line;
    EXPECT_NE(line.find("reward/goal"), std::string::npos) << line;
  }
}

TEST(RosParamReader, RefusesWrongTypesWithTheKey) {
  EXPECT_NE(failureOf(parameters(), "planner", 0.0).find("planner"), std::string::npos);
  EXPECT_NE(failureOf(parameters(), "speed", 0), "");
  EXPECT_NE(failureOf(parameters(), "count", false), "");
  EXPECT_NE(failureOf(parameters(), "count", std::string()), "");
  EXPECT_NE(failureOf(parameters(), "planner", std::vector<double>()), "");
  XmlRpc::XmlRpcValue tree;
  tree["speed"] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(failureOf(tree, "speed", 0.0), "");
}

}  // namespace
}  // namespace pomdp_crowd_nav
