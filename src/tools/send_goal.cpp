// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/client/simple_action_client.h>
#include <fmt/format.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <optional>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kProgressPeriod = 5.0;  // [s] of wall clock

struct Options {
  std::string world_file;
  std::string x, y;  // [m], empty: the world's goal
  std::string frame = "map";
  double timeout = 300.0;  // [s] of wall clock for everything
};

double toCoordinate(const std::string& name, const std::string& text) {
  size_t end = 0;
  double value = NAN;
  try {
    value = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end == text.size() && std::isfinite(value)) return value;
  throw std::invalid_argument(fmt::format("{} must be a number, got '{}'", name, text));
}

Point goalOf(const Options& options) {
  if (options.x.empty() != options.y.empty()) throw std::invalid_argument("give both --x and --y");
  if (!options.x.empty()) return {toCoordinate("--x", options.x), toCoordinate("--y", options.y)};
  if (options.world_file.empty()) throw std::invalid_argument("give --x and --y or --world-file");
  return loadWorld(options.world_file).goal;
}

move_base_msgs::MoveBaseGoal toActionGoal(const Point& goal, const std::string& frame) {
  move_base_msgs::MoveBaseGoal message;
  message.target_pose.header.frame_id = frame;
  message.target_pose.pose = toMessage(Pose{goal, 0.0});
  return message;
}

// Sends a goal, waits for the end of the trip, says how far it is and how it went.
class GoalSender {
 public:
  GoalSender() : client_("move_base", false) {
    metrics_subscriber_ = node_.subscribe("sim_metrics", 10, &GoalSender::onMetrics, this);
    status_subscriber_ = node_.subscribe("planner_status", 10, &GoalSender::onStatus, this);
  }

  // Returns whether the goal was reached and nobody came too close.
  bool drive(const Options& options, const Point& goal) {
    const ros::WallTime give_up = ros::WallTime::now() + ros::WallDuration(options.timeout);
    while (!client_.isServerConnected()) {
      if (!pauseUntil(give_up)) return fail(ros::ok() ? "no planner answers" : "interrupted");
    }
    sent_ = ros::Time::now();
    client_.sendGoal(toActionGoal(goal, options.frame), {}, {},
                     [&](const move_base_msgs::MoveBaseFeedbackConstPtr& feedback) {
                       const geometry_msgs::PoseStamped& base = feedback->base_position;
                       if (base.header.frame_id == options.frame) showProgress(base, goal);
                     });
    while (!client_.getState().isDone()) {
      if (!pauseUntil(give_up)) break;
    }
    if (!client_.getState().isDone()) client_.cancelGoal();
    const bool reached = client_.getState() == actionlib::SimpleClientGoalState::SUCCEEDED;
    std::cerr << "send_goal: " << client_.getState().toString() << ", "
              << client_.getState().getText() << std::endl;
    return summarise(reached);
  }

 private:
  void onMetrics(const EpisodeMetricsMessage& metrics) { metrics_ = metrics; }
  void onStatus(const PlannerStatus& status) { status_ = status; }

  void showProgress(const geometry_msgs::PoseStamped& base, const Point& goal) {
    const ros::WallTime now = ros::WallTime::now();
    if (now < next_progress_) return;
    next_progress_ = now + ros::WallDuration(kProgressPeriod);
    const geometry_msgs::Point& here = base.pose.position;
    std::cerr << fmt::format("send_goal: {:.0f} s, {:.1f} m to the goal",
                             (base.header.stamp - sent_).toSec(),
                             std::hypot(goal.x() - here.x, goal.y() - here.y))
              << std::endl;
  }

  bool fail(const std::string& reason) {
    std::cerr << "send_goal: " << reason << std::endl;
    return summarise(false);
  }

  static bool pauseUntil(const ros::WallTime& give_up) {
    ros::spinOnce();
    ros::WallDuration(0.02).sleep();
    return ros::ok() && ros::WallTime::now() < give_up;
  }

  // The newest metrics may be a tick older than the result.
  bool summarise(bool reached) {
    const ros::WallTime settled = ros::WallTime::now() + ros::WallDuration(0.5);
    while (pauseUntil(settled)) {
    }
    const EpisodeMetricsMessage metrics = metrics_.value_or(EpisodeMetricsMessage());
    const PlannerStatus status = status_.value_or(PlannerStatus());
    std::cout << fmt::format(
                     "goal_reached={} travel_time_s={:.1f} min_moving_distance_m={:.2f} "
                     "unsafe_steps={} sudden_brakes={} decisions={} deadline_misses={}",
                     reached, metrics.travel_time, metrics.min_moving_distance,
                     metrics.unsafe_steps, status.sudden_brakes, status.decisions,
                     status.deadline_misses)
              << std::endl;
    return reached && metrics.unsafe_steps == 0;
  }

  ros::NodeHandle node_;
  actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction> client_;
  ros::Subscriber metrics_subscriber_, status_subscriber_;
  std::optional<EpisodeMetricsMessage> metrics_;
  std::optional<PlannerStatus> status_;
  ros::Time sent_;
  ros::WallTime next_progress_;
};

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  using namespace pomdp_crowd_nav;
  ros::init(argc, argv, "send_goal");  // takes what is meant for ROS off the command line
  Options options;
  CLI::App app("Sends a goal to the planner, waits for the end of the trip and sums it up");
  app.add_option("--world-file", options.world_file, "world whose goal is sent");
  app.add_option("--x", options.x, "[m] goal, instead of the world's");
  app.add_option("--y", options.y, "[m] goal, instead of the world's");
  app.add_option("--frame", options.frame, "frame of --x and --y");
  app.add_option("--timeout", options.timeout, "[s] after which the goal is cancelled")
      ->check(CLI::PositiveNumber);
  try {
    app.parse(argc, argv);
    const Point goal = goalOf(options);
    return GoalSender().drive(options, goal) ? 0 : 1;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    std::cerr << "send_goal: " << error.what() << std::endl;
    return 2;
  }
}
