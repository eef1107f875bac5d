// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/crowd_factory.h"

#include <fmt/format.h>

#include <stdexcept>

#include "pomdp_crowd_nav/params/closest_name.h"
#include "pomdp_crowd_nav/sim/corner_crowd.h"

namespace pomdp_crowd_nav {
namespace {

template <class SomeCrowd>
std::unique_ptr<Crowd> make(const World& world, const CrowdParams& params) {
  return std::make_unique<SomeCrowd>(world, params);
}

struct Entry {
  const char* name;
  std::unique_ptr<Crowd> (*make)(const World&, const CrowdParams&);
};

// A new crowd is one more line here.
constexpr Entry kCrowds[] = {
    {"corners", make<CornerCrowd>},
};

const Entry& entryOf(const std::string& name) {
  for (const Entry& entry : kCrowds) {
    if (name == entry.name) return entry;
  }
  const std::vector<std::string> known = crowdNames();
  throw std::invalid_argument(fmt::format("crowd must be one of {}, got '{}'{}",
                                          commaSeparated(known), name, didYouMean(name, known)));
}

}  // namespace

std::vector<std::string> crowdNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kCrowds) names.emplace_back(entry.name);
  return names;
}

void requireKnownCrowd(const std::string& name) { entryOf(name); }

std::unique_ptr<Crowd> makeCrowd(const std::string& name, const World& world,
                                 const CrowdParams& params) {
  return entryOf(name).make(world, params);
}

}  // namespace pomdp_crowd_nav
