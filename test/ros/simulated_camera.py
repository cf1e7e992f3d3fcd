#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The whole way through a master: simulated camera, detector, messages, markers, labels, against the truth."""
import collections
import math
import struct
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from geometry import away_from_line, between, distance, dot, vector, z_axis
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import Collector, wait_for
from sensor_msgs.msg import CameraInfo, Image, PointCloud2
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

FRAME = "camera_depth_optical_frame"
KINDS = ["plane", "sphere", "cylinder", "cone"]
FRAMES = 5
PRIMITIVES, MARKERS, LABELS = "/detector/primitives", "/detector/markers", "/detector/labels"
TRUTH, CLOUD = "/camera/synthetic_camera/truth", "/camera/depth/points"
IMAGE, INFO, TF = "/camera/depth/image_raw", "/camera/depth/camera_info", "/tf"
TYPES = {PRIMITIVES: PrimitiveArray, MARKERS: MarkerArray, LABELS: PointCloud2, TRUTH: PrimitiveArray,
         CLOUD: PointCloud2, IMAGE: Image, INFO: CameraInfo, TF: TFMessage}

# Exact depths: what is left is the voting and the fit.
POSITION = 0.02  # m
ANGLE = math.radians(10)
UNOBSERVABLE = 1.001e6  # m^2, rad^2, and rounding
ENOUGH = 0.6  # of the true bodies; small or hidden ones may be missed


def stamp_of(message):
    if isinstance(message, MarkerArray):
        return message.markers[-1].header.stamp if message.markers else None
    return message.transforms[0].header.stamp if isinstance(message, TFMessage) else message.header.stamp


def counts_of(labels):
    """How many points carry each label."""
    offset = [f.offset for f in labels.fields if f.name == "label"][0]
    return collections.Counter(struct.unpack_from("<I", labels.data, begin + offset)[0]
                               for begin in range(0, len(labels.data), labels.point_step))


def is_the_plane(found, true):
    normal = z_axis(true.pose.pose.orientation)
    away = dot(normal, vector(found.pose.pose.position)) - dot(normal, vector(true.pose.pose.position))
    return between(z_axis(found.pose.pose.orientation), normal) < ANGLE and abs(away) < POSITION


def is_the_body(found, true):
    """Sphere and cylinder: middle or axis, and radius. The seen length may differ."""
    if found.type != true.type or abs(found.radius - true.radius) > max(0.005, 0.15 * true.radius):
        return False
    position, true_position = vector(found.pose.pose.position), vector(true.pose.pose.position)
    if true.type == Primitive.SPHERE:
        return distance(position, true_position) < POSITION
    axis = z_axis(true.pose.pose.orientation)
    angle = between(z_axis(found.pose.pose.orientation), axis)
    return min(angle, math.pi - angle) < ANGLE and away_from_line(position, true_position, axis) < POSITION


class SimulatedCamera(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        collectors = {topic: Collector(topic, message_type) for topic, message_type in TYPES.items()}
        cls.diagnostics = Collector("/diagnostics", DiagnosticArray)
        cls.frames = []

        def enough():  # frames of which everything has come; a slow machine loses some
            by_stamp = {topic: {stamp_of(m): m for m in c.all()} for topic, c in collectors.items()}
            stamps = sorted(set.intersection(*(set(messages) for messages in by_stamp.values())) - {None})
            cls.frames = [{topic: messages[stamp] for topic, messages in by_stamp.items()} for stamp in stamps]
            return len(cls.frames) >= FRAMES
        complete = wait_for(enough, seconds=150)
        for collector in collectors.values():
            collector.stop()
        assert complete, "only %d complete frames came" % len(cls.frames)

    def test_keeps_frame_and_size_of_the_cloud(self):
        for frame in self.frames:
            message, cloud = frame[PRIMITIVES], frame[CLOUD]
            self.assertEqual(message.header.frame_id, FRAME)
            self.assertEqual(message.status, PrimitiveArray.OK)
            self.assertEqual((cloud.width, cloud.height), (640, 480))
            self.assertEqual(message.points_in, 640 * 480)
            self.assertGreater(message.processing_time, 0.0)

    def test_numbers_the_primitives(self):
        for frame in self.frames:
            found = frame[PRIMITIVES].primitives
            self.assertEqual([p.id for p in found], list(range(len(found))))

    def test_finds_the_table_in_every_frame(self):
        for frame in self.frames:
            planes = [p for p in frame[TRUTH].primitives if p.type == Primitive.PLANE]
            table = max(planes, key=lambda p: p.size[0] * p.size[1])
            found = [p for p in frame[PRIMITIVES].primitives if p.type == Primitive.PLANE and is_the_plane(p, table)]
            self.assertTrue(found)

    def test_finds_the_spheres_and_cylinders_where_they_are(self):
        for kind in (Primitive.SPHERE, Primitive.CYLINDER):
            pairs = [(true, frame[PRIMITIVES].primitives) for frame in self.frames
                     for true in frame[TRUTH].primitives if true.type == kind]
            found = [true for true, primitives in pairs if any(is_the_body(p, true) for p in primitives)]
            print("%s: %d of %d found in %d frames" % (KINDS[kind], len(found), len(pairs), len(self.frames)))
            self.assertTrue(pairs, "the scene has no " + KINDS[kind])
            self.assertGreaterEqual(len(found), ENOUGH * len(pairs), KINDS[kind])

    def test_says_how_sure_and_how_exact_every_primitive_is(self):
        least = rospy.get_param("/detector/min_confidence")
        for p in [p for frame in self.frames for p in frame[PRIMITIVES].primitives]:
            with self.subTest(kind=KINDS[p.type], id=p.id):
                self.assertTrue(least <= p.confidence <= 1.0, p.confidence)
                self.assertTrue(0.0 < p.coverage <= 1.0, p.coverage)
                self.assertTrue(0.0 <= p.rms_error < 0.02, p.rms_error)
                self.assertNotEqual(p.rival, p.type)
                self.assertTrue(p.rival == Primitive.NO_RIVAL or p.rival < len(KINDS), p.rival)
                self.assertEqual(p.truncated & Primitive.TRUNCATED_UNKNOWN, 0)  # it is a pinhole camera
                self.assertEqual(p.radius_stddev > 0.0, p.type != Primitive.PLANE)
                self.assertEqual(p.half_angle_stddev > 0.0, p.type == Primitive.CONE)
                self.assertTrue(0.0 < p.position_stddev < 1.0, p.position_stddev)
                self.assertEqual(p.axis_stddev > 0.0, p.type != Primitive.SPHERE)
                self.assertEqual(p.unseen_ends & Primitive.ENDS_UNKNOWN, 0)
                self.check_covariance(p)

    def check_covariance(self, p):
        rows = [p.pose.covariance[6 * i:6 * i + 6] for i in range(6)]
        for i in range(6):
            self.assertTrue(0.0 < rows[i][i] < UNOBSERVABLE, rows[i])
            for j in range(i):
                self.assertAlmostEqual(rows[i][j], rows[j][i], delta=1e-6)
                self.assertLessEqual(rows[i][j] ** 2, rows[i][i] * rows[j][j] * (1 + 1e-6) + 1e-6)
        if p.type == Primitive.SPHERE:  # its turns cannot be observed, its place can
            self.assertLess(max(rows[i][i] for i in range(3)), POSITION ** 2)
            self.assertGreater(min(rows[i][i] for i in range(3, 6)), 0.99 * UNOBSERVABLE)

    def test_numbers_things_over_frames(self):
        for before, now in zip(self.frames, self.frames[1:]):
            ids = [p.track_id for p in now[PRIMITIVES].primitives]
            self.assertEqual(len(set(ids) - {0}), len(ids), ids)
            known = {p.track_id for p in before[PRIMITIVES].primitives}
            kept = [p for p in now[PRIMITIVES].primitives if p.track_id in known]
            self.assertGreaterEqual(len(kept), ENOUGH * len(ids))
            self.assertTrue(all(p.age > 0 for p in kept))

    def test_counts_points_of_the_cloud_as_inliers(self):
        message, labels = self.frames[-1][PRIMITIVES], self.frames[-1][LABELS]
        counts = counts_of(labels)
        for p in message.primitives:
            # The last fit moves the surface a little, and points at its edges change sides.
            self.assertAlmostEqual(counts.get(p.id + 1, 0), p.inlier_count, delta=0.2 * p.inlier_count + 20)

    def test_lists_in_the_diagnostics_why_shapes_were_refused(self):
        def refused(which):
            """Counts by reason, a dict for each report with any."""
            reports = [s for a in self.diagnostics.all() for s in a.status if s.name.endswith("detector: detection")]
            counts = [{v.key[len(which):]: int(v.value) for v in s.values if v.key.startswith(which)} for s in reports]
            return [some for some in counts if sum(some.values()) > 0]
        reasons = {"few inliers", "too large", "too small", "half angle", "edge-on", "unlikely", "not seen"}
        # Every candidate is tried as every kind: some of that never comes out, in any frame.
        self.assertTrue(wait_for(lambda: len(refused("refused: ")) >= 2))
        in_all, in_last = refused("refused: "), refused("refused in last frame: ")
        self.assertEqual([set(in_all[-1]), set(in_last[-1])], [reasons, reasons])
        self.assertGreater(sum(in_all[-1].values()), sum(in_all[0].values()), "summed over the frames")
        self.assertGreater(sum(in_all[-1].values()), sum(in_last[-1].values()))

    def test_tells_in_the_diagnostics_how_noisy_the_camera_is(self):
        def noises():
            return [float(v.value) for a in self.diagnostics.all() for s in a.status if s.name.endswith("detector: input")
                    for v in s.values if v.key == "noise, times structured light's" and v.value != "unknown"]
        self.assertTrue(wait_for(noises))
        self.assertLess(noises()[-1], 0.3, "depths are exact: see the .test")

    def test_tells_in_the_diagnostics_by_how_much_the_camera_bends_what_it_sees(self):
        def waves():
            return [v.value for a in self.diagnostics.all() for s in a.status if s.name.endswith("detector: input")
                    for v in s.values if v.key == "waves of the depth, percent of it" and v.value != "no plane tells"]
        self.assertTrue(wait_for(waves))
        self.assertLess(float(waves()[-1]), 0.1, "depths are exact")

    def test_marks_every_primitive_in_its_place_and_size(self):
        for frame in self.frames:
            array = frame[MARKERS].markers
            self.assertEqual({m.header.frame_id for m in array}, {FRAME})
            shown = {(m.ns, m.id): m for m in array if m.action == Marker.ADD}
            for p in frame[PRIMITIVES].primitives:
                with self.subTest(kind=KINDS[p.type], id=p.track_id):
                    self.assertIn((KINDS[p.type] + "_text", p.track_id), shown)
                    self.check_surface(p, shown[(KINDS[p.type], p.track_id)])

    def check_surface(self, p, marker):
        if p.type in (Primitive.PLANE, Primitive.CONE):  # triangles around the marker's place
            self.assertEqual(vector(marker.scale), (1, 1, 1))
            place = vector(marker.pose.position)
            reach = 0.5 * math.hypot(*p.size) + p.radius + 0.001
            hull = [vector(corner) for corner in p.hull]
            for offset in map(vector, marker.points):
                corner = tuple(a + b for a, b in zip(place, offset))
                if hull:
                    self.assertLess(min(distance(corner, h) for h in hull), 1e-5)
                else:
                    self.assertLess(distance(corner, vector(p.pose.pose.position)), reach)
            return
        length = p.size[2] if p.type == Primitive.CYLINDER else 2 * p.radius
        self.assertEqual(vector(marker.pose.position), vector(p.pose.pose.position))
        self.assertEqual(marker.pose.orientation, p.pose.pose.orientation)
        for got, expected in zip(vector(marker.scale), (2 * p.radius, 2 * p.radius, length)):
            self.assertAlmostEqual(got, expected, places=5)

    def test_labels_the_points_with_id_plus_one(self):
        message, labels = self.frames[-1][PRIMITIVES], self.frames[-1][LABELS]
        self.assertEqual((labels.width, labels.height), (640, 480))
        counts = counts_of(labels)
        self.assertLessEqual(max(counts), len(message.primitives))
        largest = max(message.primitives, key=lambda p: p.inlier_count)
        self.assertGreater(counts.get(largest.id + 1, 0), 1000)

    def test_image_calibration_and_tf_belong_together(self):
        frame = self.frames[-1]
        image, info, cloud = frame[IMAGE], frame[INFO], frame[CLOUD]
        self.assertEqual((image.width, image.height, image.encoding), (640, 480, "32FC1"))
        self.assertEqual((info.width, info.height), (640, 480))
        # The middle of the image, seen through the calibration, is the middle of the cloud.
        row, column = 330, 320
        depth = struct.unpack_from("<f", image.data, row * image.step + 4 * column)[0]
        x, y, z = struct.unpack_from("<3f", cloud.data, row * cloud.row_step + column * cloud.point_step)
        self.assertAlmostEqual(z, depth, places=6)
        self.assertAlmostEqual(x, (column - info.K[2]) / info.K[0] * depth, places=5)
        self.assertAlmostEqual(y, (row - info.K[5]) / info.K[4] * depth, places=5)
        transform = frame[TF].transforms[0]
        self.assertEqual((transform.header.frame_id, transform.child_frame_id), ("world", FRAME))


if __name__ == "__main__":
    rospy.init_node("simulated_camera_test")
    rostest.rosrun("primitect", "simulated_camera", SimulatedCamera, sys.argv)
