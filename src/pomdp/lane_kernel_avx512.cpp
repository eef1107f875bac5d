// SPDX-License-Identifier: BSD-3-Clause
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
// Everything that may be emitted out of line comes before the target: the linker keeps one copy of
// such a function, and it must run anywhere. What lane_kernel.h adds is always inlined.
#include "pomdp_crowd_nav/pomdp/crowd_futures.h"
#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"

#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw")

#define PCN_HAS_AVX512  // for lanes.h; the compiler's own macro is not set by the pragma everywhere
#include "pomdp_crowd_nav/pomdp/lane_kernel.h"

#define PCN_KERNEL kLaneKernelAvx512
#define PCN_KERNEL_NAME "avx512"
#define PCN_VALUE Float16
#include "lane_kernel_body.h"

#endif
