#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds that make no sense get an empty array with the reason, and the node goes on."""
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from primitect.msg import PrimitiveArray
from rosgraph_msgs.msg import Log
from ros_helpers import Collector, Detector, cloud_message, wait_for, wall_and_ball
from sensor_msgs.msg import PointField

GRID = [(0.1 * column, 0.1 * row, 1.0) for row in range(3) for column in range(4)]


def broken(change, **more):
    message = cloud_message(GRID, 4, 3, **more)
    change(message)
    return message


def without_z(message):
    message.fields.pop()


def integers(message):
    message.fields[1].datatype = PointField.INT32


def array_field(message):
    message.fields[0].count = 3


def field_beyond_point(message):
    message.fields[2].offset = 4294967292


def short_data(message):
    message.data = message.data[:-1]


def no_data(message):
    message.data = b""


def huge_width(message):
    message.width = 4294967295


def huge_both(message):
    message.width = message.height = 65536


def short_rows(message):
    message.row_step = 1


def no_point_step(message):
    message.point_step = 0


def big_endian(message):
    message.is_bigendian = True


def half_of_the_normals(message):
    message.fields += [PointField("normal_x", 0, PointField.FLOAT32, 1)]


ZOO = [without_z, integers, array_field, field_beyond_point, short_data, no_data, huge_width, huge_both, short_rows,
       no_point_step, big_endian, half_of_the_normals]


class BadMessages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.log = Collector("/rosout", Log)
        cls.diagnostics = Collector("/diagnostics", DiagnosticArray)
        cls.detector = Detector()
        assert cls.detector.ready()

    def status_of(self, message):
        answer = self.detector.ask(message)
        self.assertIsNotNone(answer, "no answer")
        self.assertEqual(answer.header.frame_id, message.header.frame_id)
        self.assertEqual(len(answer.primitives), 0)
        return answer.status

    def test_are_rejected_each(self):
        for change in ZOO:
            with self.subTest(change.__name__):
                self.assertEqual(self.status_of(broken(change)), PrimitiveArray.REJECTED_INPUT)

    def test_say_what_was_wrong_and_what_was_expected(self):
        self.assertTrue(self.warned(broken(without_z), "refuses a cloud", "expected", "'z'"))

    def test_are_shown_in_the_diagnostics(self):
        self.status_of(broken(big_endian))

        def warned():
            return [s for a in self.diagnostics.all() for s in a.status
                    if s.name == "detector: input" and s.level == 1 and "big-endian" in s.message]
        self.assertTrue(wait_for(warned))

    def test_without_points_are_empty_input(self):
        nan = float("nan")
        self.assertEqual(self.status_of(cloud_message([], 0, 0)), PrimitiveArray.EMPTY_INPUT)
        self.assertEqual(self.status_of(cloud_message([], 0, 7)), PrimitiveArray.EMPTY_INPUT)
        self.assertEqual(self.status_of(cloud_message([(nan, nan, nan)] * 12, 4, 3)), PrimitiveArray.EMPTY_INPUT)
        self.assertEqual(self.status_of(cloud_message([(0, 0, 0)] * 12, 4, 3)), PrimitiveArray.EMPTY_INPUT)
        self.assertEqual(self.status_of(cloud_message([(1, 1, 50)] * 12, 4, 3)), PrimitiveArray.EMPTY_INPUT)

    def test_with_too_few_points_say_so(self):
        self.assertEqual(self.status_of(cloud_message([(0, 0, 1)], 1, 1)), PrimitiveArray.TOO_FEW_POINTS)
        self.assertEqual(self.status_of(cloud_message([(0, 0, 1)] * 400, 20, 20)), PrimitiveArray.TOO_FEW_POINTS)

    def warned(self, message, *parts):
        """True when a warning with all of these parts came; asks again and again, as warnings are throttled."""
        def found():
            self.status_of(message)
            message.header.stamp = rospy.Time.now()
            return [m for m in self.log.all() if m.name == "/detector" and m.level == Log.WARN and
                    all(part in m.msg for part in parts)]
        return wait_for(found)

    def test_without_enough_points_are_explained(self):
        self.assertTrue(self.warned(cloud_message([(1, 1, 50)] * 12, 4, 3), "0 of 12 points", "min_depth (0.1 m)",
                                    "max_depth (2.0 m)", "expected at least 16"))
        self.assertTrue(self.warned(cloud_message(GRID, 4, 3), "12 of 12 points", "expected at least 16"))

    def test_without_enough_points_are_counted_in_the_diagnostics(self):
        def values_of(status):
            return {v.key: v.value for v in status.values}

        def counted():
            self.status_of(cloud_message([], 0, 0))
            return [s for a in self.diagnostics.all() for s in a.status
                    if s.name == "detector: input" and s.level == 1 and "0 of 0 points" in s.message and
                    int(values_of(s)["rejected: empty_input"]) > 0 and
                    values_of(s)["seen from the origin"] == "unknown"]
        self.assertTrue(wait_for(counted))

    def test_may_have_any_stamp(self):
        points, width, height = wall_and_ball()
        # Farther apart than a ros::Duration can hold (68 years), forwards and backwards.
        for seconds in (1, 4000000000, 4000000001, 2):
            answer = self.detector.ask(cloud_message(points, width, height, stamp=rospy.Time(seconds)))
            self.assertIsNotNone(answer, "no answer to stamp %d" % seconds)
            self.assertEqual(answer.status, PrimitiveArray.OK)

    def test_do_not_spoil_the_good_ones_that_follow(self):
        self.status_of(broken(huge_width))
        points, width, height = wall_and_ball()
        answer = self.detector.ask(cloud_message(points, width, height))
        self.assertEqual(answer.status, PrimitiveArray.OK)
        self.assertEqual(answer.points_in, width * height)
        self.assertTrue(answer.primitives)


if __name__ == "__main__":
    rospy.init_node("bad_messages")
    rostest.rosrun("primitect", "bad_messages", BadMessages, sys.argv)
