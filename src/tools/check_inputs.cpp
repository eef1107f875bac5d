// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>

#include "input_probe.h"
#include "option_checks.h"
#include "pomdp_crowd_nav/ros/message_gate.h"
#include "pomdp_crowd_nav/ros/odometry_input.h"
#include "run_tool.h"

namespace pomdp_crowd_nav {
namespace {

struct Options {
  double duration = 5.0;  // [s] of wall clock
  std::string node = "planner_node";
};

// Parameters of the planner node that the check depends on, or their defaults.
struct NodeParams {
  std::string global_frame = "map", world_file;
  double transform_tolerance = 0.2, odom_timeout = 0.5, people_timeout = 1.0, map_timeout = 0.0;
  VehicleParams vehicle;
};

NodeParams readParams(const std::string& node) {
  NodeParams params;
  const ros::NodeHandle handle(node);
  handle.getParam("global_frame", params.global_frame);
  handle.getParam("world_file", params.world_file);
  handle.getParam("transform_tolerance", params.transform_tolerance);
  handle.getParam("odom_timeout", params.odom_timeout);
  handle.getParam("people_timeout", params.people_timeout);
  handle.getParam("map_timeout", params.map_timeout);
  handle.getParam("max_vel_trans", params.vehicle.max_speed);
  handle.getParam("max_vel_theta", params.vehicle.max_yaw_rate);
  return params;
}

// What is wrong with a message beyond its header.
struct BodyCheck {
  VehicleParams vehicle;

  MessageFault operator()(const nav_msgs::Odometry& odometry) const {
    const auto reading = toReading(odometry, Pose{});
    if (!reading) return MessageFault::kNotFinite;
    return isWithin(*reading, readingRange(vehicle)) ? MessageFault::kNone
                                                     : MessageFault::kOutOfRange;
  }
  MessageFault operator()(const TrackedPersons& persons) const {
    const bool is_bad = !persons.tracks.empty() && toTracks(persons, Pose{}).tracks.empty();
    return is_bad ? MessageFault::kNotFinite : MessageFault::kNone;
  }
  MessageFault operator()(const People& people) const {
    const bool is_bad = !people.people.empty() && toTracks(people, Pose{}).tracks.empty();
    return is_bad ? MessageFault::kNotFinite : MessageFault::kNone;
  }
};

// {topic: nodes} of the publishers (0) or subscribers (1) that the master knows, without this one.
std::map<std::string, std::vector<std::string>> nodesByTopic(int which) {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  std::map<std::string, std::vector<std::string>> nodes;
  if (!ros::master::execute("getSystemState", request, response, payload, false)) return nodes;
  for (int i = 0; i < payload[which].size(); ++i) {
    XmlRpc::XmlRpcValue& entry = payload[which][i];
    for (int k = 0; k < entry[1].size(); ++k) {
      const std::string name = entry[1][k];
      if (name != ros::this_node::getName()) nodes[entry[0]].push_back(name);
    }
  }
  return nodes;
}

// Listens for a while and says what there is.
class InputChecker {
 public:
  explicit InputChecker(const Options& options)
      : options_(options),
        params_(readParams(options.node)),
        body_{params_.vehicle},
        frames_({params_.global_frame, params_.transform_tolerance}),
        gate_(frames_, clock_watch_, [] {}),
        clock_(node_, "/clock", 0.0, [](const auto&, HeardInput&) { return MessageFault::kNone; }),
        odometry_(node_, "odom", params_.odom_timeout, judgeStamped<nav_msgs::Odometry>()),
        persons_(node_, "tracked_persons", params_.people_timeout, judgeStamped<TrackedPersons>()),
        people_(node_, "people", params_.people_timeout, judgeStamped<People>()),
        map_(node_, "map", params_.map_timeout,
             [this](const nav_msgs::OccupancyGrid& grid, HeardInput&) {
               return withoutSlash(grid.header.frame_id) == withoutSlash(params_.global_frame)
                          ? MessageFault::kNone
                          : MessageFault::kNoTransform;
             }) {}

  // Returns whether everything is all right.
  bool check() {
    ros::AsyncSpinner spinner(2);
    spinner.start();
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(options_.duration);
    while (ros::ok() && ros::WallTime::now() < end) {
      ros::WallDuration(0.05).sleep();
      clock_moved_at_ = clock_watch_.look().moved_at;
    }
    publishers_ = nodesByTopic(0);
    subscribers_ = nodesByTopic(1);
    std::vector<CheckedInput> inputs;
    if (ros::Time::isSimTime()) inputs.push_back(checkClock());
    inputs.push_back(checked(odometry_.heard()));
    addPeople(inputs);
    inputs.push_back(checkMap());
    inputs.push_back(checkCommands());
    std::cout << tableOf(inputs) << std::flush;
    return std::all_of(inputs.begin(), inputs.end(),
                       [](const CheckedInput& input) { return input.verdict.is_fine; });
  }

 private:
  template <class Message>
  typename InputProbe<Message>::Judge judgeStamped() {
    return [this](const Message& message, HeardInput& heard) {
      const HeaderVerdict verdict = gate_.judge(message.header, {});
      heard.age = std::max(0.0, steadySeconds() - verdict.measured_at);
      return verdict.fault == MessageFault::kNone ? body_(message) : verdict.fault;
    };
  }

  CheckedInput checked(HeardInput heard) const {
    const auto found = publishers_.find(heard.topic);
    if (found != publishers_.end()) heard.publishers = found->second;
    heard.global_frame = params_.global_frame;
    heard.duration = options_.duration;
    return {heard, judge(heard)};
  }

  CheckedInput checkClock() const {
    CheckedInput clock = checked(clock_.heard());
    const bool stands = steadySeconds() - clock_moved_at_ > InputLimits().clock;
    if (clock.verdict.is_fine && ros::Time::now().isZero()) {
      clock.verdict = {false, "at zero", "/clock is at zero: the simulation has not begun"};
    } else if (clock.verdict.is_fine && stands) {
      clock.verdict = {false, "stands still", "/clock stands still: is the simulation paused?"};
    }
    return clock;
  }

  // One of the two topics is enough, and a topic without a publisher is nothing to look into.
  void addPeople(std::vector<CheckedInput>& inputs) const {
    CheckedInput persons = checked(persons_.heard());
    CheckedInput people = checked(people_.heard());
    if (persons.verdict.is_fine && people.verdict.is_fine) {
      people.verdict.text = "the planner uses the first of the two that speaks";
    }
    const auto excuse = [](const CheckedInput& other, CheckedInput& input) {
      const bool is_there = input.heard.messages + input.heard.of_other_layout > 0;
      if (other.verdict.is_fine && !is_there) {
        input.verdict = {true, "not needed, people come on " + other.heard.topic, ""};
      }
    };
    const CheckedInput persons_as_heard = persons;
    excuse(people, persons);
    excuse(persons_as_heard, people);
    inputs.push_back(persons);
    inputs.push_back(people);
  }

  CheckedInput checkMap() const {
    CheckedInput map = checked(map_.heard());
    const bool is_there = map.heard.messages + map.heard.of_other_layout > 0;
    if (!is_there && !params_.world_file.empty() && params_.map_timeout <= 0.0) {
      map.verdict = {true, "not needed, the world file gives one", ""};
    }
    return map;
  }

  CheckedInput checkCommands() {
    CheckedInput commands;
    commands.heard.name = "cmd_vel";
    commands.heard.topic = node_.resolveName("cmd_vel");
    const auto found = subscribers_.find(commands.heard.topic);
    if (found == subscribers_.end()) {
      commands.verdict = {false, "no subscriber",
                          fmt::format("nobody listens to {}: start the base, or remap "
                                      "cmd_vel:=/ITS_TOPIC",
                                      commands.heard.topic)};
    } else {
      commands.verdict.text = fmt::format("heard by {}", fmt::join(found->second, ","));
    }
    return commands;
  }

  Options options_;
  ros::NodeHandle node_;
  NodeParams params_;
  BodyCheck body_;
  FrameSource frames_;
  ClockWatch clock_watch_;
  double clock_moved_at_ = 0.0;  // [s], steady clock
  MessageGate gate_;
  InputProbe<rosgraph_msgs::Clock> clock_;
  InputProbe<nav_msgs::Odometry> odometry_;
  InputProbe<TrackedPersons> persons_;
  InputProbe<People> people_;
  InputProbe<nav_msgs::OccupancyGrid> map_;
  std::map<std::string, std::vector<std::string>> publishers_, subscribers_;
};

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  using namespace pomdp_crowd_nav;
  ros::init(argc, argv, "check_inputs", ros::init_options::AnonymousName);
  Options options;
  CLI::App app(
      "Listens to the inputs of planner_node, with the same remappings, and says what is missing");
  app.add_option("--duration", options.duration, "How long to listen [s]")
      ->check(positiveNumber())
      ->capture_default_str();
  app.add_option("--node", options.node, "Node whose parameters name frames and age limits")
      ->capture_default_str();
  app.footer(R"(
Example:
  check_inputs odom:=/robot/odom cmd_vel:=/robot/cmd_vel --duration 10

Exit status: 0 when all is right, 1 when something is missing or no master answers, 2 for a bad
argument.
)");
  return runTool("check_inputs", app, argc, argv, [&] {
    if (!ros::master::check()) {
      fmt::print(stderr, "check_inputs: no ROS master answers at {}\n", ros::master::getURI());
      return 1;
    }
    return InputChecker(options).check() ? 0 : 1;
  });
}
