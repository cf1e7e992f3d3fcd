#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""solid_of() of docs/ros_api.md, run as it stands there: its solids are where the primitives are."""
import math
import sys
import unittest

from documented import documented
from primitect.msg import Primitive
from shape_msgs.msg import SolidPrimitive

SOURCE = sys.argv.pop(1)


def turned(q, v):
    """v, turned by the quaternion."""
    def product(a, b):
        ax, ay, az, aw = a
        bx, by, bz, bw = b
        return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
                aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)
    return product(product((q.x, q.y, q.z, q.w), (*v, 0.0)), (-q.x, -q.y, -q.z, q.w))[:3]


def primitive(kind, **fields):
    result = Primitive(type=kind, **fields)
    position, q = result.pose.pose.position, result.pose.pose.orientation
    position.x, position.y, position.z = 0.3, -0.2, 1.5
    parts = (0.2, -0.4, 0.6, 0.7)
    norm = math.sqrt(sum(p * p for p in parts))
    q.x, q.y, q.z, q.w = (p / norm for p in parts)
    return result


class Solids(unittest.TestCase):
    def setUp(self):
        self.solid_of = documented(SOURCE, "solid_of")

    def expect_near(self, point, other):
        for a, b in zip(point, other):
            self.assertAlmostEqual(a, b, places=6)

    def expect_same_place(self, pose, of):
        self.expect_near((pose.position.x, pose.position.y, pose.position.z), (0.3, -0.2, 1.5))
        for v in ((1, 0, 0), (0, 0, 1)):
            self.expect_near(turned(pose.orientation, v), turned(of.pose.pose.orientation, v))

    def test_of_a_sphere_has_its_radius(self):
        ball = primitive(Primitive.SPHERE, radius=0.1)
        solid, pose = self.solid_of(ball)
        self.assertEqual((solid.type, list(solid.dimensions)), (SolidPrimitive.SPHERE, [0.1]))
        self.expect_same_place(pose, ball)

    def test_of_a_cylinder_has_its_length_and_radius(self):
        can = primitive(Primitive.CYLINDER, radius=0.03, size=[0.06, 0.06, 0.12])
        solid, pose = self.solid_of(can)
        self.assertEqual(solid.type, SolidPrimitive.CYLINDER)
        self.assertEqual(solid.dimensions[SolidPrimitive.CYLINDER_HEIGHT], 0.12)
        self.assertEqual(solid.dimensions[SolidPrimitive.CYLINDER_RADIUS], 0.03)
        self.expect_same_place(pose, can)

    def test_of_a_plane_lies_below_it(self):
        table = primitive(Primitive.PLANE, size=[0.8, 0.5, 0.0])
        solid, pose = self.solid_of(table, thickness=0.04)
        self.assertEqual((solid.type, list(solid.dimensions)), (SolidPrimitive.BOX, [0.8, 0.5, 0.04]))
        normal = turned(table.pose.pose.orientation, (0, 0, 1))
        top = [p + 0.02 * n for p, n in zip((pose.position.x, pose.position.y, pose.position.z), normal)]
        self.expect_near(top, (0.3, -0.2, 1.5))
        self.expect_near(turned(pose.orientation, (0, 0, 1)), normal)

    def test_of_a_cone_points_to_its_tip(self):
        cone = primitive(Primitive.CONE, radius=0.05, radius_small=0.001, size=[0.1, 0.1, 0.15])
        solid, pose = self.solid_of(cone)
        self.assertEqual((solid.type, list(solid.dimensions)), (SolidPrimitive.CONE, [0.15, 0.05]))
        away_from_tip = turned(cone.pose.pose.orientation, (0, 0, 1))
        self.expect_near(turned(pose.orientation, (0, 0, 1)), [-a for a in away_from_tip])
        self.expect_near(turned(pose.orientation, (1, 0, 0)), turned(cone.pose.pose.orientation, (1, 0, 0)))

    def test_of_a_cone_without_its_tip_is_the_cylinder_around_it(self):
        cup = primitive(Primitive.CONE, radius=0.05, radius_small=0.03, size=[0.1, 0.1, 0.15])
        solid, pose = self.solid_of(cup)
        self.assertEqual((solid.type, list(solid.dimensions)), (SolidPrimitive.CYLINDER, [0.15, 0.05]))
        self.expect_same_place(pose, cup)

    def test_leaves_the_message_as_it_is(self):
        table = primitive(Primitive.PLANE, size=[0.8, 0.5, 0.0])
        self.solid_of(table)
        self.expect_same_place(table.pose.pose, table)


if __name__ == "__main__":
    unittest.main()
