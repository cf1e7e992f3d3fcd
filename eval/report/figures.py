# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What all plots share: fonts, grids, a legend below the panels, never over data."""
import os

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402  the backend comes first

from report import contestants, summary  # noqa: E402

WIDTH = 9.0  # inch: 900 px wide on the page, twice as sharp in the file
DPI = 150
LEGEND = {"handlelength": 2.6, "columnspacing": 1.6}

pyplot.rcParams.update({
    "font.size": 10, "axes.titlesize": 10.5, "axes.labelsize": 10, "legend.fontsize": 9.5, "figure.titlesize": 12.5,
    "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.7, "axes.axisbelow": True,
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False, "savefig.facecolor": "white"})


def panels(rows, columns, height, **options):
    """A figure and its axes as a list of rows."""
    figure, axes = pyplot.subplots(rows, columns, figsize=(WIDTH, height), squeeze=False, **options)
    return figure, axes


def finish(figure, title, path, legend=None, note=""):
    """Title on top, legend and note below, written as PNG. legend: (handles, labels); None: those of all axes."""
    handles, labels = legend or entries(figure)
    height = figure.get_size_inches()[1]
    columns = fitting_columns(figure, handles, labels)
    below = (0.24 * -(-len(labels) // columns) + (0.24 * (note.count("\n") + 1) if note else 0) + 0.1) / height
    figure.suptitle(title, x=0.01, ha="left", fontweight="bold")
    figure.tight_layout(rect=(0, below, 1, 1 - 0.02 / height))
    if labels:
        figure.legend(handles, labels, loc="lower center", ncol=columns, **LEGEND,
                      bbox_to_anchor=(0.5, (0.24 * (note.count("\n") + 1) if note else 0) / height))
    if note:
        figure.text(0.01, 0.05 / height, note, fontsize=9, color="#555555", va="bottom")
    figure.savefig(path, dpi=DPI)
    pyplot.close(figure)
    return os.path.basename(path)


def fitting_columns(figure, handles, labels):
    """Into how many columns, four at most, a legend goes without leaving the figure."""
    for columns in range(min(len(labels), 4), 1, -1):
        legend = figure.legend(handles, labels, loc="lower center", ncol=columns, **LEGEND)
        wide = legend.get_window_extent(figure.canvas.get_renderer()).width
        legend.remove()
        if wide < figure.bbox.width:
            return columns
    return 1


def label_of(results, experiments, method, methods):
    """The method's name in a legend; with its number of clouds where others of the plot have more."""
    counts = {name: [len(summary.lines_of(results, e, name)) for e in experiments] for name in methods}
    own = sorted(set(counts[method]) - {0})
    most = [max(column) for column in zip(*counts.values())]
    if not own or all(n in (0, m) for n, m in zip(counts[method], most)):
        return contestants.title(method)
    text = "%d" % own[0] if len(own) == 1 else "%d to %d" % (own[0], own[-1])
    return "%s (%s %s)" % (contestants.title(method), text, "cloud" if own == [1] else "clouds")


def entries(figure):
    """Handles and labels of all axes, each label once."""
    found = {}
    for axes in figure.axes:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            found.setdefault(label, handle)
    return list(found.values()), list(found)


def plain_log(axis, short=False):
    """A logarithmic axis of "0.1, 1, 10, 1,000" instead of powers; with marks between on a short one."""
    axis.set_major_locator(ticker.LogLocator(subs=(1, 3) if short else (1,), numticks=12))
    axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: "{:,g}".format(float("%.6g" % value))))
    axis.set_minor_formatter(ticker.NullFormatter())


def percent_axis(axes, label="percent"):
    axes.set_ylim(-3, 103)
    axes.set_ylabel(label)
