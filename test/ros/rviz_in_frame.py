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
import yaml
from geometry_msgs.msg import Point32
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import PATIENCE, wait_for

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCRIPT = os.path.join(ROOT, "scripts", "rviz_in_frame")


class RvizInFrame(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.told = os.path.join(folder.name, "told")
        stand_in = os.path.join(folder.name, "rviz")
        with open(stand_in, "w", encoding="utf-8") as file:
            file.write('#!/bin/sh\nprintf "%%s\\n" "$@" > %s.part && mv %s.part %s\n' % ((self.told,) * 3))
        os.chmod(stand_in, 0o755)
        self.home = os.path.join(folder.name, "home")
        self.environment = dict(os.environ, PATH=folder.name + ":" + os.environ["PATH"], ROS_HOME=self.home)

    def given(self, view, topic, frame, primitives=(), folder="/views"):
        """What RViz is given once primitives in this frame came."""
        publisher = rospy.Publisher(topic, PrimitiveArray, queue_size=10)
        command = [sys.executable, SCRIPT, folder, view, "/remapped", "/remapped:=" + topic]
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
        message.primitives = primitives
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

    def test_the_robot_s_view_begins_around_the_first_primitives(self):
        table, ball = Primitive(hull=[Point32(1.0, -0.5, 0.7), Point32(2.0, 0.5, 0.7)]), Primitive()
        table.pose.pose.position.x, table.pose.pose.position.z = 1.5, 0.7
        ball.pose.pose.position.x, ball.pose.pose.position.z = 1.4, 0.9
        views = os.path.join(ROOT, "config")
        config = self.given("", "/five", "base_link", [table, ball], views)[1]
        self.assertEqual(config, os.path.join(self.home, "primitect_robot.rviz"))
        with open(config, encoding="utf-8") as copy, open(os.path.join(views, "robot.rviz"), encoding="utf-8") as original:
            manager, usual = [yaml.safe_load(file)["Visualization Manager"] for file in (copy, original)]
        view, middle = manager["Views"]["Current"], {"X": 1.5, "Y": 0.0, "Z": 0.8}
        for axis, value in middle.items():
            self.assertAlmostEqual(view["Focal Point"][axis], value, places=5)
        self.assertAlmostEqual(view["Distance"], (1.0 + 1.0 + 0.04) ** 0.5, places=5)
        self.assertEqual(manager["Displays"], usual["Displays"])
        os.remove(self.told)
        self.assertEqual(self.given("camera", "/six", "base_link", [table], views)[1], views + "/primitect.rviz")

    def test_without_a_copy_the_view_is_the_usual_one(self):
        with open(self.home, "w", encoding="utf-8"):
            pass  # a file where its folder would be
        views = os.path.join(ROOT, "config")
        self.assertEqual(self.given("robot", "/seven", "map", [Primitive()], views)[1], views + "/robot.rviz")

    def test_says_how_it_is_used(self):
        done = subprocess.run([sys.executable, SCRIPT, "/views"], env=self.environment, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("FOLDER VIEW TOPIC", done.stderr)


if __name__ == "__main__":
    rospy.init_node("rviz_in_frame_test")
    rostest.rosrun("primitect", "rviz_in_frame", RvizInFrame, sys.argv)
