// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/ordered_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

std::string aheadOf(const std::string& path) { return path + ".ahead"; }

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  return text.str();
}

// The first cells of a line, with their last comma.
std::string firstCells(const std::string& line, long count) {
  size_t end = 0;
  for (long i = 0; i < count && end != std::string::npos; ++i) {
    end = line.find(',', end);
    if (end != std::string::npos) ++end;
  }
  return line.substr(0, end);
}

std::map<std::string, size_t> indexOf(const std::vector<std::string>& keys) {
  std::map<std::string, size_t> index;
  for (const std::string& key : keys) {
    const size_t next = index.size();
    if (!index.emplace(key, next).second) {
      throw std::runtime_error(fmt::format("the episode '{}' is planned twice", key));
    }
  }
  return index;
}

}  // namespace

OrderedCsv::OrderedCsv(const Layout& layout)
    : layout_(layout), index_of_(indexOf(layout.keys)), file_(DurableFile::standardOutput()) {
  file_.append(layout_.header + "\n");
}

OrderedCsv::OrderedCsv(const std::string& path, const Layout& layout, bool resume)
    : path_(path),
      layout_(layout),
      index_of_(indexOf(layout.keys)),
      file_(resume ? DurableFile::open(path) : DurableFile::create(path)) {
  std::map<size_t, std::string> blocks;
  if (resume) {
    blocks = parse(contentOf(aheadOf(path_)), aheadOf(path_), false);
    // A block that was about to take its place is whole in the other file only.
    for (auto& block : parse(file_.read(), path_, true)) blocks.insert(std::move(block));
  }
  settle(std::move(blocks));
}

std::map<size_t, std::string> OrderedCsv::parse(const std::string& text, const std::string& path,
                                                bool in_order) {
  std::map<size_t, std::string> blocks;
  const long key_cells =
      layout_.keys.empty() ? 0 : std::count(layout_.keys[0].begin(), layout_.keys[0].end(), ',');
  size_t begin = 0;
  for (int number = 1; begin < text.size(); ++number) {
    const size_t end = text.find('\n', begin);
    if (end == std::string::npos) {
      has_dropped_line_ = true;
      break;
    }
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const auto refuse = [&](const std::string& expected) {
      throw std::runtime_error(
          fmt::format("{}:{}: expected {}, got '{}'", path, number, expected, line));
    };
    if (number == 1) {
      if (line != layout_.header) refuse(fmt::format("the header '{}'", layout_.header));
      continue;
    }
    const auto found = index_of_.find(firstCells(line, key_cells));
    if (found == index_of_.end()) refuse("an episode of this experiment");
    const size_t index = found->second;
    const size_t next = blocks.empty() ? 0 : blocks.rbegin()->first + 1;
    const bool goes_on = !layout_.one_line && index + 1 == next;
    if (in_order && index != next && !goes_on) {
      refuse(next < layout_.keys.size() ? fmt::format("the episode '{}'", layout_.keys[next])
                                        : "no more lines");
    }
    blocks[index] += line + "\n";
  }
  return blocks;
}

// Brings both files into the state that they would be in, had the program not been killed.
void OrderedCsv::settle(std::map<size_t, std::string> blocks) {
  const std::string before = file_.read();
  std::string text = layout_.header + "\n";
  next_ = 0;
  for (auto block = blocks.find(0); block != blocks.end(); block = blocks.find(next_)) {
    text += block->second;
    blocks.erase(block);
    ++next_;
  }
  ahead_ = std::move(blocks);
  std::string waiting = layout_.header + "\n";
  for (const auto& [index, block] : ahead_) waiting += block;
  if (!ahead_.empty()) replaceFile(aheadOf(path_), waiting);
  const size_t same = static_cast<size_t>(
      std::mismatch(before.begin(), before.begin() + std::min(before.size(), text.size()),
                    text.begin())
          .first -
      before.begin());
  if (same < before.size()) file_.cutTo(same);
  if (same < text.size()) file_.append(text.substr(same));
  if (ahead_.empty()) std::remove(aheadOf(path_).c_str());
}

void OrderedCsv::keepOnly(const std::vector<bool>& indices) {
  std::map<size_t, std::string> blocks = parse(file_.read(), path_, true);
  blocks.insert(ahead_.begin(), ahead_.end());
  for (auto block = blocks.begin(); block != blocks.end();) {
    block = indices[block->first] ? std::next(block) : blocks.erase(block);
  }
  settle(std::move(blocks));
}

void OrderedCsv::add(size_t index, const std::string& block) {
  if (index != next_) {
    if (!path_.empty()) {
      DurableFile ahead = DurableFile::open(aheadOf(path_));
      ahead.append((ahead_.empty() ? layout_.header + "\n" : "") + block);
    }
    ahead_[index] = block;
    return;
  }
  std::string text = block;
  size_t end = next_ + 1;  // of the blocks whose turn it is
  for (auto waiting = ahead_.find(end); waiting != ahead_.end(); waiting = ahead_.find(end)) {
    text += waiting->second;
    ++end;
  }
  file_.append(text);
  next_ = end;
  ahead_.erase(ahead_.begin(), ahead_.lower_bound(next_));
  if (ahead_.empty() && !path_.empty()) std::remove(aheadOf(path_).c_str());
}

bool OrderedCsv::holdsLines(const std::string& path) {
  const auto holds = [](const std::string& file) {
    return contentOf(file).find('\n') != std::string::npos;
  };
  return holds(path) || holds(aheadOf(path));
}

}  // namespace pomdp_crowd_nav
