# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The plots of eval/speed: where a frame's time goes, and how it grows."""
import os

from matplotlib import ticker

from report import figures as style
from report import speed, speed_page

PALETTE = ("#0b62b8", "#e8820c", "#1b8a5a", "#8e4ab8", "#d36ba8", "#86a818", "#8c8c8c", "#c9b8c4")
TITLES = {"points": "points with normals, in memory", "pixels": "pixels of a depth frame, from bytes",
          "samples": "samples a round", "objects": "objects on the table"}


def stages(figures, folder):
    """A bar a case, its stages one after the other."""
    cases = [case for case in figures if case.startswith(("detect/", "frame/"))][::-1]
    if not cases:
        return None
    figure, axes = style.panels(1, 1, 1.6 + 0.3 * len(cases))
    one = axes[0][0]
    begin = [0.0] * len(cases)
    for name, colour in zip(speed_page.stage_names(figures, cases), PALETTE):
        lengths = [figures[case]["stages_ms"].get(name) or 0.0 for case in cases]
        one.barh(range(len(cases)), lengths, left=begin, color=colour, label=name, height=0.7)
        begin = [a + b for a, b in zip(begin, lengths)]
    one.set_yticks(range(len(cases)))
    one.set_yticklabels(cases)
    one.set_xlabel("ms, sum of the stages' medians")
    return style.finish(figure, "Where the time goes", os.path.join(folder, "stages.png"))


def curves(figures, folder):
    """Time over points, pixels, samples and objects."""
    known = [(name, speed.curve(figures, name)) for name in TITLES]
    known = [(name, points) for name, points in known if len(points) > 1]
    if not known:
        return None
    figure, axes = style.panels(-(-len(known) // 2), 2, 3.1 * -(-len(known) // 2) + 0.5)
    flat = [one for row in axes for one in row]
    for one, (name, points) in zip(flat, known):
        draw_curve(one, figures, name, points)
    for unused in flat[len(known):]:
        unused.set_visible(False)
    return style.finish(figure, "How the time of a frame grows", os.path.join(folder, "scaling.png"))


def draw_curve(axes, figures, name, points):
    axes.plot(*zip(*points), color=PALETTE[0], marker="o", label="total")
    read = [(place, figures["%s/%d" % (name, place)]["stages_ms"].get("read")) for place, _ in points]
    if all(time is not None for _, time in read):
        axes.plot(*zip(*read), color=PALETTE[1], marker="s", label="of it reading")
    axes.set_xlabel(TITLES[name])
    axes.set_ylabel("ms, median")
    if name != "objects":
        axes.set_xscale("log")
        axes.set_xticks([place for place, _ in points][::2 if name != "samples" else 1])
        axes.xaxis.set_major_formatter(ticker.EngFormatter(sep="") if name != "samples" else ticker.ScalarFormatter())
        axes.xaxis.set_minor_locator(ticker.NullLocator())
    if name in ("points", "pixels"):
        axes.set_yscale("log")
        style.plain_log(axes.yaxis, short=name == "points")
    else:
        axes.set_ylim(bottom=0)
