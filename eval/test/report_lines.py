# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""A line as compare writes it, with counts of one's choice, for the tests of the report."""
COUNTS = ("truths", "found", "correct", "typed_correct", "missed", "noise", "over", "under", "type_right", "dod",
          "typed_dod")
KINDS = ("plane", "sphere", "cylinder", "cone")


def counts(**given):
    """Counts that are 0 unless given."""
    return {**dict.fromkeys(COUNTS, 0), **given}


def line(method="default", seed=1, **given):
    """One line of compare."""
    result = {"set": "paper-mixed", "seed": seed, "sigma": 0.01, "noise_scale": 1.0, "outliers": 0.0, "keep": 1.0,
              "uneven": 1.0, "shuffle": False, "noise_grain": 1, "sensor": "structured_light", "blots": 0.0,
              "robot_frame": False, "voxel": 0.0, "listed": False, "false_curved": 0, "detections": [],
              "unit": 0.01, "points": 160801, "method": method, "failure": "", "total_ms": 10.0, "vote_ms": -1.0,
              "prepare_ms": 0.0, "all": counts(), "errors": {kind: {} for kind in KINDS},
              "p_coverage": [1.0] * 26, "s_coverage": [1.0] * 26}
    result.update({kind: counts() for kind in KINDS})
    result.update(given)
    return result


def kept(text="default", repeat=2, commit="c1", cpu="cpu 1", **given):
    """The same as it is kept in lines.jsonl."""
    return dict(line(method=text.split("=")[0], **given), text=text, repeat=repeat, commit=commit, cpu=cpu,
                date="2026-01-01", angle=15.0)
