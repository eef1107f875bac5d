// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {
namespace {

constexpr const char* kNone = "–";

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : kNone;
}

std::string withError(double mean, double error, int digits) {
  if (!std::isfinite(mean)) return kNone;
  if (!std::isfinite(error)) return number(mean, digits);
  return fmt::format("{:.{}f} ± {:.{}f}", mean, digits, error, digits);
}

std::string withError(const Summary& summary, int digits) {
  return withError(summary.mean, summary.standard_error, digits);
}

// Mean and 95 % confidence interval.
std::string withInterval(const Summary& summary, double scale, int digits) {
  const double half = halfConfidenceInterval(summary);
  if (!std::isfinite(half)) return number(scale * summary.mean, digits);
  return fmt::format("{:+.{}f} [{:+.{}f}, {:+.{}f}]", scale * summary.mean, digits,
                     scale * (summary.mean - half), digits, scale * (summary.mean + half), digits);
}

using Row = std::vector<std::string>;

std::string markdownTable(const Row& header, const std::vector<Row>& rows) {
  const auto line = [](const Row& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
  };
  std::string text = line(header) + "|";
  for (size_t i = 0; i < header.size(); ++i) text += "---|";
  text += "\n";
  for (const Row& row : rows) text += line(row);
  return text + "\n";
}

// A results file with what is known of the vehicle that it is about.
class Section {
 public:
  Section(const ResultsFile& file, const PaperResults& paper,
          const std::map<TripKey, double>& bounds)
      : file_(file), paper_(paper), bounds_(bounds), cells_(cellsOf(file.rows)) {
    for (const Cell& cell : cells_) summaries_.push_back(summarize(cell));
    readVehicle();
  }

  std::string write() const {
    return heading() + travelTimes() + safety() + pairs() + searches() + boundDistances() +
           exceptions();
  }

 private:
  // From the settings, else from the planners: only a car drives with 2d_nhv.
  void readVehicle() {
    const bool has_nhv = std::any_of(cells_.begin(), cells_.end(), [](const Cell& cell) {
      return cell.planner.rfind("2d_nhv", 0) == 0;
    });
    vehicle_ = has_nhv ? "car" : "holonomic";
    double speed = has_nhv ? 4.0 : 2.0;  // [m/s], the paper's
    if (file_.settings && !file_.settings->worlds.empty()) {
      const auto& world = file_.settings->worlds.begin()->second;
      vehicle_ = world.vehicle;
      const auto key = world.parameters.find("max_vel_trans");
      speed = VehicleParams().max_speed;
      if (key != world.parameters.end()) speed = parseDouble(key->second).value_or(speed);
    }
    max_speed_ = std::lround(1000.0 * speed);
  }

  std::string heading() const {
    std::string text =
        fmt::format("## {}: {}\n\n", std::filesystem::path(file_.path).stem().string(),
                    vehicle_ == "car" ? "car" : "holonomic vehicle");
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
    return paper_.find(vehicle_, cell.planner, cell.world, cell.pedestrians);
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
          paper ? withError(paper->travel_time, paper->travel_time_error, 2) : kNone);
      add(row, shows_pairs, baseline ? pairsWon(comparePairs(cells_[i], *baseline)) : kNone);
      add(row, has_paper,
          paper && paper->pairs_won ? fmt::format("{} of 100", *paper->pairs_won) : kNone);
      add(row, true, withError(summaries_[i].sudden_brakes, 2));
      add(row, has_paper,
          paper ? withError(paper->sudden_brakes, paper->sudden_brakes_error, 2) : kNone);
      rows.push_back(row);
    }
    return "### Travel time, pairs and sudden brakes\n\n" + markdownTable(header, rows);
  }

  static std::string pairsWon(const Pairs& pairs) {
    return pairs.count > 0 ? fmt::format("{} of {}", pairs.won, pairs.count) : kNone;
  }

  std::string safety() const {
    std::vector<Row> rows;
    for (size_t i = 0; i < cells_.size(); ++i) {
      const CellSummary& s = summaries_[i];
      Row row = place(cells_[i]);
      row.push_back(fmt::format("{} of {}", s.arrived, s.episodes));
      row.push_back(fmt::format("{} ({} steps)", s.unsafe_episodes, s.unsafe_steps));
      row.push_back(fmt::format("{} ({} ticks)", s.risky_episodes, s.unsafe_ticks));
      row.push_back(number(s.min_distance, 2));
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
      row.push_back(number(1000.0 * s.mean_search_time, 1));
      row.push_back(number(1000.0 * s.max_search_time, 0));
      row.push_back(number(s.mean_trials, 0));
      row.push_back(std::to_string(s.bound_violations));
      if (has_stale) row.push_back(number(100.0 * s.stale_share, 1));
      rows.push_back(row);
    }
    return "### Search for a decision\n\n" + markdownTable(header, rows);
  }

  std::string boundDistances() const {
    std::vector<Row> rows;
    for (const Cell& cell : cells_) {
      const BoundDistance distance = compareWithBounds(cell, bounds_, max_speed_);
      if (distance.count == 0) continue;
      Row row = place(cell);
      row.push_back(std::to_string(distance.count));
      row.push_back(withInterval(distance.difference, 1.0, 2));
      row.push_back(withError(distance.ratio, 3));
      rows.push_back(row);
    }
    if (rows.empty()) return "";
    return "### Distance from the omniscient bound\n\n" +
           markdownTable({"world", "people", "planner", "episodes", "longer by [s]", "ratio"},
                         rows);
  }

  std::string exceptions() const {
    std::vector<Row> rows;
    for (const EpisodeRow& row : file_.rows) {
      if (row.reached && row.unsafe_steps == 0 && row.unsafe_ticks == 0) continue;
      rows.push_back({row.trial.world, std::to_string(row.trial.pedestrians), row.trial.planner,
                      std::to_string(row.trial.seed), causeOf(row), number(row.travel_time, 1),
                      std::to_string(row.unsafe_steps), std::to_string(row.unsafe_ticks),
                      row.min_moving_distance ? number(*row.min_moving_distance, 3) : kNone});
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
  const std::map<TripKey, double>& bounds_;
  std::vector<Cell> cells_;
  std::vector<CellSummary> summaries_;
  std::string vehicle_;
  long max_speed_ = 2000;  // [mm/s]
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
                        const std::map<TripKey, double>& bounds) {
  std::string text = "# Experiments\n\n" + overview(files);
  for (const ResultsFile& file : files) text += Section(file, paper, bounds).write();
  text.pop_back();  // the empty line at the end
  return text;
}

}  // namespace pomdp_crowd_nav
