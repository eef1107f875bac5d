// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/despot/search_result.h"

namespace pomdp_crowd_nav {

const char* describe(SearchStop stop) {
  switch (stop) {
    case SearchStop::kGapClosed:
      return "gap closed";
    case SearchStop::kTrialLimit:
      return "trial limit";
    case SearchStop::kDeadline:
      return "deadline";
    case SearchStop::kNodeLimit:
      return "node limit";
    case SearchStop::kLowerBound:
      return "lower bound reached";
  }
  return "unknown";
}

}  // namespace pomdp_crowd_nav
