#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What live_table says of messages, without a master."""
import importlib.machinery
import importlib.util
import os
import sys
import unittest
from unittest import mock

from primitect.msg import Primitive, PrimitiveArray

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "live_table")


def live_table():
    sys.dont_write_bytecode = True
    loader = importlib.machinery.SourceFileLoader("live_table", SCRIPT)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("live_table", loader))
    loader.exec_module(module)
    return module


def ball_in(frame):
    message = PrimitiveArray(points_in=640 * 480, processing_time=0.01)
    message.header.frame_id = frame
    ball = Primitive(type=Primitive.SPHERE, radius=0.05, inlier_count=5000)
    ball.pose.pose.position.z = 0.8
    message.primitives = [ball]
    return message


class LiveTable(unittest.TestCase):
    def setUp(self):
        module = live_table()
        with mock.patch.object(module.rospy, "Subscriber"):
            self.table = module.Table("primitives", "truth")

    def test_counts_what_was_found(self):
        self.table.on_truth(ball_in("camera"))
        self.table.on_primitives(ball_in("camera"))
        self.assertTrue(self.table.summary().startswith("1 frames: 100.0 % of the true objects found"))

    def test_says_that_there_is_nothing_to_compare_where_frames_differ(self):
        self.table.on_truth(ball_in("camera"))
        self.table.on_primitives(ball_in("world"))
        for said in (self.table.summary(), self.table.lines()[0]):
            self.assertIn("truth is in frame 'camera', primitives in 'world'", said)
        self.assertEqual(self.table.frames, 0)


if __name__ == "__main__":
    unittest.main()
