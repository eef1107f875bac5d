// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/number_text.h"

#include <fmt/format.h>

#include <cmath>
#include <locale>
#include <sstream>

namespace pomdp_crowd_nav {
namespace {

template <typename T>
std::optional<T> parseWhole(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  T value{};
  if (!(in >> std::noskipws >> value)) return std::nullopt;
  if (in.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parseDouble(const std::string& text) {
  const std::optional<double> value = parseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parseInteger(const std::string& text) {
  return parseWhole<std::int64_t>(text);
}

std::string toText(const std::vector<double>& numbers) {
  std::string text;
  for (double number : numbers) text += fmt::format(text.empty() ? "{:g}" : ", {:g}", number);
  return "[" + text + "]";
}

}  // namespace pomdp_crowd_nav
