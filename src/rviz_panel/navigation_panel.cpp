// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/rviz_panel/navigation_panel.h"

#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

#include "pomdp_crowd_nav/rviz_panel/name_fields.h"
#include "pomdp_crowd_nav/rviz_panel/panel_view.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kRefreshPeriod = 100;  // [ms]

std::string textIn(const rviz::Config& config, const char* key, const std::string& otherwise) {
  QString text;
  return config.mapGetString(key, &text) ? text.trimmed().toStdString() : otherwise;
}

}  // namespace

NavigationPanel::NavigationPanel(QWidget* parent) : rviz::Panel(parent), session_(PanelNames()) {
  PanelView::Actions actions;
  // After a press the panel shows at once that it was heard.
  const auto pressed = [this](auto&& press) {
    press();
    refresh();
  };
  actions.start = [=] { pressed([this] { session_.start(); }); };
  actions.pause = [=] { pressed([this] { session_.pause(); }); };
  actions.stop = [=] { pressed([this] { session_.stop(); }); };
  actions.choose_planner = [=](const std::string& planner) {
    pressed([&] { session_.choosePlanner(planner); });
  };
  actions.reset = [=](const ResetRequest& request) { pressed([&] { session_.reset(request); }); };
  actions.rename = [=](const PanelNames& names) { pressed([&] { rename(names); }); };
  actions.settings_changed = [this] { Q_EMIT configChanged(); };
  view_ = new PanelView(actions);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view_);
  QObject::connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(kRefreshPeriod);
  refresh();
}

void NavigationPanel::refresh() {
  session_.tick();
  view_->show(session_.picture());
}

void NavigationPanel::rename(const PanelNames& names) {
  const bool is_other = !(names == session_.names());
  if (is_other && session_.setNames(names)) Q_EMIT configChanged();
}

void NavigationPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  const PanelNames present;
  PanelNames names;
  names.space = textIn(config, "Namespace", present.space);
  names.planner_node = textIn(config, "Planner Node", present.planner_node);
  names.sim_node = textIn(config, "Simulator Node", present.sim_node);
  view_->names().setNames(names);
  session_.setNames(names);
  ResetRequest request;
  int seed = static_cast<int>(request.seed);
  config.mapGetInt("Seed", &seed);
  config.mapGetInt("People", &request.pedestrians);
  request.seed = static_cast<std::uint64_t>(seed < 0 ? 0 : seed);
  view_->setResetRequest(request);
}

void NavigationPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  const PanelNames& names = session_.names();
  config.mapSetValue("Namespace", QString::fromStdString(names.space));
  config.mapSetValue("Planner Node", QString::fromStdString(names.planner_node));
  config.mapSetValue("Simulator Node", QString::fromStdString(names.sim_node));
  const ResetRequest request = view_->resetRequest();
  config.mapSetValue("Seed", static_cast<int>(request.seed));
  config.mapSetValue("People", request.pedestrians);
}

}  // namespace pomdp_crowd_nav

PLUGINLIB_EXPORT_CLASS(pomdp_crowd_nav::NavigationPanel, rviz::Panel)
