# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Is a detection as long and as wide as what is seen of the true shape?"""
import numpy

from report import trust
from report.tables import Table, cell

MILLIMETRES = 1000.0
ON_FACES, SEEN, MAY_GO_ON = "on faces", "seen", "may go on"  # what a detection says of an end
WHOLE, TRUNCATED = "whole", "truncated"


def ends(lines):
    """How far ends lie beyond what is seen (mm), by what the detections say of them: {ON_FACES: [mm], ...}."""
    result = {ON_FACES: [], SEEN: [], MAY_GO_ON: []}
    for found in trust.detections(lines):
        extent = found.get("extent", {})
        for k, beyond in enumerate(extent.get("beyond_ends", ())):
            said = ON_FACES if extent["on_faces"] >> k & 1 else MAY_GO_ON if extent["unseen_ends"] >> k & 1 else SEEN
            result[said].append(MILLIMETRES * beyond)
    return result


def overlaps(lines):
    """Shares in [0, 1] of planes' outlines, by whether the detections say that they are whole."""
    result = {WHOLE: [], TRUNCATED: []}
    for found in trust.detections(lines):
        extent = found.get("extent", {})
        if "outline_overlap" in extent:
            result[TRUNCATED if extent["truncated"] else WHOLE].append(extent["outline_overlap"])
    return result


def figures(values, extreme, digits):
    """Count, median and a percentile as cells."""
    if not values:
        return [cell(0, 0), cell(None), cell(None)]
    return [cell(len(values), 0), cell(float(numpy.median(values)), digits),
            cell(float(numpy.percentile(values, extreme)), digits)]


def table(lines):
    """A row for each group of clouds whose truth tells how much of a shape is seen; of frames of which a thing was cut
    out it tells how much was seen before."""
    rows = []
    for name, some in trust.groups(lines).items():
        if name == trust.CUT_OUTS:
            continue
        found, shared = ends(some), overlaps(some)
        cells = [one for said in (ON_FACES, SEEN) for one in figures(list(map(abs, found[said])), 95, 2)]
        cells += figures(found[MAY_GO_ON], 95, 2)
        cells += [one for said in (WHOLE, TRUNCATED) for one in figures(shared[said], 5, 3)]
        if any(map(len, found.values())) or any(map(len, shared.values())):
            rows.append((name, cells))
    return Table("extents", "Extent",
                 "Of right detections on simulated depth frames, against what is seen of the true shape, without "
                 "noise. Ends of cylinders and cones along the axis: on a face, as the table that a thing stands on "
                 "(it lies beyond what is seen where something hides the foot), and seen: absolute errors; those that "
                 "the detection says may go on: how far they lie beyond the last point seen. Planes: area that both "
                 "outlines share over that of both together, of planes said to be whole and of those said to be cut "
                 "off.",
                 [("ends on faces", 3), ("ends seen", 3), ("ends that may go on", 3), ("whole planes", 3),
                  ("truncated planes", 3)],
                 ["ends", "median mm", "95 % mm"] * 3 + ["planes", "median", "5 %"] * 2, rows)
