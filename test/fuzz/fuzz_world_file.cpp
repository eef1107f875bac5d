// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "fuzz_file.h"
#include "pomdp_crowd_nav/prior/grid_frame.h"
#include "pomdp_crowd_nav/sim/corner_crowd.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kResolution = 0.5;  // [m]

void checkWorld(const World& world) {
  const StaticMap map = world.map();
  promise(world.start.position.allFinite() && std::isfinite(world.start.heading), "finite start");
  promise(map.bounds().contains(world.start.position), "start inside the bounds");
  promise(map.bounds().contains(world.goal), "goal inside the bounds");
  promise(map.clearance(world.start.position) > 0.0, "start outside obstacles");
  promise(map.clearance(world.goal) > 0.0, "goal outside obstacles");
  promise(!world.destinations.empty(), "destinations");
  for (const Point& destination : world.destinations) {
    promise(destination.allFinite(), "finite destinations");
  }
  const GridFrame grid = coveringGrid(map.bounds(), kResolution);
  promise(grid.columns > 0 && grid.rows > 0, "cells");
}

void checkCrowd(const World& world) {
  CornerCrowd::Params params;
  params.pedestrians = 3;
  CornerCrowd crowd(world, params);
  for (int i = 0; i < 3; ++i) crowd.tick();
  for (const Walker& walker : crowd.walkers())
    promise(walker.position.allFinite(), "finite people");
}

}  // namespace
}  // namespace pomdp_crowd_nav

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size) {
  using namespace pomdp_crowd_nav;
  const FuzzFile file(data, size);
  try {
    const World world = loadWorld(file.path());
    checkWorld(world);
    checkCrowd(world);
  } catch (const std::runtime_error&) {     // refused: file, key and value are named
  } catch (const std::invalid_argument&) {  // refused by the map or the crowd
  }
  return 0;
}
