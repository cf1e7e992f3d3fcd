# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plots with bars and boxes: runtime, parameter errors of the depth frames."""
import os

from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from report import contestants, figures, plan, published, summary

FEWEST_FOR_BOX = 5
# rows of panels: kind; columns: position, direction, size
PANELS = {
    "plane": (("position", "offset along the normal (mm)", 1000), ("axis_deg", "normal (deg)", 1), None),
    "sphere": (("position", "centre (mm)", 1000), None, ("radius", "radius (mm)", 1000)),
    "cylinder": (("position", "axis, sideways (mm)", 1000), ("axis_deg", "axis direction (deg)", 1),
                 ("radius", "radius (mm)", 1000)),
    "cone": (("apex", "apex (mm)", 1000), ("axis_deg", "axis direction (deg)", 1),
             ("half_angle_deg", "half angle (deg)", 1)),
}


def runtime(results, folder):
    """Joint and for each kind alone, with the paper's figures as dashes."""
    experiments = summary.of_part(results, "runtime")
    if not experiments:
        return None
    columns, texts = plan.RUNTIME_COLUMNS, plan.kind_methods()
    methods = ("default", "paper", "cgal", "cgal-2048")
    figure, axes = figures.panels(1, 1, 4.4)
    one, width = axes[0][0], 0.19
    for index, method in enumerate(methods):
        for place, column in enumerate(columns):
            value = summary.median(summary.times_without_tree(
                summary.lines_of(results, experiments[0], texts[method, column])))
            if value is None:
                continue
            x = place + (index - 1.5) * width
            one.bar(x, value, 0.92 * width, color=contestants.COLOURS[method])
            one.annotate("%.0f" % value if value >= 10 else "%.1f" % value, (x, 0), xycoords=("data", "axes fraction"),
                         xytext=(0, 3), textcoords="offset points", ha="center", fontsize=8.5, fontweight="bold",
                         color="black" if method == "cgal-2048" else "white")
            printed = published.figure(published.RUNTIME, published.COLUMN_OF.get(method), column)
            if printed:
                one.plot(x, printed, marker="_", markersize=13, markeredgewidth=2, color="#222222")
    one.set_yscale("log")
    one.set_ylim(bottom=one.get_ylim()[0] / 2)  # room for the numbers
    figures.plain_log(one.yaxis)
    one.set_ylabel("median time (ms)")
    one.set_xticks(range(len(columns)), ["all four kinds"] + [kind + " only" for kind in columns[1:]])
    one.grid(False, axis="x")
    handles = [Patch(color=contestants.COLOURS[method], label=contestants.title(method)) for method in methods]
    handles.append(Line2D([], [], marker="_", markersize=13, markeredgewidth=2, color="#222222", linestyle="",
                          label="printed in the paper"))
    return figures.finish(figure, "Time for one cloud of 160,801 points, one thread",
                          os.path.join(folder, "runtime.png"),
                          (handles, [handle.get_label() for handle in handles]),
                          note="Without the search tree of Efficient RANSAC, as in the paper, whose machine was "
                               "another one. Logarithmic scale.")


def tabletop_errors(results, folder):
    """Boxes of the parameter errors on depth frames."""
    chosen = [e for e in summary.of_part(results, "tabletop") if e.recipe.noise_scale == 1.0]
    if not chosen:
        return None
    methods = [m for m in ("default", "paper", "cgal", "cgal-3sigma", "pcl-planes", "pcl-sac")
               if summary.lines_of(results, chosen[0], m)]
    figure, axes = figures.panels(len(PANELS), 3, 8.8)
    for row, (kind, measures) in zip(axes, PANELS.items()):
        for one, measure in zip(row, measures):
            if measure is None:
                one.set_axis_off()
                continue
            found = [summary.errors(summary.lines_of(results, chosen[0], method), kind, measure[0])
                     for method in methods]
            boxes(one, [[measure[2] * value for value in values] for values in found], methods)
            one.set_title("%s: %s" % (kind, measure[1]), loc="left")
    handles = [Patch(color=contestants.COLOURS[method], label=figures.label_of(results, chosen[:1], method, methods))
               for method in methods]
    return figures.finish(figure, "Errors of the parameters on simulated depth frames, right type only",
                          os.path.join(folder, "tabletop_errors.png"),
                          (handles, [handle.get_label() for handle in handles]),
                          note="Line: median, box: the middle half, whiskers: 5 to 95 %, dots: fewer than five shapes. "
                               "Logarithmic scale.\nBelow: how many shapes. A method that finds fewer finds "
                               "the easy ones.")


def boxes(axes, values, methods):
    """One box a method, or dots where the values are few; their number below."""
    for place, (some, method) in enumerate(zip(values, methods)):
        if len(some) < FEWEST_FOR_BOX:
            axes.plot([place] * len(some), some, "o", color=contestants.COLOURS[method])
        else:
            drawn = axes.boxplot([some], positions=[place], widths=0.65, whis=(5, 95), showfliers=False,
                                 patch_artist=True, medianprops={"color": "black"})
            drawn["boxes"][0].set_facecolor(contestants.COLOURS[method])
    axes.set_xlim(-0.6, len(methods) - 0.4)
    axes.set_xticks(range(len(methods)), [str(len(some)) for some in values], fontsize=8)
    axes.tick_params(axis="x", length=0)
    axes.set_yscale("log")
    low, high = axes.get_ylim()
    if high < 10 * low:  # at least a decade, or nearly equal values look far apart
        middle = (low * high) ** 0.5
        axes.set_ylim(middle / 10 ** 0.5, middle * 10 ** 0.5)
    figures.plain_log(axes.yaxis, short=True)
    axes.grid(False, axis="x")
