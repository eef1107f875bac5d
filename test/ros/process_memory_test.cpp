// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/process_memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <thread>

#include "../instrumented.h"

namespace pomdp_crowd_nav {
namespace {

constexpr size_t kBlock = 20'000'000;  // [B]

double residentMegabytes() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0.0;
  double resident = 0.0;
  statm >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

// Twice, as glibc keeps only the second block of a size.
void useAndFree() {
  for (int i = 0; i < 2; ++i) {
    const std::unique_ptr<char[]> block(new char[kBlock]);
    for (size_t byte = 0; byte < kBlock; byte += 1024) {
      static_cast<volatile char*>(block.get())[byte] = 1;
    }
  }
}

TEST(ProcessMemory, LargeBlocksGoBackToTheSystem) {
  if (kIsInstrumented) GTEST_SKIP() << "sanitizers allocate in their own way";
  returnLargeBlocks();
  const double before = residentMegabytes();
  useAndFree();
  std::thread(useAndFree).join();
  EXPECT_LT(residentMegabytes(), before + 5.0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
