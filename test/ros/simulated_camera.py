#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The whole way through a master: simulated camera, detector, messages, markers, labels, against the truth."""
import math
import struct
import sys
import unittest

import rospy
import rostest
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import Collector, wait_for
from sensor_msgs.msg import CameraInfo, Image, PointCloud2
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

FRAME = "camera_depth_optical_frame"
KINDS = ["plane", "sphere", "cylinder", "cone"]


def vector(p):
    return (p.x, p.y, p.z)


def dot(a, b):
    return sum(s * t for s, t in zip(a, b))


def minus(a, b):
    return tuple(s - t for s, t in zip(a, b))


def z_axis(q):
    return (2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y))


class SimulatedCamera(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        topics = {"/detector/primitives": PrimitiveArray, "/detector/markers": MarkerArray,
                  "/detector/labels": PointCloud2, "/camera/synthetic_camera/truth": PrimitiveArray,
                  "/camera/depth/points": PointCloud2, "/camera/depth/image_raw": Image,
                  "/camera/depth/camera_info": CameraInfo, "/tf": TFMessage}
        cls.topics = {topic: Collector(topic, message_type) for topic, message_type in topics.items()}
        assert wait_for(lambda: len(cls.topics["/detector/primitives"].all()) >= 3), "no primitives came"

    def all(self, topic):
        return self.topics[topic].all()

    def with_stamp(self, topic, stamp):
        def found():
            return [m for m in self.all(topic) if m.header.stamp == stamp]
        self.assertTrue(wait_for(found), "nothing with that stamp on " + topic)
        return found()[0]

    def newest_with_truth(self):
        """A message of primitives and the truth of the same frame; the first frames may have no truth yet."""
        found = []

        def search():
            truths = {m.header.stamp: m for m in self.all("/camera/synthetic_camera/truth")}
            found[:] = [(m, truths[m.header.stamp]) for m in self.all("/detector/primitives")
                        if m.header.stamp in truths]
            return found
        self.assertTrue(wait_for(search), "no truth for any frame")
        return found[-1]

    def test_keeps_stamp_and_frame_of_the_cloud(self):
        message, _ = self.newest_with_truth()
        self.assertEqual(message.header.frame_id, FRAME)
        self.assertEqual(message.status, PrimitiveArray.OK)
        self.assertEqual(message.points_in, 640 * 480)
        self.assertGreater(message.processing_time, 0.0)
        cloud = self.with_stamp("/camera/depth/points", message.header.stamp)
        self.assertEqual((cloud.width, cloud.height), (640, 480))

    def test_numbers_the_primitives(self):
        message, _ = self.newest_with_truth()
        self.assertEqual([p.id for p in message.primitives], list(range(len(message.primitives))))

    def test_finds_the_table(self):
        message, truth = self.newest_with_truth()
        table = max((p for p in truth.primitives if p.type == Primitive.PLANE), key=lambda p: p.size[0] * p.size[1])
        normal = z_axis(table.pose.pose.orientation)
        offset = dot(normal, vector(table.pose.pose.position))

        def is_the_table(p):
            # Exact depths: what is left is the voting's bins, 10 deg and 0.005 of the scene's 2 m diameter.
            along = dot(z_axis(p.pose.pose.orientation), normal)
            away = abs(dot(normal, vector(p.pose.pose.position)) - offset)
            return p.type == Primitive.PLANE and along > math.cos(math.radians(5)) and away < 0.02
        self.assertTrue([p for p in message.primitives if is_the_table(p)])

    def test_finds_a_sphere_where_there_is_one(self):
        message, truth = self.newest_with_truth()
        spheres = [p for p in truth.primitives if p.type == Primitive.SPHERE]
        self.assertTrue(spheres)

        def matches(found, true):
            away = minus(vector(found.pose.pose.position), vector(true.pose.pose.position))
            return (found.type == Primitive.SPHERE and math.sqrt(dot(away, away)) < 0.02 and
                    abs(found.radius - true.radius) < 0.02)
        self.assertTrue([s for s in spheres for p in message.primitives if matches(p, s)])

    def test_marks_every_primitive(self):
        message, _ = self.newest_with_truth()
        array = [m for m in self.all("/detector/markers") if m.markers and
                 m.markers[-1].header.stamp == message.header.stamp]
        self.assertTrue(array)
        shown = {(m.ns, m.id) for m in array[0].markers if m.action == Marker.ADD}
        for p in message.primitives:
            self.assertIn((KINDS[p.type] + "_text", p.id), shown)
        self.assertTrue({m.header.frame_id for m in array[0].markers} == {FRAME})

    def test_labels_the_points_with_id_plus_one(self):
        message, _ = self.newest_with_truth()
        labels = self.with_stamp("/detector/labels", message.header.stamp)
        self.assertEqual((labels.width, labels.height), (640, 480))
        offset = [f.offset for f in labels.fields if f.name == "label"][0]
        counts = {}
        for begin in range(0, len(labels.data), labels.point_step):
            label = struct.unpack_from("<I", labels.data, begin + offset)[0]
            counts[label] = counts.get(label, 0) + 1
        self.assertLessEqual(max(counts), len(message.primitives))
        largest = max(message.primitives, key=lambda p: p.inlier_count)
        self.assertGreater(counts.get(largest.id + 1, 0), 1000)

    def test_image_calibration_and_tf_belong_together(self):
        self.assertTrue(wait_for(lambda: self.all("/camera/depth/image_raw") and self.all("/camera/depth/camera_info")
                                 and self.all("/tf")))
        image, info = self.all("/camera/depth/image_raw")[-1], self.all("/camera/depth/camera_info")[-1]
        self.assertEqual((image.width, image.height, image.encoding), (640, 480, "32FC1"))
        self.assertEqual((info.width, info.height), (640, 480))
        # The middle of the image, seen through the calibration, is the middle of the cloud.
        cloud = self.with_stamp("/camera/depth/points", image.header.stamp)
        row, column = 330, 320
        depth = struct.unpack_from("<f", image.data, row * image.step + 4 * column)[0]
        x, y, z = struct.unpack_from("<3f", cloud.data, row * cloud.row_step + column * cloud.point_step)
        self.assertAlmostEqual(z, depth, places=6)
        self.assertAlmostEqual(x, (column - info.K[2]) / info.K[0] * depth, places=5)
        self.assertAlmostEqual(y, (row - info.K[5]) / info.K[4] * depth, places=5)
        transform = self.all("/tf")[-1].transforms[0]
        self.assertEqual((transform.header.frame_id, transform.child_frame_id), ("world", FRAME))


if __name__ == "__main__":
    rospy.init_node("simulated_camera_test")
    rostest.rosrun("primitect", "simulated_camera", SimulatedCamera, sys.argv)
