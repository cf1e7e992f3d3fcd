# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a scene and what several methods found in it, as in the paper's figure: instances and distances."""
import colorsys

import matplotlib

matplotlib.use("Agg")
import matplotlib.patheffects  # noqa: E402
import matplotlib.pyplot as pyplot  # noqa: E402
import numpy  # noqa: E402
from matplotlib.colors import to_rgb  # noqa: E402
from matplotlib.patches import Patch  # noqa: E402

from report import contestants, scene_dump, scene_view  # noqa: E402

# The largest shape is mostly the ground: a quiet colour for it.
COLORS = ("#9ec5f0", "#e6194b", "#3cb44b", "#ffd400", "#4363d8", "#f58231", "#911eb4", "#42d4f4", "#f032e6", "#a5d610",
          "#f7a1bd", "#2a8c82", "#b79cf0", "#9a6324", "#d9cf7a", "#8c1010", "#7ee2a0", "#808000", "#f5b98a", "#26268c")
KIND_COLORS = {"plane": "#7aa6e0", "sphere": "#e8743b", "cylinder": "#43a047", "cone": "#9c3fb5"}
KIND_LETTERS = {"plane": "P", "sphere": "S", "cylinder": "Cy", "cone": "Co"}
UNASSIGNED = to_rgb("#4d4d4d")
EXPLANATION = ("Left: the points of each detection in the colour of its true shape (spare colours: none); dark grey: "
               "points of no detection.\nLetters: kind, red if wrong. Right: distance to the closest detection.")
HALO = [matplotlib.patheffects.withStroke(linewidth=2, foreground="white")]
PANEL = {"frame": 5.4, "wide": 4.2, "part": 6.0}  # inches wide
BAR_COLUMN, ROW_HEADING, HEADING = 1.25, 0.5, 0.65  # inches


def color_of(index):
    """Distinct colours; past the list, hues that do not come back soon."""
    if index < len(COLORS):
        return to_rgb(COLORS[index])
    return colorsys.hsv_to_rgb(index * 0.618 % 1.0, 0.45 + 0.25 * (index % 3), 0.95 - 0.2 * (index % 2))


def true_colors(scene):
    """A colour for each true shape, the largest first in the list."""
    size = numpy.bincount(scene["surface"][scene["surface"] >= 0], minlength=len(scene["truth"]))
    colors = [None] * len(size)
    for rank, t in enumerate(numpy.argsort(-size, kind="stable")):
        colors[t] = color_of(rank)
    return colors


def found_colors(scene, match, colors):
    """A colour for each detection: its true shape's, else one that no true shape has."""
    spare = iter(range(len(colors), len(colors) + len(match)))
    return [color_of(next(spare)) if t is None else colors[t] for t in match]


def painted(labels, colors):
    """A colour for each point; grey for what belongs to nothing."""
    return numpy.array(list(colors) + [UNASSIGNED])[numpy.maximum(labels, -1)]


def write_kinds(axes, view, labels, shapes, true_shapes):
    """The kind of each detection as letters on its points; red when it is wrong."""
    for d, shape in enumerate(shapes):
        place = view.place_of(labels == d)
        if place is None:
            continue
        right = true_shapes[d] is not None and true_shapes[d]["type"] == shape["type"]
        axes.text(*place, KIND_LETTERS[shape["type"]], fontsize=7, weight="bold", ha="center", va="center",
                  color="black" if right else "#d00000", path_effects=HALO)


def caption(name, score):
    """Method, counts and shares of a scene."""
    shares = ["%s %.0f %%" % (word, 100.0 * score["typed"] / score[whole]) if score[whole] else word + " –"
              for word, whole in (("precision", "found"), ("recall", "truths"))]
    return "%s\nfound %d of %d true shapes (%d of right kind), %d detections; typed %s, %s" % (
        contestants.title(name), score["correct"], score["truths"], score["typed"], score["found"], *shares)


def draw_truth(left, right, bar, scene, view, colors):
    """The first row: true instances, and their kinds."""
    view.show(left, painted(scene["surface"], colors))
    write_kinds(left, view, scene["surface"], scene["truth"], scene["truth"])
    must = sum(shape["must"] for shape in scene["truth"])
    rest = len(scene["truth"]) - must
    left.set_title("truth: %d shapes" % must + (" and %d that need not be found" % rest if rest else ""), fontsize=9,
                   loc="left", weight="bold")
    view.show(right, painted(scene["surface"], [to_rgb(KIND_COLORS[shape["type"]]) for shape in scene["truth"]]))
    right.set_title("true kinds", fontsize=9, loc="left")
    patches = [Patch(color=color, label="%s (%s)" % (kind, KIND_LETTERS[kind])) for kind, color in KIND_COLORS.items()]
    bar.set_axis_off()
    bar.legend(handles=patches + [Patch(color=UNASSIGNED, label="of no shape")], fontsize=7.5, frameon=False,
               loc="center left", bbox_to_anchor=(-1.0, 0.5), borderpad=0)


def draw_method(left, right, bar, scene, view, colors, name):
    """A row: instances that a method found, and distances to the closest one. Returns its score."""
    result = scene["methods"][name]
    score = scene_dump.score_scene(scene, result)
    match = scene_dump.matching(scene, result)
    view.show(left, painted(result["labels"], found_colors(scene, match, colors)))
    write_kinds(left, view, result["labels"], result["primitives"],
                [None if t is None else scene["truth"][t] for t in match])
    left.set_title(caption(name, score), fontsize=9, loc="left")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0.0, 1000.0 * view.far), "turbo")
    distance = 1000.0 * numpy.nan_to_num(result["distance"].astype(float), nan=view.far, posinf=view.far)
    view.show(right, scale.to_rgba(numpy.minimum(distance, 1000.0 * view.far))[:, :3], shaded=False)
    pyplot.colorbar(scale, cax=bar, extend="max").set_label("mm to the closest detection", fontsize=8)
    bar.tick_params(labelsize=8)
    return score


def make_panels(view, rows):
    """A figure with so many rows of two panels and a colour bar, all of them measured in inches."""
    width = PANEL[view.kind]
    height = width * view.aspect
    total = (2 * width + 0.25 + BAR_COLUMN, rows * (height + ROW_HEADING) + HEADING)
    figure = pyplot.figure(figsize=total, dpi=100)
    panels = []
    for row in range(rows):
        bottom = total[1] - HEADING - (row + 1) * (height + ROW_HEADING) + 0.05
        boxes = [(0.1, bottom, width, height), (width + 0.2, bottom, width, height),
                 (2 * width + 0.4, bottom + 0.05 * height, 0.16, 0.9 * height)]
        panels.append([figure.add_axes([x / total[0], y / total[1], wide / total[0], high / total[1]])
                       for x, y, wide, high in boxes])
    return figure, panels


def draw_scene(dump_json_path, methods, out_png):
    """Draws a dumped scene: a row for the truth and one for each method; to the left the points in the colour of their
    detection, to the right in the colour of their distance to the closest one.

    Returns {method: see scene_dump.score_scene}. Raises ValueError naming file or method when there is nothing to draw.
    """
    scene = scene_dump.read_scene(dump_json_path)
    unknown = [name for name in methods if name not in scene["methods"]]
    if unknown:
        raise ValueError("%s: has no result of %s, only of %s" % (
            dump_json_path, ", ".join(unknown), ", ".join(scene["methods"])))
    view, colors = scene_view.View(scene), true_colors(scene)
    figure, panels = make_panels(view, 1 + len(methods))
    left, inch = 0.1 / figure.get_figwidth(), 1.0 / figure.get_figheight()
    figure.text(left, 1 - 0.1 * inch, scene["title"], fontsize=13, weight="bold", va="top")
    figure.text(left, 1 - 0.36 * inch, EXPLANATION, fontsize=9, va="top")
    draw_truth(*panels[0], scene, view, colors)
    scores = {name: draw_method(*panels[row], scene, view, colors, name) for row, name in enumerate(methods, 1)}
    figure.savefig(out_png)
    pyplot.close(figure)
    return scores
