#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where no cloud comes the log says why: a topic of another type, nobody who publishes it, or a publisher that is
quiet, or has fallen silent. Diagnostics do not claim that any came."""
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from primitect.msg import PrimitiveArray
from ros_helpers import Collector, wait_for
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import Image, PointCloud2


class Silence(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.log = Collector("/rosout", Log)
        cls.diagnostics = Collector("/diagnostics", DiagnosticArray)
        cls.image = rospy.Publisher("/image", Image, queue_size=1, latch=True)
        cls.image.publish(Image())
        cls.quiet = rospy.Publisher("/quiet", PointCloud2, queue_size=1)
        cls.outputs = [Collector(name + "/primitives", PrimitiveArray)
                       for name in ("/on_image", "/on_nothing", "/on_quiet", "/on_refused")]

    def why(self, node, topic):
        """What the log says of the silence, from the topic's name on; None where it says nothing."""
        start = "%s: no cloud on %s for " % (node, topic)

        def told():
            return [entry.msg for entry in self.log.all() if entry.level == Log.WARN and entry.msg.startswith(start)]
        self.assertTrue(wait_for(told), "nothing is told about " + topic)
        return told()[0].split("; ", 1)[1]

    def test_another_type_is_named_with_the_launch_file_that_takes_it(self):
        self.assertEqual(self.why("/on_image", "/image"),
                         "it is a sensor_msgs/Image, not a sensor_msgs/PointCloud2 (depth_image.launch takes depth:=TOPIC)")

    def test_a_topic_that_nobody_publishes(self):
        self.assertEqual(self.why("/on_nothing", "/misspelt"),
                         "nobody publishes it (launch files take input:=TOPIC, or depth:=TOPIC of a depth image)")

    def test_a_publisher_that_never_publishes(self):
        self.assertEqual(self.why("/on_quiet", "/quiet"),
                         "of its 1 publisher none sent any; one that makes it of a depth image needs an image, not a cloud, "
                         "and camera_info")

    def test_diagnostics_say_that_the_first_cloud_is_waited_for(self):
        def told():
            return [status.message for array in self.diagnostics.all() for status in array.status
                    if status.name.endswith("on_quiet: input")]
        self.assertTrue(wait_for(lambda: any(message.startswith("no cloud for") for message in told())))
        self.assertIn("waiting for the first cloud", told())
        self.assertNotIn("receiving", told())

    def test_diagnostics_say_so_after_a_cloud_that_was_refused_too(self):
        def told():
            return [status.message for array in self.diagnostics.all() for status in array.status
                    if status.name.endswith("on_refused: input")]
        publisher = rospy.Publisher("/refused", PointCloud2, queue_size=1, latch=True)
        publisher.publish(PointCloud2(width=1, height=1))  # without any field
        self.assertTrue(wait_for(lambda: any(message.startswith("last cloud refused") for message in told())))
        self.assertTrue(wait_for(lambda: any(message.startswith("no cloud for") and "refused" in message
                                             for message in told())))
        self.assertTrue(wait_for(lambda: [entry for entry in self.log.all() if "/on_refused: no cloud on" in entry.msg and
                                          entry.msg.endswith("its publisher sends no more")]))


if __name__ == "__main__":
    rospy.init_node("silence")
    rostest.rosrun("primitect", "silence", Silence, sys.argv)
