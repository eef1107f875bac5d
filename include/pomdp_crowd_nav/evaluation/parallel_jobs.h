// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace pomdp_crowd_nav {

// Hands a job's result on.
using Delivery = std::function<void()>;
// Does the job of a number; called from several threads at once.
using Job = std::function<Delivery(size_t)>;

// Does the jobs 0 .. count - 1 on `threads` threads, begun in order. Every delivery is called as
// soon as it is there, never two at once. An exception ends it all and is thrown on: of a job after
// what else is done has been delivered, of a delivery at once, for it may have done half of its
// work.
void runJobs(size_t count, int threads, const Job& job);

}  // namespace pomdp_crowd_nav
