// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/experiment_log.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <random>
#include <sstream>

namespace pomdp_crowd_nav {
namespace {

namespace fs = std::filesystem;

class ExperimentLogTest : public testing::Test {
 protected:
  ExperimentLogTest() {
    std::string folder = (fs::temp_directory_path() / "experiment_log_XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = folder;
    settings_.plan = {{"w"}, {10}, {"p", "q"}, 4, 1};
    settings_.max_trials = 200;
    settings_.worlds["w"] = {"paper", "holonomic", {{"search/scenarios", "100"}}, {}, ""};
    settings_.version = "1.2.3";
    trials_ = settings_.plan.trials();
    ExperimentLog log(files("whole"), trials_, settings_);
    for (size_t i = 0; i < trials_.size(); ++i) add(log, i);
    results_ = read("whole.csv");
    trails_ = read("whole.trails.csv");
  }
  ~ExperimentLogTest() override { fs::remove_all(folder_); }

  ExperimentLog::Files files(const std::string& name, bool resume = false) const {
    return {path(name + ".csv"), path(name + ".trails.csv"), resume};
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void add(ExperimentLog& log, size_t index) const {
    EpisodeResult result;
    result.metrics.travel_time = 10.0 + static_cast<double>(index);
    result.trail.assign(30, Point(static_cast<double>(index), 1.0));
    log.add(index, csvRow(trials_[index], result),
            trailRows(trials_[index], {0.0, 0.0}, 1.0, result));
  }

  std::string read(const std::string& name) const {
    std::ifstream file(path(name));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
  }

  std::string refusal(const ExperimentLog::Files& files, const ExperimentSettings& settings) const {
    try {
      ExperimentLog log(files, settings.plan.trials(), settings);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
  ExperimentSettings settings_;
  std::vector<Trial> trials_;
  std::string results_, trails_;  // of an experiment that was not interrupted
};

TEST_F(ExperimentLogTest, WritesInOrderWhateverOrderTheEpisodesEndIn) {
  std::mt19937 random(3);
  std::vector<size_t> order(trials_.size());
  std::iota(order.begin(), order.end(), 0U);
  for (int i = 0; i < 20; ++i) {
    std::shuffle(order.begin(), order.end(), random);
    const std::string name = "mixed" + std::to_string(i);
    ExperimentLog log(files(name), trials_, settings_);
    for (const size_t index : order) {
      EXPECT_FALSE(log.has(index));
      add(log, index);
      EXPECT_TRUE(log.has(index));
    }
    EXPECT_EQ(read(name + ".csv"), results_);
    EXPECT_EQ(read(name + ".trails.csv"), trails_);
    EXPECT_FALSE(fs::exists(path(name + ".csv.ahead")));
    EXPECT_FALSE(fs::exists(path(name + ".trails.csv.ahead")));
  }
}

// Killed again and again, after any episode or in the middle of writing its trail or its row.
TEST_F(ExperimentLogTest, LosesAndRepeatsNothingWhereverItIsKilled) {
  std::mt19937 random(7);
  const std::vector<std::string> endings = {".csv", ".csv.ahead", ".trails.csv",
                                            ".trails.csv.ahead"};
  for (int i = 0; i < 15; ++i) {
    const std::string name = "killed" + std::to_string(i);
    std::vector<bool> is_done(trials_.size(), false);
    while (!std::all_of(is_done.begin(), is_done.end(), [](bool done) { return done; })) {
      ExperimentLog log(files(name, true), trials_, settings_);
      std::vector<size_t> missing;
      for (size_t k = 0; k < trials_.size(); ++k) {
        ASSERT_FALSE(is_done[k] && !log.has(k)) << "lost " << k;
        if (!log.has(k)) missing.push_back(k);
      }
      if (missing.empty()) break;
      std::shuffle(missing.begin(), missing.end(), random);
      missing.resize(1 + random() % missing.size());
      const size_t last = missing.back();
      missing.pop_back();
      for (const size_t index : missing) add(log, index);
      for (const size_t index : missing) is_done[index] = true;
      std::map<std::string, std::string> before;
      for (const std::string& ending : endings) before[ending] = read(name + ending);
      add(log, last);
      if (random() % 2 == 0) {
        is_done[last] = true;
        continue;
      }
      // Only a part of the last row was written, or only a part of its trail.
      std::vector<std::string> torn = {".csv", ".csv.ahead"};
      if (random() % 2 == 0) torn = endings;
      for (const std::string& ending : torn) {
        const std::string old = before[ending];
        const std::string now = read(name + ending);
        const bool has_grown = now.size() > old.size();
        const bool is_trail = ending.find("trails") != std::string::npos;
        const bool is_cut_here = has_grown && is_trail == (torn.size() == 4);
        write(name + ending,
              is_cut_here ? now.substr(0, old.size() + random() % (now.size() - old.size())) : old);
        if (!is_cut_here && old.empty()) fs::remove(path(name + ending));
      }
    }
    ExperimentLog log(files(name, true), trials_, settings_);
    for (size_t k = 0; k < trials_.size(); ++k) {
      if (!log.has(k)) add(log, k);
    }
    ASSERT_EQ(read(name + ".csv"), results_);
    ASSERT_EQ(read(name + ".trails.csv"), trails_);
  }
}

TEST_F(ExperimentLogTest, DropsAnIncompleteLineAndSaysSo) {
  for (size_t cut = 1; cut < results_.size(); cut += 11) {
    fs::copy_file(path("whole.csv.settings.json"), path("cut.csv.settings.json"),
                  fs::copy_options::overwrite_existing);
    write("cut.csv", results_.substr(0, cut));
    fs::remove(path("cut.trails.csv"));
    ExperimentLog log({path("cut.csv"), "", true}, trials_, settings_);
    const bool ends_in_a_line = results_[cut - 1] != '\n';
    EXPECT_EQ(log.hasDroppedLine(), ends_in_a_line);
    const long lines = std::count(results_.begin(), results_.begin() + cut, '\n');
    EXPECT_EQ(log.count(), static_cast<size_t>(std::max(0L, lines - 1)));
    for (size_t k = 0; k < trials_.size(); ++k) {
      if (!log.has(k)) add(log, k);
    }
    ASSERT_EQ(read("cut.csv"), results_) << cut;
  }
}

TEST_F(ExperimentLogTest, RefusesAFileThatIsThere) {
  EXPECT_NE(refusal(files("whole"), settings_).find("--resume"), std::string::npos);
  write("old.trails.csv", "x\n");
  EXPECT_NE(refusal(files("old"), settings_).find("--trails"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("old.csv"))) << "nothing is left of a refused run";
  EXPECT_EQ(read("whole.csv"), results_);
}

TEST_F(ExperimentLogTest, RefusesOtherSettings) {
  EXPECT_EQ(refusal(files("whole", true), settings_), "");
  ExperimentSettings other = settings_;
  other.max_trials = 100;
  EXPECT_NE(refusal(files("whole", true), other).find("max_trials was 200 and is 100"),
            std::string::npos);
  other = settings_;
  other.worlds["w"].parameters["search/scenarios"] = "50";
  EXPECT_NE(refusal(files("whole", true), other)
                .find("worlds/w/parameters/search/scenarios was \"100\" and is \"50\""),
            std::string::npos);
  other = settings_;
  other.plan.first_seed = 2;
  EXPECT_NE(refusal(files("whole", true), other).find("plan/seed"), std::string::npos);
  other = settings_;
  other.plan.planners.pop_back();
  EXPECT_NE(refusal(files("whole", true), other).find("plan/planners/1"), std::string::npos);
  other = settings_;
  other.worlds["w"].recording = "7 bytes, 0";
  EXPECT_NE(refusal(files("whole", true), other).find("worlds/w/recording"), std::string::npos);
  EXPECT_EQ(read("whole.csv"), results_);
  fs::remove(path("whole.csv.settings.json"));
  EXPECT_NE(refusal(files("whole", true), settings_).find("settings.json"), std::string::npos);
}

TEST_F(ExperimentLogTest, RefusesToGoOnWithAnotherVersionOfTheProgram) {
  ExperimentSettings other = settings_;
  other.version = "1.3.0";
  other.max_trials = 100;
  EXPECT_NE(refusal(files("whole", true), other)
                .find("the version of the program was \"1.2.3\" and is \"1.3.0\" now"),
            std::string::npos);
  std::string text = read("whole.csv.settings.json");
  text.replace(text.find("\"version\""), 9, "\"without\"");
  write("whole.csv.settings.json", text);
  EXPECT_NE(refusal(files("whole", true), settings_).find("was missing and is \"1.2.3\" now"),
            std::string::npos);
  EXPECT_EQ(readSettings(path("whole.csv.settings.json")).version, "") << "but it can be read";
}

TEST_F(ExperimentLogTest, AFingerprintTellsContentsApart) {
  write("a.csv", "0.0,1,2.0,3.0\n");
  write("b.csv", "0.0,1,2.0,3.1\n");
  write("c.csv", "a");
  EXPECT_EQ(fingerprintOf(path("a.csv")), fingerprintOf(path("a.csv")));
  EXPECT_NE(fingerprintOf(path("a.csv")), fingerprintOf(path("b.csv")));
  EXPECT_EQ(fingerprintOf(path("c.csv")), "1 bytes, af63dc4c8601ec8c") << "the published value";
  EXPECT_THROW(fingerprintOf(path("none.csv")), std::runtime_error);
  EXPECT_THROW(fingerprintOf(folder_.string()), std::runtime_error);
}

// Rows that wait for their turn were written with settings too.
TEST_F(ExperimentLogTest, RefusesOtherSettingsWhereOnlyWaitingRowsAreLeft) {
  {
    ExperimentLog log(files("ahead"), trials_, settings_);
    add(log, 3);
  }
  fs::remove(path("ahead.csv"));
  ExperimentSettings other = settings_;
  other.max_trials = 100;
  EXPECT_NE(refusal(files("ahead", true), other).find("max_trials was 200 and is 100"),
            std::string::npos);
  const ExperimentLog log(files("ahead", true), trials_, settings_);
  EXPECT_TRUE(log.has(3));
  EXPECT_EQ(log.count(), 1U);
}

// No file grows beyond `bytes` while it lives, as on a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(size_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

// Wherever in the row, in the trail or in what waits for its turn the disk is full.
TEST_F(ExperimentLogTest, AFailedWriteLeavesFilesThatCanBeGoneOnWith) {
  const std::vector<size_t> order = {1, 0, 4, 3, 2, 7, 6, 5};
  int failures = 0;
  for (size_t bytes = 150; bytes < trails_.size(); bytes += 37) {
    const std::string name = "full" + std::to_string(bytes);
    std::vector<size_t> done;
    {
      ExperimentLog log(files(name), trials_, settings_);
      const FullDisk disk(bytes);
      for (const size_t index : order) {
        try {
          add(log, index);
        } catch (const std::runtime_error&) {
          ++failures;
          EXPECT_FALSE(log.has(index)) << "what is not written is not there";
          break;
        }
        done.push_back(index);
      }
      EXPECT_EQ(log.count(), done.size());
    }
    ExperimentLog log(files(name, true), trials_, settings_);
    EXPECT_FALSE(log.hasDroppedLine()) << "the torn line was cut off";
    ASSERT_EQ(log.count(), done.size());
    for (const size_t index : order) {
      EXPECT_EQ(log.has(index), std::count(done.begin(), done.end(), index) == 1);
      if (!log.has(index)) add(log, index);
    }
    ASSERT_EQ(read(name + ".csv"), results_) << bytes;
    ASSERT_EQ(read(name + ".trails.csv"), trails_) << bytes;
  }
  EXPECT_GT(failures, 10);
}

TEST_F(ExperimentLogTest, RefusesAnotherHeaderAndForeignRowsAndMissingTrails) {
  write("whole.csv", "world,seed\nw,1\n");
  EXPECT_NE(refusal(files("whole", true), settings_).find("whole.csv:1: expected the header"),
            std::string::npos);
  const size_t first = results_.find('\n') + 1;
  write("whole.csv", results_.substr(0, first) + results_.substr(results_.find('\n', first) + 1));
  EXPECT_NE(refusal(files("whole", true), settings_).find("whole.csv:2: expected the episode"),
            std::string::npos);
  write("whole.csv", results_ + results_.substr(results_.rfind("w,")));
  EXPECT_NE(refusal(files("whole", true), settings_).find("whole.csv:10: expected no more lines"),
            std::string::npos);
  write("whole.csv", results_);
  fs::remove(path("whole.trails.csv"));
  EXPECT_NE(refusal(files("whole", true), settings_).find("there is no trail of"),
            std::string::npos);
}

TEST_F(ExperimentLogTest, IsWrittenByOneProgramAtATime) {
  ExperimentLog log(files("locked"), trials_, settings_);
  EXPECT_NE(refusal(files("locked", true), settings_).find("another program"), std::string::npos);
}

TEST_F(ExperimentLogTest, SettingsAreReadAsTheyWereWritten) {
  settings_.search_time = 0.1;
  settings_.tracks = "people.csv";
  settings_.replaced = {"search/scenarios=100"};
  writeSettings(path("s.json"), settings_);
  const ExperimentSettings read = readSettings(path("s.json"));
  EXPECT_NO_THROW(requireSameSettings(path("s.json"), read));
  EXPECT_EQ(read.worlds.at("w").vehicle, "holonomic");
  EXPECT_EQ(read.replaced, settings_.replaced);
  write("s.json", "{");
  EXPECT_THROW(readSettings(path("s.json")), std::runtime_error);
  write("s.json", "{}");
  EXPECT_THROW(readSettings(path("s.json")), std::runtime_error);
}

}  // namespace
}  // namespace pomdp_crowd_nav
