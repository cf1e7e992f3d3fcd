#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The gate lets small change through and nothing else."""
import copy
import importlib.machinery
import importlib.util
import os
import unittest

PATH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "gate")
LOADER = importlib.machinery.SourceFileLoader("gate", PATH)
gate = importlib.util.module_from_spec(importlib.util.spec_from_loader("gate", LOADER))
LOADER.exec_module(gate)

RECORD = {name: {"default": {"clouds": 2, "truths": 30, "found": 28, "typed_correct": 25, "false_curved": 2}}
          for name in ("a", "b", "c")}


def changed(**amounts):
    """The record with an amount added to found and typed_correct of some groups."""
    now = copy.deepcopy(RECORD)
    for group, (found, correct) in amounts.items():
        now[group]["default"]["found"] += found
        now[group]["default"]["typed_correct"] += correct
    return now


class Gate(unittest.TestCase):
    def test_lets_the_record_itself_pass(self):
        self.assertEqual(gate.faults_of(RECORD, RECORD), [])

    def test_lets_gains_pass(self):
        self.assertEqual(gate.faults_of(changed(a=(2, 2), b=(-3, 0)), RECORD), [])

    def test_lets_one_shape_of_a_group_pass(self):
        self.assertEqual(gate.faults_of(changed(a=(-1, -1), b=(1, 0)), RECORD), [])

    def test_sees_recall_fall_in_a_group(self):
        faults = gate.faults_of(changed(a=(-2, -2)), RECORD)
        self.assertEqual(len(faults), 1)
        self.assertIn("a, default: recall fell, 23 true shapes found, on record 25", faults[0])

    def test_sees_precision_fall_in_a_group(self):
        faults = gate.faults_of(changed(b=(2, 0)), RECORD)
        self.assertEqual(len(faults), 1)
        self.assertIn("b, default: precision fell, 5 wrong detections, on record 3", faults[0])

    def test_lets_one_more_false_curved_shape_of_a_group_pass_and_sees_two(self):
        now = changed()
        now["a"]["default"]["false_curved"] += 1
        self.assertEqual(gate.faults_of(now, RECORD), [])
        now["a"]["default"]["false_curved"] += 1
        faults = gate.faults_of(now, RECORD)
        self.assertEqual(len(faults), 1)
        self.assertIn("a, default: more is taken for something curved, 4 wrong", faults[0])

    def test_sees_small_falls_in_all_groups(self):
        faults = gate.faults_of(changed(a=(-1, -1), b=(-1, -1), c=(-1, -1)), RECORD)
        self.assertEqual(len(faults), 1)
        self.assertIn("all groups, default: recall fell", faults[0])

    def test_refuses_other_clouds_than_those_on_record(self):
        now = changed()
        now["a"]["default"]["truths"] += 1
        self.assertIn("the clouds are not those on record", gate.faults_of(now, RECORD)[0])

    def test_refuses_other_groups_than_those_on_record(self):
        now = changed()
        del now["c"]
        self.assertEqual(len(gate.faults_of(now, RECORD)), 1)


if __name__ == "__main__":
    unittest.main()
