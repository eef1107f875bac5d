// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/markdown.h"

#include <fmt/format.h>

#include <cmath>

namespace pomdp_crowd_nav {

std::string figure(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : kNoFigure;
}

std::string withError(double mean, double error, int digits) {
  if (!std::isfinite(mean)) return kNoFigure;
  if (!std::isfinite(error)) return figure(mean, digits);
  return fmt::format("{:.{}f} ± {:.{}f}", mean, digits, error, digits);
}

std::string withError(const Summary& summary, int digits) {
  return withError(summary.mean, summary.standard_error, digits);
}

std::string withInterval(const Summary& summary, double scale, int digits) {
  const double half = halfConfidenceInterval(summary);
  if (!std::isfinite(half)) return figure(scale * summary.mean, digits);
  return fmt::format("{:+.{}f} [{:+.{}f}, {:+.{}f}]", scale * summary.mean, digits,
                     scale * (summary.mean - half), digits, scale * (summary.mean + half), digits);
}

std::string markdownTable(const MarkdownRow& header, const std::vector<MarkdownRow>& rows) {
  const auto line = [](const MarkdownRow& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
  };
  std::string text = line(header) + "|";
  for (size_t i = 0; i < header.size(); ++i) text += "---|";
  text += "\n";
  for (const MarkdownRow& row : rows) text += line(row);
  return text + "\n";
}

}  // namespace pomdp_crowd_nav
