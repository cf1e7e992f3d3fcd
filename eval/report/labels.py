# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Do the points that carry a detection's label lie on its true shape, and do the points there carry it?"""
import numpy

from report import trust
from report.kinds import KINDS
from report.tables import Table, cell

PERCENT = 100.0
WORST = 5  # percentile


def shares(lines, kind):
    """Of each detection of that kind: share of the points with its label that lie on the true shape; share of the
    shape's points that carry the label. Two lists, in [0, 1]."""
    counts = [found["labels"] for found in trust.detections(lines) if found["kind"] == kind and "labels" in found]
    return ([one["both"] / one["labelled"] for one in counts if one["labelled"]],
            [one["both"] / one["on_shape"] for one in counts if one["on_shape"]])


def figures(values):
    """Mean and a low percentile as cells, in percent."""
    if not values:
        return [cell(None), cell(None)]
    return [cell(PERCENT * float(numpy.mean(values))), cell(PERCENT * float(numpy.percentile(values, WORST)))]


def table(lines):
    """A row for each group of clouds and kind of which labels are known."""
    rows = []
    for name, some in trust.groups(lines).items():
        for kind in KINDS:
            right, labelled = shares(some, kind)
            if labelled:
                rows.append(("%s: %ss" % (name, kind), [cell(len(labelled), 0)] + figures(right) + figures(labelled)))
    return Table("labels", "Labels",
                 "Of right detections, of clouds whose points the detector got as they are scored: share of the points "
                 "with its label that lie on the true shape, and share of the shape's points that carry the label; "
                 "percent, mean over the detections and what 95 % of them reach.",
                 [("", 1), ("labelled points on the shape", 2), ("points of the shape labelled", 2)],
                 ["detections"] + ["mean", "5 %"] * 2, rows)
