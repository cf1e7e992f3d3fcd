#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Labels of detections against true surfaces: shares of points, their table."""
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.dirname(HERE), HERE]

from report import labels  # noqa: E402
from report_lines import line  # noqa: E402


def found(kind, labelled, on_shape, both):
    return {"kind": kind, "verdict": "right", "confidence": 0.9,
            "labels": {"labelled": labelled, "on_shape": on_shape, "both": both}}


def frame(*detections):
    return line(set="tabletop", detections=list(detections))


def test_shares_are_of_what_is_labelled_and_of_what_there_is():
    frames = [frame(found("plane", 100, 80, 60), found("cone", 10, 10, 10)), frame(found("plane", 50, 200, 50))]
    assert labels.shares(frames, "plane") == ([0.6, 1.0], [0.75, 0.25])


def test_a_shape_without_labelled_points_has_all_of_them_missing():
    assert labels.shares([frame(found("sphere", 0, 80, 0))], "sphere") == ([], [0.0])


def test_each_kind_that_is_known_has_a_row():
    made = labels.table([frame(found("plane", 100, 80, 60), found("cone", 10, 20, 10)), line(
        detections=[{"kind": "plane", "verdict": "right", "confidence": 1.0}])])
    assert [name for name, _ in made.rows] == ["depth frames: planes", "depth frames: cones"]
    assert all(len(cells) == len(made.columns) == sum(wide for _, wide in made.groups) for _, cells in made.rows)
    assert [one.value for one in made.rows[1][1]] == [1, 100.0, 100.0, 50.0, 50.0]


if __name__ == "__main__":
    for name, test in sorted(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
