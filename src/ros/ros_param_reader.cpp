// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/ros_param_reader.h"

#include <ros/node_handle.h>

#include <cmath>
#include <optional>
#include <sstream>

namespace pomdp_crowd_nav {
namespace {

using XmlRpc::XmlRpcValue;

std::string toText(const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeString) {
    return static_cast<std::string>(XmlRpcValue(value));
  }
  std::ostringstream text;
  value.write(text);
  return text.str();
}

std::optional<double> toDouble(XmlRpcValue value) {
  if (value.getType() == XmlRpcValue::TypeInt) return static_cast<int>(value);
  if (value.getType() != XmlRpcValue::TypeDouble) return std::nullopt;
  const double number = static_cast<double>(value);
  return std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}

std::optional<std::vector<double>> toNumbers(XmlRpcValue value) {
  if (value.getType() != XmlRpcValue::TypeArray) return std::nullopt;
  std::vector<double> numbers;
  for (int i = 0; i < value.size(); ++i) {
    const std::optional<double> number = toDouble(value[i]);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

bool holdsStructs(XmlRpcValue value) {
  if (value.getType() != XmlRpcValue::TypeArray) return false;
  for (int i = 0; i < value.size(); ++i) {
    if (value[i].getType() == XmlRpcValue::TypeStruct) return true;
  }
  return false;
}

XmlRpcValue parametersOf(const ros::NodeHandle& node) {
  XmlRpcValue tree;
  if (!node.getParam(node.getNamespace(), tree)) return XmlRpcValue();
  return tree;
}

}  // namespace

RosParamReader::RosParamReader(const ros::NodeHandle& node)
    : RosParamReader(parametersOf(node), node.getNamespace()) {}

RosParamReader::RosParamReader(const XmlRpcValue& tree, const std::string& source)
    : source_(source) {
  if (tree.valid()) addLeaves("", tree);
}

void RosParamReader::addLeaves(const std::string& key, const XmlRpcValue& value) {
  XmlRpcValue node = value;  // its accessors are not const
  const std::string prefix = key.empty() ? "" : key + "/";
  if (node.getType() == XmlRpcValue::TypeStruct) {
    for (auto& member : node) addLeaves(prefix + member.first, member.second);
  } else if (holdsStructs(node)) {
    for (int i = 0; i < node.size(); ++i) addLeaves(prefix + std::to_string(i), node[i]);
  } else {
    leaves_[key] = value;
  }
}

const XmlRpcValue* RosParamReader::find(const std::string& key) const {
  const auto leaf = leaves_.find(key);
  return leaf == leaves_.end() ? nullptr : &leaf->second;
}

bool RosParamReader::get(const std::string& key, double& value) const {
  const XmlRpcValue* found = find(key);
  if (!found) return false;
  const std::optional<double> number = toDouble(*found);
  if (!number) fail(key, "a finite number", toText(*found));
  value = *number;
  return true;
}

bool RosParamReader::get(const std::string& key, int& value) const {
  const XmlRpcValue* found = find(key);
  if (!found) return false;
  if (found->getType() != XmlRpcValue::TypeInt) fail(key, "an integer", toText(*found));
  value = static_cast<int>(XmlRpcValue(*found));
  return true;
}

bool RosParamReader::get(const std::string& key, bool& value) const {
  const XmlRpcValue* found = find(key);
  if (!found) return false;
  if (found->getType() != XmlRpcValue::TypeBoolean) fail(key, "true or false", toText(*found));
  value = static_cast<bool>(XmlRpcValue(*found));
  return true;
}

bool RosParamReader::get(const std::string& key, std::string& value) const {
  const XmlRpcValue* found = find(key);
  if (!found) return false;
  if (found->getType() != XmlRpcValue::TypeString) fail(key, "a text", toText(*found));
  value = toText(*found);
  return true;
}

bool RosParamReader::get(const std::string& key, std::vector<double>& value) const {
  const XmlRpcValue* found = find(key);
  if (!found) return false;
  const auto numbers = toNumbers(*found);
  if (!numbers) fail(key, "a list of finite numbers", toText(*found));
  value = *numbers;
  return true;
}

bool RosParamReader::get(const std::string& key, std::vector<std::vector<double>>& value) const {
  const XmlRpcValue* found = find(key);
  if (!found) return false;
  XmlRpcValue rows = *found;
  const char* expected = "a list of lists of finite numbers";
  if (rows.getType() != XmlRpcValue::TypeArray) fail(key, expected, toText(rows));
  value.clear();
  for (int i = 0; i < rows.size(); ++i) {
    const auto numbers = toNumbers(rows[i]);
    if (!numbers) fail(key, expected, toText(rows));
    value.push_back(*numbers);
  }
  return true;
}

std::vector<std::string> RosParamReader::keys() const {
  std::vector<std::string> names;
  for (const auto& leaf : leaves_) names.push_back(leaf.first);
  return names;
}

}  // namespace pomdp_crowd_nav
