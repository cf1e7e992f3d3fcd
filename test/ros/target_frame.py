#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""target_frame: primitives move along with tf; without a transform the reason is said."""
import os
import sys
import unittest
import xmlrpc.client

import rosgraph
import rosnode
import rospy
import rostest
import tf2_ros
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import Collector, Detector, camera_looking_ahead, cloud_message, wait_for, wall_and_ball
from rosgraph_msgs.msg import Log
from visualization_msgs.msg import MarkerArray

SCENE = wall_and_ball()  # the wall is at z = 1.2 m of the camera


HEIGHT = 0.7  # m
UNOBSERVABLE = 1e6  # m^2


def threads_of(node):
    """How many threads a node's process has; None while it is not up."""
    uri = rosnode.get_api_uri(rosgraph.Master("/test"), node)
    if not uri:
        return None
    process = xmlrpc.client.ServerProxy(uri).getPid("/test")[2]
    return len(os.listdir("/proc/%d/task" % process))


class TargetFrame(unittest.TestCase):
    def test_adds_no_thread_to_listen_to_tf(self):
        self.assertTrue(Detector().ready())
        counts = []

        def alike():
            counts[:] = [threads_of("/detector"), threads_of("/detector_without_frame")]
            return None not in counts and counts[0] == counts[1]
        self.assertTrue(wait_for(alike), "threads with and without target_frame: %s" % counts)

    def test_says_that_there_is_no_transform_and_moves_the_primitives_when_there_is(self):
        detector = Detector()
        log = Collector("/rosout", Log)
        markers = Collector("/detector/markers", MarkerArray)
        self.assertTrue(detector.ready())

        def warned():
            answer = detector.ask(cloud_message(*SCENE))  # again, as the warning is throttled
            self.assertEqual(answer.status, PrimitiveArray.NO_TRANSFORM)
            self.assertEqual(len(answer.primitives), 0)
            self.assertEqual(answer.header.frame_id, "camera")
            return [m for m in log.all() if m.name == "/detector" and "'camera'" in m.msg and "'base'" in m.msg]
        self.assertTrue(wait_for(warned))
        self.check_frames_of_what_is_not_searched(detector)

        broadcaster = tf2_ros.StaticTransformBroadcaster()
        broadcaster.sendTransform(camera_looking_ahead(HEIGHT))
        answers = []

        def moved():
            answers.append(detector.ask(cloud_message(*SCENE)))
            return answers[-1].status == PrimitiveArray.OK
        self.assertTrue(wait_for(moved))
        self.assertTrue(wait_for(lambda: [m for m in log.all() if m.name == "/detector" and m.level == Log.INFO and
                                          "the transform that was missing is there" in m.msg]))
        answer = answers[-1]
        self.assertEqual(answer.header.frame_id, "base")
        wall = max((p for p in answer.primitives if p.type == Primitive.PLANE), key=lambda p: p.inlier_count)
        self.assertAlmostEqual(wall.pose.pose.position.x, 1.2, delta=0.03)
        for corner in wall.hull:
            self.assertAlmostEqual(corner.x, 1.2, delta=0.1)
        self.check_covariance_of_wall(wall)
        ball = max((p for p in answer.primitives if p.type == Primitive.SPHERE), key=lambda p: p.inlier_count)
        self.assertAlmostEqual(ball.pose.pose.position.x, 0.8, delta=0.01)
        self.assertAlmostEqual(ball.pose.pose.position.z, HEIGHT, delta=0.01)
        # Seen from one side, its distance is what is known least of its place.
        variances = ball.pose.covariance[0:36:7]
        self.assertGreater(variances[0], max(variances[1:3]))
        self.assertLess(variances[0], 0.01 ** 2)
        self.assertTrue(wait_for(lambda: markers.last() and [m.header.frame_id for m in markers.last().markers][-1:] ==
                                 ["base"]))
        self.check_frames_of_what_is_not_searched(detector)

    def check_frames_of_what_is_not_searched(self, detector):
        """The cloud's, whether target_frame can be reached or not."""
        rejected = cloud_message(*SCENE)
        rejected.fields.pop()
        for message, status in ((rejected, PrimitiveArray.REJECTED_INPUT),
                                (cloud_message([], 0, 0), PrimitiveArray.EMPTY_INPUT),
                                (cloud_message([(0, 0, 1)], 1, 1), PrimitiveArray.TOO_FEW_POINTS)):
            answer = detector.ask(message)
            self.assertEqual((answer.status, answer.header.frame_id), (status, "camera"))

    def check_covariance_of_wall(self, wall):
        """Ahead is where the wall is known: shift along x, turns about y and z. All else cannot be observed."""
        shift_x, shift_y, shift_z, turn_x, turn_y, turn_z = wall.pose.covariance[0:36:7]
        for known in (shift_x, turn_y, turn_z):
            # Below that of one point (m^2, rad^2); the wall is not exactly across, so that 1e6 leaks in.
            self.assertLess(abs(known), 0.02 * UNOBSERVABLE)
        for unknown in (shift_y, shift_z, turn_x):
            self.assertGreater(unknown, 0.9 * UNOBSERVABLE)


if __name__ == "__main__":
    rospy.init_node("target_frame_test")
    rostest.rosrun("primitect", "target_frame", TargetFrame, sys.argv)
