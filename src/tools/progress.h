// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

namespace pomdp_crowd_nav {

// "95 s", "12 min", "2 h 05 min"
inline std::string durationText(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 120) return fmt::format("{} s", whole);
  if (whole < 7200) return fmt::format("{} min", (whole + 30) / 60);
  return fmt::format("{} h {:02d} min", whole / 3600, whole % 3600 / 60);
}

// How much of a long run is done and how long the rest will take, on standard error: a bar on a
// terminal, else a line now and then.
class Progress {
 public:
  // `before`: units that are done already.
  Progress(size_t before, size_t total, const char* unit)
      : before_(before), total_(total), unit_(unit), is_terminal_(isatty(STDERR_FILENO) == 1) {}

  void show(size_t done) {
    const auto now = Clock::now();
    const bool is_last = done == total_;
    const double pause = is_terminal_ ? 0.2 : 10.0;  // [s]
    if (!is_last && std::chrono::duration<double>(now - shown_).count() < pause) return;
    shown_ = now;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double share = static_cast<double>(total_ - done) / static_cast<double>(done - before_);
    const std::string text = fmt::format(
        "{}/{} {}, {}", done, total_, unit_,
        is_last ? durationText(elapsed) + " in all" : durationText(elapsed * share) + " left");
    if (is_terminal_) {
      fmt::print(stderr, "\r{} {:<40}{}", bar(done), text, is_last ? "\n" : "");
      has_open_line_ = !is_last;
    } else {
      fmt::print(stderr, "{}\n", text);
    }
    std::fflush(stderr);
  }

  // Before anything else is written to the terminal.
  void endLine() {
    if (has_open_line_) fmt::print(stderr, "\n");
    has_open_line_ = false;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string bar(size_t done) const {
    constexpr size_t kWidth = 30;
    const size_t full = kWidth * done / total_;
    return "[" + std::string(full, '#') + std::string(kWidth - full, '.') + "]";
  }

  size_t before_;
  size_t total_;
  const char* unit_;
  bool is_terminal_;
  bool has_open_line_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace pomdp_crowd_nav
