// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/rviz_panel/panel_view.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <utility>

#include "pomdp_crowd_nav/rviz_panel/name_fields.h"
#include "pomdp_crowd_nav/rviz_panel/sparkline.h"

namespace pomdp_crowd_nav {
namespace {

const char* colourOf(Mood mood) {
  switch (mood) {
    case Mood::kIdle:
      return "#5f6b76";
    case Mood::kDriving:
      return "#2e7d32";
    case Mood::kWaiting:
      return "#b26a00";
    case Mood::kTrouble:
      return "#b3261e";
    default:
      return "#8a8f94";
  }
}

// The wheel scrolls what is around it; it does not choose another planner in passing.
class Choice : public QComboBox {
 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

void showControl(QWidget* widget, const Control& control) {
  widget->setEnabled(control.is_enabled);
  widget->setToolTip(QString::fromStdString(control.tooltip));
}

QPushButton* makeButton(const char* title, const char* name, const std::function<void()>& action) {
  auto* button = new QPushButton(title);
  button->setObjectName(name);
  button->setMinimumWidth(40);
  button->setFocusPolicy(Qt::NoFocus);  // no key starts a robot
  QObject::connect(button, &QPushButton::clicked, button, action);
  return button;
}

QLabel* makeText(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  // Text of any length wraps in the width that the dock has.
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  return label;
}

QFormLayout* makeForm() {
  auto* form = new QFormLayout;
  form->setLabelAlignment(Qt::AlignLeft);
  form->setVerticalSpacing(2);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  return form;
}

}  // namespace

PanelView::PanelView(Actions actions, QWidget* parent)
    : QWidget(parent), actions_(std::move(actions)) {
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(6, 6, 6, 6);
  all->setSpacing(6);
  state_ = makeText("state_label");
  state_->setAlignment(Qt::AlignCenter);
  all->addWidget(state_);
  cause_ = makeText("cause_label");
  all->addWidget(cause_);
  all->addLayout(makeDriving());
  all->addLayout(makeStatus());
  sparkline_ = new Sparkline;
  sparkline_->setObjectName("cycle_sparkline");
  all->addWidget(sparkline_);
  all->addLayout(makeSimulation());
  message_ = makeText("message_label");
  all->addWidget(message_);
  names_ = new NameFields(actions_.rename);
  all->addWidget(names_);
  all->addStretch(1);
}

QLayout* PanelView::makeDriving() {
  auto* rows = new QVBoxLayout;
  auto* buttons = new QHBoxLayout;
  start_ = makeButton("Start", "start_button", actions_.start);
  pause_ = makeButton("Pause", "pause_button", actions_.pause);
  stop_ = makeButton("Stop", "stop_button", actions_.stop);
  for (QPushButton* button : {start_, pause_, stop_}) buttons->addWidget(button);
  rows->addLayout(buttons);
  auto* choice = makeForm();
  planner_ = new Choice;
  planner_->setObjectName("planner_choice");
  QObject::connect(planner_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    actions_.choose_planner(planner_->itemText(index).toStdString());
  });
  choice->addRow("Planner", planner_);
  rows->addLayout(choice);
  return rows;
}

QLabel* PanelView::addRow(QFormLayout* rows, const char* title, const char* name) {
  auto* label = makeText(name);
  rows->addRow(title, label);
  return label;
}

QLayout* PanelView::makeStatus() {
  auto* form = makeForm();
  rows_ = {{addRow(form, "Decision", "decision_label"), &StatusTexts::decision},
           {addRow(form, "Too late", "late_label"), &StatusTexts::late},
           {addRow(form, "Odometry", "odometry_label"), &StatusTexts::odometry},
           {addRow(form, "People", "people_label"), &StatusTexts::people},
           {addRow(form, "Map", "map_label"), &StatusTexts::map}};
  return form;
}

QLayout* PanelView::makeSimulation() {
  auto* row = new QHBoxLayout;
  seed_ = new QSpinBox;
  seed_->setObjectName("seed_field");
  seed_->setRange(0, 999999999);
  seed_->setPrefix("seed ");
  people_ = new QSpinBox;
  people_->setObjectName("people_field");
  people_->setRange(-1, 10000);
  people_->setSpecialValueText("as before");
  people_->setSuffix(" people");
  seed_->setToolTip("seed of the crowd after a reset");
  people_->setToolTip("number of people after a reset");
  for (QSpinBox* field : {seed_, people_}) {
    field->setMinimumWidth(60);
    QObject::connect(field, QOverload<int>::of(&QSpinBox::valueChanged), this,
                     [this] { actions_.settings_changed(); });
    row->addWidget(field, 1);
  }
  setResetRequest({});
  reset_ = makeButton("Reset", "reset_button", [this] { actions_.reset(resetRequest()); });
  row->addWidget(reset_);
  return row;
}

void PanelView::show(const PanelPicture& picture) {
  showTexts(picture.texts);
  showControl(planner_, picture.controls.planner);
  showControl(start_, picture.controls.start);
  showControl(pause_, picture.controls.pause);
  showControl(stop_, picture.controls.stop);
  showControl(reset_, picture.controls.reset);
  start_->setText(picture.controls.is_resume ? "Resume" : "Start");
  showPlanners(picture);
  sparkline_->show(picture.cycles, picture.deadline);
  message_->setText(QString::fromStdString(picture.message));
  message_->setVisible(!picture.message.empty());
  message_->setStyleSheet(picture.is_complaint ? "color: #b3261e" : "");
}

void PanelView::showTexts(const StatusTexts& texts) {
  state_->setText(QString::fromStdString(texts.state));
  const QString style =
      QString("color: white; background: %1; padding: 4px; font-weight: bold; border-radius: 3px")
          .arg(colourOf(texts.mood));
  if (state_->styleSheet() != style) state_->setStyleSheet(style);
  cause_->setText(QString::fromStdString(texts.cause));
  cause_->setVisible(!texts.cause.empty());
  for (const auto& [label, text] : rows_) label->setText(QString::fromStdString(texts.*text));
}

// What the planner has, unless somebody is choosing.
void PanelView::showPlanners(const PanelPicture& picture) {
  if (picture.is_busy || planner_->view()->isVisible()) return;
  QStringList names;
  for (const std::string& name : picture.planners) names << QString::fromStdString(name);
  const QString present = QString::fromStdString(picture.planner);
  if (!present.isEmpty() && !names.contains(present)) names << present;
  QStringList shown;
  for (int i = 0; i < planner_->count(); ++i) shown << planner_->itemText(i);
  if (shown != names) {
    planner_->clear();
    planner_->addItems(names);
  }
  planner_->setCurrentIndex(names.indexOf(present));
}

ResetRequest PanelView::resetRequest() const {
  ResetRequest request;
  request.pedestrians = people_->value();
  request.seed = static_cast<std::uint64_t>(seed_->value());
  return request;
}

void PanelView::setResetRequest(const ResetRequest& request) {
  people_->setValue(request.pedestrians);
  seed_->setValue(static_cast<int>(request.seed));
}

}  // namespace pomdp_crowd_nav
