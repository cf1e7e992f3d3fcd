#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""sensor_frame: clouds that were moved to another frame are looked at from where the sensor was."""
import struct
import sys
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import Collector, Detector, camera_looking_ahead, cloud_message, wait_for, wall_and_ball
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import PointCloud2

HEIGHT = 0.7  # m
POINTS, WIDTH, IMAGE_HEIGHT = wall_and_ball()  # the wall is at z = 1.2 m of the camera, the ball at 0.8 m


def in_base():
    return cloud_message([(z, -x, HEIGHT - y) for x, y, z in POINTS], WIDTH, IMAGE_HEIGHT, frame="base")


def largest(answer, kind):
    return max((p for p in answer.primitives if p.type == kind), key=lambda p: p.inlier_count)


class SensorFrame(unittest.TestCase):
    def test_says_that_there_is_no_transform_and_finds_what_the_camera_saw_when_there_is(self):
        detector, log = Detector(), Collector("/rosout", Log)
        labels = Collector("/detector/labels", PointCloud2)
        self.assertTrue(detector.ready())
        self.assertTrue(wait_for(labels.connected))

        def warned():
            answer = detector.ask(in_base())  # again, as the warning is throttled
            self.assertEqual(answer.status, PrimitiveArray.NO_TRANSFORM)
            self.assertEqual(len(answer.primitives), 0)
            return [m for m in log.all() if m.name == "/detector" and "sensor_frame 'camera'" in m.msg]
        self.assertTrue(wait_for(warned))
        self.assertEqual(labels.all(), [])

        broadcaster = tf2_ros.StaticTransformBroadcaster()
        broadcaster.sendTransform(camera_looking_ahead(HEIGHT))
        answers = []

        def found():
            answers.append(detector.ask(in_base()))
            return answers[-1].status == PrimitiveArray.OK
        self.assertTrue(wait_for(found))
        answer = answers[-1]
        self.check_primitives(answer)
        self.assertTrue(wait_for(lambda: labels.last() and labels.last().header.stamp == answer.header.stamp))
        self.check_labels(labels.last())

    def check_primitives(self, answer):
        self.assertEqual(answer.header.frame_id, "base")
        self.assertEqual(sorted(p.type for p in answer.primitives), [Primitive.PLANE, Primitive.SPHERE])
        ball, wall = largest(answer, Primitive.SPHERE), largest(answer, Primitive.PLANE)
        self.assertFalse(ball.concave)
        self.assertAlmostEqual(ball.radius, 0.1, delta=0.003)
        for value, true in zip((ball.pose.pose.position.x, ball.pose.pose.position.y, ball.pose.pose.position.z),
                               (0.8, 0.0, HEIGHT)):
            self.assertAlmostEqual(value, true, delta=0.01)
        self.assertAlmostEqual(wall.pose.pose.position.x, 1.2, delta=0.03)

    def check_labels(self, labels):
        """Where they were looked at: in the sensor's frame."""
        self.assertEqual(labels.header.frame_id, "camera")
        self.assertEqual((labels.width, labels.height), (WIDTH, IMAGE_HEIGHT))
        middle = (IMAGE_HEIGHT // 2 * WIDTH + WIDTH // 2) * labels.point_step
        self.assertAlmostEqual(struct.unpack_from("<3f", labels.data, middle)[2], 0.7, delta=0.001)

    def test_without_it_the_log_and_diagnostics_ask_for_it(self):
        detector, log = Detector("/other_cloud", "/without"), Collector("/rosout", Log)
        diagnostics = Collector("/diagnostics", DiagnosticArray)
        self.assertTrue(detector.ready())

        def said():
            detector.ask(in_base())
            states = [s for m in diagnostics.all() for s in m.status if s.name == "without: input"]
            warnings = [m for m in log.all() if m.name == "/without" and "set sensor_frame" in m.msg]
            return warnings and [s for s in states if s.level == 1 and "sensor_frame" in s.message]
        self.assertTrue(wait_for(said))


if __name__ == "__main__":
    rospy.init_node("sensor_frame_test")
    rostest.rosrun("primitect", "sensor_frame", SensorFrame, sys.argv)
