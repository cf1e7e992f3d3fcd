#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Log and diagnostics of a node name the voting kernel and the loops that it runs on; the environment names others."""
import os
import signal
import subprocess
import sys
import tempfile
import unittest

import roslib.packages
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from ros_helpers import PATIENCE, Collector, wait_for


def started(kernels, output):
    """A plain node, with these kernels wanted by the environment; its log goes to the output."""
    # Not rosrun: it passes over a build folder within the package.
    command = [roslib.packages.find_node("primitect", "detector")[0], "__name:=chosen"]
    return subprocess.Popen(command, env={**os.environ, "PRIMITECT_KERNELS": kernels}, stdout=output,
                            stderr=subprocess.STDOUT)


class KernelChoice(unittest.TestCase):
    def test_is_told_in_the_log_and_in_the_diagnostics(self):
        diagnostics = Collector("/diagnostics", DiagnosticArray)
        with tempfile.NamedTemporaryFile("r", encoding="utf-8") as log, open(log.name, "wb") as output:
            node = started("scalar", output)
            try:
                def told():
                    values = [s.values for a in diagnostics.all() for s in a.status if s.name.endswith("chosen: timing")]
                    return {v.key: v.value for v in values[-1]} if values else {}
                self.assertTrue(wait_for(told))
                self.assertEqual((told().get("voting kernel"), told().get("loops")), ("scalar", "baseline"))
            finally:
                node.send_signal(signal.SIGINT)  # as Ctrl-C does: it ends in order, and its log is written
                try:
                    node.wait(PATIENCE)
                finally:
                    node.kill()
            self.assertIn("voting kernel 'scalar', loops 'baseline'", log.read())

    def test_of_what_is_none_refuses_the_start(self):
        with tempfile.NamedTemporaryFile("r", encoding="utf-8") as log, open(log.name, "wb") as output:
            node = started("fastest", output)
            try:
                self.assertEqual(node.wait(PATIENCE), 1)
            finally:
                node.kill()
            said = log.read()
            self.assertIn("fastest", said)
            self.assertIn("scalar", said, "what there is")


if __name__ == "__main__":
    rospy.init_node("kernel_choice")
    rostest.rosrun("primitect", "kernel_choice", KernelChoice, sys.argv)
