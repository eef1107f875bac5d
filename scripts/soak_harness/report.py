# SPDX-License-Identifier: BSD-3-Clause
"""What a soak has shown, as JSON and on one screen."""
import collections
import json
import math

from .figures import summary
from .memory import Memory


def finite(value):
    """JSON has no nan and no inf."""
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list):
        return [finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def results(rig, duration):
    growth = rig.memory.growth()
    for node, figures in growth.items():
        figures["verdict"] = Memory.verdict(figures, rig.options.max_growth)
    return finite({
        "settings": {key: value for key, value in vars(rig.options).items() if key != "output"},
        "duration_s": round(duration, 1),
        "goals": {"sent": rig.trips.sent_count, "reached": rig.trips.reached},
        "faults": rig.outcomes,
        "violations": rig.violations,
        "unsafe": {"total": rig.truth.totals, "caused_by_robot": rig.truth.caused_by_robot,
                   "smallest_moving_distance_m": rig.truth.smallest_distance,
                   "events": rig.truth.events},
        "commands": {"topic": rig.commands.topic, "count": rig.commands.count,
                     "violations": dict(rig.commands.violations), "largest": rig.commands.worst,
                     "period_s": summary(rig.commands.periods)},
        "decisions": {"count": rig.status.decisions, "deadline_misses": rig.status.deadline_misses,
                      "bound_violations": rig.status.bound_violations,
                      "time_s": summary(rig.status.cycle_times)},
        "memory": growth})


def write(path, figures):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(figures, file, indent=1)
        file.write("\n")


def text_of(value, digits=3):
    return "-" if value is None else f"{value:.{digits}f}"


def fault_lines(outcomes):
    by_name = collections.defaultdict(list)
    for outcome in outcomes:
        by_name[outcome["fault"]].append(outcome)
    lines = ["fault                      times  longest to rest / bound [s]  longest to ready [s]"]
    for name, group in sorted(by_name.items()):
        rest = [outcome["rest_s"] for outcome in group if outcome["rest_s"] is not None]
        ready = [outcome["ready_s"] for outcome in group if outcome["ready_s"] is not None]
        bound = group[0]["bound_s"]
        reached = (f"{max(rest):.2f} / {bound:.2f}" if bound is not None and rest else
                   f"never / {bound:.2f}" if bound is not None else "-")
        lines.append(f"{name:26} {len(group):5}  {reached:>27}  "
                     f"{text_of(max(ready, default=None), 2):>20}")
    return lines


def screen(figures):
    period, times = figures["commands"]["period_s"], figures["decisions"]["time_s"]
    unsafe = figures["unsafe"]
    lines = fault_lines(figures["faults"]) + [
        "",
        f"goals reached     {figures['goals']['reached']} in {figures['duration_s']:.0f} s",
        f"unsafe, all       {unsafe['total']}",
        f"unsafe, by robot  {unsafe['caused_by_robot']}",
        f"commands          {figures['commands']['count']}, out of limits "
        f"{sum(figures['commands']['violations'].values())}; period p50 {text_of(period['p50'])} "
        f"p99 {text_of(period['p99'])} max {text_of(period['max'])} s",
        f"decisions         {figures['decisions']['count']}, too late "
        f"{figures['decisions']['deadline_misses']}; p50 {text_of(times['p50'])} "
        f"p99 {text_of(times['p99'])} max {text_of(times['max'])} s"]
    for node, growth in figures["memory"].items():
        lines.append(f"memory of {node:24} {text_of(growth['last_mb'], 1)} MB, peak "
                     f"{text_of(growth['peak_mb'], 1)} MB, slope "
                     f"{text_of(growth['slope_mb_per_h'], 2)} +- "
                     f"{text_of(growth['error_mb_per_h'], 2)} MB/h over {growth['span_s']:.0f} s: "
                     f"{growth['verdict']}")
    lines.append(f"violations        {len(figures['violations'])}")
    return lines
