// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/yaml_param_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "pomdp_crowd_nav/params/file_errors.h"
#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kDeepest = 16;
constexpr int kMostNodes = 1000000;  // an alias counts as what it stands for

bool isPlainScalar(const YAML::Node& node) { return node.IsScalar() && node.Tag() != "!"; }

bool holdsMaps(const YAML::Node& node) {
  if (!node.IsSequence()) return false;
  return std::any_of(node.begin(), node.end(), [](const YAML::Node& item) { return item.IsMap(); });
}

// The node on one line, for messages.
std::string toText(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  if (node.IsNull()) return "";
  std::string text;
  for (const YAML::Node& item : node) text += (text.empty() ? "" : ", ") + toText(item);
  return "[" + text + "]";
}

// Whether the document, with its aliases written out, is of a size to be walked through; one that
// holds an alias of itself has none.
bool isModest(const YAML::Node& node, int depth, int& left) {
  if (depth > kDeepest || --left < 0) return false;
  if (!node.IsSequence() && !node.IsMap()) return true;
  return std::all_of(node.begin(), node.end(), [&](const auto& item) {
    if (node.IsSequence()) return isModest(item, depth + 1, left);
    return isModest(item.first, depth + 1, left) && isModest(item.second, depth + 1, left);
  });
}

std::string excess() {
  return fmt::format("nested more than {} deep or more than {} values", kDeepest, kMostNodes);
}

std::optional<double> toDouble(const YAML::Node& node) {
  return isPlainScalar(node) ? parseDouble(node.Scalar()) : std::nullopt;
}

std::optional<bool> toBool(const YAML::Node& node) {
  if (!isPlainScalar(node)) return std::nullopt;
  const std::string& text = node.Scalar();
  if (text == "true" || text == "True" || text == "TRUE") return true;
  if (text == "false" || text == "False" || text == "FALSE") return false;
  return std::nullopt;
}

std::optional<std::vector<double>> toNumbers(const YAML::Node& node) {
  if (!node.IsSequence()) return std::nullopt;
  std::vector<double> numbers;
  for (const YAML::Node& item : node) {
    const std::optional<double> number = toDouble(item);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

YamlParamReader YamlParamReader::fromFile(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad()) {
    throw std::runtime_error(cannotBeRead(path));
  }
  return fromText(text.str(), path);
}

YamlParamReader YamlParamReader::fromText(const std::string& text, const std::string& source) {
  YamlParamReader reader(source);
  try {
    const YAML::Node root = YAML::Load(text);
    int left = kMostNodes;
    if (!isModest(root, 0, left)) throw std::runtime_error(fmt::format("{}: {}", source, excess()));
    if (!root.IsNull() && !root.IsMap()) reader.failAt(root.Mark(), "expected 'key: value' lines");
    if (root.IsMap()) reader.addMap("", root);
  } catch (const YAML::Exception& error) {
    reader.failAt(error.mark, error.msg);
  }
  return reader;
}

void YamlParamReader::replace(const std::string& assignment) {
  const size_t sign = assignment.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == assignment.size()) {
    throw std::runtime_error(fmt::format("expected KEY=VALUE, got '{}'", assignment));
  }
  const std::string key = assignment.substr(0, sign);
  source_ += fmt::format(" with {}", assignment);
  try {
    const YAML::Node value = YAML::Load(assignment.substr(sign + 1));
    int left = kMostNodes;
    if (!isModest(value, 0, left)) {
      throw std::runtime_error(fmt::format("{}: {}", source_, excess()));
    }
    leaves_.erase(key);
    addLeaves(key, value);
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", source_, error.msg));
  }
}

std::map<std::string, std::string> YamlParamReader::texts() const {
  std::map<std::string, std::string> texts;
  for (const auto& [key, node] : leaves_) texts[key] = toText(node);
  return texts;
}

void YamlParamReader::addMap(const std::string& prefix, const YAML::Node& node) {
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) failAt(entry.first.Mark(), "a key must be a word");
    addLeaves(prefix + entry.first.Scalar(), entry.second);
  }
}

void YamlParamReader::addLeaves(const std::string& key, const YAML::Node& node) {
  if (node.IsMap()) {
    addMap(key + "/", node);
  } else if (holdsMaps(node)) {
    size_t index = 0;
    for (const YAML::Node& item : node) addLeaves(fmt::format("{}/{}", key, index++), item);
  } else if (!leaves_.emplace(key, node).second) {
    failAt(node.Mark(), fmt::format("key '{}' is given twice", key));
  }
}

const YAML::Node* YamlParamReader::find(const std::string& key) const {
  const auto leaf = leaves_.find(key);
  return leaf == leaves_.end() ? nullptr : &leaf->second;
}

bool YamlParamReader::get(const std::string& key, double& value) const {
  const YAML::Node* node = find(key);
  if (!node) return false;
  const std::optional<double> number = toDouble(*node);
  if (!number) fail(key, "a finite number", toText(*node));
  value = *number;
  return true;
}

bool YamlParamReader::get(const std::string& key, int& value) const {
  const YAML::Node* node = find(key);
  if (!node) return false;
  const auto number = isPlainScalar(*node) ? parseInteger(node->Scalar()) : std::nullopt;
  using Limits = std::numeric_limits<int>;
  if (!number || *number < Limits::min() || *number > Limits::max()) {
    fail(key, fmt::format("an integer from {} to {}", Limits::min(), Limits::max()), toText(*node));
  }
  value = static_cast<int>(*number);
  return true;
}

bool YamlParamReader::get(const std::string& key, bool& value) const {
  const YAML::Node* node = find(key);
  if (!node) return false;
  const std::optional<bool> truth = toBool(*node);
  if (!truth) fail(key, "true or false", toText(*node));
  value = *truth;
  return true;
}

bool YamlParamReader::get(const std::string& key, std::string& value) const {
  const YAML::Node* node = find(key);
  if (!node) return false;
  if (!node->IsScalar()) fail(key, "a text", toText(*node));
  value = node->Scalar();
  return true;
}

bool YamlParamReader::get(const std::string& key, std::vector<double>& value) const {
  const YAML::Node* node = find(key);
  if (!node) return false;
  const auto numbers = toNumbers(*node);
  if (!numbers) fail(key, "a list of finite numbers", toText(*node));
  value = *numbers;
  return true;
}

bool YamlParamReader::get(const std::string& key, std::vector<std::vector<double>>& value) const {
  const YAML::Node* node = find(key);
  if (!node) return false;
  if (!node->IsSequence()) fail(key, "a list of lists of finite numbers", toText(*node));
  value.clear();
  for (const YAML::Node& row : *node) {
    const auto numbers = toNumbers(row);
    if (!numbers) fail(key, "a list of lists of finite numbers", toText(row));
    value.push_back(*numbers);
  }
  return true;
}

std::vector<std::string> YamlParamReader::keys() const {
  std::vector<std::string> names;
  for (const auto& leaf : leaves_) names.push_back(leaf.first);
  return names;
}

void YamlParamReader::failAt(const YAML::Mark& mark, const std::string& reason) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", source_, mark.line + 1, reason));
}

}  // namespace pomdp_crowd_nav
