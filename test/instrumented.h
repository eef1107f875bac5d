// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pomdp_crowd_nav {

// Whether scripts/sanitize.sh has built this. Nodes are then several times slower, and a robot
// whose decisions or people come late rests, as it should: tests do not ask it to keep moving.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsInstrumented = true;
#else
constexpr bool kIsInstrumented = false;
#endif

}  // namespace pomdp_crowd_nav
