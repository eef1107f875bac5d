// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/params/param_reader.h"

namespace pomdp_crowd_nav {

// Reads parameters from a yaml file.
//
// Types are strict, as on the ROS parameter server: true is no number, 1 is no truth value, "1.5"
// in quotes is a text. Numbers must be finite; an integer is accepted where a real is expected.
class YamlParamReader : public ParamReader {
 public:
  // Both throw std::runtime_error with one line: for a file that cannot be read, for a syntax
  // error (with its line), for a key given twice and for a document that is no map.
  static YamlParamReader fromFile(const std::string& path);
  static YamlParamReader fromText(const std::string& text, const std::string& source);

  // Puts a value, spelt as in yaml, in the place of what the document says of a key. Throws
  // std::runtime_error unless the text is "key=value". From now on messages name the text too.
  void replace(const std::string& assignment);

  // The value of every key on one line, to be compared with another document's.
  std::map<std::string, std::string> texts() const;

 protected:
  bool get(const std::string& key, double& value) const override;
  bool get(const std::string& key, int& value) const override;
  bool get(const std::string& key, bool& value) const override;
  bool get(const std::string& key, std::string& value) const override;
  bool get(const std::string& key, std::vector<double>& value) const override;
  bool get(const std::string& key, std::vector<std::vector<double>>& value) const override;

  std::vector<std::string> keys() const override;
  std::string source() const override { return source_; }

 private:
  explicit YamlParamReader(const std::string& source) : source_(source) {}

  void addLeaves(const std::string& key, const YAML::Node& node);
  void addMap(const std::string& prefix, const YAML::Node& node);
  const YAML::Node* find(const std::string& key) const;
  [[noreturn]] void failAt(const YAML::Mark& mark, const std::string& reason) const;

  std::string source_;
  std::map<std::string, YAML::Node> leaves_;
};

}  // namespace pomdp_crowd_nav
