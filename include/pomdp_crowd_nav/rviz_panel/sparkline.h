// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <optional>

#include "pomdp_crowd_nav/ros/panel/cycle_history.h"

namespace pomdp_crowd_nav {

// Draws the time of each of the newest decisions as a bar, the late ones in red, and the deadline
// as a line.
class Sparkline : public QWidget {
 public:
  static constexpr QRgb kInTime = 0xff4a7fb5, kLate = 0xffc0392b, kDeadline = 0xffd98200;

  explicit Sparkline(QWidget* parent = nullptr);

  void show(const CycleHistory& history, std::optional<double> deadline);
  QSize sizeHint() const override { return {240, 64}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  CycleHistory history_;
  std::optional<double> deadline_;  // [s]
};

}  // namespace pomdp_crowd_nav
