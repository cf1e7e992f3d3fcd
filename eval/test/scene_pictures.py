#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of scenes: what is read from a dump, counted in it and matched, on a hand-made one."""
import json
import os
import sys
import tempfile
import unittest

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from report import clouds, scene_dump  # noqa: E402

# Ten points each of a sphere, a plane and a cylinder that need not be found, then ten of nothing.
SURFACE = numpy.repeat([0, 1, 2, -1], 10)
WITH_CLUTTER = numpy.repeat([0, 1, 2, scene_dump.CLUTTER], 10)
TRUTH = [{"type": "sphere", "must": True}, {"type": "plane", "must": True}, {"type": "cylinder", "must": False}]


def scene(labels, kinds, surface=SURFACE):
    result = {"primitives": [{"type": kind} for kind in kinds], "labels": numpy.array(labels)}
    return {"surface": surface, "truth": TRUTH}, result


def counts(labels, kinds, surface=SURFACE):
    score = scene_dump.score_scene(*scene(labels, kinds, surface))
    return tuple(score[key] for key in ("truths", "found", "correct", "typed"))


class Counts(unittest.TestCase):
    def test_the_truth_is_all_right(self):
        self.assertEqual(counts(SURFACE, ["sphere", "plane", "cylinder"]), (2, 2, 2, 2))

    def test_wrong_kind_is_correct_but_not_typed(self):
        self.assertEqual(counts(numpy.repeat([0, 1, -1, -1], 10), ["cylinder", "plane"]), (2, 2, 2, 1))

    def test_six_of_ten_points_are_enough_and_five_are_not(self):
        self.assertEqual(counts([0] * 6 + [-1] * 34, ["sphere"]), (2, 1, 1, 1))
        self.assertEqual(counts([0] * 5 + [-1] * 35, ["sphere"]), (2, 1, 0, 0))

    def test_detection_over_two_shapes_is_neither(self):
        self.assertEqual(counts([0] * 20 + [-1] * 20, ["sphere"]), (2, 1, 0, 0))

    def test_points_that_need_not_be_found_are_not_held_against_a_detection(self):
        self.assertEqual(counts([0] * 10 + [-1] * 10 + [0] * 10 + [-1] * 10, ["sphere"]), (2, 1, 1, 1))

    def test_detection_mostly_on_an_optional_shape_does_not_count(self):
        self.assertEqual(counts([-1] * 20 + [0] * 12 + [-1] * 8, ["cone"]), (2, 0, 0, 0))

    def test_clutter_spoils_no_pair_but_a_detection_of_it_counts(self):
        labels = [0] * 10 + [-1] * 20 + [0] * 10
        self.assertEqual(counts(labels, ["sphere"], WITH_CLUTTER), (2, 1, 1, 1))
        self.assertEqual(counts(labels, ["sphere"], SURFACE), (2, 1, 0, 0))
        self.assertEqual(counts([-1] * 30 + [0] * 10, ["sphere"], WITH_CLUTTER), (2, 1, 0, 0))

    def test_clutter_is_painted_like_what_belongs_to_nothing(self):
        colors = clouds.painted(numpy.array([0, -1, scene_dump.CLUTTER]), [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
        self.assertEqual(colors[1].tolist(), colors[2].tolist())
        self.assertEqual(colors[0].tolist(), [1.0, 0.0, 0.0])

    def test_nothing_found(self):
        self.assertEqual(counts([-1] * 40, []), (2, 0, 0, 0))


class Matching(unittest.TestCase):
    def test_largest_overlap_first_one_to_one(self):
        labels = [0] * 4 + [1] * 6 + [1] * 3 + [2] * 7 + [-1] * 20
        self.assertEqual(scene_dump.matching(*scene(labels, ["sphere", "sphere", "plane"])), [None, 0, 1])


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, width, height, points, **more):
        """A dump whose left half is a plane, found as a cylinder, and whose right half is nothing."""
        count = len(points)
        rows = numpy.hstack([points, numpy.tile([0.0, 0.0, 1.0], (count, 1))]).astype("f4")
        labels = numpy.where(points[:, 0] < 0, 0, -1).astype("i4")
        for name, values in (("a.f32", rows), ("a.i32", labels), ("a_b.i32", labels),
                             ("a_b.f32", numpy.abs(points[:, 2]).astype("f4"))):
            values.tofile(self.path(name))
        method = {"primitives": [{"type": "cylinder"}], "labels": "a_b.i32", "distance": "a_b.f32"}
        dump = {"width": width, "height": height, "points": "a.f32", "surface": "a.i32",
                "truth": [{"type": "plane", "must": True}], "methods": {"b": method}}
        dump.update(more)
        with open(self.path("a.json"), "w", encoding="utf-8") as file:
            json.dump(dump, file)

    def grid(self, size):
        y, x = numpy.mgrid[-1:1:size * 1j, -1:1:size * 1j]
        return numpy.stack([x.ravel(), y.ravel(), 0.01 * x.ravel()], axis=1)

    def assert_drawn(self):
        scores = clouds.draw_scene(self.path("a.json"), ["b"], self.path("a.png"))
        self.assertEqual((scores["b"]["correct"], scores["b"]["typed"]), (1, 0))
        with open(self.path("a.png"), "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_draws_a_wide_grid_a_thinned_one_a_depth_frame_and_a_part(self):
        wide = 2.0 * self.grid(60)
        frame = self.grid(60) + [0, 0, 1]
        frame[:70] = numpy.nan
        part = 0.2 * self.grid(20)
        for width, height, points in ((3600, 1, wide), (500, 1, wide[::7][:500]), (60, 60, frame), (400, 1, part)):
            self.write(width, height, points)
            self.assert_drawn()

    def test_missing_method_is_named(self):
        self.write(400, 1, self.grid(20))
        with self.assertRaisesRegex(ValueError, "has no result of c, only of b"):
            clouds.draw_scene(self.path("a.json"), ["c"], self.path("a.png"))

    def test_broken_dumps_are_named(self):
        self.write(400, 1, self.grid(20))
        os.truncate(self.path("a_b.i32"), 80)
        with self.assertRaisesRegex(ValueError, "a_b.i32: has 20 numbers, must have 400"):
            scene_dump.read_scene(self.path("a.json"))
        self.write(399, 1, self.grid(20))
        with self.assertRaisesRegex(ValueError, "a.f32: has 400 points, must have 399"):
            scene_dump.read_scene(self.path("a.json"))
        self.write(400, 1, self.grid(20), surface="none.i32")
        with self.assertRaisesRegex(ValueError, "none.i32"):
            scene_dump.read_scene(self.path("a.json"))
        with self.assertRaisesRegex(ValueError, "nowhere.json"):
            scene_dump.read_scene(self.path("nowhere.json"))


if __name__ == "__main__":
    unittest.main()
