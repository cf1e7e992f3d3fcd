# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""A labelled cloud and what methods found in it, as `compare --write` leaves them (see eval/dump.h), read back."""
import json
import os

import numpy

OVERLAP = 0.6  # T of SegComp: a pair is correct when it shares as much of both
CLUTTER = -2  # label of a surface that is none of the four kinds; -1: of no shape


def read_values(folder, name, kind, count):
    """So many numbers from a raw file. Raises ValueError naming the file when there are more or fewer."""
    path = os.path.join(folder, name)
    try:
        values = numpy.fromfile(path, kind)
    except OSError as error:
        raise ValueError("%s: cannot be read: %s" % (path, error)) from error
    if count is not None and len(values) != count:
        raise ValueError("%s: has %d numbers, must have %d" % (path, len(values), count))
    return values


def read_scene(path):
    """{"title", "shape": (rows, columns), "points": n x 3 (m), "normals": n x 3, "surface": n, "truth": shapes,
    "methods": {name: {"primitives": shapes, "labels": n, "distance": n (m)}}}.

    Raises ValueError naming the file and what is wrong with it.
    """
    folder = os.path.dirname(path)
    try:
        with open(path, encoding="utf-8") as file:
            dump = json.load(file)
        rows = read_values(folder, dump["points"], "f4", None)
        rows = rows[:len(rows) // 6 * 6].reshape(-1, 6).astype(float)
        count = dump["width"] * dump["height"]
        if len(rows) != count:
            raise ValueError("%s: has %d points, must have %d" % (dump["points"], len(rows), count))
        scene = {"title": os.path.splitext(os.path.basename(path))[0].replace("_", ", seed "),
                 "shape": (dump["height"], dump["width"]), "points": rows[:, :3], "normals": rows[:, 3:],
                 "surface": read_values(folder, dump["surface"], "i4", count), "truth": dump["truth"], "methods": {}}
        for name, method in dump["methods"].items():
            scene["methods"][name] = {"primitives": method["primitives"],
                                      "labels": read_values(folder, method["labels"], "i4", count),
                                      "distance": read_values(folder, method["distance"], "f4", count)}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ValueError("%s: no dump of a scene: %s" % (path, error)) from error
    return scene


def overlaps(scene, labels, count):
    """Points that each true shape (rows) shares with each of so many detections (columns)."""
    surface, both = scene["surface"], (scene["surface"] >= 0) & (labels >= 0)
    shared = numpy.zeros((len(scene["truth"]), count), int)
    numpy.add.at(shared, (surface[both], labels[both]), 1)
    return shared


def score_scene(scene, result):
    """{"truths", "found", "correct", "typed", "pairs": {detection: true shape}} of one result, as case_score.h counts:
    points on shapes that need not be found count for nobody, nor does a detection that lies mostly on them; points on
    clutter count for no pair."""
    must = numpy.array([shape["must"] for shape in scene["truth"]], bool)
    shapes = result["primitives"]
    shared = overlaps(scene, result["labels"], len(shapes))
    optional, clutter = shared[~must].sum(axis=0), scene["surface"] == CLUTTER
    points = numpy.bincount(result["labels"][result["labels"] >= 0], minlength=len(shapes)) - optional
    own = points - numpy.bincount(result["labels"][(result["labels"] >= 0) & clutter], minlength=len(shapes))
    size = numpy.bincount(scene["surface"][scene["surface"] >= 0], minlength=len(must))
    pairs = {d: t for t in numpy.nonzero(must)[0] for d in range(len(shapes))
             if shared[t, d] > 0 and shared[t, d] >= OVERLAP * size[t] and shared[t, d] >= OVERLAP * own[d]}
    counted = [d for d in range(len(shapes)) if d in pairs or optional[d] <= points[d]]
    typed = sum(shapes[d]["type"] == scene["truth"][t]["type"] for d, t in pairs.items())
    return {"truths": int(must.sum()), "found": len(counted), "correct": len(pairs), "typed": typed, "pairs": pairs}


def matching(scene, result):
    """The true shape of each detection, one to one, largest overlaps first; None for what is left over."""
    shared = overlaps(scene, result["labels"], len(result["primitives"]))
    match, taken = [None] * shared.shape[1], set()
    for place in numpy.argsort(-shared, axis=None, kind="stable"):
        t, d = divmod(int(place), shared.shape[1])
        if shared[t, d] > 0 and match[d] is None and t not in taken:
            match[d] = t
            taken.add(t)
    return match
