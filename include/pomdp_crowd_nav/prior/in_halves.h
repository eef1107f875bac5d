// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <future>

namespace pomdp_crowd_nav {

// Calls work(first, last) for the rows [0, rows) of a grid in two halves, one of them in a thread
// of its own where there is one to be had. The halves must not write to the same place.
template <typename Work>
void inHalves(int rows, const Work& work) {
  std::future<void> upper = std::async(std::launch::async | std::launch::deferred,
                                       [&work, rows] { work(rows / 2, rows); });
  work(0, rows / 2);
  upper.get();
}

}  // namespace pomdp_crowd_nav
