#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The program detect_bag on a bag of a ball before a wall: what it prints and writes, and what it refuses."""
import io
import json
import os
import random
import resource
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import cloud_message, wall_and_ball
from sensor_msgs.msg import PointCloud2

PROGRAM = sys.argv.pop(1)


class DetectBag(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.bag = self.path("clouds.bag")
        points = wall_and_ball()
        with rosbag.Bag(self.bag, "w") as bag:
            for k in range(3):
                stamp = rospy.Time(1000, 100000000 * k)
                message = cloud_message(*points, stamp=stamp)
                if k == 2:
                    message.fields = message.fields[:2]
                bag.write("/points", message, stamp)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)

    def expect_refusal(self, code, says, *arguments):
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertTrue(done.stderr.startswith("detect_bag: "), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn(says, done.stderr)

    def test_prints_a_line_for_each_cloud_and_a_summary(self):
        done = self.run_program(self.bag)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 4)
        self.assertRegex(lines[1], r"0\.100 s +[0-9.]+ ms +1 plane, 1 sphere$")
        self.assertIn("field 'z' is missing", lines[2])
        self.assertRegex(lines[3], r"^3 clouds on /points, 2 searched\. In the mean 1\.0 planes, 1\.0 spheres, .*; 2 tracks; ")

    def test_counts_what_was_refused(self):
        done = self.run_program(self.bag, "--min_confidence", "1")
        self.assertRegex(done.stdout.splitlines()[-1],
                         r"^Tried and refused, in all of them: .*[1-9][0-9]* unlikely \(see min_confidence\)")
        done = self.run_program(self.bag, "--min_confidence", "1", "--json", "-")
        refused = [json.loads(line)["refused"]["unlikely"] for line in done.stdout.splitlines()]
        self.assertTrue(refused[0] > 0 and refused[1] > 0 and refused[2] == 0, refused)

    def test_writes_json_a_line_for_each_cloud(self):
        done = self.run_program(self.bag, "--json", "-")
        frames = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([f["stamp"]["nsecs"] for f in frames], [0, 100000000, 200000000])
        self.assertEqual([f["status"] for f in frames], ["ok", "ok", "rejected_input"])
        self.assertEqual([f["frame_id"] for f in frames], ["camera"] * 3)
        self.assertEqual([f["seen_from_origin"] for f in frames], [True] * 3)
        self.assertEqual(frames[2]["primitives"], [])
        self.assertIn("field 'z' is missing", frames[2]["problem"])
        self.assertIsNone(frames[0]["problem"])
        ball = [p for p in frames[1]["primitives"] if p["type"] == "sphere"][0]
        self.assertAlmostEqual(ball["radius"], 0.1, delta=1e-3)
        self.assertAlmostEqual(ball["center"][2], 0.8, delta=1e-3)
        self.assertEqual(ball["age"], 1)
        self.assertIn(ball["track_id"], (1, 2))
        file = self.path("found.jsonl")
        self.assertIn("3 clouds", self.run_program(self.bag, "--json", file).stdout)
        with open(file, encoding="utf-8") as lines:
            written = [json.loads(line)["primitives"] for line in lines]
        self.assertEqual(written, [f["primitives"] for f in frames])

    def test_takes_parameters_of_options_and_files(self):
        params = self.path("params.yaml")
        with open(params, "w", encoding="utf-8") as file:
            file.write("detect_spheres: false\ndetect_cylinders: false\ndetect_cones: false\n")
        done = self.run_program(self.bag, "--params", params, "--max_depth", "1", "--json", "-")
        self.assertEqual(json.loads(done.stdout.splitlines()[0])["primitives"], [])  # the wall is at 1.2 m
        self.assertIn("max_depth: 1.0", self.run_program("--max_depth", "1", "--print-params").stdout)

    def test_refuses_names_that_are_empty(self):
        for option in ("--topic", "--camera-info", "--json", "--pictures", "--out"):
            self.expect_refusal(2, option + ": empty", self.bag, option, "")

    def test_writes_a_bag_to_play_beside_the_recording(self):
        found = self.path("found.bag")
        self.assertEqual(self.run_program(self.bag, "--out", found).returncode, 0)
        with rosbag.Bag(found) as bag:
            arrays = [message for topic, message, _ in bag.read_messages("/detector/primitives")]
        self.assertEqual([a.status for a in arrays], [PrimitiveArray.OK, PrimitiveArray.OK, PrimitiveArray.REJECTED_INPUT])
        self.assertEqual(sorted(p.type for p in arrays[0].primitives), [Primitive.PLANE, Primitive.SPHERE])
        self.assertEqual(sorted(os.listdir(self.folder)), ["clouds.bag", "found.bag"])

    def test_says_where_a_disk_is_full_and_leaves_no_bag(self):
        for size in (4096, 20480):  # the first is too small for what a bag begins with
            done = subprocess.run([PROGRAM, self.bag, "--out", self.path("found.bag")], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True, check=False, restore_signals=False,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("found.bag: cannot be written: ", done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertEqual(os.listdir(self.folder), ["clouds.bag"])

    def test_says_where_standard_output_cannot_be_written(self):
        for arguments in (["--print-params"], ["--help"], [self.bag], [self.bag, "--json", "-"]):
            with open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (1, "detect_bag: standard output cannot be written\n"))

    def test_writes_pictures_of_clouds_that_were_searched(self):
        folder, points = self.path("made/for/pictures"), wall_and_ball()
        with rosbag.Bag(self.bag, "w") as bag:
            for k in range(3):
                message = cloud_message(*points, stamp=rospy.Time(1000, 100000000 * k))
                message.fields = message.fields[:2] if k == 1 else message.fields
                bag.write("/points", message, message.header.stamp)
        self.assertEqual(self.run_program(self.bag, "--pictures", folder).returncode, 0)
        self.assertEqual(sorted(os.listdir(folder)), ["000001.png", "000003.png"])
        for name in os.listdir(folder):
            with open(os.path.join(folder, name), "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_goes_on_after_messages_that_are_not_what_they_say(self):
        points, path = wall_and_ball(), self.path("odd.bag")
        data = self.serialized(cloud_message(*points, stamp=rospy.Time(1000, 100000000)))
        with rosbag.Bag(path, "w") as bag:
            bag.write("/points", cloud_message(*points, stamp=rospy.Time(1000)), rospy.Time(1000))
            bag.write("/points", self.raw(data[:5000], PointCloud2._md5sum), rospy.Time(1002), raw=True)
            bag.write("/points", cloud_message(*points, stamp=rospy.Time(1000, 200000000)), rospy.Time(1003))
        with rosbag.Bag(self.path("other.bag"), "w") as bag:
            bag.write("/points", self.raw(data, "0" * 32), rospy.Time(1001), raw=True)
        done = self.run_program(path, self.path("other.bag"), "--json", "-")
        self.assertEqual(done.returncode, 1, done.stderr)  # not all could be read
        frames = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([f["status"] for f in frames], ["ok", "rejected_input", "rejected_input", "ok"])
        self.assertIn("has other fields", frames[1]["problem"])
        self.assertIn("the bag is damaged there: ", frames[2]["problem"])
        self.assertEqual([p["age"] for p in frames[3]["primitives"]], [1, 1])  # tracks go on
        self.assertIn("2 tracks", self.run_program(path, self.path("other.bag")).stdout)

    def test_ends_with_one_and_says_why_where_nothing_was_searched(self):
        done = self.run_program(self.bag, "--max_depth", "0.2")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"3 clouds on /points, 0 searched\. The first: 0 of 19200 points are measured")

    def test_warns_of_clouds_that_are_not_seen_from_the_origin(self):
        # Above the origin, in no order that could tell more; nor does the shadow, which another camera has seen.
        points = wall_and_ball()[0] + wall_and_ball(radius=0.0)[0]
        with rosbag.Bag(self.path("moved.bag"), "w") as bag:
            moved = sorted(((y, z - 1.0, 0.5 - x) for x, y, z in points), key=lambda p: hash(p))
            bag.write("/points", cloud_message(moved, len(moved), 1, stamp=rospy.Time(1000)), rospy.Time(1000))
        done = self.run_program(self.path("moved.bag"), "--min_depth", "0")
        self.assertIn("1 of 1 clouds are not seen from the origin", done.stderr)
        self.assertEqual(self.run_program(self.bag).stderr, "")

    def test_notes_lists_that_are_taken_for_seen_from_the_origin_and_what_lies_beyond_max_depth(self):
        points, width, height = wall_and_ball()
        points = random.Random(1).sample(points, len(points))  # in no order that could tell more
        with rosbag.Bag(self.path("list.bag"), "w") as bag:
            for frame in ("base", "my_optical_frame"):
                bag.write("/points", cloud_message(points, width * height, 1, frame=frame, stamp=rospy.Time(1000)),
                          rospy.Time(1000))
        done = self.run_program(self.path("list.bag"), "--max_depth", "1")
        self.assertIn("note: 1 of 2 clouds are lists without rows and columns", done.stderr)
        self.assertRegex(done.stderr, r"note: \d+ % of what was measured lies beyond max_depth")

    def test_does_not_advise_to_look_farther_where_nothing_is_measured(self):
        with rosbag.Bag(self.path("far.bag"), "w") as bag:
            bag.write("/points", cloud_message([(float("inf"),) * 3] * 100, 100, 1, stamp=rospy.Time(1000)), rospy.Time(1000))
        done = self.run_program(self.path("far.bag"))
        self.assertIn("none of its points is measured", done.stdout)
        self.assertNotIn("beyond max_depth", done.stderr)

    def test_tells_where_the_order_of_a_list_says_that_the_camera_was(self):
        noise = random.Random(2)
        points, width, height = wall_and_ball()
        with rosbag.Bag(self.path("moved_list.bag"), "w") as bag:
            # Along its rays, by a millimetre: a wall without noise tells nothing. 1.2 m above the base, x ahead.
            scales = [1.0 + noise.gauss(0.0, 0.001) for _ in points]
            noisy = [tuple(scale * a for a in point) for scale, point in zip(scales, points)]
            moved = [(z, -x, 1.2 - y) for x, y, z in noisy]
            bag.write("/points", cloud_message(moved, width * height, 1, frame="base", stamp=rospy.Time(1000)),
                      rospy.Time(1000))
        done = self.run_program(self.path("moved_list.bag"), "--json", "-")
        frame = json.loads(done.stdout)
        self.assertTrue(frame["sensor"], done.stderr)
        for value, true in zip(frame["sensor"]["position"], (0.0, 0.0, 1.2)):
            self.assertAlmostEqual(value, true, delta=0.002)
        self.assertIn("note: 1 of 1 clouds were moved to another frame", done.stderr)
        self.assertEqual(sorted(p["type"] for p in frame["primitives"]), ["plane", "sphere"])
        done = self.run_program(self.bag, "--json", "-")
        self.assertEqual([json.loads(line)["sensor"] for line in done.stdout.splitlines()], [None] * 3)

    def test_ends_with_one_where_the_bag_is_damaged(self):
        with rosbag.Bag(self.path("damaged.bag"), "w", compression="bz2") as bag:
            bag.write("/points", cloud_message(*wall_and_ball(), stamp=rospy.Time(1000)), rospy.Time(1000))
        with open(self.path("damaged.bag"), "r+b") as file:
            file.seek(os.path.getsize(file.name) // 2)
            file.write(b"\0" * 64)
        done = self.run_program(self.path("damaged.bag"))
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("damaged", done.stdout + done.stderr)

    def test_leaves_no_bag_and_keeps_what_was_there_when_it_does_not_run(self):
        for name in ("old.jsonl", "old.bag"):
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write("old")
        self.run_program(self.path("none.bag"), "--json", self.path("old.jsonl"), "--out", self.path("old.bag"))
        for name in ("old.jsonl", "old.bag"):
            with open(self.path(name), encoding="utf-8") as file:
                self.assertEqual(file.read(), "old")
        with open("/dev/full", "w", encoding="utf-8") as full:
            self.assertEqual(subprocess.run([PROGRAM, self.bag, "--json", "-"], stdout=full, stderr=subprocess.DEVNULL,
                                            check=False).returncode, 1)

    @staticmethod
    def raw(data, md5):
        return ("sensor_msgs/PointCloud2", data, md5, PointCloud2)

    @staticmethod
    def serialized(message):
        buffer = io.BytesIO()
        message.serialize(buffer)
        return buffer.getvalue()

    def test_refuses_what_is_wrong_in_one_line(self):
        self.expect_refusal(2, "no BAG given")
        self.expect_refusal(2, "max_depth", self.bag, "--max_depth", "-1")
        self.expect_refusal(2, "--start", self.bag, "--start", "-1")
        self.expect_refusal(2, "would be overwritten", self.bag, "--out", self.bag)
        self.expect_refusal(2, "would be overwritten", self.bag, "--json", self.bag)
        self.expect_refusal(2, "named twice", self.bag, self.path("./clouds.bag"))
        self.expect_refusal(2, "--duration", self.bag, "--duration", "nan")
        os.mkdir(self.path("folder.bag"))
        self.expect_refusal(2, "no file", self.bag, "--out", self.path("folder.bag"))
        os.rmdir(self.path("folder.bag"))
        self.expect_refusal(2, "ends in .bag", self.bag, "--out", self.path("found.jsonl"))
        self.expect_refusal(2, "no file", self.bag, "--out", "-")
        os.rename(self.bag, self.path("x.bag.part"))
        self.expect_refusal(2, "would be overwritten", self.path("x.bag.part"), "--out", self.path("x.bag"))
        os.rename(self.path("x.bag.part"), self.bag)
        self.expect_refusal(2, "same file", self.bag, "--json", self.path("x.bag"), "--out", self.path("x.bag"))
        self.expect_refusal(1, "none.bag", self.path("none.bag"))
        self.expect_refusal(1, "/points (sensor_msgs/PointCloud2)", self.bag, "--topic", "/other")
        self.expect_refusal(1, "nowhere", self.bag, "--out", self.path("nowhere/found.bag"))
        self.expect_refusal(1, "nowhere", self.bag, "--json", self.path("nowhere/found.jsonl"))
        self.expect_refusal(2, "is no folder", self.bag, "--pictures", self.bag)
        for option in ("--out", "--json"):
            self.expect_refusal(2, "is a file that is written", self.bag, "--pictures", self.path("x.bag"), option, self.path("x.bag"))
        self.expect_refusal(1, "cannot be made", self.bag, "--pictures", self.path("clouds.bag/pictures"))
        self.expect_refusal(1, "0.2 s", self.bag, "--start", "100")
        self.assertEqual(os.listdir(self.folder), ["clouds.bag"])


if __name__ == "__main__":
    unittest.main()
