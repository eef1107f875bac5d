// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/evaluation/durable_file.h"

namespace pomdp_crowd_nav {

// A CSV file with one block of lines for each of a known sequence of episodes, in that order,
// whatever order the blocks are added in and wherever the program is killed meanwhile: what is
// added ahead of its turn waits in the file PATH.ahead.
class OrderedCsv {
 public:
  struct Layout {
    std::string header;
    // Of each block in order: the cells that begin all its lines, with their last comma.
    std::vector<std::string> keys;
    bool one_line = true;  // in each block
  };

  // Throws std::runtime_error with one line: for a file that exists unless `resume`, and for one
  // with another header or with lines that belong to none of the blocks or out of order.
  OrderedCsv(const std::string& path, const Layout& layout, bool resume);

  // Whether there is a whole line in the file, or in the one of what waits for its turn.
  static bool holdsLines(const std::string& path);

  // To standard output, where nothing can be resumed.
  explicit OrderedCsv(const Layout& layout);

  bool has(size_t index) const { return index < next_ || ahead_.count(index) > 0; }
  size_t count() const { return next_ + ahead_.size(); }
  bool hasDroppedLine() const { return has_dropped_line_; }  // one that ended in its middle

  // Drops blocks found in the files that may be unfinished.
  void keepOnly(const std::vector<bool>& indices);

  void add(size_t index, const std::string& block);

 private:
  std::map<size_t, std::string> parse(const std::string& text, const std::string& path,
                                      bool in_order);
  void settle(std::map<size_t, std::string> blocks);

  std::string path_;  // empty: standard output
  Layout layout_;
  std::map<std::string, size_t> index_of_;  // of a key
  DurableFile file_;
  size_t next_ = 0;                      // block whose turn it is
  std::map<size_t, std::string> ahead_;  // blocks that wait for it
  bool has_dropped_line_ = false;
};

}  // namespace pomdp_crowd_nav
