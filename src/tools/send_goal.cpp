// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/client/simple_action_client.h>
#include <fmt/format.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <optional>

#include "option_checks.h"
#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/shutdown_request.h"
#include "pomdp_crowd_nav/sim/world_file.h"
#include "run_tool.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kProgressPeriod = 5.0;      // [s] of wall clock
constexpr double kCancelPatience = 6.0;      // [s]; the planner says after 5 s that it has stopped
constexpr const char* kWorldsOwn = "world";  // for a coordinate: the world's goal
constexpr const char* kTakenOver = "preempted by a newer goal";  // as the planner's result says

struct Options {
  std::string world_file;
  std::string x = kWorldsOwn, y = kWorldsOwn;  // [m]
  std::string frame = "map";
  double timeout = 300.0;  // [s] of wall clock for everything
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--world-file", options.world_file, "World whose goal is sent");
  app.add_option("--x", options.x, "Goal [m]; 'world': the world's")->capture_default_str();
  app.add_option("--y", options.y, "Goal [m]; 'world': the world's")->capture_default_str();
  app.add_option("--frame", options.frame, "Frame of --x and --y")->capture_default_str();
  app.add_option("--timeout", options.timeout, "After which the goal is cancelled [s]")
      ->check(positiveNumber())
      ->capture_default_str();
  app.footer(R"(
Examples:
  send_goal --x 8 --y 5 planner_status:=planner_node/status
  send_goal --world-file yard.yaml sim_metrics:=sim_node/metrics \
    planner_status:=planner_node/status

Ctrl-C, SIGTERM, SIGHUP and rosnode kill cancel the goal and wait for the robot to stop.

Exit status: 0 when the goal was reached and, in simulation, the metrics say that nobody came within
1 m of the moving robot, or a newer goal took over; 1 otherwise; 2 for a bad argument.
)");
}

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
  const bool has_x = options.x != kWorldsOwn, has_y = options.y != kWorldsOwn;
  if (has_x != has_y) throw std::invalid_argument("give both --x and --y");
  if (has_x) return {toCoordinate("--x", options.x), toCoordinate("--y", options.y)};
  if (options.world_file.empty()) throw std::invalid_argument("give --x and --y or --world-file");
  return loadWorld(options.world_file).goal;
}

move_base_msgs::MoveBaseGoal toActionGoal(const Point& goal, const std::string& frame) {
  move_base_msgs::MoveBaseGoal message;
  message.target_pose.header.frame_id = frame;
  message.target_pose.pose = toMessage(Pose{goal, 0.0});
  return message;
}

// Whether it is to go on.
bool isUndisturbed() { return ros::ok() && !isShutdownRequested(); }

// Topic on which somebody publishes metrics of a simulation; empty on a robot. A master that is
// gone is not waited for.
std::string topicOfMetrics() {
  XmlRpc::XmlRpcValue args, response, topics;
  args[0] = ros::this_node::getName();
  args[1] = "";
  if (!ros::master::execute("getPublishedTopics", args, response, topics, false)) return "";
  for (int i = 0; i < topics.size(); ++i) {
    const std::string type = topics[i][1];
    if (type == ros::message_traits::datatype<EpisodeMetricsMessage>()) return topics[i][0];
  }
  return "";
}

// Sends a goal, waits for the end of the trip, says how far it is and how it went.
class GoalSender {
 public:
  using State = actionlib::SimpleClientGoalState;

  GoalSender() : client_("move_base", false) {
    metrics_subscriber_ = node_.subscribe("sim_metrics", 10, &GoalSender::onMetrics, this);
    status_subscriber_ = node_.subscribe("planner_status", 10, &GoalSender::onStatus, this);
  }

  // Returns whether the goal was reached and nobody came too close, or a newer goal took over.
  bool drive(const Options& options, const Point& goal, const ros::WallTime& give_up) {
    while (!client_.isServerConnected()) {
      if (!pauseUntil(give_up)) {
        return fail(isUndisturbed() ? "no planner answers" : "interrupted");
      }
    }
    sent_ = ros::Time::now();
    client_.sendGoal(toActionGoal(goal, options.frame), {}, {},
                     [&](const move_base_msgs::MoveBaseFeedbackConstPtr& feedback) {
                       const geometry_msgs::PoseStamped& base = feedback->base_position;
                       if (base.header.frame_id == options.frame) showProgress(base, goal);
                     });
    is_sent_ = true;
    while (!client_.getState().isDone()) {
      if (!pauseUntil(give_up)) break;
    }
    if (!client_.getState().isDone()) return giveUp(options.timeout);
    const State end = client_.getState();
    say(fmt::format("{}, {}", end.toString(), end.getText()));
    const bool is_fine = summarise(end == State::SUCCEEDED);
    return is_fine || (end == State::PREEMPTED && end.getText() == kTakenOver);
  }

  // Sums up a trip that did not come about.
  static bool fail(const std::string& reason) {
    say(reason);
    std::cout << summaryOf(false, std::nullopt, std::nullopt) << std::endl;
    return false;
  }

 private:
  // News of this trip, not of the one before or after it.
  bool isOfThisTrip() {
    if (!is_sent_) return false;
    const State state = client_.getState();
    return state == State::ACTIVE || state == State::SUCCEEDED;
  }

  void onMetrics(const EpisodeMetricsMessage& metrics) {
    const bool is_next_trip = metrics_ && client_.getState() == State::SUCCEEDED &&
                              metrics.travel_time < metrics_->travel_time;
    if (isOfThisTrip() && !is_next_trip) metrics_ = metrics;
  }

  void onStatus(const PlannerStatus& status) {
    const bool is_next_trip =
        status_ && client_.getState() == State::SUCCEEDED && status.decisions < status_->decisions;
    if (!isOfThisTrip() || is_next_trip) return;
    status_ = status;
    sayWhatHolds(status);
  }

  // Once, until it changes: no progress comes from a robot that may not start or go on. The reason
  // why it is blocked counts the seconds.
  void sayWhatHolds(const PlannerStatus& status) {
    const bool is_held = status.state == PlannerStatus::WAITING_FOR_INPUT ||
                         status.state == PlannerStatus::PAUSED ||
                         status.state == PlannerStatus::BLOCKED;
    const bool counts = status.state == PlannerStatus::BLOCKED;
    const std::string text = status.state_name + ": " + status.stop_cause;
    const std::string held = is_held ? (counts ? status.state_name : text) : "";
    if (held == held_) return;
    held_ = held;
    if (is_held) say(text);
  }

  void showProgress(const geometry_msgs::PoseStamped& base, const Point& goal) {
    const ros::WallTime now = ros::WallTime::now();
    if (now < next_progress_) return;
    next_progress_ = now + ros::WallDuration(kProgressPeriod);
    const geometry_msgs::Point& here = base.pose.position;
    say(fmt::format("{:.0f} s, {:.1f} m to the goal", (base.header.stamp - sent_).toSec(),
                    std::hypot(goal.x() - here.x, goal.y() - here.y)));
  }

  bool giveUp(double timeout) {
    say(isUndisturbed() ? timedOut(timeout) : "interrupted");
    cancel();
    summarise(client_.getState() == State::SUCCEEDED);  // it may have come first
    return false;
  }

  std::string timedOut(double timeout) {
    std::string reason = fmt::format("timed out after {:g} s", timeout);
    if (client_.getState() == State::PENDING) reason += ", the goal was not taken";
    if (status_) reason += " in " + status_->state_name;
    if (status_ && !status_->stop_cause.empty()) reason += ": " + status_->stop_cause;
    return reason;
  }

  // The robot must not drive on when this program is gone.
  void cancel() {
    client_.cancelGoal();
    const ros::WallTime give_up = ros::WallTime::now() + ros::WallDuration(kCancelPatience);
    while (client_.isServerConnected() && !client_.getState().isDone()) {
      if (!ros::ok() || ros::WallTime::now() >= give_up) break;
      spinShortly();
    }
    const State end = client_.getState();
    say(end.isDone() ? fmt::format("{}, {}", end.toString(), end.getText())
                     : "the planner does not say that the goal is cancelled");
  }

  static void say(const std::string& text) { std::cerr << "send_goal: " << text << std::endl; }

  static bool pauseUntil(const ros::WallTime& give_up) {
    spinShortly();
    return isUndisturbed() && ros::WallTime::now() < give_up;
  }

  static void spinShortly() {
    ros::spinOnce();
    ros::WallDuration(0.02).sleep();
  }

  // What was not received is no number.
  static std::string summaryOf(bool reached, const std::optional<EpisodeMetricsMessage>& metrics,
                               const std::optional<PlannerStatus>& status) {
    const auto count = [](bool is_there, unsigned value) {
      return is_there ? std::to_string(value) : "nan";
    };
    const EpisodeMetricsMessage m = metrics.value_or(EpisodeMetricsMessage());
    const PlannerStatus s = status.value_or(PlannerStatus());
    return fmt::format(
        "goal_reached={} travel_time_s={:.1f} min_moving_distance_m={:.2f} unsafe_steps={} "
        "sudden_brakes={} decisions={} deadline_misses={}",
        reached, metrics ? m.travel_time : NAN, metrics ? m.min_moving_distance : NAN,
        count(metrics.has_value(), m.unsafe_steps), count(status.has_value(), s.sudden_brakes),
        count(status.has_value(), s.decisions), count(status.has_value(), s.deadline_misses));
  }

  // The newest metrics may be a tick older than the result.
  bool summarise(bool reached) {
    const ros::WallTime settled = ros::WallTime::now() + ros::WallDuration(0.5);
    while (pauseUntil(settled)) {
    }
    const std::string topic = reached && !metrics_ ? topicOfMetrics() : "";
    if (!topic.empty()) say("no metrics received: remap sim_metrics to " + topic);
    std::cout << summaryOf(reached, metrics_, status_) << std::endl;
    return reached && topic.empty() && (!metrics_ || metrics_->unsafe_steps == 0);
  }

  ros::NodeHandle node_;
  actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction> client_;
  ros::Subscriber metrics_subscriber_, status_subscriber_;
  std::optional<EpisodeMetricsMessage> metrics_;
  std::optional<PlannerStatus> status_;
  std::string held_;  // by what the robot is held, as was said last
  bool is_sent_ = false;
  ros::Time sent_;
  ros::WallTime next_progress_;
};

// Without a master a node would wait for ever.
bool drive(const Options& options, const Point& goal) {
  const ros::WallTime give_up = ros::WallTime::now() + ros::WallDuration(options.timeout);
  while (!ros::master::check()) {
    if (ros::WallTime::now() >= give_up) {
      return GoalSender::fail("no ROS master answers at " + ros::master::getURI());
    }
    ros::WallDuration(0.1).sleep();
  }
  GoalSender sender;
  catchShutdownRequests();
  return sender.drive(options, goal, give_up);
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  using namespace pomdp_crowd_nav;
  // Takes what is meant for ROS off the command line.
  ros::init(argc, argv, "send_goal", ros::init_options::NoSigintHandler);
  Options options;
  CLI::App app("Sends a goal to the planner, waits for the end of the trip and sums it up");
  addOptions(app, options);
  return runTool("send_goal", app, argc, argv, [&] {
    const Point goal = goalOf(options);
    return drive(options, goal) ? 0 : 1;
  });
}
