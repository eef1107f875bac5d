// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// Reads named values from wherever a user keeps them (a yaml file, the ROS parameter server).
//
// An absent key leaves the field at its default. A value of the wrong type throws
// std::runtime_error with one line: source, key, value, what was expected. After everything has
// been read, `requireAllUsed` throws for keys that nobody asked for, naming the closest known key.
// Nested keys are written with a slash: "reward/goal"; items of a list of maps by their index:
// "polygons/0/closed".
class ParamReader {
 public:
  virtual ~ParamReader() = default;

  // Each returns whether the key is present.
  bool read(const std::string& key, double& field);
  bool read(const std::string& key, int& field);
  bool read(const std::string& key, bool& field);
  bool read(const std::string& key, std::string& field);
  bool read(const std::string& key, std::vector<double>& field);
  bool read(const std::string& key, std::vector<std::vector<double>>& field);
  bool read(const std::string& key, std::vector<Point>& field);  // list of [x, y]

  void requireAllUsed() const;

 protected:
  // Each returns false when the key is absent and throws when the value does not fit. `value` comes
  // in as the field is now.
  virtual bool get(const std::string& key, double& value) const = 0;
  virtual bool get(const std::string& key, int& value) const = 0;
  virtual bool get(const std::string& key, bool& value) const = 0;
  virtual bool get(const std::string& key, std::string& value) const = 0;
  virtual bool get(const std::string& key, std::vector<double>& value) const = 0;
  virtual bool get(const std::string& key, std::vector<std::vector<double>>& value) const = 0;

  // Every key present, leaves only.
  virtual std::vector<std::string> keys() const = 0;
  // For messages: a file name or a parameter namespace.
  virtual std::string source() const = 0;

  // The line that every wrong value is reported with.
  [[noreturn]] void fail(const std::string& key, const std::string& expected,
                         const std::string& value) const;

 private:
  template <typename T>
  bool readAs(const std::string& key, T& field);

  std::set<std::string> known_;
};

}  // namespace pomdp_crowd_nav
