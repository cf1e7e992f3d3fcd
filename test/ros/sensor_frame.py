#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""sensor_frame: clouds that were moved to another frame are looked at from where the sensor was."""
import math
import random
import struct
import sys
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.client import Client
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import PATIENCE, Collector, Detector, camera_looking_ahead, cloud_message, wait_for, wall_and_ball
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import PointCloud2
from visualization_msgs.msg import MarkerArray

HEIGHT = 0.3  # m: less than half of the image is higher than the least depth above the base
NEAR_WALL, FAR_WALL, MAX_DEPTH = 1.2, 2.4, 2.0  # m
BALL, RADIUS = (0.0, 0.0, 0.8), 0.1
TILT = 0.1  # rad
LONGER_WAIT = 0.5  # s


def scene():
    """The wall steps back in the last quarter of the columns."""
    points, width, height = wall_and_ball(RADIUS, BALL, NEAR_WALL)
    steps = [FAR_WALL / NEAR_WALL if i % width >= 0.75 * width else 1.0 for i in range(len(points))]
    return [tuple(step * a for a in point) for step, point in zip(steps, points)], width, height


POINTS, WIDTH, IMAGE_HEIGHT = scene()  # in the camera's frame


def turned(vector):
    """From the camera's axes to those of the base."""
    x, y, z = vector
    return z, -x, -y


def in_base():
    moved = [turned(point) for point in POINTS]
    return cloud_message([(x, y, z + HEIGHT) for x, y, z in moved], WIDTH, IMAGE_HEIGHT, frame="base")


def true_normal(point):
    """Of the camera's frame; that of the wall is tilted about y, so that it can be told from one that was measured."""
    if point[2] < NEAR_WALL - 0.1:
        return tuple((p - c) / RADIUS for p, c in zip(point, BALL))
    return -math.sin(TILT), 0.0, -math.cos(TILT)


def in_base_with_normals():
    values = [(x, y, z + HEIGHT) + turned(true_normal(point))
              for point, (x, y, z) in ((point, turned(point)) for point in POINTS)]
    return cloud_message(values, WIDTH, IMAGE_HEIGHT, frame="base",
                         names=("x", "y", "z", "normal_x", "normal_y", "normal_z"))


def wall_in_base():
    """Of which no image tells where its camera was."""
    moved = [turned([NEAR_WALL / point[2] * a for a in point]) for point in POINTS]
    return cloud_message([(x, y, z + HEIGHT) for x, y, z in moved], WIDTH, IMAGE_HEIGHT, frame="base")


def largest(answer, kind):
    return max((p for p in answer.primitives if p.type == kind), key=lambda p: p.inlier_count)


def found(detector, make_message):
    """The first answer to such clouds with status OK."""
    answers = []

    def ok():
        answers.append(detector.ask(make_message()))
        return answers[-1].status == PrimitiveArray.OK
    return answers[-1] if wait_for(ok) else None


def camera_told(diagnostics):
    """In the last words on the input of the detector that has no sensor_frame; None before."""
    told = [v.value for m in diagnostics.all() for s in m.status if s.name == "without: input"
            for v in s.values if v.key == "camera that the points tell, x y z (m) and x y z w"]
    return told[-1] if told else None


class SensorFrame(unittest.TestCase):
    def test_says_that_there_is_no_transform_and_finds_what_the_camera_saw_when_there_is(self):
        detector, log = Detector(), Collector("/rosout", Log)
        labels = Collector("/detector/labels", PointCloud2)
        normals = Collector("/detector/normals", PointCloud2)
        self.assertTrue(detector.ready())
        self.assertTrue(wait_for(lambda: labels.connected() and normals.connected()))
        without_transform = []

        def warned():
            answer = detector.ask(in_base())  # again, as the warning is throttled
            self.assertEqual(answer.status, PrimitiveArray.NO_TRANSFORM)
            self.assertEqual(len(answer.primitives), 0)
            without_transform.append(answer.header.stamp)
            return [m for m in log.all() if m.name == "/detector" and "sensor_frame 'camera'" in m.msg and
                    "view_frames.py" in m.msg]
        self.assertTrue(wait_for(warned))

        broadcaster = tf2_ros.StaticTransformBroadcaster()
        broadcaster.sendTransform(camera_looking_ahead(HEIGHT))
        answer = found(detector, in_base)
        self.assertTrue(wait_for(lambda: [m for m in log.all() if m.name == "/detector" and m.level == Log.INFO and
                                          "the transform that was missing is there" in m.msg]))
        self.assertTrue(answer.seen_from_origin)  # of the camera
        self.check_primitives(answer)
        self.check_labels(self.of_answer(labels, answer))

        answer = found(detector, in_base_with_normals)
        self.check_primitives(answer)
        self.check_normals(self.of_answer(normals, answer))
        for outputs in (labels, normals):
            self.assertFalse(set(without_transform) & {m.header.stamp for m in outputs.all()})

    def test_waits_for_a_transform_as_long_as_it_was_told_meanwhile(self):
        detector, diagnostics, log = Detector(), Collector("/diagnostics", DiagnosticArray), Collector("/rosout", Log)
        self.assertTrue(detector.ready())
        client = Client("/detector", timeout=PATIENCE)
        usual = client.get_configuration()["transform_patience"]
        self.assertLess(usual, LONGER_WAIT)
        self.addCleanup(client.update_configuration, {"transform_patience": usual})
        client.update_configuration({"transform_patience": LONGER_WAIT})
        answer = detector.ask(cloud_message(POINTS, WIDTH, IMAGE_HEIGHT, frame="waited_for_by_this_test_alone"))
        self.assertEqual(answer.status, PrimitiveArray.NO_TRANSFORM)
        self.assertEqual(answer.points_in, len(POINTS))
        self.assertGreaterEqual(answer.processing_time, LONGER_WAIT)
        self.assertTrue(wait_for(lambda: [m for m in log.all() if m.name == "/detector" and
                                          "parameters changed: transform_patience: " in m.msg]))

        late = cloud_message(POINTS, WIDTH, IMAGE_HEIGHT, frame="moving")
        moving = camera_looking_ahead(HEIGHT)
        moving.child_frame_id, moving.header.stamp = "moving", late.header.stamp - rospy.Duration(1.0)
        broadcaster = tf2_ros.TransformBroadcaster()

        def advised():
            broadcaster.sendTransform(moving)
            detector.ask(late)
            return [s for m in diagnostics.all() for s in m.status if s.name == "detector: input" and
                    "transform_patience, %g s" % LONGER_WAIT in s.message]
        self.assertTrue(wait_for(advised))

    def of_answer(self, outputs, answer):
        """The cloud that came with this answer, where it was looked at: in the sensor's frame."""
        self.assertTrue(wait_for(lambda: outputs.last() and outputs.last().header.stamp == answer.header.stamp))
        self.assertEqual(outputs.last().header.frame_id, "camera")
        return outputs.last()

    def check_primitives(self, answer):
        self.assertEqual(answer.header.frame_id, "base")
        self.assertEqual(answer.points_used, sum(z <= MAX_DEPTH for _, _, z in POINTS))
        self.assertEqual(sorted(p.type for p in answer.primitives), [Primitive.PLANE, Primitive.SPHERE])
        ball, wall = largest(answer, Primitive.SPHERE), largest(answer, Primitive.PLANE)
        self.assertFalse(ball.concave)
        self.assertAlmostEqual(ball.radius, RADIUS, delta=0.003)
        for value, true in zip((ball.pose.pose.position.x, ball.pose.pose.position.y, ball.pose.pose.position.z),
                               (BALL[2], 0.0, HEIGHT)):
            self.assertAlmostEqual(value, true, delta=0.01)
        self.assertAlmostEqual(wall.pose.pose.position.x, NEAR_WALL, delta=0.03)

    def check_labels(self, labels):
        self.assertEqual((labels.width, labels.height), (WIDTH, IMAGE_HEIGHT))
        for i, (_, _, true) in enumerate(POINTS):
            z = struct.unpack_from("<3f", labels.data, i * labels.point_step)[2]
            if true <= MAX_DEPTH:
                self.assertAlmostEqual(z, true, delta=0.001)
            else:
                self.assertTrue(math.isnan(z))

    def check_normals(self, normals):
        self.assertGreater(normals.width, 500)
        for i in range(normals.width):
            values = struct.unpack_from("<6f", normals.data, i * normals.point_step)
            for value, true in zip(values[3:], true_normal(values[:3])):
                self.assertAlmostEqual(value, true, delta=0.001)

    def test_without_it_an_image_tells_where_its_camera_was(self):
        detector, log = Detector("/other_cloud", "/without"), Collector("/rosout", Log)
        labels, normals = Collector("/without/labels", PointCloud2), Collector("/without/normals", PointCloud2)
        markers, diagnostics = Collector("/without/markers", MarkerArray), Collector("/diagnostics", DiagnosticArray)
        self.assertTrue(detector.ready())
        self.assertTrue(wait_for(lambda: all(m.connected() for m in (labels, normals, markers))))
        answers = []

        def told():
            answers.append(detector.ask(in_base_with_normals()))
            return [m for m in log.all() if m.name == "/without" and "rows and columns tell" in m.msg]
        self.assertTrue(wait_for(told))
        self.check_primitives(answers[-1])
        self.assertTrue(wait_for(lambda: camera_told(diagnostics) not in (None, "none")))
        numbers = [float(number) for number in camera_told(diagnostics).split()]
        self.assertEqual(len(numbers), 7)
        for value, true in zip(numbers, (0.0, 0.0, HEIGHT)):
            self.assertAlmostEqual(value, true, delta=0.005)
        # z ahead along x of the base, x to the right, y down: a third of a turn, of either sign.
        sign = -1.0 if numbers[6] < 0.0 else 1.0
        for value, true in zip(numbers[3:], (-0.5, 0.5, -0.5, 0.5)):
            self.assertAlmostEqual(sign * value, true, delta=0.01)
        stamp = answers[-1].header.stamp
        self.assertTrue(wait_for(lambda: all(m.last() and m.last().header.stamp == stamp for m in (labels, normals))))
        self.assertEqual((labels.last().header.frame_id, normals.last().header.frame_id), ("base", "base"))
        for i, point in enumerate(POINTS):
            x, y, z = struct.unpack_from("<3f", labels.last().data, i * labels.last().point_step)
            if point[2] > MAX_DEPTH:
                self.assertTrue(math.isnan(x))
                continue
            for value, true in zip((x, y, z - HEIGHT), turned(point)):
                self.assertAlmostEqual(value, true, delta=0.001)
        name = [m for m in markers.last().markers if m.ns == "sphere_text"][0].pose.position
        self.assertGreater(name.z, HEIGHT + RADIUS)  # above the ball
        self.assertAlmostEqual(name.y, 0.0, delta=RADIUS)
        self.assertGreater(normals.last().width, 500)
        for i in range(normals.last().width):
            x, y, z, *normal = struct.unpack_from("<6f", normals.last().data, i * normals.last().point_step)
            for value, true in zip(normal, turned(true_normal((-y, HEIGHT - z, x)))):
                self.assertAlmostEqual(value, true, delta=0.005)

    def test_without_it_lists_are_said_to_be_taken_for_seen_from_their_origin(self):
        detector, log = Detector("/other_cloud", "/without"), Collector("/rosout", Log)
        self.assertTrue(detector.ready())

        points = random.Random(1).sample(POINTS, len(POINTS))  # in no order that could tell more

        def warned():
            for frame in ("my_optical_frame", "base"):
                answer = detector.ask(cloud_message(points, len(points), 1, frame=frame))
                self.assertEqual(answer.status, PrimitiveArray.OK)
                self.assertTrue(answer.seen_from_origin)
            return [m for m in log.all() if m.name == "/without" and "without rows and columns in frame" in m.msg]
        warnings = wait_for(warned)
        self.assertTrue(warnings)
        self.assertEqual([m.msg for m in warned() if "'base'" not in m.msg], [])
        self.assertEqual(len(warned()), 1)

    def test_without_it_the_order_of_a_list_tells_where_its_camera_was(self):
        detector = Detector("/other_cloud", "/without")
        self.assertTrue(detector.ready())
        points = [(x, y, z + HEIGHT) for x, y, z in map(turned, POINTS)]
        answer = found(detector, lambda: cloud_message(points, len(points), 1, frame="base"))
        self.assertTrue(answer)
        self.check_primitives(answer)  # also that depths were cut along the axis of the camera

    def test_without_it_the_log_and_diagnostics_ask_for_it(self):
        detector, log = Detector("/other_cloud", "/without"), Collector("/rosout", Log)
        diagnostics = Collector("/diagnostics", DiagnosticArray)
        self.assertTrue(detector.ready())

        def said():
            self.assertFalse(detector.ask(wall_in_base()).seen_from_origin)
            states = [s for m in diagnostics.all() for s in m.status if s.name == "without: input"]
            warnings = [m for m in log.all() if m.name == "/without" and "set sensor_frame" in m.msg]
            return warnings and [s for s in states if s.level == 1 and "sensor_frame" in s.message and
                                 "no" in [v.value for v in s.values if v.key == "seen from the origin"]]
        self.assertTrue(wait_for(said))
        self.assertEqual(camera_told(diagnostics), "none")


if __name__ == "__main__":
    rospy.init_node("sensor_frame_test")
    rostest.rosrun("primitect", "sensor_frame", SensorFrame, sys.argv)
