#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""eval/run --quick from end to end with the real programs: clouds, methods, tables, plots, pictures and report.

    quick_run.py PROGRAMS      the folder that holds compare
"""
import glob
import os
import subprocess
import sys
import tempfile
import unittest

EVAL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PROGRAMS = sys.argv.pop()
PARTS = ("tabletop", "pictures")  # the least that makes tables, plots and pictures


class QuickRun(unittest.TestCase):
    def test_leaves_tables_plots_pictures_and_a_report(self):
        with tempfile.TemporaryDirectory() as out:
            command = [os.path.join(EVAL, "run"), "--quick", "--out", out, "--programs", PROGRAMS]
            for part in PARTS:
                command += ["--only", part]
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(done.returncode, 0, done.stdout)
            with open(os.path.join(out, "lines.jsonl"), encoding="utf-8") as file:
                self.assertGreater(len(file.readlines()), 30)
            for name in ("tabletop.csv", "scores.csv", "summary.md"):
                self.assertIn(name, os.listdir(out))
            for pattern, least in (("plots/*.png", 2), ("pictures/*.png", 3)):
                self.assertGreaterEqual(len(glob.glob(os.path.join(out, pattern))), least, pattern)
            with open(os.path.join(out, "report.html"), encoding="utf-8") as file:
                page = file.read()
            self.assertGreaterEqual(page.count("data:image/"), 5)
            self.assertIn("truth handed in", page)
            self.assertNotIn('src="plots', page)


if __name__ == "__main__":
    unittest.main()
