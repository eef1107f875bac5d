// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTest>
#include <functional>
#include <memory>
#include <pluginlib/class_loader.hpp>
#include <stdexcept>
#include <string>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {

// The panel as RViz makes it: found by pluginlib, and configured.
class PanelRig {
 public:
  explicit PanelRig(const std::string& space) : loader_("rviz", "rviz::Panel") {
    panel_.reset(loader_.createUnmanagedInstance("pomdp_crowd_nav/NavigationPanel"));
    rviz::Config config;
    config.mapSetValue("Namespace", QString::fromStdString(space));
    panel_->load(config);
    panel_->resize(300, 480);
    panel_->show();
  }

  rviz::Panel& panel() { return *panel_; }

  template <class Widget>
  Widget* find(const char* name) {
    auto* widget = panel_->findChild<Widget*>(name);
    if (!widget) throw std::runtime_error(std::string("the panel has no ") + name);
    return widget;
  }

  std::string text(const char* label) { return find<QLabel>(label)->text().toStdString(); }
  std::string tooltip(const char* widget) { return find<QWidget>(widget)->toolTip().toStdString(); }
  bool isEnabled(const char* widget) { return find<QWidget>(widget)->isEnabled(); }

  // With the mouse, so that what is grey does nothing.
  void click(const char* button) {
    QTest::mouseClick(find<QAbstractButton>(button), Qt::LeftButton);
  }

  // As somebody who opens the list and takes an entry.
  void choose(const std::string& planner) {
    auto* choice = find<QComboBox>("planner_choice");
    const int index = choice->findText(QString::fromStdString(planner));
    if (index < 0) throw std::runtime_error("the panel does not offer " + planner);
    choice->setCurrentIndex(index);
    Q_EMIT choice->activated(index);
  }

  bool waitUntil(double timeout, const std::function<bool()>& condition) {
    const double give_up = steadySeconds() + timeout;
    while (steadySeconds() < give_up) {
      QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
      if (condition()) return true;
      QTest::qSleep(5);
    }
    return condition();
  }

  bool waitForEnabled(const char* widget) {
    return waitUntil(10.0, [&] { return isEnabled(widget); });
  }

  bool waitForText(const char* label, const std::string& part, double timeout = 10.0) {
    return waitUntil(timeout, [&] { return text(label).find(part) != std::string::npos; });
  }

 private:
  pluginlib::ClassLoader<rviz::Panel> loader_;  // outlives what it has loaded
  std::unique_ptr<rviz::Panel> panel_;
};

// Draws without a screen.
inline int runPanelTests(int argc, char** argv, const char* name) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  ros::init(argc, argv, name);
  const ros::NodeHandle node;  // keeps ROS up between tests
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}

}  // namespace pomdp_crowd_nav
