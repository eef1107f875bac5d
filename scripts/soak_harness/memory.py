# SPDX-License-Identifier: BSD-3-Clause
"""Resident memory of every process of the nodes, and how it grows."""
import math

from .figures import common_slope

RESTARTED = 120.0   # [s] a process that was started again has to warm up
SHORTEST = 600.0    # [s] of samples below which a slope means nothing


def resident(pid):
    """[MB]; nan for a process that is gone."""
    try:
        with open(f"/proc/{pid}/status", encoding="ascii", errors="replace") as file:
            for line in file:
                if line.startswith("VmRSS:"):
                    return float(line.split()[1]) / 1024.0
    except OSError:
        pass
    return math.nan


class Memory:
    def __init__(self, warm_up):
        self.warm_up = warm_up
        self.series = {}  # of (node, pid): [(time [s], MB)]

    def sample(self, now, pids):
        row = {}
        for name, pid in pids.items():
            row[name] = resident(pid)
            if math.isfinite(row[name]):
                self.series.setdefault((name, pid), []).append((now, row[name]))
        return row

    def growth(self):
        """For each node its slope [MB/h], the slope's standard error, and the time it spans [s]."""
        result = {}
        for name in sorted({name for name, _ in self.series}):
            parts = []
            for (owner, _), points in self.series.items():
                if owner == name:
                    begin = max(self.warm_up, points[0][0] + RESTARTED if points[0][0] > 30.0 else 0)
                    parts.append([(t / 3600.0, mb) for t, mb in points if t >= begin])
            slope, error = common_slope(parts)
            spans = [part[-1][0] - part[0][0] for part in parts if len(part) > 1]
            last = [points[-1][1] for (owner, _), points in self.series.items() if owner == name]
            peak = max(mb for (owner, _), points in self.series.items() if owner == name
                       for _, mb in points)
            result[name] = {"slope_mb_per_h": slope, "error_mb_per_h": error,
                            "span_s": 3600.0 * sum(spans), "last_mb": last[-1], "peak_mb": peak}
        return result

    @staticmethod
    def verdict(growth, limit):
        """"grows" or "flat" where slope and twice its error tell; else "undecided"."""
        if growth["span_s"] < SHORTEST or math.isnan(growth["slope_mb_per_h"]):
            return "undecided"
        slope, margin = growth["slope_mb_per_h"], 2.0 * growth["error_mb_per_h"]
        if slope - margin > limit:
            return "grows"
        return "flat" if slope + margin <= limit else "undecided"
