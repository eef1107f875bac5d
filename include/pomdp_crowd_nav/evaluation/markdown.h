// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/evaluation/statistics.h"

namespace pomdp_crowd_nav {

// Cells of a table in a report; what is not finite is kNoFigure.
inline constexpr const char* kNoFigure = "–";
std::string figure(double value, int digits);
std::string withError(double mean, double error, int digits);
std::string withError(const Summary& summary, int digits);
// `scale` times the mean and its 95 % confidence interval.
std::string withInterval(const Summary& summary, double scale, int digits);

using MarkdownRow = std::vector<std::string>;

// With an empty line behind it.
std::string markdownTable(const MarkdownRow& header, const std::vector<MarkdownRow>& rows);

}  // namespace pomdp_crowd_nav
