// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/process_memory.h"

#include <malloc.h>

namespace pomdp_crowd_nav {

void returnLargeBlocks() {
#ifdef __GLIBC__
  constexpr int kLarge = 128 * 1024;  // [B], glibc's own threshold before it adapts
  mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

}  // namespace pomdp_crowd_nav
