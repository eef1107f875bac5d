# SPDX-License-Identifier: BSD-3-Clause
"""How all figures look."""
import math
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from command_line.refusal import Refusal  # noqa: E402

NAMES = {"1d_astar": "1D-A*", "2d_fmm": "2D-FMM", "2d_prm": "2D-PRM", "2d_nhv": "2D-NHV",
         "2d_nhv_fm2": "2D-NHV-FM²", "2d_straight": "2D-straight"}
# Okabe and Ito's colours, which the colour-blind tell apart, by falling darkness; hatches and markers
# tell them apart without colour.
COLOURS = ["#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00"]
HATCHES = ["", "///", "...", "xxx", "\\\\\\", "+++"]
MARKERS = ["o", "s", "^", "D", "v", "P"]
INK = "#222222"
OBSTACLE = {"facecolor": "#9a9a9a", "edgecolor": INK, "linewidth": 0.8}
FORMATS = ("png", "pdf", "svg")
STYLE = {"font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "legend.fontsize": 8,
         "xtick.labelsize": 8, "ytick.labelsize": 8, "axes.edgecolor": INK, "axes.linewidth": 0.7,
         "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
         "savefig.dpi": 180, "pdf.fonttype": 42, "svg.fonttype": "none", "hatch.linewidth": 0.6}

# Places of a legend outside the figure, which grows to hold it when it is saved.
ABOVE = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0)}
BELOW = {"loc": "upper center", "bbox_to_anchor": (0.5, 0.0)}


def name_of(planner):
    return NAMES.get(planner, planner)


def world_name(world):
    stem = pathlib.Path(world).stem
    return stem.replace("scenario_", "Scenario ")


def error_bars(errors):
    """For matplotlib, which draws none where an error is no number, but fails where none is one."""
    return errors if any(map(math.isfinite, errors)) else None


def spread_label(errors, single):
    """What the error bars are, and of what there are none because their error is not known."""
    if not any(map(math.isfinite, errors)):
        return f"({single} each, no standard error)"
    if all(map(math.isfinite, errors)):
        return "(mean ± standard error)"
    return f"(mean ± standard error;\nnone for {single})"


def save(figure, outputs):
    for output in outputs:
        try:
            figure.savefig(output, bbox_inches="tight", pad_inches=0.04)
        except OSError as error:
            raise Refusal(f"--output: cannot write '{output}': {error.strerror}") from None
