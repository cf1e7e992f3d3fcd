# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Names and colours of the methods, the same in every table and plot."""

TITLES = {
    "truth": "truth handed in",
    "default": "primitect, default",
    "paper": "primitect, paper preset",
    "b": "(b) Drost* baseline",
    "c": "(c) NMS clustering",
    "d": "(d) no bin averages",
    "e": "(e) no vote spreading",
    "cgal": "CGAL Efficient RANSAC",
    "cgal-2048": "CGAL Eff. RANSAC, 2048 points",
    "cgal-3sigma": "CGAL Eff. RANSAC, epsilon 3 sigma",
    "pcl-sac": "PCL SAC loop, 4096 points",
    "pcl-planes": "PCL multi-plane",
}

# Colour-blind safe: strong blue and orange are ours, greens and purples are peers, greys are ablations.
COLOURS = {
    "truth": "#222222", "default": "#0b62b8", "paper": "#e8820c", "b": "#8c8c8c", "c": "#a9a9a9", "d": "#bdb08a",
    "e": "#c9b8c4", "cgal": "#1b8a5a", "cgal-2048": "#7cc9a3", "cgal-3sigma": "#86a818", "pcl-sac": "#8e4ab8",
    "pcl-planes": "#d36ba8",
}
MARKERS = {"truth": "", "default": "o", "paper": "s", "cgal": "^", "cgal-2048": "v", "cgal-3sigma": "<", "pcl-sac": "D",
           "pcl-planes": "P"}
WIDER = ("Epsilon 3 sigma: a point may be three times the noise away from its shape (10 mm on depth frames) instead "
         "of 1 % of the cloud's diagonal.")
OURS = ("default", "paper", "b", "c", "d", "e")


def base(method):
    """The method that a variant belongs to: "default-512" and "default-planes" are "default", "cgal:cones" is cgal."""
    name = method.split("=")[0].split(":")[0]
    if name in TITLES:
        return name
    head = name.split("-")[0]
    return head if head in TITLES else name


def title(method):
    """What a reader calls it."""
    name = method.split("=")[0]
    if name in TITLES:
        return TITLES[name]
    rest = name[len(base(name)):].strip("-:")
    return "%s, %s" % (TITLES.get(base(name), name), rest + " samples" if rest.isdigit() else rest)


def note_on_wider(labels):
    """What stands below a table with a row that has a tolerance of its own."""
    return " " + WIDER if any(label.startswith(TITLES["cgal-3sigma"]) for label in labels) else ""


def line_style(method):
    """Keyword arguments for a line of this method in any plot."""
    name = base(method)
    width = {"default": 2.8, "paper": 2.0, "truth": 1.3}.get(name, 1.1 if name in OURS else 1.5)
    return {"color": COLOURS.get(name, "#000000"), "linewidth": width, "marker": MARKERS.get(name, ""),
            "markersize": 5 if name in ("default", "paper") else 4, "label": title(name),
            "linestyle": ":" if name == "truth" else "-",
            "zorder": {"default": 5, "paper": 4}.get(name, 3)}
