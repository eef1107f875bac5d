// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>

#include "pomdp_crowd_nav/ros/panel/panel_names.h"

class QFormLayout;
class QLineEdit;

namespace pomdp_crowd_nav {

// Where the panel's nodes are, folded away until somebody asks for it.
class NameFields : public QWidget {
 public:
  using Rename = std::function<void(const PanelNames&)>;

  // `rename` is called when somebody has finished a name, whether it is another or not.
  explicit NameFields(Rename rename, QWidget* parent = nullptr);

  PanelNames names() const;
  void setNames(const PanelNames& names);

 private:
  QLineEdit* add(QFormLayout& form, const char* title, const char* name);

  Rename rename_;
  QLineEdit *space_ = nullptr, *planner_node_ = nullptr, *sim_node_ = nullptr;
};

}  // namespace pomdp_crowd_nav
