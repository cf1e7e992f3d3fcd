#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""max_latency: a bound that every machine misses costs samples, not messages; it is told, and off again it is gone."""
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from dynamic_reconfigure.client import Client
from primitect.msg import PrimitiveArray
from ros_helpers import PATIENCE, Collector, Detector, cloud_message, wait_for, wall_and_ball
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import PointCloud2

SCENE = wall_and_ball()
FRAMES = 10
UNATTAINABLE = 1e-6  # s: reading the clock takes longer than a tenth of it


class MaxLatency(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.detector = Detector()
        cls.answers = Collector("/detector/primitives", PrimitiveArray)
        cls.diagnostics = Collector("/diagnostics", DiagnosticArray)
        cls.log = Collector("/rosout", Log)
        assert cls.detector.ready() and wait_for(cls.answers.connected)
        cls.client = Client("/detector", timeout=PATIENCE)
        assert wait_for(cls.log_is_heard)

    @classmethod
    def log_is_heard(cls):
        cls.client.update_configuration({"max_latency": 0.0})  # which is logged
        return any(entry.name == "/detector" for entry in cls.log.all())

    def tearDown(self):
        self.client.update_configuration({"max_latency": 0.0})

    def samples(self):
        answer = self.detector.ask(cloud_message(*SCENE))
        self.assertIsNotNone(answer, "no answer")
        self.assertEqual(answer.status, PrimitiveArray.OK)
        return answer.samples

    def timing(self):
        """The newest report of the detector on its time: level and values."""
        for array in reversed(self.diagnostics.all()):
            for status in array.status:
                if status.name == "detector: timing":
                    return status.level, {v.key: v.value for v in status.values}
        return None, {}

    def warnings(self):
        return [entry for entry in self.log.all() if entry.level == Log.WARN and "max_latency" in entry.msg]

    def test_out_of_reach_costs_samples_but_no_message(self):
        everything = self.samples()
        self.client.update_configuration({"max_latency": UNATTAINABLE})
        before = len(self.answers.all())
        used = [self.samples() for _ in range(FRAMES)]
        self.assertEqual(len(self.answers.all()) - before, FRAMES)
        self.assertTrue(all(count < everything for count in used), (everything, used))
        self.assertLess(used[-1], used[0])
        self.client.update_configuration({"max_latency": 0.0})
        self.assertEqual(self.samples(), everything)

    def test_out_of_reach_is_told(self):
        told = len(self.warnings())
        self.client.update_configuration({"max_latency": UNATTAINABLE})
        for _ in range(FRAMES):
            self.samples()
        self.assertTrue(wait_for(lambda: len(self.warnings()) > told), "no warning")
        self.assertTrue(wait_for(lambda: self.timing()[1].get("frames over max_latency") == str(FRAMES)), self.timing())
        level, values = self.timing()
        self.assertEqual(level, DiagnosticStatus.WARN)
        self.assertEqual(values["frames under max_latency"], "0")
        self.assertEqual(values["max_latency ms"], "0.001")
        self.assertLess(float(values["share of the samples"]), 1.0)
        self.assertEqual(len(self.warnings()), told + 1, "one warning is enough")

    def test_leaves_out_what_is_published_to_be_looked_at(self):
        labels = Collector("/detector/labels", PointCloud2)
        self.assertTrue(wait_for(labels.connected))
        self.samples()
        self.assertTrue(wait_for(lambda: labels.all()))
        self.assertTrue(wait_for(lambda: "publish ms p50 p95 max" in self.timing()[1]), self.timing())

    def test_is_not_mentioned_while_it_is_off(self):
        self.assertTrue(wait_for(lambda: self.timing()[1] and "max_latency ms" not in self.timing()[1]))


if __name__ == "__main__":
    rospy.init_node("max_latency")
    rostest.rosrun("primitect", "max_latency", MaxLatency, sys.argv)
