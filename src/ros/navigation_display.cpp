// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/navigation_display.h"

#include <pthread.h>

#include <algorithm>
#include <utility>

#include "pomdp_crowd_nav/ros/marker_shapes.h"
#include "pomdp_crowd_nav/ros/prior_layers.h"
#include "pomdp_crowd_nav/ros/robot_markers.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kPeriod = 0.125;          // [s], within which a new tree or planner is drawn
constexpr int kTicksPerPicture = 2;        // of people and robot: 4 Hz
constexpr double kLettersPerField = 45.0;  // letters as high as this, side by side over its width
constexpr int kMaxTreeEdges = 4000;        // 8000 points
constexpr Trail::Params kDriven{2000, 0.25, 3.0};  // 500 m

std::vector<Point> positions(const std::vector<VehicleState>& plan) {
  std::vector<Point> points;
  for (const VehicleState& state : plan) points.push_back(state.position);
  return points;
}

}  // namespace

NavigationDisplay::NavigationDisplay(const ros::NodeHandle& private_node,
                                     const PlannerNodeParams& params, Guarded<Drive>& drive)
    : frames_(params.frames),
      destinations_(params.destinations),
      limits_(inputLimits(params)),
      radius_(params.navigation.planning.model.vehicle.radius),
      drive_(drive),
      driven_(kDriven),
      arrival_time_(private_node, "arrival_time", queue_, [this] { return makeArrivalTime(); }),
      roadmap_(private_node, "roadmap", queue_, [this] { return makeRoadmap(); }) {
  ros::NodeHandle node(private_node);
  advertise(node);
  ros::SteadyTimerOptions options;
  options.period = ros::WallDuration(kPeriod);
  options.callback = [this](const ros::SteadyTimerEvent&) { onTimer(); };
  options.callback_queue = &queue_;
  timer_ = node.createSteadyTimer(options);
  thread_ = std::thread([this] { run(); });
}

NavigationDisplay::~NavigationDisplay() {
  stop_ = true;
  thread_.join();
}

// No less important than other threads: it holds locks for which these wait. A picture that cannot
// be drawn must not end the node.
void NavigationDisplay::run() {
  pthread_setname_np(pthread_self(), "display");
  while (!stop_) {
    try {
      queue_.callAvailable(ros::WallDuration(kPeriod));
    } catch (const std::exception& error) {
      ROS_WARN_THROTTLE(10.0, "a picture could not be drawn: %s", error.what());
    }
  }
}

void NavigationDisplay::advertise(ros::NodeHandle& node) {
  using visualization_msgs::MarkerArray;
  goal_ = node.advertise<geometry_msgs::PoseStamped>("current_goal", 1, true);
  global_plan_ = node.advertise<nav_msgs::Path>("global_plan", 1);
  local_plan_ = node.advertise<nav_msgs::Path>("local_plan", 1);
  beliefs_ = node.advertise<CrowdBeliefMessage>("beliefs", 1);
  belief_markers_ = node.advertise<MarkerArray>("belief_markers", 1);
  robot_markers_ = node.advertise<MarkerArray>("robot_markers", 1);
  search_tree_ = node.advertise<MarkerArray>("search_tree", 1);
}

std_msgs::Header NavigationDisplay::header() const {
  std_msgs::Header header;
  header.frame_id = frames_.global;
  header.stamp = ros::Time::now();
  return header;
}

void NavigationDisplay::showGoal(const Goal& goal) {
  geometry_msgs::PoseStamped message;
  message.header = header();
  message.pose = toMessage(goal.pose);
  goal_.publish(message);
}

void NavigationDisplay::showPlanner(const Planner& planner) {
  const Guidance guidance = planner.guidance();
  news_.with([&](News& news) {
    if (news.guidance.field == guidance.field) return;
    news.guidance = guidance;
    news.has_new_guidance = true;
  });
}

void NavigationDisplay::showDecision(const DecisionReport& report, const Planner& planner) {
  int depth = 0;
  const bool is_over = drive_.with([&](Drive& drive) {
    depth = drive.params->tree_depth;
    return !drive.hasGoal();
  });
  if (is_over) return;  // else it would stay when plans have been cleared
  std::vector<Point> plan = positions(report.decision.plan);
  local_plan_.publish(toMessage(plan, header()));
  if (global_plan_.getNumSubscribers() > 0) {
    const std::vector<Point>& path = report.decision.path;
    const Point& here = report.situation.vehicle.position;
    global_plan_.publish(toMessage(path.empty() ? planner.globalPath(here) : path, header()));
  }
  std::optional<TreeScene> tree;
  if (search_tree_.getNumSubscribers() > 0) {
    tree = TreeScene{planner.viewTree({kMaxTreeEdges, depth}), std::move(plan)};
  }
  news_.with([&](News& news) {
    news.attended = report.decision.attended;
    news.tree = std::move(tree);
  });
}

void NavigationDisplay::clearPlans() {
  news_.with([](News& news) {
    news.attended.clear();
    news.tree = TreeScene();
  });
  global_plan_.publish(toMessage(std::vector<Point>(), header()));
  local_plan_.publish(toMessage(std::vector<Point>(), header()));
}

void NavigationDisplay::onTimer() {
  followRobot();
  renewLayers();
  drawTree();
  if (++ticks_ % kTicksPerPicture != 0) return;
  drawBeliefs();
  drawRobot();
}

void NavigationDisplay::followRobot() {
  std::shared_ptr<const StaticMap> map;
  drive_.with([&](Drive& drive) {
    map = drive.inputs.map;
    if (drive.inputs.robot) robot_ = drive.inputs.robot->pose.position;
  });
  if (robot_) driven_.extend(*robot_);
  if (!map || map == map_) return;
  map_ = map;
  const Bounds& field = map->bounds();
  symbol_size_ = symbolSize(field);
  letter_size_ = std::min(2.2 * symbol_size_, (field.max.x() - field.min.x()) / kLettersPerField);
  headline_ = {0.5 * (field.min.x() + field.max.x()), field.max.y() + 2.0 * letter_size_};
}

void NavigationDisplay::renewLayers() {
  const bool is_due =
      news_.with([](News& news) { return std::exchange(news.has_new_guidance, false); });
  if (!is_due) return;
  arrival_time_.renew();
  roadmap_.renew();
}

void NavigationDisplay::drawTree() {
  const auto tree = news_.with([](News& news) { return std::exchange(news.tree, std::nullopt); });
  if (!tree || search_tree_.getNumSubscribers() == 0) return;
  search_tree_.publish(treeMarkers(*tree, symbol_size_, header()));
}

void NavigationDisplay::drawBeliefs() {
  const bool are_pictures_wanted = belief_markers_.getNumSubscribers() > 0;
  if (!are_pictures_wanted && beliefs_.getNumSubscribers() == 0) return;
  CrowdBelief crowd;
  std::int64_t blocker = -1;
  drive_.with([&](Drive& drive) {
    crowd = drive.inputs.crowd;
    blocker = drive.blocker.id;
  });
  if (beliefs_.getNumSubscribers() > 0) {
    beliefs_.publish(toMessage(crowd, destinations_, header()));
  }
  if (!are_pictures_wanted) return;
  crowd_trails_.see(crowd);
  const auto attended = news_.with([](News& news) { return news.attended; });
  belief_markers_.publish(beliefMarkers({crowd, destinations_, attended, crowd_trails_,
                                         robot_.value_or(Point(0.0, 0.0)), blocker, symbol_size_},
                                        header()));
}

void NavigationDisplay::drawRobot() {
  if (robot_markers_.getNumSubscribers() == 0 || !robot_) return;
  PlannerStatus status;
  EmergencyOverride::Params emergency;
  drive_.with([&](Drive& drive) {
    status = toStatus(drive, limits_, steadySeconds());
    emergency = drive.params->emergency;
  });
  const double distance = emergency.enabled ? emergency.decision_distance : 0.0;
  robot_markers_.publish(robotMarkers({driven_, status, frames_.base, *robot_, headline_, radius_,
                                       distance, symbol_size_, letter_size_},
                                      header()));
}

std::optional<nav_msgs::OccupancyGrid> NavigationDisplay::makeArrivalTime() {
  const Guidance guidance = news_.with([](News& news) { return news.guidance; });
  if (!guidance.field) return std::nullopt;
  const PlannerParams planning = drive_.with([](Drive& drive) { return drive.params->planning; });
  const double margin = guidance.field->isStraightLine()
                            ? 0.0
                            : planning.model.obstacleClearance() + planning.prior.extra_clearance;
  return arrivalTimeGrid(*guidance.field, margin, header());
}

std::optional<visualization_msgs::MarkerArray> NavigationDisplay::makeRoadmap() {
  const Guidance guidance = news_.with([](News& news) { return news.guidance; });
  if (!guidance.field) return std::nullopt;
  const auto* roadmap = dynamic_cast<const RoadmapPrior*>(guidance.prior.get());
  if (roadmap != nullptr) return roadmapMarkers(*roadmap, symbol_size_, header());
  return MarkerBuilder(header()).take();  // nothing: the planner uses none
}

}  // namespace pomdp_crowd_nav
