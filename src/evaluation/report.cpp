// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "pomdp_crowd_nav/evaluation/markdown.h"
#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {
namespace {

using Row = MarkdownRow;

// A results file with what is known of the vehicle that it is about.
class Section {
 public:
  Section(const ResultsFile& file, const PaperResults& paper, const BoundsOfTrips& bounds)
      : file_(file), paper_(paper), bounds_(bounds), cells_(cellsOf(file.rows)) {
    for (const Cell& cell : cells_) summaries_.push_back(summarize(cell));
    has_nhv_ = std::any_of(cells_.begin(), cells_.end(),
                           [](const Cell& cell) { return cell.planner.rfind("2d_nhv", 0) == 0; });
  }

  std::string write() const {
    return heading() + travelTimes() + safety() + pairs() + searches() + boundDistances() +
           exceptions();
  }

 private:
  struct Vehicle {
    std::string kind;
    long max_speed;  // [mm/s]
  };

  // From the settings, else from the planners: only a car drives with 2d_nhv.
  Vehicle vehicleIn(const std::string& world_name) const {
    if (file_.settings) {
      const auto world = file_.settings->worlds.find(world_name);
      if (world != file_.settings->worlds.end()) return vehicleOf(world->second);
    }
    return has_nhv_ ? Vehicle{"car", 4000} : Vehicle{"holonomic", 2000};  // the paper's
  }

  static Vehicle vehicleOf(const ExperimentSettings::WorldSettings& world) {
    double speed = VehicleParams().max_speed;
    const auto key = world.parameters.find("max_vel_trans");
    if (key != world.parameters.end()) speed = parseDouble(key->second).value_or(speed);
    return {world.vehicle, std::lround(1000.0 * speed)};
  }

  std::string vehicles() const {
    bool has_car = false, has_other = false;
    for (const Cell& cell : cells_) {
      (vehicleIn(cell.world).kind == "car" ? has_car : has_other) = true;
    }
    if (!has_car) return "holonomic vehicle";
    return has_other ? "car and holonomic vehicle" : "car";
  }

  std::string heading() const {
    std::string text =
        fmt::format("## {}: {}\n\n", std::filesystem::path(file_.path).stem().string(), vehicles());
    if (!file_.settings) return text;
    const ExperimentSettings& settings = *file_.settings;
    std::string profiles;
    for (const auto& [name, world] : settings.worlds) {
      const std::string profile = std::filesystem::path(world.profile).stem().string();
      if (profiles.find("`" + profile + "`") != std::string::npos) continue;
      profiles += (profiles.empty() ? "`" : ", `") + profile + "`";
    }
    text += "Profile " + profiles;
    for (const std::string& replaced : settings.replaced) text += " with `" + replaced + "`";
    text += settings.max_trials > 0
                ? fmt::format(", at most {} search trials for each decision", settings.max_trials)
                : fmt::format(", {} s of search for each decision", settings.search_time);
    return text + fmt::format(", seeds {} to {}.\n\n", settings.plan.first_seed,
                              settings.plan.first_seed + settings.plan.runs - 1);
  }

  std::optional<PaperResult> paperOf(const Cell& cell) const {
    return paper_.find(vehicleIn(cell.world).kind, cell.planner, cell.world, cell.pedestrians);
  }

  const Cell* baselineOf(const Cell& cell) const {
    if (cell.planner == kBaselinePlanner) return nullptr;
    for (const Cell& other : cells_) {
      if (other.planner == kBaselinePlanner && other.world == cell.world &&
          other.pedestrians == cell.pedestrians) {
        return &other;
      }
    }
    return nullptr;
  }

  static Row place(const Cell& cell) {
    return {std::filesystem::path(cell.world).stem().string(), std::to_string(cell.pedestrians),
            cell.planner};
  }

  std::string travelTimes() const {
    const bool has_paper =
        std::any_of(cells_.begin(), cells_.end(), [&](const Cell& cell) { return paperOf(cell); });
    const bool has_baseline = std::any_of(cells_.begin(), cells_.end(),
                                          [&](const Cell& cell) { return baselineOf(cell); });
    Row header{"world", "people", "planner"};
    const auto add = [](Row& row, bool wanted, const std::string& cell) {
      if (wanted) row.push_back(cell);
    };
    const bool shows_pairs = has_baseline || has_paper;
    add(header, true, "travel time [s]");
    add(header, has_paper, "paper");
    add(header, shows_pairs, fmt::format("faster than {}", kBaselinePlanner));
    add(header, has_paper, "paper");
    add(header, true, "sudden brakes");
    add(header, has_paper, "paper");
    std::vector<Row> rows;
    for (size_t i = 0; i < cells_.size(); ++i) {
      const auto paper = paperOf(cells_[i]);
      const Cell* baseline = baselineOf(cells_[i]);
      Row row = place(cells_[i]);
      add(row, true, withError(summaries_[i].travel_time, 2));
      add(row, has_paper,
          paper ? withError(paper->travel_time, paper->travel_time_error, 2) : kNoFigure);
      add(row, shows_pairs, baseline ? pairsWon(comparePairs(cells_[i], *baseline)) : kNoFigure);
      add(row, has_paper,
          paper && paper->pairs_won ? fmt::format("{} of 100", *paper->pairs_won) : kNoFigure);
      add(row, true, withError(summaries_[i].sudden_brakes, 2));
      add(row, has_paper,
          paper ? withError(paper->sudden_brakes, paper->sudden_brakes_error, 2) : kNoFigure);
      rows.push_back(row);
    }
    return "### Travel time, pairs and sudden brakes\n\n" + markdownTable(header, rows);
  }

  static std::string pairsWon(const Pairs& pairs) {
    return pairs.count > 0 ? fmt::format("{} of {}", pairs.won, pairs.count) : kNoFigure;
  }

  std::string safety() const {
    std::vector<Row> rows;
    for (size_t i = 0; i < cells_.size(); ++i) {
      const CellSummary& s = summaries_[i];
      Row row = place(cells_[i]);
      row.push_back(fmt::format("{} of {}", s.arrived, s.episodes));
      row.push_back(fmt::format("{} ({} steps)", s.unsafe_episodes, s.unsafe_steps));
      row.push_back(fmt::format("{} ({} ticks)", s.risky_episodes, s.unsafe_ticks));
      row.push_back(figure(s.min_distance, 2));
      rows.push_back(row);
    }
    return "### Arrival and safety\n\n" +
           markdownTable({"world", "people", "planner", "arrived", "unsafe, paper", "unsafe, code",
                          "smallest distance [m]"},
                         rows);
  }

  std::string pairs() const {
    std::vector<Row> rows;
    for (const Cell& cell : cells_) {
      const Cell* baseline = baselineOf(cell);
      if (baseline == nullptr) continue;
      const Pairs pairs = comparePairs(cell, *baseline);
      Row row = place(cell);
      row.push_back(std::to_string(pairs.count));
      row.push_back(withInterval(pairs.difference, 1.0, 2));
      row.push_back(withInterval(pairs.reduction, 100.0, 1));
      rows.push_back(row);
    }
    if (rows.empty()) return "";
    return fmt::format("### Paired differences to {}\n\n", kBaselinePlanner) +
           markdownTable({"world", "people", "planner", "pairs", "difference [s]", "reduction [%]"},
                         rows);
  }

  std::string searches() const {
    const bool has_stale =
        std::any_of(summaries_.begin(), summaries_.end(),
                    [](const CellSummary& s) { return std::isfinite(s.stale_share); });
    Row header{"world",        "people", "planner",         "mean [ms]",
               "longest [ms]", "trials", "bound violations"};
    if (has_stale) header.push_back("decisions without a fresh path [%]");
    std::vector<Row> rows;
    for (size_t i = 0; i < cells_.size(); ++i) {
      const CellSummary& s = summaries_[i];
      Row row = place(cells_[i]);
      row.push_back(figure(1000.0 * s.mean_search_time, 1));
      row.push_back(figure(1000.0 * s.max_search_time, 0));
      row.push_back(figure(s.mean_trials, 0));
      row.push_back(std::to_string(s.bound_violations));
      if (has_stale) row.push_back(figure(100.0 * s.stale_share, 1));
      rows.push_back(row);
    }
    return "### Search for a decision\n\n" + markdownTable(header, rows);
  }

  std::string boundDistances() const {
    std::vector<Row> rows;
    for (const Cell& cell : cells_) {
      const BoundDistances distances =
          compareWithBounds(cell, bounds_, vehicleIn(cell.world).max_speed);
      if (distances.free_drive.ratio.count == 0) continue;
      Row row = place(cell);
      for (const BoundDistance& distance : {distances.plan, distances.free_drive}) {
        row.push_back(std::to_string(distance.ratio.count));
        row.push_back(withInterval(distance.difference, 1.0, 2));
        row.push_back(withError(distance.ratio, 3));
      }
      rows.push_back(row);
    }
    if (rows.empty()) return "";
    return "### Distance from the omniscient plan and from the free drive\n\n"
           "The omniscient plan is the fastest that was found on a lattice for a robot that knows "
           "where everybody will be and is at full speed or at rest: it can be driven, and a trip "
           "may in principle be faster. The free drive is a limit: no trip takes less, whoever is "
           "about.\n\n" +
           markdownTable({"world", "people", "planner", "episodes", "longer than the plan by [s]",
                          "ratio", "episodes", "longer than the free drive by [s]", "ratio"},
                         rows);
  }

  std::string exceptions() const {
    std::vector<Row> rows;
    for (const EpisodeRow& row : file_.rows) {
      if (row.reached && row.unsafe_steps == 0 && row.unsafe_ticks == 0) continue;
      rows.push_back({row.trial.world, std::to_string(row.trial.pedestrians), row.trial.planner,
                      std::to_string(row.trial.seed), causeOf(row), figure(row.travel_time, 1),
                      std::to_string(row.unsafe_steps), std::to_string(row.unsafe_ticks),
                      row.min_moving_distance ? figure(*row.min_moving_distance, 3) : kNoFigure});
    }
    const std::string title = "### Episodes that did not arrive or were unsafe\n\n";
    if (rows.empty()) return title + fmt::format("None of {}.\n\n", file_.rows.size());
    return title + fmt::format("{} of {}:\n\n", rows.size(), file_.rows.size()) +
           markdownTable({"world", "people", "planner", "seed", "what", "time [s]",
                          "unsafe steps (1 m)", "unsafe ticks (0.5 m)", "smallest distance [m]"},
                         rows);
  }

  static std::string causeOf(const EpisodeRow& row) {
    const bool is_late = row.travel_time >= EpisodeParams().time_limit;
    std::string cause;
    if (!row.reached) cause = is_late ? "time limit" : "left the field or hit an obstacle";
    if (row.unsafe_steps > 0 || row.unsafe_ticks > 0) {
      cause += cause.empty() ? "too close to somebody" : ", too close to somebody";
    }
    return cause;
  }

  const ResultsFile& file_;
  const PaperResults& paper_;
  const BoundsOfTrips& bounds_;
  std::vector<Cell> cells_;
  std::vector<CellSummary> summaries_;
  bool has_nhv_ = false;
};

std::string overview(const std::vector<ResultsFile>& files) {
  size_t episodes = 0, arrived = 0, unsafe = 0, risky = 0;
  for (const ResultsFile& file : files) {
    for (const EpisodeRow& row : file.rows) {
      ++episodes;
      arrived += row.reached ? 1 : 0;
      unsafe += row.unsafe_steps > 0 ? 1 : 0;
      risky += row.unsafe_ticks > 0 ? 1 : 0;
    }
  }
  return fmt::format(
      "{} of {} episodes arrived. Unsafe were {} by the paper's rule (moving within 1 m of "
      "somebody) and {} by the rule of the authors' code (within 0.5 m).\n\n"
      "Means are ± their standard error, over the episodes that arrived and were safe by the rule "
      "of the code, as the authors take them. Pairs are episodes among the same people (same "
      "seed); in brackets are 95 % confidence intervals of the mean difference (Student's t).\n\n",
      arrived, episodes, unsafe, risky);
}

}  // namespace

std::string writeReport(const std::vector<ResultsFile>& files, const PaperResults& paper,
                        const BoundsOfTrips& bounds) {
  std::string text = "# Experiments\n\n" + overview(files);
  for (const ResultsFile& file : files) text += Section(file, paper, bounds).write();
  text.pop_back();  // the empty line at the end
  return text;
}

}  // namespace pomdp_crowd_nav
