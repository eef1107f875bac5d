// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/simulation_server.h"

#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/prior/grid_frame.h"
#include "pomdp_crowd_nav/ros/map_conversions.h"
#include "pomdp_crowd_nav/ros/markers.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kStep = 0.02;       // [s], of the base, its odometry and the clock
constexpr int kStepsPerTick = 5;     // of the crowd
constexpr int kMostSteps = 5;        // caught up at once; a longer delay slows the simulation down
constexpr double kRestSpeed = 0.03;  // [m/s]

TripObserver::Params observerParams(const SimNodeParams& params) {
  TripObserver::Params observer;
  observer.metrics.step = params.navigation.planning.model.step;
  observer.goal_tolerance = params.navigation.planning.model.goal_tolerance;
  return observer;
}

// `name` beside the world file in use; it must not lead out of that folder.
std::string worldNamed(const std::string& name, const std::string& world_file) {
  if (name.find('/') != std::string::npos) {
    throw std::invalid_argument("world must be a name, not a path: '" + name + "'");
  }
  const size_t folder_end = world_file.find_last_of('/');
  const std::string folder =
      folder_end == std::string::npos ? "" : world_file.substr(0, folder_end + 1);
  return folder + name + ".yaml";
}

// A planner that runs learns of another map, but keeps the destinations that it was started with.
void requireSameDestinations(const World& present, const World& next) {
  if (next.destinations == present.destinations) return;
  throw std::invalid_argument("people in " + next.name + " walk to other destinations than in " +
                              present.name + ": start the nodes with that world instead");
}

}  // namespace

SimulationServer::SimulationServer(ros::NodeHandle node, ros::NodeHandle private_node,
                                   const SimNodeParams& params)
    : start_time_(ros::WallTime::now().toSec()) {
  ros::param::get("/use_sim_time", use_sim_time_);
  start(params);
  advertise(node, private_node);
  subscribe(node, private_node);
  publishWorld();
  last_tick_ = steadySeconds();
  ros::SteadyTimerOptions options;
  options.period = ros::WallDuration(kStep);
  options.callback = [this](const ros::SteadyTimerEvent& event) { onTimer(event); };
  options.callback_queue = nullptr;
  timer_ = node.createSteadyTimer(options);
}

// Replaces the simulation only when the new one stands.
void SimulationServer::start(const SimNodeParams& params) {
  auto simulator = std::make_unique<Simulator>(loadSimWorld(params), params.simulator);
  coveringGrid(simulator->world().bounds, params.map_resolution);  // throws where it is too large
  if (simulator_) time_before_reset_ += simulator_->time();
  params_ = params;
  simulator_ = std::move(simulator);
  ROS_INFO("simulating %s, robot of radius %.2f m, up to %.2f m/s",
           simulator_->world().name.c_str(), params.simulator.vehicle.radius,
           params.simulator.vehicle.max_speed);
  observer_ = std::make_unique<TripObserver>(observerParams(params), simulator_->world().goal);
  odom_origin_ = simulator_->world().start;
  planner_status_ = PlannerStatus();
  steps_ = 0;
}

void SimulationServer::advertise(ros::NodeHandle& node, ros::NodeHandle& private_node) {
  using visualization_msgs::MarkerArray;
  if (use_sim_time_) publishers_.clock = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
  publishers_.odom = node.advertise<nav_msgs::Odometry>("odom", 10);
  publishers_.map = node.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  publishers_.persons = node.advertise<TrackedPersons>("tracked_persons", 2);
  publishers_.crowd_markers = private_node.advertise<MarkerArray>("crowd_markers", 1);
  publishers_.world_markers = private_node.advertise<MarkerArray>("world_markers", 1, true);
  publishers_.metrics = private_node.advertise<EpisodeMetricsMessage>("metrics", 10);
}

void SimulationServer::subscribe(ros::NodeHandle& node, ros::NodeHandle& private_node) {
  subscribers_ = {node.subscribe("cmd_vel", 1, &SimulationServer::onCommand, this,
                                 ros::TransportHints().tcpNoDelay()),
                  node.subscribe("initialpose", 1, &SimulationServer::onInitialPose, this),
                  node.subscribe("current_goal", 1, &SimulationServer::onGoal, this),
                  node.subscribe("planner_status", 10, &SimulationServer::onPlannerStatus, this)};
  services_ = {private_node.advertiseService("reset", &SimulationServer::onReset, this),
               private_node.advertiseService("pause", &SimulationServer::onPause, this)};
}

void SimulationServer::onTimer(const ros::SteadyTimerEvent&) {
  const double time = steadySeconds();
  const int due = static_cast<int>((time - last_tick_) / kStep + 0.5);
  const double lost = due > kMostSteps ? time - last_tick_ - kMostSteps * kStep : 0.0;
  last_tick_ = due > kMostSteps ? time : last_tick_ + due * kStep;
  if (is_paused_) return;
  if (lost > 0.0) ROS_WARN_THROTTLE(1.0, "too slow: the simulation falls back by %.2f s", lost);
  for (int i = 0; i < std::min(due, kMostSteps); ++i) step();
}

void SimulationServer::step() {
  simulator_->advance(kStep);
  ++steps_;
  if (use_sim_time_) {
    rosgraph_msgs::Clock clock;
    clock.clock = now();
    publishers_.clock.publish(clock);
  }
  publishBase();
  observer_->look(*simulator_);
  if (steps_ % kStepsPerTick != 0) return;
  observer_->tick(*simulator_);
  publishCrowd();
  publishMetrics();
}

void SimulationServer::publishBase() {
  const SimulatedBase& base = simulator_->base();
  const Pose in_odom = transformed(inverse(odom_origin_), base.pose());
  geometry_msgs::TransformStamped odom_in_map;
  odom_in_map.header = header(params_.frames.global);
  odom_in_map.child_frame_id = params_.frames.odom;
  odom_in_map.transform = toTransform(odom_origin_);
  geometry_msgs::TransformStamped base_in_odom;
  base_in_odom.header = header(params_.frames.odom);
  base_in_odom.header.stamp = odom_in_map.header.stamp;
  base_in_odom.child_frame_id = params_.frames.base;
  base_in_odom.transform = toTransform(in_odom);
  transforms_.sendTransform({odom_in_map, base_in_odom});

  nav_msgs::Odometry odom;
  odom.header = base_in_odom.header;
  odom.child_frame_id = params_.frames.base;
  odom.pose.pose = toMessage(in_odom);
  odom.twist.twist =
      toMessage(BaseCommand{rotated(-base.pose().heading, base.velocity()), base.yawRate()});
  publishers_.odom.publish(odom);
}

void SimulationServer::publishCrowd() {
  const TrackList tracks = simulator_->sense();
  std_msgs::Header seen = header(params_.frames.global);
  seen.stamp -= ros::Duration(simulator_->time() - tracks.stamp);
  publishers_.persons.publish(toMessage(tracks, seen));
  if (publishers_.crowd_markers.getNumSubscribers() == 0) return;
  publishers_.crowd_markers.publish(crowdMarkers(simulator_->crowd().walkers(),
                                                 symbolSize(simulator_->world().bounds),
                                                 header(params_.frames.global)));
}

void SimulationServer::publishWorld() {
  const World& world = simulator_->world();
  const double tolerance = params_.navigation.planning.model.goal_tolerance;
  publishers_.map.publish(
      toMessage(world.map(), params_.map_resolution, header(params_.frames.global)));
  publishers_.world_markers.publish(worldMarkers(world, tolerance, header(params_.frames.global)));
}

void SimulationServer::publishMetrics() {
  EpisodeMetricsMessage metrics = toMessage(observer_->metrics());
  metrics.header = header(params_.frames.global);
  metrics.time = simulator_->time();
  metrics.goal_reached = observer_->hasReachedGoal();
  metrics.at_rest = simulator_->base().velocity().norm() < kRestSpeed;
  metrics.decisions = planner_status_.decisions;
  metrics.deadline_misses = planner_status_.deadline_misses;
  metrics.sudden_brakes = planner_status_.sudden_brakes;
  publishers_.metrics.publish(metrics);
}

void SimulationServer::onCommand(const geometry_msgs::Twist& twist) {
  const auto command = toCommand(twist);
  if (command) simulator_->setCommand(*command);
  if (!command) ROS_WARN_THROTTLE(1.0, "a command that is not finite is ignored");
}

// The base is put there at rest, and its odometry starts afresh.
void SimulationServer::onInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const auto pose = toPose(message.pose.pose);
  if (!pose || message.header.frame_id != params_.frames.global) {
    ROS_WARN("initialpose must be finite and in frame '%s'", params_.frames.global.c_str());
    return;
  }
  if (!simulator_->world().bounds.contains(pose->position)) {
    ROS_WARN("initialpose (%.2f, %.2f) is off the field and ignored", pose->position.x(),
             pose->position.y());
    return;
  }
  simulator_->placeRobot(*pose);
  observer_->jump();
  odom_origin_ = *pose;
}

void SimulationServer::onGoal(const geometry_msgs::PoseStamped& goal) {
  if (const auto pose = toPose(goal.pose)) observer_->begin(pose->position, simulator_->time());
}

bool SimulationServer::onReset(ResetSimulation::Request& request,
                               ResetSimulation::Response& response) {
  try {
    SimNodeParams params = params_;
    if (!request.world.empty()) params.world_file = worldNamed(request.world, params.world_file);
    if (!request.world.empty() && params.world_file != params_.world_file) params.tracks_file = "";
    if (request.pedestrians >= 0) params.simulator.pedestrians = request.pedestrians;
    params.simulator.seed = request.seed;
    requireSameDestinations(simulator_->world(), loadSimWorld(params));
    start(params);
    publishWorld();
    response.success = true;
    response.message = "simulating " + simulator_->world().name;
  } catch (const std::exception& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

bool SimulationServer::onPause(PauseService::Request& request, PauseService::Response& response) {
  is_paused_ = request.data;
  response.success = true;
  response.message = is_paused_ ? "paused" : "resumed";
  return true;
}

ros::Time SimulationServer::now() const {
  if (!use_sim_time_) return ros::Time::now();
  return start_time_ + ros::Duration(time_before_reset_ + simulator_->time());
}

std_msgs::Header SimulationServer::header(const std::string& frame) const {
  std_msgs::Header message;
  message.frame_id = frame;
  message.stamp = now();
  return message;
}

}  // namespace pomdp_crowd_nav
