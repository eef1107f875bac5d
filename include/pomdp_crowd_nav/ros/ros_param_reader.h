// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <map>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/params/param_reader.h"

namespace ros {
class NodeHandle;
}

namespace pomdp_crowd_nav {

// Reads parameters from a namespace of the ROS parameter server, as it was at construction.
//
// As strict as the yaml reader: an integer is accepted where a real is expected, and nothing else
// is converted; numbers must be finite.
class RosParamReader : public ParamReader {
 public:
  explicit RosParamReader(const ros::NodeHandle& node);

  // The parameters in `tree`, a struct as the server holds it; `source` is for messages.
  RosParamReader(const XmlRpc::XmlRpcValue& tree, const std::string& source);

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
  void addLeaves(const std::string& key, const XmlRpc::XmlRpcValue& value);
  const XmlRpc::XmlRpcValue* find(const std::string& key) const;

  std::string source_;
  std::map<std::string, XmlRpc::XmlRpcValue> leaves_;
};

}  // namespace pomdp_crowd_nav
