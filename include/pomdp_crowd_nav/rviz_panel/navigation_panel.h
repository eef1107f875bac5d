// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

#include <QTimer>

#include "pomdp_crowd_nav/ros/panel/panel_session.h"

namespace pomdp_crowd_nav {

class PanelView;

// RViz's panel for planner_node and sim_node. It joins a PanelSession and its widgets, and keeps
// names of nodes and the values for a reset in the .rviz file.
class NavigationPanel : public rviz::Panel {
 public:
  explicit NavigationPanel(QWidget* parent = nullptr);

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void refresh();
  void rename(const PanelNames& names);

  PanelSession session_;
  PanelView* view_;
  QTimer timer_;
};

}  // namespace pomdp_crowd_nav
