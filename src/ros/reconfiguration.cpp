// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/reconfiguration.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

using dynamic_reconfigure::ConfigTools;

constexpr std::uint32_t kStart = ~0u;  // level of the call that is no client's

std::string nameOf(const std::string& key) {
  std::string name = key;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

// Reads and writes parameters by their keys where dynamic_reconfigure says their names.
ros::NodeHandle withKeys(const ros::NodeHandle& node, const NavigationParams& params) {
  ros::M_string keys;
  for (const auto& entry : valuesOf(params)) {
    if (nameOf(entry.first) != entry.first) keys[nameOf(entry.first)] = entry.first;
  }
  return ros::NodeHandle(node, "", keys);
}

// "reward/goal 1000 -> 500"
std::string differences(const NavigationParams& from, const NavigationParams& to) {
  const ParamValues before = valuesOf(from), after = valuesOf(to);
  std::string text;
  for (const std::string& key : changedKeys(from, to)) {
    text += fmt::format("{}{} {} -> {}", text.empty() ? "" : ", ", key, toText(before.at(key)),
                        toText(after.at(key)));
  }
  return text;
}

}  // namespace

Reconfiguration::Reconfiguration(const ros::NodeHandle& private_node,
                                 const NavigationParams& params, Adopt adopt)
    : params_(params), adopt_(std::move(adopt)), server_(withKeys(private_node, params)) {
  server_.setCallback(
      [this](PlannerConfig& config, std::uint32_t level) { onChange(config, level); });
}

void Reconfiguration::onChange(PlannerConfig& config, std::uint32_t level) {
  const std::string reason = level == kStart ? "" : change(config);
  if (!reason.empty()) ROS_WARN("parameters stay as they were: %s", reason.c_str());
  config = present();
}

// Returns why not, if not.
std::string Reconfiguration::change(const PlannerConfig& config) {
  try {
    const NavigationParams changed = withValues(params_, valuesIn(config));
    const std::string what = differences(params_, changed);
    if (what.empty()) return "";
    const std::string reason = adopt_(changed);
    if (!reason.empty()) return reason;
    params_ = changed;
    ROS_INFO("parameters changed: %s", what.c_str());
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

ParamValues Reconfiguration::valuesIn(const PlannerConfig& config) const {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  ParamValues values;
  for (auto [key, value] : valuesOf(params_)) {
    const std::string name = nameOf(key);
    const bool is_there =
        std::visit([&](auto& it) { return ConfigTools::getParameter(message, name, it); }, value);
    if (is_there) values[key] = value;
  }
  return values;
}

PlannerConfig Reconfiguration::present() const {
  PlannerConfig config;
  dynamic_reconfigure::Config message;
  PlannerConfig::__getDefault__().__toMessage__(message);
  for (const auto& entry : valuesOf(params_)) {
    const std::string name = nameOf(entry.first);
    const auto put = [&](const auto& value) {
      for (auto& parameter : ConfigTools::getVectorForType(message, value)) {
        if (parameter.name == name) parameter.value = value;
      }
    };
    std::visit(put, entry.second);
  }
  config.__fromMessage__(message);
  return config;
}

}  // namespace pomdp_crowd_nav
