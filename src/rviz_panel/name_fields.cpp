// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/rviz_panel/name_fields.h"

#include <QFormLayout>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

namespace pomdp_crowd_nav {

NameFields::NameFields(Rename rename, QWidget* parent)
    : QWidget(parent), rename_(std::move(rename)) {
  auto* fold = new QToolButton;
  fold->setObjectName("names_button");
  fold->setText("Nodes");
  fold->setCheckable(true);
  fold->setAutoRaise(true);
  fold->setArrowType(Qt::RightArrow);
  fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  auto* fields = new QWidget;
  auto* form = new QFormLayout(fields);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(2);
  space_ = add(*form, "Namespace", "namespace_field");
  planner_node_ = add(*form, "Planner", "planner_node_field");
  sim_node_ = add(*form, "Simulator", "sim_node_field");
  setNames({});
  fields->setVisible(false);
  QObject::connect(fold, &QToolButton::toggled, fields, [fold, fields](bool is_open) {
    fold->setArrowType(is_open ? Qt::DownArrow : Qt::RightArrow);
    fields->setVisible(is_open);
  });
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(fold);
  rows->addWidget(fields);
}

QLineEdit* NameFields::add(QFormLayout& form, const char* title, const char* name) {
  auto* field = new QLineEdit;
  field->setObjectName(name);
  QObject::connect(field, &QLineEdit::editingFinished, this, [this] { rename_(names()); });
  form.addRow(title, field);
  return field;
}

PanelNames NameFields::names() const {
  PanelNames names;
  names.space = space_->text().trimmed().toStdString();
  names.planner_node = planner_node_->text().trimmed().toStdString();
  names.sim_node = sim_node_->text().trimmed().toStdString();
  return names;
}

void NameFields::setNames(const PanelNames& names) {
  space_->setText(QString::fromStdString(names.space));
  planner_node_->setText(QString::fromStdString(names.planner_node));
  sim_node_->setText(QString::fromStdString(names.sim_node));
}

}  // namespace pomdp_crowd_nav
