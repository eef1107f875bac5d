// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/lane_kernel.h"
#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"

#define PCN_KERNEL kLaneKernelBaseline
#define PCN_KERNEL_NAME "baseline"
#define PCN_VALUE Float4
#include "lane_kernel_body.h"
