// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/lane_kernel.h"

namespace pomdp_crowd_nav {

extern const LaneKernel kLaneKernelBaseline;
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
extern const LaneKernel kLaneKernelAvx2;
extern const LaneKernel kLaneKernelAvx512;
#endif

std::vector<const LaneKernel*> laneKernels() {
  std::vector<const LaneKernel*> kernels{&kLaneKernelBaseline};
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  if (__builtin_cpu_supports("avx2")) kernels.push_back(&kLaneKernelAvx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw")) {
    kernels.push_back(&kLaneKernelAvx512);
  }
#endif
  return kernels;
}

const LaneKernel& laneKernel() {
  static const LaneKernel& widest = *laneKernels().back();
  return widest;
}

}  // namespace pomdp_crowd_nav
