#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters that are unknown, of the wrong type or out of range keep a node from starting, with a reason."""
import subprocess
import sys
import unittest

import rosgraph
import roslib.packages
import rospy
import rostest
from ros_helpers import PATIENCE, Collector, wait_for
from rosgraph_msgs.msg import Log


def run(program, values, arguments=()):
    """Exit code and output of a plain node with these private parameters; None when it kept running."""
    rospy.set_param("/tested", values)
    # Not rosrun: it passes over a build folder within the package.
    command = [roslib.packages.find_node("primitect", program)[0], "__name:=tested", *arguments]
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=PATIENCE,
                              check=False)
        return done.returncode, done.stdout
    except subprocess.TimeoutExpired:
        return None, ""
    finally:
        rospy.delete_param("/tested")


def published(prefix):
    topics, _, _ = rosgraph.Master("/bad_parameters").getSystemState()
    return [topic for topic, _ in topics if topic.startswith(prefix)]


class BadParameters(unittest.TestCase):
    def refused(self, program, values, said):
        with self.subTest(str(values)):
            code, output = run(program, values)
            self.assertEqual(code, 1, output)
            for text in said:
                self.assertIn(text, output)

    def test_end_the_detector_with_exit_code_1_and_a_reason(self):
        self.refused("detector", {"max_dept": 2.0}, ["max_dept"])
        self.refused("detector", {"max_depth": 1000.0}, ["max_depth", "1000", "0 to 100"])
        self.refused("detector", {"samples": "many"}, ["samples", "many", "65536"])
        self.refused("detector", {"samples": [1, 2]}, ["samples"])
        self.refused("detector", {"preset": "fast"}, ["preset", "fast", "paper"])
        self.refused("detector", {"inner": {"max_depth": 2.0}}, ["inner/max_depth"])

    def test_end_the_simulated_camera_with_exit_code_1_and_a_reason(self):
        self.refused("synthetic_camera", {"rat": 30}, ["rat"])
        self.refused("synthetic_camera", {"rate": 0}, ["rate", "0.1 to 200"])
        self.refused("synthetic_camera", {"depth_encoding": "8UC1"}, ["depth_encoding", "8UC1", "16UC1"])
        self.refused("synthetic_camera", {"sensor": "lidar"}, ["sensor", "lidar", "time_of_flight"])
        self.refused("synthetic_camera", {"objects": "can 0.03"}, ["can 0.03", "1 instead of 2 sizes", "can R HEIGHT"])
        self.refused("synthetic_camera", {"eye": "1 2"}, ["1 2", "X Y Z"])
        self.refused("synthetic_camera", {"roll": 90.0}, ["roll", "eye"])
        self.refused("synthetic_camera", {"look_at": "0 0 1"}, ["look_at", "eye"])

    def test_arguments_that_are_no_names_end_a_node_and_help_says_what_it_is(self):
        for program in ("detector", "synthetic_camera"):
            with self.subTest(program):
                code, output = run(program, {}, ["--help"])
                self.assertEqual(code, 0, output)
                self.assertIn("docs/ros_api.md", output)
                code, output = run(program, {}, ["cloud.pcd"])
                self.assertEqual(code, 2, output)
                self.assertIn("cloud.pcd", output)
                self.assertIn("--help", output)

    def load(self, name, values):
        """Loads the nodelet into the running manager, as roslaunch would."""
        rospy.set_param("/" + name, values)
        loader = subprocess.Popen(["rosrun", "nodelet", "nodelet", "load", "primitect/detector", "manager",
                                   "__name:=" + name])
        self.addCleanup(lambda: (loader.terminate(), loader.wait()))

    def test_keep_the_nodelet_from_advertising(self):
        log = Collector("/rosout", Log)
        self.assertTrue(wait_for(log.connected))
        self.load("refused", {"max_depth": -1})
        self.assertTrue(wait_for(lambda: [m for m in log.all() if m.level == Log.FATAL and "max_depth" in m.msg and
                                          "-1" in m.msg and "0 to 100" in m.msg]))
        self.assertEqual([t for t in published("/refused") if not t.endswith("bond")], [])
        # The manager lives on and takes the same nodelet with good parameters.
        self.load("accepted", {"max_depth": 3})
        self.assertTrue(wait_for(lambda: "/accepted/primitives" in published("/accepted")))


if __name__ == "__main__":
    rospy.init_node("bad_parameters")
    rostest.rosrun("primitect", "bad_parameters", BadParameters, sys.argv)
