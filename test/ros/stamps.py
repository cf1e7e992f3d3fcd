#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stamps that go back once begin a new recording; where they do so again and again log and diagnostics tell, as all
tracks begin anew each time."""
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from ros_helpers import Collector, Detector, cloud_message, wait_for, wall_and_ball
from rosgraph_msgs.msg import Log


class Stamps(unittest.TestCase):
    def test_that_go_back_again_and_again_are_told(self):
        log = Collector("/rosout", Log)
        diagnostics = Collector("/diagnostics", DiagnosticArray)
        detector = Detector("/clouds")
        self.assertTrue(detector.ready())
        points, width, height = wall_and_ball(width=40, height=30)

        def logged(text):
            return [entry.level for entry in log.all() if text in entry.msg]

        def inputs():
            return [status for array in diagnostics.all() for status in array.status
                    if status.name.endswith("detector: input")]

        def told():
            return [status for status in inputs() if status.message.startswith("stamps go back again and again")]

        def ask(seconds):
            cloud = cloud_message(points, width, height, stamp=rospy.Time.from_sec(seconds))
            self.assertIsNotNone(detector.ask(cloud), seconds)

        ask(1000)
        ask(900)
        self.assertTrue(wait_for(lambda: any(value.value == "1" for status in inputs() for value in status.values
                                             if value.key == "times that stamps went back")))
        self.assertEqual(logged("time went back by 100 s"), [Log.INFO])
        self.assertFalse(told())
        for k in range(1, 6):
            ask(1000 + k)
            ask(900 + k)
        self.assertTrue(wait_for(told))
        self.assertEqual(told()[0].level, DiagnosticStatus.WARN)
        self.assertEqual(logged("time went back"), [Log.INFO] * 2)
        self.assertEqual(logged("stamps on /clouds go back again and again"), [Log.WARN])

    def test_without_a_frame_are_told_once(self):
        log = Collector("/rosout", Log)
        detector = Detector("/clouds")
        self.assertTrue(detector.ready())
        points, width, height = wall_and_ball(width=40, height=30)

        def told():
            return [entry.msg for entry in log.all() if " have no " in entry.msg]
        for seconds in 1, 2, 3:
            cloud = cloud_message(points, width, height, frame="", stamp=rospy.Time(seconds))
            self.assertIsNotNone(detector.ask(cloud), seconds)
        self.assertTrue(wait_for(told))
        self.assertEqual(len(told()), 1)
        self.assertIn(": clouds on /clouds have no frame_id: ", told()[0])


if __name__ == "__main__":
    rospy.init_node("stamps")
    rostest.rosrun("primitect", "stamps", Stamps, sys.argv)
