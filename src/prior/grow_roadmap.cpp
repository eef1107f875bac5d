// SPDX-License-Identifier: BSD-3-Clause
#include "grow_roadmap.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/ValidStateSampler.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <memory>
#include <random>

namespace pomdp_crowd_nav {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using PlaneState = ob::RealVectorStateSpace::StateType;

constexpr long kDrawsPerMilestone = 100;

Point pointOf(const ob::State* state) {
  const auto* place = state->as<PlaneState>();
  return {place->values[0], place->values[1]};
}

// OMPL prints to the console what is of no interest to a user of this package.
class SilentOmpl {
 public:
  SilentOmpl() : before_(ompl::msg::getOutputHandler()) { ompl::msg::noOutputHandler(); }
  ~SilentOmpl() { ompl::msg::useOutputHandler(before_); }
  SilentOmpl(const SilentOmpl&) = delete;
  SilentOmpl& operator=(const SilentOmpl&) = delete;

 private:
  ompl::msg::OutputHandler* before_;
};

// Draws uniformly, with a generator of its own: OMPL's are seeded once per process.
class MilestoneSource {
 public:
  MilestoneSource(const LineOfSight& sight, const Roadmap::Params& params)
      : sight_(sight),
        spacing_(params.spacing),
        draws_left_(kDrawsPerMilestone * params.milestones),
        random_(static_cast<std::mt19937_64::result_type>(params.seed)) {}

  bool isExhausted() const { return draws_left_ <= 0; }

  bool draw(Point& place) {
    --draws_left_;
    const Bounds& bounds = sight_.map().bounds();
    const Point share(uniform(), uniform());
    place = bounds.min + share.cwiseProduct(bounds.max - bounds.min);
    if (!sight_.isFree(place)) return false;
    const auto is_close = [&](const Point& p) { return (p - place).norm() < spacing_; };
    if (std::any_of(found_.begin(), found_.end(), is_close)) return false;
    found_.push_back(place);
    return true;
  }

 private:
  // In [0, 1), the same with every standard library.
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }

  const LineOfSight& sight_;
  double spacing_;
  long draws_left_;
  std::mt19937_64 random_;
  std::vector<Point> found_;
};

class MilestoneSampler : public ob::ValidStateSampler {
 public:
  MilestoneSampler(const ob::SpaceInformation* space, MilestoneSource& source)
      : ob::ValidStateSampler(space), source_(source) {}

  bool sample(ob::State* state) override {
    Point place;
    if (source_.isExhausted() || !source_.draw(place)) return false;
    state->as<PlaneState>()->values[0] = place.x();
    state->as<PlaneState>()->values[1] = place.y();
    return true;
  }

  // Not called while a roadmap grows.
  bool sampleNear(ob::State* state, const ob::State*, double) override { return sample(state); }

 private:
  MilestoneSource& source_;
};

class EdgeValidator : public ob::MotionValidator {
 public:
  EdgeValidator(const ob::SpaceInformationPtr& space, const LineOfSight& sight)
      : ob::MotionValidator(space), sight_(sight) {}

  // Both ways, which stride over different points.
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const Point a = pointOf(from);
    const Point b = pointOf(to);
    return sight_.isClear(a, b) && sight_.isClear(b, a);
  }

  // Not called by PRM, which takes a motion whole or not at all.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>&) const override {
    return checkMotion(from, to);
  }

 private:
  const LineOfSight& sight_;
};

ob::SpaceInformationPtr makeSpace(const LineOfSight& sight, MilestoneSource& source) {
  const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  for (unsigned axis = 0; axis < 2; ++axis) {
    bounds.setLow(axis, sight.map().bounds().min[axis]);
    bounds.setHigh(axis, sight.map().bounds().max[axis]);
  }
  plane->setBounds(bounds);
  auto space = std::make_shared<ob::SpaceInformation>(plane);
  space->setStateValidityChecker(
      [&sight](const ob::State* state) { return sight.isFree(pointOf(state)); });
  space->setMotionValidator(std::make_shared<EdgeValidator>(space, sight));
  space->setValidStateSamplerAllocator([&source](const ob::SpaceInformation* of) {
    return std::make_shared<MilestoneSampler>(of, source);
  });
  space->setup();
  return space;
}

GrownRoadmap copyOf(const og::PRM::Graph& graph) {
  GrownRoadmap grown;
  const auto states = boost::get(og::PRM::vertex_state_t(), graph);
  for (const auto vertex : boost::make_iterator_range(boost::vertices(graph))) {
    grown.milestones.push_back(pointOf(states[vertex]));
  }
  for (const auto edge : boost::make_iterator_range(boost::edges(graph))) {
    const int from = static_cast<int>(boost::source(edge, graph));
    const int to = static_cast<int>(boost::target(edge, graph));
    grown.edges.push_back({from, to, (grown.milestones[from] - grown.milestones[to]).norm()});
  }
  return grown;
}

}  // namespace

GrownRoadmap growRoadmap(const LineOfSight& sight, const Roadmap::Params& params) {
  const SilentOmpl silent;
  MilestoneSource source(sight, params);
  const ob::SpaceInformationPtr space = makeSpace(sight, source);
  const auto problem = std::make_shared<ob::ProblemDefinition>(space);
  problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(space));
  og::PRM prm(space);
  prm.setProblemDefinition(problem);
  prm.setMaxNearestNeighbors(static_cast<unsigned>(params.neighbours));
  prm.setup();
  const auto wanted = static_cast<unsigned long>(params.milestones);
  prm.growRoadmap(ob::PlannerTerminationCondition(
      [&] { return source.isExhausted() || prm.milestoneCount() >= wanted; }));
  return copyOf(prm.getRoadmap());
}

}  // namespace pomdp_crowd_nav
