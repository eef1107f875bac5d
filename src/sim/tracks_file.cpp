// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/tracks_file.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <set>
#include <stdexcept>
#include <utility>

#include "pomdp_crowd_nav/params/file_errors.h"
#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {
namespace {

const std::vector<std::string> kColumns = {"time_s", "ped_id", "x_m", "y_m"};
constexpr double kFarthest = 1.0e6;  // [m]
constexpr double kLatest = 1.0e10;   // [s], stamps of a clock of today are smaller
const std::string kHeader = "time_s,ped_id,x_m,y_m";

std::string trimmed(const std::string& text) {
  const char* const kBlanks = " \t\r";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string> splitAtCommas(const std::string& line) {
  std::vector<std::string> cells;
  size_t begin = 0;
  for (size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, end - begin)));
  }
  return cells;
}

// Reads the rows of one file and knows where it is, for messages.
class RowReader {
 public:
  explicit RowReader(const std::string& path) : path_(path) {}

  void readHeader(const std::string& line) {
    ++line_;
    if (trimmed(line) == kHeader) return;
    fail(fmt::format("expected the header '{}', got '{}'", kHeader, trimmed(line)));
  }

  void readRow(const std::string& line) {
    ++line_;
    if (trimmed(line).empty()) return;
    const std::vector<std::string> cells = splitAtCommas(line);
    if (cells.size() != kColumns.size()) {
      fail(fmt::format("expected {} columns, got {}", kColumns.size(), cells.size()));
    }
    const auto id = parseInteger(cells[1]);
    if (!id) failAt(1, "an integer", cells[1]);
    const double time = number(cells, 0);
    add({time, *id, Point(number(cells, 2), number(cells, 3))}, cells[0]);
  }

  std::vector<TrackSample> samples() { return std::move(samples_); }

 private:
  double number(const std::vector<std::string>& cells, size_t column) const {
    const auto value = parseDouble(cells[column]);
    if (!value) failAt(column, "a number", cells[column]);
    const double most = column == 0 ? kLatest : kFarthest;
    if (std::abs(*value) > most) {
      failAt(column, fmt::format("a number within +-{:.0e}", most), cells[column]);
    }
    return *value;
  }

  void add(const TrackSample& sample, const std::string& time_text) {
    const bool is_first = samples_.empty();
    if (!is_first && sample.time < samples_.back().time) {
      failAt(0, "rows in order of time", time_text);
    }
    if (is_first || sample.time > samples_.back().time) ids_at_this_time_.clear();
    if (!ids_at_this_time_.insert(sample.id).second) {
      fail(fmt::format("person {} is given twice at time {}", sample.id, time_text));
    }
    samples_.push_back(sample);
  }

  [[noreturn]] void failAt(size_t column, const std::string& expected,
                           const std::string& value) const {
    fail(fmt::format("column {}: expected {}, got '{}'", kColumns[column], expected, value));
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", path_, line_, reason));
  }

  std::string path_;
  int line_ = 0;
  std::set<std::int64_t> ids_at_this_time_;
  std::vector<TrackSample> samples_;
};

}  // namespace

std::vector<TrackSample> readTracksFile(const std::string& path) {
  std::ifstream file(path);
  file.peek();  // fails on a directory
  if (!file.is_open() || file.bad()) {
    throw std::runtime_error(cannotBeRead(path));
  }
  RowReader reader(path);
  std::string line;
  std::getline(file, line);
  reader.readHeader(line);
  while (std::getline(file, line)) reader.readRow(line);
  std::vector<TrackSample> samples = reader.samples();
  if (samples.empty()) throw std::runtime_error(fmt::format("{}: no rows", path));
  return samples;
}

}  // namespace pomdp_crowd_nav
