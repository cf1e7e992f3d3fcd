#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Extents of detections against what was seen: ends by what is said of them, outlines, their table."""
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.dirname(HERE), HERE]

from report import extents  # noqa: E402
from report_lines import line  # noqa: E402


def tube(beyond, on_faces=0, unseen=0, kind="cylinder"):
    extent = {"beyond_ends": beyond, "truncated": 0, "unseen_ends": unseen, "on_faces": on_faces}
    return {"kind": kind, "verdict": "right", "confidence": 0.9, "extent": extent}


def plane(overlap, truncated=0):
    extent = {"outline_overlap": overlap, "truncated": truncated, "unseen_ends": 0, "on_faces": 0}
    return {"kind": "plane", "verdict": "right", "confidence": 0.9, "extent": extent}


def frame(*detections):
    return line(set="tabletop", detections=list(detections))


def test_ends_go_by_what_is_said_of_them():
    found = extents.ends([frame(tube([0.001, 0.002], on_faces=1), tube([-0.003, 0.004], unseen=1),
                                tube([0.005, 0.006], on_faces=2, kind="cone"), plane(0.9))])
    assert found == {extents.ON_FACES: [1.0, 6.0], extents.SEEN: [2.0, 4.0, 5.0], extents.MAY_GO_ON: [-3.0]}


def test_planes_go_by_whether_they_are_whole():
    assert extents.overlaps([frame(plane(0.9), plane(0.5, truncated=4), tube([0.0, 0.0]))]) == {
        extents.WHOLE: [0.9], extents.TRUNCATED: [0.5]}


def test_the_table_has_absolute_errors_where_ends_are_known_and_signed_ones_elsewhere():
    made = extents.table([frame(tube([-0.002, -0.004], on_faces=1, unseen=2), plane(0.75)), line()])
    (name, cells), = made.rows
    assert name == "depth frames" and len(cells) == len(made.columns) == sum(wide for _, wide in made.groups)
    assert [cells[k].value for k in range(15)] == [1, 2.0, 2.0, 0, None, None, 1, -4.0, -4.0, 1, 0.75, 0.75, 0, None,
                                                   None]


def test_what_was_cut_out_and_clouds_without_extents_have_no_row():
    assert not extents.table([line(set="objects", detections=[plane(0.1)])]).rows
    assert not extents.table([line(detections=[{"kind": "plane", "verdict": "right", "confidence": 1.0}])]).rows


if __name__ == "__main__":
    for name, test in sorted(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
