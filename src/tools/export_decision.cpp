// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config_files.h"
#include "episode_params.h"
#include "option_checks.h"
#include "pomdp_crowd_nav/evaluation/durable_file.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "run_tool.h"

using namespace pomdp_crowd_nav;

namespace {

using Json = nlohmann::json;

struct Options {
  std::string world = "scenario_2";
  int pedestrians = 200;
  std::string planner;  // empty: the one of the profile
  std::uint64_t seed = 1;
  int step = 15;
  long max_trials = 200;
  int max_edges = 4000;
  std::string config = findConfigFolder();
  std::string profile;
  std::vector<std::string> replaced;
  std::string output;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--world", options.world, "Name in config/worlds, or a yaml file")
      ->capture_default_str();
  app.add_option("--pedestrians", options.pedestrians, "Size of the crowd")
      ->check(wholeNumber(0, 10000))
      ->capture_default_str();
  app.add_option("--planner", options.planner,
                 "Planner that decides; without it the one of the profile")
      ->check(oneOf(plannerNames()));
  app.add_option("--seed", options.seed, "Seed of the episode")
      ->check(wholeNumber(0, 4294967295))
      ->capture_default_str();
  app.add_option("--step", options.step, "Which decision of the episode, the first is 1")
      ->check(wholeNumber(1, 100000))
      ->capture_default_str();
  app.add_option("--max-trials", options.max_trials, "Search trials for each decision")
      ->check(wholeNumber(1, 1000000000))
      ->capture_default_str();
  app.add_option("--max-edges", options.max_edges, "Edges of the tree, those of most weight first")
      ->check(wholeNumber(1, 10000000))
      ->capture_default_str();
  app.add_option("--profile", options.profile,
                 "Name in config/profiles, or a yaml file; without it paper for the worlds "
                 "scenario_*, street for the others");
  app.add_option("--set", options.replaced, "KEY=VALUE of the profile, instead of what it says")
      ->expected(1, 1000);
  app.add_option("--config", options.config, "Folder of worlds and profiles")
      ->capture_default_str();
  app.add_option("--output", options.output, "JSON to write; standard output without it");
}

Json pointOf(const Point& point) { return {point.x(), point.y()}; }

Json pathOf(const std::vector<Point>& path) {
  Json json = Json::array();
  for (const Point& point : path) json.push_back(pointOf(point));
  return json;
}

Json worldOf(const World& world) {
  Json json{{"name", world.name},
            {"bounds", {pointOf(world.bounds.min), pointOf(world.bounds.max)}},
            {"start", pointOf(world.start.position)},
            {"goal", pointOf(world.goal)},
            {"destinations", pathOf(world.destinations)},
            {"circles", Json::array()},
            {"polygons", Json::array()}};
  for (const Circle& circle : world.obstacles.circles) {
    json["circles"].push_back({circle.center.x(), circle.center.y(), circle.radius});
  }
  for (const Polygon& polygon : world.obstacles.polygons) {
    json["polygons"].push_back(
        {{"vertices", pathOf(polygon.vertices)}, {"closed", polygon.closed}});
  }
  return json;
}

// Where somebody will be at the next steps, doing what is likeliest.
std::vector<Point> predictedPlaces(const Pedestrian& walker, double step) {
  constexpr int kSteps = 5;
  std::vector<Point> places;
  const Point way = walker.destination - walker.position;
  for (int i = 1; i <= kSteps; ++i) {
    const double length = std::min(way.norm(), walker.speed * step * i);
    places.push_back(walker.position + (way.norm() > 0.0 ? Point(way.normalized()) : way) * length);
  }
  return places;
}

Json peopleOf(const EpisodeMoment& moment, const std::vector<Point>& destinations, double step) {
  Json people = Json::array();
  const std::vector<std::int64_t>& attended = moment.decision.attended;
  for (const PersonBelief& person : moment.crowd.people) {
    const Pedestrian walker = walkerOf(person, person.intention.mostLikely(), destinations);
    people.push_back({{"id", person.id},
                      {"position", pointOf(person.position)},
                      {"belief", person.intention.probabilities()},
                      {"standing", person.intention.standing()},
                      {"elsewhere", person.intention.elsewhere()},
                      {"attended", std::count(attended.begin(), attended.end(), person.id) > 0},
                      {"predicted", pathOf(predictedPlaces(walker, step))}});
  }
  return people;
}

Json treeOf(const TreeView& view) {
  Json edges = Json::array();
  for (const TreeEdge& edge : view.edges) {
    edges.push_back({{"from", pointOf(edge.from)},
                     {"to", pointOf(edge.to)},
                     {"value", edge.value},
                     {"weight", edge.weight},
                     {"depth", edge.depth}});
  }
  return edges;
}

Json decisionOf(const EpisodeMoment& moment, const EpisodeParams& params, int max_edges) {
  const ModelParams& model = params.navigation.planning.model;
  const TreeView view = moment.planner.viewTree({max_edges});
  const Pose& pose = moment.simulator.base().pose();
  Json plan = Json::array();
  for (const VehicleState& state : moment.decision.plan) plan.push_back(pointOf(state.position));
  Json json{{"time_s", moment.time},
            {"step_s", model.step},
            {"action", describe(moment.decision.action)},
            {"trials", moment.decision.search.trials},
            {"robot", {{"position", pointOf(pose.position)}, {"radius", model.vehicle.radius}}},
            {"plan", plan},
            {"tree", treeOf(view)},
            {"rollouts", Json::array()}};
  for (const std::vector<Point>& path : view.rollouts) json["rollouts"].push_back(pathOf(path));
  json["people"] = peopleOf(moment, moment.simulator.world().destinations, model.step);
  return json;
}

struct Exported {};  // ends the episode

Json runTo(const Options& options, const World& world, const EpisodeParams& params) {
  Json json;
  int decisions = 0;
  try {
    runEpisode(world, params, [&](const EpisodeMoment& moment) {
      if (++decisions < options.step) return;
      json = decisionOf(moment, params, options.max_edges);
      throw Exported{};
    });
  } catch (const Exported&) {
    return json;
  }
  throw std::runtime_error(
      fmt::format("--step: the trip was over after {} decisions, got {}", decisions, options.step));
}

void run(const Options& options) {
  const std::string profile = options.profile.empty() ? profileFor(options.world) : options.profile;
  YamlParamReader reader = openProfile(options.config, profile, options.replaced);
  EpisodeParams params = loadEpisodeParams(reader);
  params.max_trials = options.max_trials;
  if (!options.planner.empty()) params.navigation.planner = options.planner;
  params.simulator.pedestrians = options.pedestrians;
  params.seed = options.seed;
  params.tables = std::make_shared<SharedTables>();
  const World world = loadWorld(configFile(options.config, "worlds", options.world));
  requireDrivable(world, params);
  Json json = runTo(options, world, params);
  json["world"] = worldOf(world);
  json["planner"] = params.navigation.planner;
  json["pedestrians"] = options.pedestrians;
  json["seed"] = options.seed;
  const std::string text = json.dump(1) + "\n";
  if (options.output.empty()) {
    fmt::print("{}", text);
  } else {
    replaceFile(options.output, text);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Writes one decision of an episode as JSON: search tree, roll-outs and people."};
  app.footer(std::string(R"(
Example:
  export_decision --world scenario_2 --step 15 --output decision.json
  plot_experiments.py decision decision.json --output decision.png
)") + kExitStatus +
             "\nThe status is 2 as well where the trip is over before that decision.");
  Options options;
  addOptions(app, options);
  return runTool("export_decision", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
