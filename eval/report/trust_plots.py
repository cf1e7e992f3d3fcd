# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plots of what detections say of themselves: reliability diagram, normalised errors by kind."""
import math
import os
import textwrap

from matplotlib.patches import Patch

from report import figures, trust
from report.kinds import KINDS

MOST_IN_A_ROW = 5  # panels
COUNTS_HEIGHT = 0.35  # of the tallest bar
COLOURS = {"total": "#0b62b8", "origin": "#7fb3e6", "axis": "#e8820c", "radius": "#1b8a5a", "half_angle": "#8e4ab8"}


def title_of(group, error):
    """In lines that are no wider than a panel of five."""
    return "%s\nECE %.3f" % (textwrap.fill(group, 18), error)


def grid(count, most_in_a_row, row_height, **options):
    """A figure, its axes in rows, and the first `count` of them; the others are hidden."""
    rows = -(-count // most_in_a_row)
    figure, axes = figures.panels(rows, -(-count // rows), 1.2 + row_height * rows, **options)
    places = [one for row in axes for one in row]
    for one in places[count:]:
        one.set_visible(False)
    return figure, axes, places[:count]


def reliability(lines, folder):
    """A diagram for each group: the share right over the confidence, and how many. None without confidences."""
    chosen = {name: trust.reliability(some) for name, some in trust.groups(lines).items()}
    chosen = {name: bins for name, bins in chosen.items() if trust.calibration_error(bins) is not None}
    if not chosen:
        return None
    figure, axes, places = grid(len(chosen), MOST_IN_A_ROW, 2.9)
    most = max(one.count for bins in chosen.values() for one in bins)
    for one, (name, bins) in zip(places, chosen.items()):
        one.bar([(k + 0.5) / trust.BINS for k in range(trust.BINS)],
                [COUNTS_HEIGHT * math.log1p(part.count) / math.log1p(most) for part in bins], 0.9 / trust.BINS,
                color="#c9c9c9")
        one.plot((0, 1), (0, 1), ":", color="#222222", label="as it should be")
        some = [part for part in bins if part.count]
        one.plot([part.confidence for part in some], [part.right for part in some], "o-", color="#0b62b8",
                 label="share that is right")
        one.set_title(title_of(name, trust.calibration_error(bins)))
        one.set_xlim(0, 1.02)
        one.set_ylim(0, 1.03)
        one.set_xlabel("confidence")
    for row in axes:
        row[0].set_ylabel("share right")
    return figures.finish(figure, "Confidence of detections", os.path.join(folder, "reliability.png"),
                          note="ECE: expected calibration error, the mean distance of the two, weighted by the "
                               "detections. Grey: how many these are, logarithmically.")


def normalised_errors(lines, folder):
    """Bars by kind and part, 1 where the covariance is right. None without covariances."""
    chosen = {name: {(kind, part): trust.normalised_error(some, kind, part) for kind in KINDS for part in trust.PARTS}
              for name, some in trust.groups(lines).items()}
    chosen = {name: errors for name, errors in chosen.items() if any(count for _, count in errors.values())}
    if not chosen:
        return None
    figure, axes, places = grid(len(chosen), 2, 3.0, sharey=True)  # names of kinds need their place
    width = 0.16
    # At least a decade, or nearly equal values look far apart.
    values = [value for errors in chosen.values() for value, _ in errors.values() if value]
    lowest, highest = min([0.3] + [0.8 * value for value in values]), max([3.3] + [1.2 * value for value in values])
    for one, (name, errors) in zip(places, chosen.items()):
        one.axhspan(*trust.CALIBRATED, color="#dff0df")
        one.axhline(1.0, color="#222222", linewidth=1, linestyle=":")
        for place, kind in enumerate(KINDS):
            for index, part in enumerate(trust.PARTS):
                value, _ = errors[kind, part]
                if value is not None:
                    one.bar(place + (index - 2) * width, value, 0.92 * width, color=COLOURS[part])
        counts = [max(errors[kind, part][1] for part in trust.PARTS) for kind in KINDS]
        one.set_xticks(range(len(KINDS)), ["%ss\n%d" % pair for pair in zip(KINDS, counts)])
        one.set_yscale("log")
        one.set_ylim(lowest, highest)
        figures.plain_log(one.yaxis, short=True)
        one.grid(False, axis="x")
        one.set_title(name)
    for row in axes:
        row[0].set_ylabel("mean squared error / degrees")
    handles = [Patch(color=COLOURS[part], label=part.replace("_", " ")) for part in trust.PARTS]
    return figures.finish(figure, "Errors over what the covariance promises",
                          os.path.join(folder, "nees.png"), (handles, [handle.get_label() for handle in handles]),
                          note="Green: within 20 % of 1. Below the kinds: detections.")
