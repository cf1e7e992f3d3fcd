#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""eval/speed --smoke from end to end with the real programs: whether everything comes out, not how fast it is.

    speed_smoke.py PROGRAMS      the folder that holds bench_detector and detect
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

EVAL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PROGRAMS = sys.argv.pop()
CASES = {"detect/wall-640/default", "detect/clutter-640/default", "points/10000", "samples/1280", "objects/1"}
CASES_WITH_ROS = {"frame/wall-640/16", "pixels/10000"}
STAGES = {"sample", "normals", "vote"}  # that every detection has, whatever comes after
WALL = """VERSION .7
FIELDS x y z
SIZE 4 4 4
TYPE F F F
COUNT 1 1 1
WIDTH 40
HEIGHT 40
VIEWPOINT 0 0 0 1 0 0 0
POINTS 1600
DATA ascii
""" + "".join("%.4f %.4f 1\n" % (0.01 * (k % 40) - 0.2, 0.01 * (k // 40) - 0.2) for k in range(1600))


class Smoke(unittest.TestCase):
    def test_measures_every_kind_of_case_and_leaves_tables_and_plots(self):
        with tempfile.TemporaryDirectory() as out:
            frames = os.path.join(out, "frames")
            os.mkdir(frames)
            with open(os.path.join(frames, "wall.pcd"), "w", encoding="utf-8") as file:
                file.write(WALL)
            command = [os.path.join(EVAL, "speed"), "--smoke", "--out", out, "--programs", PROGRAMS, "--frames", frames]
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(done.returncode, 0, done.stdout)
            with open(os.path.join(out, "speed.json"), encoding="utf-8") as file:
                result = json.load(file)
            with_ros = os.path.exists(os.path.join(PROGRAMS, "bench_frame"))
            self.assertEqual(set(result["figures"]), CASES | (CASES_WITH_ROS if with_ros else set()))
            for case, figures in result["figures"].items():
                self.assertGreater(figures["median_ms"], 0.0, case)
                self.assertGreaterEqual(set(figures["stages_ms"]), STAGES, case)
            self.assertGreaterEqual(len(result["targets"]), 10)
            self.assertGreater(min(map(len, result["kernels"].values())), 0)
            memory = result["memory"]["detect/wall-640/default"]
            self.assertGreater(memory["peak_kb"], memory["input_kb"])
            wall = result["recorded"]["wall.pcd"]
            self.assertEqual((wall["points"], wall["primitives"]), (1600, 1))
            self.assertAlmostEqual(sum(wall["stages_ms"].values()), wall["median_ms"], delta=0.5 * wall["median_ms"])
            self.assertGreaterEqual(wall["worst_ms"], wall["median_ms"])
            for name in ("speed.md", "recorded.csv", "targets.csv", "detect.csv", "kernels.csv", "memory.csv",
                         "stages.png"):
                self.assertIn(name, os.listdir(out))


if __name__ == "__main__":
    unittest.main()
