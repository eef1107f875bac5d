// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace pomdp_crowd_nav {

// Four neighbours of a table and the surface over the unit square between them: two triangles, cut
// along the diagonal that makes the steeper of the two as flat as can be. Neighbouring squares
// meet without a step, and a fold of the surface costs no slope, as it does in bilinear
// interpolation.
class Quad {
 public:
  // `lower_left` points to the first value of two, `columns` before the other two.
  Quad(const float* lower_left, int columns)
      : lower_left_(lower_left[0]),
        upper_right_(lower_left[columns + 1]),
        bottom_(lower_left[1] - lower_left[0]),
        top_(lower_left[columns + 1] - lower_left[columns]),
        left_(lower_left[columns] - lower_left[0]),
        right_(lower_left[columns + 1] - lower_left[1]) {}

  // Squared length of the steeper gradient.
  float slopeSq() const { return std::min(risingSlopeSq(), fallingSlopeSq()); }

  // `x` and `y` in [0, 1] from the lower left corner.
  float at(float x, float y) const {
    if (risingSlopeSq() <= fallingSlopeSq()) {
      return lower_left_ + (x >= y ? x * bottom_ + y * right_ : x * top_ + y * left_);
    }
    if (x + y <= 1.0F) return lower_left_ + x * bottom_ + y * left_;
    return upper_right_ - (1.0F - x) * top_ - (1.0F - y) * right_;
  }

 private:
  // Cut from the lower left to the upper right corner, or along the other diagonal.
  float risingSlopeSq() const {
    return std::max(bottom_ * bottom_ + right_ * right_, top_ * top_ + left_ * left_);
  }
  float fallingSlopeSq() const {
    return std::max(bottom_ * bottom_ + left_ * left_, top_ * top_ + right_ * right_);
  }

  float lower_left_, upper_right_;
  float bottom_, top_, left_, right_;  // differences along the edges
};

}  // namespace pomdp_crowd_nav
