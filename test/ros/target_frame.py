#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""target_frame: primitives move along with tf; without a transform the reason is said."""
import sys
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import Collector, Detector, cloud_message, wait_for, wall_and_ball
from rosgraph_msgs.msg import Log
from visualization_msgs.msg import MarkerArray

SCENE = wall_and_ball()  # the wall is at z = 1.2 m of the camera


def camera_above_base():
    """The camera looks down on the base from 5 m: its z axis is the base's -z axis."""
    transform = TransformStamped()
    transform.header.frame_id, transform.child_frame_id = "base", "camera"
    transform.transform.translation.z = 5.0
    transform.transform.rotation.x = 1.0
    return transform


class TargetFrame(unittest.TestCase):
    def test_says_that_there_is_no_transform_and_moves_the_primitives_when_there_is(self):
        detector = Detector()
        log = Collector("/rosout", Log)
        markers = Collector("/detector/markers", MarkerArray)
        self.assertTrue(detector.ready())

        def warned():
            answer = detector.ask(cloud_message(*SCENE))  # again, as the warning is throttled
            self.assertEqual(answer.status, PrimitiveArray.NO_TRANSFORM)
            self.assertEqual(len(answer.primitives), 0)
            return [m for m in log.all() if m.name == "/detector" and "'camera'" in m.msg and "'base'" in m.msg]
        self.assertTrue(wait_for(warned))

        broadcaster = tf2_ros.StaticTransformBroadcaster()
        broadcaster.sendTransform(camera_above_base())
        answers = []

        def moved():
            answers.append(detector.ask(cloud_message(*SCENE)))
            return answers[-1].status == PrimitiveArray.OK
        self.assertTrue(wait_for(moved))
        answer = answers[-1]
        self.assertEqual(answer.header.frame_id, "base")
        wall = max((p for p in answer.primitives if p.type == Primitive.PLANE), key=lambda p: p.inlier_count)
        self.assertAlmostEqual(wall.pose.pose.position.z, 5.0 - 1.2, delta=0.03)
        for corner in wall.hull:
            self.assertAlmostEqual(corner.z, 5.0 - 1.2, delta=0.1)
        self.assertTrue(wait_for(lambda: markers.last() and markers.last().markers[-1].header.frame_id == "base"))


if __name__ == "__main__":
    rospy.init_node("target_frame_test")
    rostest.rosrun("primitect", "target_frame", TargetFrame, sys.argv)
