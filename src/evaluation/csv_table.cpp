// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "pomdp_crowd_nav/params/file_errors.h"
#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {
namespace {

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  size_t begin = 0;
  for (size_t end = line.find(','); end != std::string::npos; end = line.find(',', begin)) {
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  cells.push_back(line.substr(begin));
  return cells;
}

}  // namespace

CsvTable::CsvTable(const std::string& path) : path_(path) {
  std::ifstream file(path);
  file.peek();  // fails on a directory
  if (!file.is_open() || file.bad()) throw std::runtime_error(cannotBeRead(path));
  std::string line;
  while (std::getline(file, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::vector<std::string> cells = cellsOf(line);
    if (columns_.empty()) {
      columns_ = std::move(cells);
      continue;
    }
    rows_.push_back(std::move(cells));
    if (rows_.back().size() == columns_.size()) continue;
    fail(rows_.size() - 1, fmt::format("expected {} cells as in the header, got {}",
                                       columns_.size(), rows_.back().size()));
  }
  if (columns_.empty() || (columns_.size() == 1 && columns_[0].empty())) {
    throw std::runtime_error(path_ + ":1: expected a header, the file is empty");
  }
}

std::optional<size_t> CsvTable::findColumn(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<size_t>(found - columns_.begin());
}

size_t CsvTable::column(const std::string& name) const {
  if (const auto found = findColumn(name)) return *found;
  throw std::runtime_error(fmt::format("{}:1: there is no column '{}'", path_, name));
}

double CsvTable::number(size_t row, size_t column) const {
  const auto value = parseDouble(text(row, column));
  if (!value) failCell(row, column, "a number");
  return *value;
}

std::optional<double> CsvTable::numberOrNothing(size_t row, size_t column) const {
  if (text(row, column).empty()) return std::nullopt;
  return number(row, column);
}

std::int64_t CsvTable::count(size_t row, size_t column) const {
  const auto value = parseInteger(text(row, column));
  if (!value || *value < 0) failCell(row, column, "a whole number, at least 0");
  return *value;
}

void CsvTable::fail(size_t row, const std::string& reason) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", path_, row + 2, reason));
}

void CsvTable::failCell(size_t row, size_t column, const char* expected) const {
  fail(row,
       fmt::format("{}: expected {}, got '{}'", columns_[column], expected, text(row, column)));
}

}  // namespace pomdp_crowd_nav
