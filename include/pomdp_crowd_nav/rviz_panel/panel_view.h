// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/ros/panel/panel_session.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLayout;
class QPushButton;
class QSpinBox;

namespace pomdp_crowd_nav {

class NameFields;
class Sparkline;

// The widgets of the panel, and no more. Each has an object name, by which tests find it.
class PanelView : public QWidget {
 public:
  struct Actions {
    std::function<void()> start, pause, stop;
    std::function<void(const std::string&)> choose_planner;
    std::function<void(const ResetRequest&)> reset;
    std::function<void(const PanelNames&)> rename;
    std::function<void()> settings_changed;  // of the reset
  };

  explicit PanelView(Actions actions, QWidget* parent = nullptr);

  void show(const PanelPicture& picture);

  ResetRequest resetRequest() const;
  void setResetRequest(const ResetRequest& request);
  NameFields& names() { return *names_; }

 private:
  QLayout* makeDriving();
  QLayout* makeSimulation();
  QLayout* makeStatus();
  QLabel* addRow(QFormLayout* rows, const char* title, const char* name);
  void showPlanners(const PanelPicture& picture);
  void showTexts(const StatusTexts& texts);

  Actions actions_;
  QComboBox* planner_ = nullptr;
  QPushButton *start_ = nullptr, *pause_ = nullptr, *stop_ = nullptr, *reset_ = nullptr;
  QSpinBox *seed_ = nullptr, *people_ = nullptr;
  QLabel *state_ = nullptr, *cause_ = nullptr, *message_ = nullptr;
  std::vector<std::pair<QLabel*, std::string StatusTexts::*>> rows_;
  Sparkline* sparkline_ = nullptr;
  NameFields* names_ = nullptr;
};

}  // namespace pomdp_crowd_nav
