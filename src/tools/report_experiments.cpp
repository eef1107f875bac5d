// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "config_files.h"
#include "pomdp_crowd_nav/evaluation/report.h"
#include "run_tool.h"

using namespace pomdp_crowd_nav;

namespace {

struct Options {
  std::vector<std::string> results;
  std::vector<std::string> bounds;
  std::string paper = findConfigFolder() + "/paper_results.yaml";
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("results", options.results,
                 "Files that run_experiments wrote; each becomes a section")
      ->required();
  app.add_option("--bound", options.bounds, "Files that omniscient_bound wrote");
  app.add_option("--paper", options.paper, "Published results to compare with")
      ->capture_default_str();
}

void run(const Options& options) {
  std::vector<ResultsFile> files;
  for (const std::string& path : options.results) files.push_back(readResults(path));
  const PaperResults paper = PaperResults::fromFile(options.paper);
  fmt::print("{}", writeReport(files, paper, readBounds(options.bounds)));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Sums results of run_experiments up in Markdown, beside the paper's."};
  app.footer(std::string(R"(
Example:
  run_experiments --planners 1d_astar 2d_fmm --runs 10 --output results.csv
  report_experiments results.csv > report.md
)") + kExitStatus);
  Options options;
  addOptions(app, options);
  return runTool("report_experiments", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
