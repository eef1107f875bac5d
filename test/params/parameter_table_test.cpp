// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "pomdp_crowd_nav/params/param_values.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {
namespace {

YAML::Node table() { return YAML::LoadFile(SOURCE_DIR "/config/parameters.yaml")["profile"]; }

NavigationParams defaults() {
  NavigationParams params;
  params.planning.model.step = 0.5;
  return params;
}

double toNumber(const YAML::Node& node) {
  if (node.Scalar() == "pi") return M_PI;
  if (node.Scalar() == "pi / 4") return M_PI / 4.0;
  return node.as<double>();
}

void expectSame(const std::string& key, const YAML::Node& said, const ParamValue& value) {
  if (const double* number = std::get_if<double>(&value)) {
    EXPECT_DOUBLE_EQ(toNumber(said), *number) << key;
    EXPECT_NE(said.Scalar().find_first_of(".p"), std::string::npos) << key << " is no integer";
  } else if (const int* integer = std::get_if<int>(&value)) {
    EXPECT_EQ(said.Scalar(), std::to_string(*integer)) << key;
  } else if (const bool* truth = std::get_if<bool>(&value)) {
    EXPECT_EQ(said.Scalar(), *truth ? "true" : "false") << key;
  } else {
    EXPECT_EQ(said.Scalar(), std::get<std::string>(value)) << key;
  }
}

// Empty when the value is taken.
std::string refusal(const std::string& key, const ParamValue& value) {
  NavigationParams params = defaults();
  params.planning.model.near_distance = key == "model/far_distance" ? 0.0 : 4.0;
  params.planning.model.far_distance = key == "model/near_distance" ? 50.0 : 6.0;
  try {
    return withValues(params, {{key, value}}), "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(ParameterTable, HasEveryKeyWithItsDefault) {
  const ParamValues values = valuesOf(defaults());
  std::set<std::string> in_table;
  for (const auto& row : table()) {
    const std::string key = row.first.as<std::string>();
    in_table.insert(key);
    ASSERT_EQ(values.count(key), 1u) << key << " is in the table only";
    ASSERT_TRUE(row.second["default"]) << key;
    expectSame(key, row.second["default"], values.at(key));
  }
  for (const auto& entry : values) EXPECT_EQ(in_table.count(entry.first), 1u) << entry.first;
}

TEST(ParameterTable, RangesOfWhatMayChangeInFlightAreThoseOfTheCode) {
  const ParamValues values = valuesOf(defaults());
  int checked = 0;
  for (const auto& row : table()) {
    const std::string key = row.first.as<std::string>();
    const YAML::Node range = row.second["range"];
    if (!row.second["change"] || std::holds_alternative<bool>(values.at(key))) continue;
    ASSERT_TRUE(range && range.IsSequence()) << key;
    if (std::holds_alternative<std::string>(values.at(key))) continue;
    ASSERT_EQ(range.size(), 2u) << key;
    const auto value = [&](double number) {
      return std::holds_alternative<int>(values.at(key)) ? ParamValue(static_cast<int>(number))
                                                         : ParamValue(number);
    };
    const double step = std::holds_alternative<int>(values.at(key)) ? 1.0 : 1e-6;
    const double lowest = range[0].as<double>(), highest = range[1].as<double>();
    EXPECT_EQ(refusal(key, value(lowest)), "");
    EXPECT_EQ(refusal(key, value(highest)), "");
    EXPECT_NE(refusal(key, value(lowest - step)), "") << key;
    EXPECT_NE(refusal(key, value(highest + step)), "") << key;
    ++checked;
  }
  EXPECT_GT(checked, 15);
}

TEST(ParameterTable, NamesThePlannersThereAre) {
  const auto planners = table()["planner"]["range"].as<std::vector<std::string>>();
  EXPECT_EQ(planners, plannerNames());
}

}  // namespace
}  // namespace pomdp_crowd_nav
