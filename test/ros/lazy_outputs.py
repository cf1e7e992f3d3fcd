#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""With nothing subscribed nothing is computed; each output alone wakes the input up."""
import sys
import unittest

import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from primitect.msg import PrimitiveArray
from ros_helpers import Collector, cloud_message, wait_for, wall_and_ball
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import PointCloud2
from visualization_msgs.msg import MarkerArray

SCENE = wall_and_ball()
OUTPUTS = {"primitives": PrimitiveArray, "markers": MarkerArray, "labels": PointCloud2, "normals": PointCloud2}


def subscribers(topic):
    _, subscribed, _ = rosgraph.Master("/lazy_outputs").getSystemState()
    return [node for name, nodes in subscribed for node in nodes if name == topic]


def frames_in(diagnostics):
    """The detector's own count in its newest report."""
    for array in reversed(diagnostics.all()):
        for status in array.status:
            if status.name == "detector: input" and status.values:
                return int({v.key: v.value for v in status.values}["frames in"])
    return None


class LazyOutputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.publisher = rospy.Publisher("/cloud", PointCloud2, queue_size=1, latch=True)
        cls.publisher.publish(cloud_message(*SCENE))
        cls.diagnostics = Collector("/diagnostics", DiagnosticArray)

    def asleep(self):
        return not subscribers("/cloud")

    def wait_for_reports(self, count):
        have = len(self.diagnostics.all())
        self.assertTrue(wait_for(lambda: len(self.diagnostics.all()) >= have + count))

    def test_nothing_is_computed_while_nobody_subscribes(self):
        self.assertTrue(wait_for(self.asleep))
        self.wait_for_reports(2)  # the first may still be on its way from before
        before = frames_in(self.diagnostics)
        self.assertIsNotNone(before)
        self.wait_for_reports(2)
        self.assertEqual(frames_in(self.diagnostics), before)
        self.assertTrue(self.asleep())

    def test_each_output_alone_subscribes_the_input_and_lets_go_of_it(self):
        for name, message_type in OUTPUTS.items():
            with self.subTest(name):
                self.assertTrue(wait_for(self.asleep), "still subscribed")
                output = Collector("/detector/" + name, message_type)
                self.assertTrue(wait_for(lambda: output.last() is not None), "nothing came")
                output.stop()
                self.assertTrue(wait_for(self.asleep), "subscribed without need")

    def test_silence_is_told_in_the_log_once(self):
        log = Collector("/rosout", Log)
        output = Collector("/detector/primitives", PrimitiveArray)

        def told():
            return [entry for entry in log.all() if "no cloud on /cloud for 5 s" in entry.msg]

        # The latched cloud comes, and then no other.
        self.assertTrue(wait_for(lambda: output.last() is not None and told()))
        self.assertEqual(told()[0].level, Log.WARN)
        self.wait_for_reports(3)
        self.assertEqual(len(told()), 1)
        output.stop()
        log.stop()

    def test_labels_are_organized_like_the_input(self):
        labels = Collector("/detector/labels", PointCloud2)
        self.assertTrue(wait_for(lambda: labels.last() is not None))
        message = labels.last()
        labels.stop()
        self.assertEqual((message.width, message.height), SCENE[1:])
        self.assertEqual([f.name for f in message.fields], ["x", "y", "z", "rgb", "label"])
        self.assertEqual(len(message.data), message.row_step * message.height)
        self.assertEqual(message.header.frame_id, "camera")


if __name__ == "__main__":
    rospy.init_node("lazy_outputs")
    rostest.rosrun("primitect", "lazy_outputs", LazyOutputs, sys.argv)
