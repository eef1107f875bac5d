# SPDX-License-Identifier: BSD-3-Clause
"""Percentiles and slopes."""
import math


def percentile(values, share):
    """The nearest rank; nan of nothing."""
    if not values:
        return math.nan
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, max(0, math.ceil(share * len(ordered)) - 1))]


def summary(values):
    return {"count": len(values), "p50": percentile(values, 0.5), "p99": percentile(values, 0.99),
            "max": max(values, default=math.nan)}


def common_slope(series):
    """Slope of (x, y) points by least squares, each series with an intercept of its own, and the
    slope's standard error; nan where there is too little."""
    sxx = sxy = syy = 0.0
    freedom = -1
    for points in series:
        if len(points) < 3:
            continue
        mean_x = sum(x for x, _ in points) / len(points)
        mean_y = sum(y for _, y in points) / len(points)
        sxx += sum((x - mean_x) ** 2 for x, _ in points)
        sxy += sum((x - mean_x) * (y - mean_y) for x, y in points)
        syy += sum((y - mean_y) ** 2 for _, y in points)
        freedom += len(points) - 1
    if freedom < 1 or sxx <= 0.0:
        return math.nan, math.nan
    slope = sxy / sxx
    return slope, math.sqrt(max(0.0, syy - slope * sxy) / freedom / sxx)
