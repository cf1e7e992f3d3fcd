#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""grasp_of() of docs/ros_api.md, run as it stands there: where a can stands, and what is known of that in other frames
than its own."""
import math
import sys
import unittest

import numpy
from documented import documented
from primitect.msg import Primitive

SOURCE = sys.argv.pop(1)
ACROSS, ALONG = 0.0004 ** 2, 1e6  # m^2
LID, TABLE = 3, 1


def can(lean, down=False):
    """12 cm high, its axis turned by this (rad) about y from up, or from down."""
    angle = lean + (math.pi if down else 0.0)
    result = Primitive(type=Primitive.CYLINDER, size=[0.08, 0.08, 0.12], face_at_minus_z=LID if down else TABLE,
                       face_at_plus_z=Primitive.NO_FACE if not down else TABLE)
    result.pose.pose.position.x, result.pose.pose.position.y, result.pose.pose.position.z = 0.4, -0.1, 0.8
    result.pose.pose.orientation.y, result.pose.pose.orientation.w = math.sin(angle / 2), math.cos(angle / 2)
    axis = numpy.array([math.sin(angle), 0.0, math.cos(angle)])
    covariance = numpy.zeros((6, 6))
    covariance[:3, :3] = ACROSS * (numpy.eye(3) - numpy.outer(axis, axis)) + ALONG * numpy.outer(axis, axis)
    result.pose.covariance = covariance.flatten().tolist()
    return result


PLANES = [Primitive(id=TABLE, position_stddev=0.0002), Primitive(id=LID, position_stddev=0.0005)]


class Grasp(unittest.TestCase):
    def setUp(self):
        self.grasp_of = documented(SOURCE, "grasp_of")

    def test_knows_across_the_axis_what_a_milliradian_hides_in_the_frame(self):
        for down in (False, True):
            found = can(0.02, down)
            self.assertGreater(found.pose.covariance[0], 100.0)
            middle, axis, covariance, _, _ = self.grasp_of(found, PLANES)
            self.assertEqual(middle.tolist(), [0.4, -0.1, 0.8])
            self.assertAlmostEqual(axis[2], math.cos(0.02))
            values = sorted(numpy.linalg.eigvalsh(covariance))
            self.assertAlmostEqual(values[0], 0.0, delta=0.01 * ACROSS)
            for value in values[1:]:
                self.assertAlmostEqual(value, ACROSS, delta=0.01 * ACROSS)

    def test_ends_are_those_of_its_faces_whichever_way_z_points(self):
        _, _, _, bottom, top = self.grasp_of(can(0.0), PLANES)
        self.assertAlmostEqual(bottom[0], 0.74)
        self.assertAlmostEqual(top[0], 0.86)
        self.assertEqual((bottom[1], top[1]), (PLANES[0].position_stddev, None))
        _, _, _, bottom, top = self.grasp_of(can(0.0, down=True), PLANES)
        self.assertAlmostEqual(bottom[0], 0.74)
        self.assertEqual((bottom[1], top[1]), (PLANES[0].position_stddev, PLANES[1].position_stddev))

    def test_is_none_of_what_lies_or_is_hollow_or_no_can(self):
        self.assertIsNone(self.grasp_of(can(0.5), PLANES))
        hollow, ball = can(0.0), can(0.0)
        hollow.concave, ball.type = True, Primitive.SPHERE
        self.assertIsNone(self.grasp_of(hollow, PLANES))
        self.assertIsNone(self.grasp_of(ball, PLANES))


if __name__ == "__main__":
    unittest.main()
