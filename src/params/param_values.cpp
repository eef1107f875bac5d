// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/param_values.h"

#include <fmt/format.h>

#include <utility>

namespace pomdp_crowd_nav {
namespace {

// Finds nothing and writes down what the fields hold.
class FieldRecorder : public ParamReader {
 public:
  explicit FieldRecorder(ParamValues& values) : values_(values) {}

 protected:
  bool get(const std::string& key, double& value) const override { return note(key, value); }
  bool get(const std::string& key, int& value) const override { return note(key, value); }
  bool get(const std::string& key, bool& value) const override { return note(key, value); }
  bool get(const std::string& key, std::string& value) const override { return note(key, value); }
  bool get(const std::string&, std::vector<double>&) const override { return false; }
  bool get(const std::string&, std::vector<std::vector<double>>&) const override { return false; }

  std::vector<std::string> keys() const override { return {}; }
  std::string source() const override { return "parameters"; }

 private:
  template <typename T>
  bool note(const std::string& key, const T& value) const {
    values_[key] = value;
    return false;
  }

  ParamValues& values_;
};

class ValueReader : public ParamReader {
 public:
  explicit ValueReader(const ParamValues& values) : values_(values) {}

 protected:
  bool get(const std::string& key, double& value) const override {
    return find(key, value, "a number");
  }
  bool get(const std::string& key, int& value) const override {
    return find(key, value, "an integer");
  }
  bool get(const std::string& key, bool& value) const override {
    return find(key, value, "true or false");
  }
  bool get(const std::string& key, std::string& value) const override {
    return find(key, value, "a text");
  }
  bool get(const std::string&, std::vector<double>&) const override { return false; }
  bool get(const std::string&, std::vector<std::vector<double>>&) const override { return false; }

  std::vector<std::string> keys() const override {
    std::vector<std::string> names;
    for (const auto& entry : values_) names.push_back(entry.first);
    return names;
  }
  std::string source() const override { return "new parameters"; }

 private:
  template <typename T>
  bool find(const std::string& key, T& value, const char* expected) const {
    const auto found = values_.find(key);
    if (found == values_.end()) return false;
    if (!std::holds_alternative<T>(found->second)) fail(key, expected, toText(found->second));
    value = std::get<T>(found->second);
    return true;
  }

  const ParamValues& values_;
};

}  // namespace

ParamValues valuesOf(const NavigationParams& params) {
  ParamValues values;
  FieldRecorder recorder(values);
  NavigationParams copy = params;
  readNavigationParams(recorder, copy);
  return values;
}

NavigationParams withValues(const NavigationParams& params, const ParamValues& values) {
  ValueReader reader(values);
  NavigationParams changed = params;
  readNavigationParams(reader, changed);
  reader.requireAllUsed();
  validate(changed);
  return changed;
}

std::vector<std::string> changedKeys(const NavigationParams& from, const NavigationParams& to) {
  const ParamValues before = valuesOf(from);
  std::vector<std::string> keys;
  for (const auto& [key, value] : valuesOf(to)) {
    if (before.at(key) != value) keys.push_back(key);
  }
  return keys;
}

std::string toText(const ParamValue& value) {
  return std::visit([](const auto& it) { return fmt::format("{}", it); }, value);
}

}  // namespace pomdp_crowd_nav
