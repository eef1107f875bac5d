// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pomdp_crowd_nav {

// A CSV file whose columns are found by their names. What is wrong with it is thrown as
// std::runtime_error, one line with the file and the line.
class CsvTable {
 public:
  // Refuses a file without header and rows whose number of cells is another than the header's.
  explicit CsvTable(const std::string& path);

  const std::string& path() const { return path_; }
  size_t rowCount() const { return rows_.size(); }

  size_t column(const std::string& name) const;  // throws where there is none
  std::optional<size_t> findColumn(const std::string& name) const;

  const std::string& text(size_t row, size_t column) const { return rows_[row][column]; }
  double number(size_t row, size_t column) const;
  std::optional<double> numberOrNothing(size_t row, size_t column) const;  // none: an empty cell
  std::int64_t count(size_t row, size_t column) const;                     // whole, at least 0

  // Throws with the place of a row.
  [[noreturn]] void fail(size_t row, const std::string& reason) const;

 private:
  [[noreturn]] void failCell(size_t row, size_t column, const char* expected) const;

  std::string path_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace pomdp_crowd_nav
