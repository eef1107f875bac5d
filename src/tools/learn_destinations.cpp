// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "option_checks.h"
#include "pomdp_crowd_nav/evaluation/destination_learning.h"
#include "pomdp_crowd_nav/evaluation/durable_file.h"
#include "pomdp_crowd_nav/ros/bag_tracks.h"
#include "progress.h"
#include "run_tool.h"

using namespace pomdp_crowd_nav;

namespace {

struct Options {
  BagSource tracks;
  LearningParams learning;
  std::string output;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--tracks", options.tracks.path,
                 "Recorded people: a bag if its name ends in .bag, else a CSV with the header "
                 "time_s,ped_id,x_m,y_m")
      ->required();
  app.add_option("--topic", options.tracks.topic, "TrackedPersons or People in the bag")
      ->capture_default_str();
  app.add_option("--frame", options.tracks.frame,
                 "Frame of the destinations; tracks in another one are brought into it by the "
                 "transforms in the bag")
      ->capture_default_str();
  app.add_option("--min-people", options.learning.min_people,
                 "Who begin or end their walk at a destination, at least")
      ->check(wholeNumber(1, 1000000))
      ->capture_default_str();
  app.add_option("--merge-distance", options.learning.merge_distance,
                 "Ends of walks this close to a destination belong to it [m]")
      ->check(positiveNumber())
      ->capture_default_str();
  app.add_option("--min-walk", options.learning.min_walk,
                 "Who gets less far from where they began does not count [m]")
      ->check(positiveNumber())
      ->capture_default_str();
  app.add_option("--output", options.output, "yaml to write; standard output without it");
}

std::vector<TrackSample> readTracks(const BagSource& source) {
  if (std::filesystem::path(source.path).extension() != ".bag") return readTracksFile(source.path);
  constexpr size_t kLongBag = 20000;  // messages; a shorter one is read at once
  std::optional<Progress> progress;
  const BagTracks tracks = readTracksBag(source, [&](size_t done, size_t total) {
    if (total < kLongBag) return;
    if (!progress) progress.emplace(0, total, "messages");
    progress->show(done);
  });
  if (tracks.left_out > 0) {
    fmt::print(stderr, "{} of {} messages are left out: the bag has no transform at their time\n",
               tracks.left_out, tracks.messages);
  }
  return tracks.samples;
}

void run(const Options& options) {
  if (!options.output.empty() && std::filesystem::exists(options.output)) {
    throw std::runtime_error(fmt::format("--output: cannot write '{}': it exists", options.output));
  }
  const LearnedDestinations learned =
      learnDestinations(readTracks(options.tracks), options.learning);
  if (learned.destinations.empty()) {
    throw std::runtime_error(
        fmt::format("{}: nowhere do {} people begin or end a walk: {} walks are long enough",
                    options.tracks.path, options.learning.min_people, learned.walks));
  }
  fmt::print(stderr, "{} destinations from {} walks; {} of {} beginnings and ends are near one\n",
             learned.destinations.size(), learned.walks, learned.ends_near, learned.ends);
  if (options.output.empty()) {
    fmt::print("{}", toYaml(learned));
    return;
  }
  replaceFile(options.output, toYaml(learned));
  for (const LearnedDestination& one : learned.destinations) {
    fmt::print("[{:.2f}, {:.2f}]: {} people\n", one.position.x(), one.position.y(), one.people);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Finds out from recorded people where they come from and go to."};
  app.footer(std::string(R"(
Examples:
  learn_destinations --tracks people.csv
  learn_destinations --tracks people.bag --topic /spencer/perception/tracked_persons \
    --output destinations.yaml
  rosparam load destinations.yaml /planner_node
)") + kExitStatus +
             "\nThe status is 2 as well where no destination is found.");
  Options options;
  addOptions(app, options);
  return runTool("learn_destinations", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
