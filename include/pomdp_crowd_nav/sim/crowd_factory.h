// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/sim/crowd.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {

// Names that makeCrowd knows.
std::vector<std::string> crowdNames();

// Throws std::invalid_argument unless there is a crowd of that name, listing those there are.
void requireKnownCrowd(const std::string& name);

// People who are generated. Throws std::invalid_argument for an unknown name.
std::unique_ptr<Crowd> makeCrowd(const std::string& name, const World& world,
                                 const CrowdParams& params);

}  // namespace pomdp_crowd_nav
