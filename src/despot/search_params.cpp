// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/despot/search_params.h"

#include <fmt/format.h>

#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

template <class Value>
void require(bool fits, const char* name, const char* expected, Value value) {
  if (fits) return;
  throw std::invalid_argument(fmt::format("search/{} must be {}, got {}", name, expected, value));
}

}  // namespace

void validate(const SearchParams& p) {
  require(p.scenarios >= 1 && p.scenarios <= 65535, "scenarios", "between 1 and 65535",
          p.scenarios);
  require(p.max_depth >= 0 && p.max_depth <= 30000, "max_depth", "between 0 and 30000",
          p.max_depth);
  require(p.discount > 0.0 && p.discount < 1.0, "discount", "in (0, 1)", p.discount);
  require(p.regularization >= 0.0, "regularization", "at least 0", p.regularization);
  require(p.target_gap >= 0.0 && p.target_gap < 1.0, "target_gap", "in [0, 1)", p.target_gap);
  require(p.max_nodes >= 1, "max_nodes", "at least 1", p.max_nodes);
  require(p.max_memory > 0.0, "max_memory", "positive", p.max_memory);
  require(p.threads >= 1 && p.threads <= 64, "threads", "between 1 and 64", p.threads);
}

}  // namespace pomdp_crowd_nav
