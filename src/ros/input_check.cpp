// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/input_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pomdp_crowd_nav {
namespace {

using Row = std::array<std::string, 9>;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

bool isOfTransform(MessageFault fault) {
  return fault == MessageFault::kNoTransform || fault == MessageFault::kOldTransform ||
         fault == MessageFault::kBadTransform;
}

std::string adviceFor(const HeardInput& input) {
  switch (input.fault) {
    case MessageFault::kNoTransform:
      return fmt::format(
          "no transform leads from '{}' to '{}': start the localisation, or set "
          "global_frame",
          input.frame, input.global_frame);
    case MessageFault::kOldTransform:
      return fmt::format("the transform from '{}' to '{}' is too old: who publishes it has stopped",
                         input.frame, input.global_frame);
    case MessageFault::kFuture:
    case MessageFault::kOutOfOrder:
      return fmt::format("{}: {}; are the clocks of the machines in step?", input.topic,
                         describe(input.fault));
    default:
      return fmt::format("{}: {}; ask its publisher, {}", input.topic, describe(input.fault),
                         joined(input.publishers));
  }
}

std::string shown(double value, const char* unit) {
  return value < 0.0 ? "-" : fmt::format("{:.2f} {}", value, unit);
}

std::string transformOf(const HeardInput& input) {
  if (input.frame.empty() || input.messages == 0) return "-";
  return isOfTransform(input.fault) ? "no" : "yes";
}

std::string verdictOf(const InputVerdict& verdict) {
  const std::string text = verdict.is_fine ? "ok" : "NOT OK";
  return verdict.text.empty() ? text : text + ": " + verdict.text;
}

Row rowOf(const CheckedInput& input) {
  const HeardInput& heard = input.heard;
  const auto orDash = [](const std::string& text) { return text.empty() ? "-" : text; };
  return {heard.name,
          orDash(heard.topic),
          orDash(heard.type),
          orDash(joined(heard.publishers)),
          orDash(heard.frame),
          heard.rate > 0.0 ? fmt::format("{:.1f} Hz", heard.rate) : "-",
          shown(heard.age, "s"),
          transformOf(heard),
          verdictOf(input.verdict)};
}

}  // namespace

InputVerdict judge(const HeardInput& input) {
  if (input.publishers.empty() && input.messages == 0 && input.of_other_layout == 0) {
    return {false, "no publisher",
            fmt::format("nobody publishes {} ({}): start it, or remap {}:=/ITS_TOPIC", input.topic,
                        input.expected_type, input.name)};
  }
  if (input.messages == 0 && input.of_other_layout > 0) {
    return {false, "other type",
            fmt::format("{} carries {}, expected {} or its layout: remap {}:=/ITS_TOPIC",
                        input.topic, input.type, input.expected_type, input.name)};
  }
  if (input.messages == 0) {
    return {false, "silent",
            fmt::format("{} is published by {}, but nothing came in {:g} s", input.topic,
                        joined(input.publishers), input.duration)};
  }
  if (input.fault != MessageFault::kNone) {
    return {false, describe(input.fault), adviceFor(input)};
  }
  if (input.limit > 0.0 && input.age > input.limit) {
    return {false, "too old",
            fmt::format("{} is {:.2f} s old when it comes, at most {:g} s are allowed; are the "
                        "clocks of the machines in step?",
                        input.topic, input.age, input.limit)};
  }
  if (input.limit > 0.0 && input.rate * input.limit < 1.0) {
    return {false, "too slow",
            fmt::format("{} comes at {:.2f} Hz, and after {:g} s without it the robot stops",
                        input.topic, input.rate, input.limit)};
  }
  return {};
}

std::string tableOf(const std::vector<CheckedInput>& inputs) {
  std::vector<Row> rows = {
      {"input", "topic", "type", "publisher", "frame", "rate", "age", "to global", "verdict"}};
  for (const CheckedInput& input : inputs) rows.push_back(rowOf(input));
  std::array<size_t, std::tuple_size<Row>::value> widths{};
  for (const Row& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (size_t i = 0; i + 1 < row.size(); ++i) text += fmt::format("{:<{}}  ", row[i], widths[i]);
    text += row.back() + "\n";
  }
  for (const CheckedInput& input : inputs) {
    if (!input.verdict.is_fine) text += "-> " + input.verdict.advice + "\n";
  }
  return text;
}

}  // namespace pomdp_crowd_nav
