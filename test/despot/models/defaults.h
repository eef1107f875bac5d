// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pomdp_crowd_nav {

// How much the default policies of a model know of its problem.
enum class Defaults {
  kPlain,  // next to nothing: what is earned is the search's own work
  kSmart,  // close to the best there is
};

}  // namespace pomdp_crowd_nav
