#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""RViz is started in the frame of the first primitives, and not before; in its place a program that writes down what it
is given."""
import os
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
from primitect.msg import PrimitiveArray
from ros_helpers import PATIENCE, wait_for

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "rviz_in_frame")


class RvizInFrame(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.told = os.path.join(folder.name, "told")
        stand_in = os.path.join(folder.name, "rviz")
        with open(stand_in, "w", encoding="utf-8") as file:
            file.write('#!/bin/sh\nprintf "%%s\\n" "$@" > %s.part && mv %s.part %s\n' % ((self.told,) * 3))
        os.chmod(stand_in, 0o755)
        self.environment = dict(os.environ, PATH=folder.name + ":" + os.environ["PATH"])

    def given(self, view, topic, frame):
        """What RViz is given once primitives in this frame came."""
        publisher = rospy.Publisher(topic, PrimitiveArray, queue_size=10)
        command = [sys.executable, SCRIPT, "/views", view, "/remapped", "/remapped:=" + topic]
        program = subprocess.Popen(command, env=self.environment)
        self.addCleanup(program.kill)
        self.assertTrue(wait_for(lambda: publisher.get_num_connections() > 0))
        self.assertFalse(os.path.exists(self.told))
        waiting = PrimitiveArray(status=PrimitiveArray.NO_TRANSFORM)
        waiting.header.frame_id = "frame_of_the_cloud"
        publisher.publish(waiting)
        message = PrimitiveArray()
        publisher.publish(message)  # of no frame
        message.header.frame_id = frame
        publisher.publish(message)
        self.assertEqual(program.wait(PATIENCE), 0)
        with open(self.told, encoding="utf-8") as file:
            return file.read().split("\n")[:-1]

    def test_takes_the_camera_s_view_and_its_frame_without_the_slash_of_tf(self):
        self.assertEqual(self.given("", "/one", "/lens"), ["-d", "/views/primitect.rviz", "-f", "lens", "/remapped:=/one"])

    def test_takes_the_robot_s_view_in_its_base_and_where_it_is_told_to(self):
        self.assertEqual(self.given("", "/two", "base_link")[1:4], ["/views/robot.rviz", "-f", "base_link"])
        os.remove(self.told)
        self.assertEqual(self.given("robot", "/three", "lens")[1:4], ["/views/robot.rviz", "-f", "lens"])
        os.remove(self.told)
        self.assertEqual(self.given("camera", "/four", "base_link")[1:4], ["/views/primitect.rviz", "-f", "base_link"])

    def test_says_how_it_is_used(self):
        done = subprocess.run([sys.executable, SCRIPT, "/views"], env=self.environment, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("FOLDER VIEW TOPIC", done.stderr)


if __name__ == "__main__":
    rospy.init_node("rviz_in_frame_test")
    rostest.rosrun("primitect", "rviz_in_frame", RvizInFrame, sys.argv)
