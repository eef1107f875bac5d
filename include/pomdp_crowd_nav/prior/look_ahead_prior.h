// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "pomdp_crowd_nav/prior/rollout_prior.h"

namespace pomdp_crowd_nav {

// Another prior, for a vehicle that cannot turn at once: the direction is that of the place which
// the other prior's path reaches some distance on, so that the vehicle turns before the path does.
class LookAheadPrior : public RolloutPrior {
 public:
  // `distance` [m] along the path; throws std::invalid_argument where it is negative or infinite.
  LookAheadPrior(std::shared_ptr<const RolloutPrior> path, double distance);

  const Point& goal() const override { return path_->goal(); }
  std::optional<double> directionAt(const Pose& pose) const override;
  double distanceToGoal(const Point& position) const override {
    return path_->distanceToGoal(position);
  }

 private:
  std::shared_ptr<const RolloutPrior> path_;
  double distance_;
};

}  // namespace pomdp_crowd_nav
