# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of recorded frames: the shaded depth image, and on it what was found, what was missed and what is false."""
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.patheffects  # noqa: E402
import matplotlib.pyplot as pyplot  # noqa: E402
import numpy  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Patch  # noqa: E402

from report import frame_images, frame_scoring  # noqa: E402

GREEN, RED, BLUE, AMBER, GREY = "#1a9641", "#e0201b", "#5b8fd6", "#d9a300", "#6e6e6e"
HALO = [matplotlib.patheffects.withStroke(linewidth=2.5, foreground="white")]
LEGEND = [
    Line2D([], [], marker="o", ls="", mfc=GREEN, mec="white", ms=13, label="must be found: found"),
    Line2D([], [], marker="X", ls="", mfc=RED, mec="white", ms=13, label="must be found: MISSED"),
    Line2D([], [], marker="o", ls="", mfc=GREY, mec="white", ms=8, label="optional (filled: found)"),
    Line2D([], [], color=RED, lw=2, label="outline of a false alarm, with its number"),
    Patch(color=GREEN, alpha=0.6, label="points of a right detection"),
    Patch(color=RED, alpha=0.6, label="points of a false alarm"),
    Patch(color=BLUE, alpha=0.6, label="not judged: fits no label, but need not be wrong"),
    Patch(color="#b0b0b0", label="grey: belongs to nothing found; white: not measured"),
]


def tinted(points, labels, verdicts, detections):
    """The shaded image with the points of each detection in the colour of its verdict."""
    image = frame_images.shaded(points)
    for k, verdict in enumerate(verdicts):
        color = GREEN if verdict == "right" else RED if verdict == "false" else BLUE
        strength = 0.25 if detections[k]["type"] == "plane" else 0.6
        own = labels == k
        image[own] = (1 - strength) * image[own] + strength * image[own].mean() * 1.4 * numpy.array(
            matplotlib.colors.to_rgb(color))
    return numpy.clip(image, 0, 1)


def ring(centre, x_axis, z_axis, radius):
    """Points of a circle around z_axis."""
    turn = numpy.linspace(0, 2 * numpy.pi, 49)[:, None]
    x_axis, z_axis = frame_scoring.unit(x_axis), frame_scoring.unit(z_axis)
    return centre + radius * (numpy.cos(turn) * x_axis + numpy.sin(turn) * numpy.cross(z_axis, x_axis))


def outlines(found):
    """Lines in space (m) that show a detected sphere, cylinder or cone."""
    extent = found.get("extent", {})
    if found["type"] == "sphere":
        centre = numpy.array(found["center"])
        view = frame_scoring.unit(centre)
        return [ring(centre, numpy.cross(view, [0, 1, 0.1]), view, found["radius"])]
    if not {"origin", "x_axis", "z_axis", "length"} <= set(extent):
        return []
    ends = [numpy.array(extent["origin"]) + side * extent["length"] * frame_scoring.unit(extent["z_axis"])
            for side in (-0.5, 0.5)]
    radii = [found.get("radius", extent.get("radius_small", 0.0)), found.get("radius", extent.get("radius_large", 0.0))]
    rings = [ring(end, extent["x_axis"], extent["z_axis"], radius) for end, radius in zip(ends, radii)]
    return rings + [numpy.array([rings[0][k], rings[1][k]]) for k in range(0, 48, 12)]


def to_pixels(points, lens):
    """Points (m) in the image; NaN behind the camera."""
    fx, fy, cx, cy = lens
    depth = numpy.where(points[:, 2] > 0.02, points[:, 2], numpy.nan)
    return numpy.stack([fx * points[:, 0] / depth + cx, fy * points[:, 1] / depth + cy], axis=1)


def number_place(labels, k, found, lens):
    """Where the number of a detection goes: a point of its own near their middle, else its origin."""
    rows, columns = numpy.nonzero(labels == k)
    if len(rows):
        nearest = numpy.argmin((rows - numpy.median(rows)) ** 2 + (columns - numpy.median(columns)) ** 2)
        return columns[nearest], rows[nearest]
    place = found.get("extent", {}).get("origin") or found.get("center") or found.get("apex") or found.get("point")
    return tuple(to_pixels(numpy.array([place], float), lens)[0])


def label_pixel(label, frame_label, lens):
    """Where a label is in the image; None when it does not say."""
    if label["pixel"]:
        return label["pixel"]
    return to_pixels(numpy.array([frame_label["centre"]], float), lens)[0] if "centre" in frame_label else None


def draw_mark(axes, label, place, size):
    """Found, missed or optional."""
    found, must = label["verdict"] == "found", label["must"]
    if must and found:
        axes.plot(*place, marker="o", mfc=GREEN, mec="white", ms=1.3 * size, zorder=5)
        axes.text(*place, "✓", color="white", fontsize=0.9 * size, weight="bold", ha="center", va="center", zorder=6)
    elif must:
        axes.plot(*place, marker="X", mfc=RED, mec="white", ms=1.6 * size, zorder=5)
    else:
        axes.plot(*place, marker="o", mfc=GREY if found else "white", mec="white" if found else GREY, ms=0.8 * size,
                  zorder=5)


def free_place(place, text, taken, limits):
    """Where a text beside a mark goes, px of the image, and which end of it; where no text is yet; adds it to taken.

    limits: first and last column of the picture.
    """
    left_end, right_end = limits
    scale = (right_end - left_end) / 640.0
    long, high, gap = 5.6 * scale * len(text), 15.0 * scale, 11.0 * scale
    for right, down in [(x, y) for y in (0, -13, 13, -26, 26) for x in (gap, -gap - long)]:
        x, y = place[0] + right, place[1] + down * scale
        clear = all(x > left + length or left > x + long or abs(y - middle) > high for left, middle, length in taken)
        if clear and x >= left_end and x + long <= right_end:
            break
    else:
        right, x, y = gap, place[0] + gap, place[1]
    taken.append((x, y, long))
    return (x, y, "left") if right > 0 else (x + long, y, "right")


def draw_names(axes, labels, places):
    """The names of all labels beside their marks."""
    taken = [(x - 8, y, 16) for x, y in places]
    for label, place in zip(labels, places):
        missed = label["must"] and label["verdict"] == "missed"
        text = ("MISSED: " if missed else "") + label["name"]
        x, y, end = free_place(place, text, taken, axes.get_xlim())
        axes.text(x, y, text, fontsize=8, ha=end, va="center", zorder=7,
                  path_effects=HALO, color=RED if missed else "#0d6b2f" if label["must"] else "#444444",
                  weight="bold" if label["must"] else "normal", clip_on=True)


def show_measured_part(axes, points):
    """Cuts the rows and columns off where nothing was measured."""
    measured = numpy.isfinite(points[..., 2])
    rows, columns = numpy.nonzero(measured.any(axis=1))[0], numpy.nonzero(measured.any(axis=0))[0]
    if len(rows):
        axes.set_xlim(columns[0] - 4.5, columns[-1] + 4.5)
        axes.set_ylim(rows[-1] + 4.5, rows[0] - 4.5)


def draw_image(axes, frame, result, image, size=10, with_text=True):
    """A frame into a plot. result: score_frame's, with "detections". image: read_labelled_image's, None without."""
    detections, verdicts = result["detections"], result["verdicts"]
    axes.set_axis_off()
    if image is None:
        axes.text(0.5, 0.5, "no picture: see the faults", ha="center", va="center", transform=axes.transAxes)
        return
    points, labels = image
    axes.imshow(tinted(points, labels, verdicts, detections), interpolation="nearest")
    false = [k for k, verdict in enumerate(verdicts) if verdict == "false"]
    for number, k in enumerate(false, 1):
        for line in outlines(detections[k]):
            axes.plot(*to_pixels(line, frame["lens"]).T, color=RED, lw=0.13 * size, alpha=0.6, zorder=3)
        place = number_place(labels, k, detections[k], frame["lens"])
        axes.text(*place, str(number), color="white", fontsize=0.8 * size, weight="bold", ha="center", va="center",
                  zorder=4, clip_on=True,
                  bbox={"boxstyle": "round,pad=0.15", "fc": RED, "ec": "white", "lw": 0.8})
    show_measured_part(axes, points)
    marked = [(label, label_pixel(label, frame_label, frame["lens"]))
              for label, frame_label in zip(result["labels"], frame["labels"])]
    marked = [(label, place) for label, place in marked if place is not None]
    for label, place in marked:
        draw_mark(axes, label, place, size)
    if with_text and marked:
        draw_names(axes, *zip(*marked))


def heading(name, frame, result):
    """One line that says how a frame went."""
    must = [label for label in result["labels"] if label["must"]]
    found = sum(label["verdict"] == "found" for label in must)
    false = result["verdicts"].count("false")
    return "%s%s: %s, %s" % (name, " (negative)" if frame["negative"] else "",
                             "%d of %d found" % (found, len(must)) if must else "optional labels only",
                             "no false alarm" if not false else "%d false alarm%s" % (false, "s" * (false > 1)))


def label_line(label):
    """A label and what became of it, in words."""
    mark = {"found": "✓", "missed": "✗" if label["must"] else "–", "not judged": "·"}[label["verdict"]]
    text = "%s %s" % (mark, label["name"])
    if label["radius_mm"] is not None:
        return text + "\n    %s r %.1f mm, label %.1f (%+.1f)" % (
            label["kind"], label["radius_mm"], label["label_radius_mm"], label["radius_error_mm"])
    radius = " r %.1f mm" % label["label_radius_mm"] if label["label_radius_mm"] else ""
    rest = {"found": "", "missed": " not found", "not judged": ", not judged"}[label["verdict"]]
    why = ": " + label["remark"] if label["remark"] and label["verdict"] != "found" else ""
    return text + "\n    " + textwrap.shorten(label["kind"] + radius + rest + why, 50, placeholder=" …")


def side_blocks(frame, result):
    """The text beside a picture: (text, colour) from top to bottom."""
    blocks = []
    for must, title in ((True, "MUST BE FOUND"), (False, "\nOPTIONAL")):
        labels = [label for label in result["labels"] if label["must"] == must]
        blocks.append((title + ("" if labels else ": none"), "black"))
        for label in labels:
            found, missed = label["verdict"] == "found", label["verdict"] == "missed"
            blocks.append((label_line(label), GREEN if must and found else RED if must and missed else GREY))
    blocks.append(("\nFALSE ALARMS" + (" (nothing curved is here)" if frame["negative"] else ""), "black"))
    false = [found for found, verdict in zip(result["detections"], result["verdicts"]) if verdict == "false"]
    blocks += [("%d  %s" % (k, frame_scoring.describe(found)), RED) for k, found in enumerate(false, 1)]
    if not false:
        blocks.append(("none", GREEN))
    time = "\ntime %.0f ms" % result["total_ms"] if result["total_ms"] is not None else "\ntime not known"
    return blocks + [(time, "black")]


def draw_frame(name, preset, frame, result, image, path):
    """One frame: the image to the left, the words to the right, the legend below."""
    figure = pyplot.figure(figsize=(13.6, 8.2), dpi=100)
    axes = figure.add_axes([0.005, 0.085, 0.70, 0.845])
    draw_image(axes, frame, result, image)
    figure.text(0.008, 0.975, "%s preset  –  %s" % (preset, heading(name, frame, result)), fontsize=14,
                weight="bold", va="top")
    figure.text(0.008, 0.942, frame["title"], fontsize=10, color=GREY, va="top")
    blocks = side_blocks(frame, result)
    lines = sum(text.count("\n") + 1 for text, _ in blocks)
    step = min(0.0225, 0.9 / lines)
    height = 0.94
    for text, color in blocks:
        figure.text(0.715, height, text, fontsize=min(9.5, 420 * step), color=color, va="top", linespacing=1.15)
        height -= step * (text.count("\n") + 1)
    figure.legend(handles=LEGEND, loc="lower left", ncol=4, fontsize=9, frameon=False, bbox_to_anchor=(0.0, 0.0))
    figure.savefig(path)
    pyplot.close(figure)


def draw_sheet(preset, entries, path):
    """All frames at one glance. entries: (name, frame, result, image)."""
    columns = min(4, max(1, len(entries)))
    rows = max(1, -(-len(entries) // columns))
    figure = pyplot.figure(figsize=(4.5 * columns, 3.65 * rows + 1.0), dpi=100, layout="constrained")
    figure.get_layout_engine().set(rect=(0, 0.75 / (3.65 * rows + 1.0), 1, 1 - 0.75 / (3.65 * rows + 1.0)))
    must = [label for _, _, result, _ in entries for label in result["labels"] if label["must"]]
    figure.suptitle("%s preset: %d of %d shapes that must be found were found, %.1f false alarms a frame" % (
        preset, sum(label["verdict"] == "found" for label in must), len(must),
        sum(result["verdicts"].count("false") for _, _, result, _ in entries) / max(1, len(entries))),
                    fontsize=14, weight="bold")
    for k, (name, frame, result, image) in enumerate(entries):
        axes = figure.add_subplot(rows, columns, k + 1)
        draw_image(axes, frame, result, image, size=7, with_text=False)
        missed = any(label["must"] and label["verdict"] == "missed" for label in result["labels"])
        axes.set_title(heading(name, frame, result), fontsize=9.5, color=RED if missed else "black",
                       weight="bold" if missed else "normal")
    figure.legend(handles=LEGEND, loc="lower center", ncol=min(4, columns + 1), fontsize=10, frameon=False)
    figure.savefig(path)
    pyplot.close(figure)
