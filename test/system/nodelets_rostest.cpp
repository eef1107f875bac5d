// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>

#include "navigation_client.h"

namespace pomdp_crowd_nav {
namespace {

class NodeletsTest : public testing::Test {
 protected:
  // A second planner in the same manager, with the parameters of the first.
  static bool load(const std::string& name, const XmlRpc::XmlRpcValue& params) {
    ros::param::set(name, params);
    nodelet::NodeletLoad call;
    call.request.name = name;
    call.request.type = "pomdp_crowd_nav/PlannerNodelet";
    for (const char* topic : {"odom", "tracked_persons", "map"}) {
      const std::string parent = name.substr(0, name.rfind('/') + 1);
      call.request.remap_source_args.push_back(parent + topic);
      call.request.remap_target_args.push_back(std::string("/") + topic);
    }
    return ros::service::call("nodelet_manager/load_nodelet", call) && call.response.success;
  }

  static bool unload(const std::string& name) {
    nodelet::NodeletUnload call;
    call.request.name = name;
    return ros::service::call("nodelet_manager/unload_nodelet", call) && call.response.success;
  }

  static XmlRpc::XmlRpcValue params() {
    XmlRpc::XmlRpcValue tree;
    EXPECT_TRUE(ros::param::get("planner_node", tree));
    return tree;
  }

  NavigationClient client_;
  LogListener log_;
};

TEST_F(NodeletsTest, BothDriveToAGoal) {
  ASSERT_TRUE(client_.connect());
  client_.send(10.0, 27.0);
  ASSERT_TRUE(client_.waitForEnd(60.0)) << client_.status().stop_cause;
  EXPECT_EQ(client_.state(), NavigationClient::State::SUCCEEDED) << client_.text();
  EXPECT_TRUE(client_.areCommandsFinite());
  EXPECT_GT(client_.topSpeed(), 0.5);
  EXPECT_EQ(client_.commandedSpeed(), 0.0);
}

TEST_F(NodeletsTest, AMisspeltParameterIsNamedAndNothingIsLoaded) {
  ASSERT_TRUE(client_.connect());
  ASSERT_TRUE(client_.waitUntil(10.0, [&] { return log_.programs() >= 4; }));
  XmlRpc::XmlRpcValue wrong = params();
  wrong["max_vel_tran"] = 1.0;
  EXPECT_FALSE(load("/robot_3/planner_node", wrong));
  EXPECT_TRUE(NavigationClient::waitUntil(
      5.0, [&] { return log_.has("unknown key 'max_vel_tran', did you mean 'max_vel_trans'?"); }));
  EXPECT_FALSE(unload("/robot_3/planner_node")) << "it was loaded";
}

TEST_F(NodeletsTest, UnloadingStopsTheBase) {
  ASSERT_TRUE(client_.connect());
  ASSERT_TRUE(load("/robot_2/planner_node", params()));
  geometry_msgs::Twist command;
  ros::NodeHandle node;
  const ros::Subscriber commands = node.subscribe<geometry_msgs::Twist>(
      "/robot_2/cmd_vel", 100,
      [&](const geometry_msgs::Twist::ConstPtr& twist) { command = *twist; });
  actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction> action("/robot_2/move_base", true);
  ASSERT_TRUE(NavigationClient::waitUntil(
      20.0, [&] { return action.isServerConnected() && commands.getNumPublishers() > 0; }));
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose.header.frame_id = "map";
  goal.target_pose.pose = toMessage(Pose{Point(60.0, 60.0), 0.0});
  action.sendGoal(goal);
  const auto speed = [&] { return std::hypot(command.linear.x, command.linear.y); };
  ASSERT_TRUE(NavigationClient::waitUntil(20.0, [&] { return speed() > 0.3; }));
  EXPECT_TRUE(unload("/robot_2/planner_node"));
  EXPECT_TRUE(NavigationClient::waitUntil(1.0, [&] { return speed() == 0.0; }))
      << "the last command is " << speed() << " m/s";
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelets_rostest");
  return RUN_ALL_TESTS();
}
