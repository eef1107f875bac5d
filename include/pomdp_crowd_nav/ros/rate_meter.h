// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace pomdp_crowd_nav {

// How often something happened lately: over the last events, and over the silence since.
class RateMeter {
 public:
  // `now` [s], steady clock.
  void count(double now) {
    times_[next_] = now;
    next_ = (next_ + 1) % times_.size();
    size_ = std::min(size_ + 1, times_.size());
  }

  // [Hz]; 0 before the second event.
  double rate(double now) const {
    if (size_ < 2) return 0.0;
    const double oldest = times_[(next_ + times_.size() - size_) % times_.size()];
    const double duration = std::max(now, last()) - oldest;
    return duration > 0.0 ? static_cast<double>(size_ - 1) / duration : 0.0;
  }

  // [s] moment of the last event; negative: none yet.
  double last() const {
    return size_ == 0 ? -1.0 : times_[(next_ + times_.size() - 1) % times_.size()];
  }

 private:
  std::array<double, 50> times_{};
  size_t next_ = 0, size_ = 0;
};

}  // namespace pomdp_crowd_nav
