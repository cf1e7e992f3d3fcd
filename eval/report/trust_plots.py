# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plots of what detections say of themselves: reliability diagram, normalised errors by kind."""
import os
import textwrap

from matplotlib.patches import Patch

from report import figures, trust
from report.kinds import KINDS

MOST_IN_A_ROW = 5  # panels
COLOURS = {"total": "#0b62b8", "origin": "#7fb3e6", "axis": "#e8820c", "radius": "#1b8a5a", "half_angle": "#8e4ab8"}


def title_of(group, error):
    """In lines that are no wider than a panel of five."""
    return "%s\nECE %.3f" % (textwrap.fill(group, 22), error)


def reliability(lines, folder):
    """A diagram for each group: the share right over the confidence, and below how many. None without confidences."""
    chosen = {name: trust.reliability(some) for name, some in trust.groups(lines).items()}
    chosen = {name: bins for name, bins in chosen.items() if trust.calibration_error(bins) is not None}
    if not chosen:
        return None
    rows = -(-len(chosen) // MOST_IN_A_ROW)
    columns = -(-len(chosen) // rows)
    figure, axes = figures.panels(2 * rows, columns, 1.0 + 4.2 * rows, gridspec_kw={"height_ratios": (3, 1) * rows})
    for place in range(rows * columns):
        for part in (0, 1):
            axes[2 * (place // columns) + part][place % columns].set_visible(place < len(chosen))
    for place, (name, bins) in enumerate(chosen.items()):
        row, column = divmod(place, columns)
        top, bottom = axes[2 * row][column], axes[2 * row + 1][column]
        top.plot((0, 1), (0, 1), ":", color="#222222", label="as it should be")
        some = [one for one in bins if one.count]
        top.plot([one.confidence for one in some], [one.right for one in some], "o-", color="#0b62b8",
                 label="share that is right")
        top.set_title(title_of(name, trust.calibration_error(bins)))
        top.set_xlim(0, 1)
        top.set_xticklabels([])
        top.set_ylim(-0.03, 1.03)
        bottom.bar([(k + 0.5) / trust.BINS for k in range(trust.BINS)], [one.count for one in bins],
                   0.9 / trust.BINS, color="#a9a9a9")
        bottom.set_xlim(0, 1)
        bottom.set_yscale("symlog")
        bottom.set_xlabel("confidence")
        if column == 0:
            top.set_ylabel("share right")
            bottom.set_ylabel("detections")
    return figures.finish(figure, "Confidence of detections", os.path.join(folder, "reliability.png"),
                          note="ECE: expected calibration error, the mean distance of the two, weighted by the "
                               "detections.")


def normalised_errors(lines, folder):
    """Bars by kind and part, 1 where the covariance is right. None without covariances."""
    chosen = {name: {(kind, part): trust.normalised_error(some, kind, part) for kind in KINDS for part in trust.PARTS}
              for name, some in trust.groups(lines).items()}
    chosen = {name: errors for name, errors in chosen.items() if any(count for _, count in errors.values())}
    if not chosen:
        return None
    rows = -(-len(chosen) // 2)  # of two panels: names of kinds need their place
    figure, axes = figures.panels(rows, min(len(chosen), 2), 1.2 + 3.0 * rows, sharey=True)
    places = [one for row in axes for one in row]
    for one in places[len(chosen):]:
        one.set_visible(False)
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
