#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""dynamic_reconfigure changes what the next frame gives; contradictions are refused."""
import sys
import unittest

import rospy
import rostest
from dynamic_reconfigure.client import Client
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import PATIENCE, Detector, cloud_message, wall_and_ball

SCENE = wall_and_ball()


class LiveParameters(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.detector = Detector()
        assert cls.detector.ready()
        cls.client = Client("/detector", timeout=PATIENCE)

    def types(self):
        answer = self.detector.ask(cloud_message(*SCENE))
        self.assertIsNotNone(answer, "no answer")
        return answer.status, {p.type for p in answer.primitives}

    def test_switch_a_kind_off_and_on(self):
        self.assertIn(Primitive.PLANE, self.types()[1])
        self.client.update_configuration({"detect_planes": False})
        self.assertNotIn(Primitive.PLANE, self.types()[1])
        self.client.update_configuration({"detect_planes": True})
        self.assertIn(Primitive.PLANE, self.types()[1])

    def test_move_the_depth_cut(self):
        self.client.update_configuration({"max_depth": 0.3})
        self.assertEqual(self.types()[0], PrimitiveArray.EMPTY_INPUT)
        self.client.update_configuration({"max_depth": 2.0})
        self.assertEqual(self.types()[0], PrimitiveArray.OK)

    def test_keep_their_values_when_the_new_ones_contradict_each_other(self):
        before = self.client.get_configuration()["min_depth"]
        taken = self.client.update_configuration({"min_depth": 5.0})
        self.assertEqual(taken["min_depth"], before)
        self.assertEqual(rospy.get_param("/detector/min_depth"), before)
        self.assertEqual(self.types()[0], PrimitiveArray.OK)

    def test_are_on_the_parameter_server(self):
        for name in ("samples", "max_depth", "clustering", "detect_cones"):
            self.assertEqual(rospy.get_param("/detector/" + name), self.client.get_configuration()[name])


if __name__ == "__main__":
    rospy.init_node("live_parameters")
    rostest.rosrun("primitect", "live_parameters", LiveParameters, sys.argv)
