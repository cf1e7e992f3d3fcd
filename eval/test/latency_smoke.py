#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""eval/latency --quick from end to end, with a real master: whether everything comes out, not how fast it is.

    latency_smoke.py PROGRAMS      the folder that holds detector, synthetic_camera and latency_observer
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

EVAL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PROGRAMS = sys.argv.pop()
FAST = "200"  # Hz, more than a detector in a usual test can do
SCENARIOS = {"nodelet, 30 Hz": 1, "node, 30 Hz": 1, "nodelet, %s Hz" % FAST: 1, "node, %s Hz" % FAST: 1,
             "four cameras, nodelets, 30 Hz": 4}  # cameras of each


class Smoke(unittest.TestCase):
    def test_measures_every_scenario_and_leaves_tables(self):
        with tempfile.TemporaryDirectory() as out:
            command = [os.path.join(EVAL, "latency"), "--quick", "--rates", "30," + FAST, "--out", out, "--programs",
                       PROGRAMS]
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(done.returncode, 0, done.stdout)
            with open(os.path.join(out, "latency.json"), encoding="utf-8") as file:
                result = json.load(file)
            self.assertEqual(set(result["scenarios"]), set(SCENARIOS))
            for name, figures in result["scenarios"].items():
                self.assertGreaterEqual(figures["answered"], SCENARIOS[name], name)
                self.assertGreaterEqual(figures["sent"], figures["answered"], name)
                self.assertTrue(0.0 < figures["p50_ms"] <= figures["p95_ms"] <= figures["p99_ms"], name)
                self.assertGreater(figures["p50_ms"], 0.5 * figures["processing_ms"], name)
                self.assertGreater(figures["cpu_percent"], 0.0, name)
            for node in ("nodelet", "node"):  # its queue throws away, and says so
                figures = result["scenarios"]["%s, %s Hz" % (node, FAST)]
                self.assertGreater(figures["replaced"], figures["lost"], node)
            self.assertGreater(result["memory"]["peak_mb"], result["memory"]["empty_mb"])
            self.assertEqual(len(result["targets"]), 4)
            for name in ("latency.md", "latency.csv", "latency_memory.csv", "latency_targets.csv"):
                self.assertIn(name, os.listdir(out))


if __name__ == "__main__":
    unittest.main()
