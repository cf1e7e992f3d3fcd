# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The figures of the paper (PrimiTect, ICRA 2020): percent, DOD in multiples of the noise, ms."""

# Table "Precision, recall, missed-rate and noise-rate": (a) Efficient RANSAC, (b) Drost*, ours; noise 0.01.
DETECTION = {
    "spheres": {"precision": {"a": 81.0, "b": 85.1, "ours": 94.9}, "recall": {"a": 98.6, "b": 95.3, "ours": 91.3},
                "missed": {"a": 1.4, "b": 2.9, "ours": 8.5}, "noise": {"a": 18.3, "b": 0.8, "ours": 0.3}},
    "cylinders": {"precision": {"a": 54.9, "b": 67.4, "ours": 95.9}, "recall": {"a": 69.8, "b": 65.1, "ours": 76.4},
                  "missed": {"a": 13.7, "b": 23.9, "ours": 23.3}, "noise": {"a": 9.0, "b": 6.1, "ours": 0.7}},
    "cones": {"precision": {"a": 41.2, "b": 64.3, "ours": 91.4}, "recall": {"a": 63.0, "b": 46.5, "ours": 54.1},
              "missed": {"a": 21.5, "b": 45.8, "ours": 44.3}, "noise": {"a": 30.8, "b": 9.0, "ours": 1.9}},
    "mixed": {"precision": {"a": 61.0, "b": 63.8, "ours": 74.7}, "recall": {"a": 76.7, "b": 57.7, "ours": 76.6},
              "missed": {"a": 9.9, "b": 36.4, "ours": 21.7}, "noise": {"a": 7.6, "b": 7.3, "ours": 1.4}},
}

# The same table, data-aware object distance; (c) without clustering by averaging, (d) without averaging of bins,
# (e) without spreading of votes.
DOD = {
    "spheres": {"a": 1.01, "b": 1.32, "c": 1.15, "d": 0.49, "e": 0.58, "ours": 0.48},
    "cylinders": {"a": 1.45, "b": 1.64, "c": 1.31, "d": 0.65, "e": 0.63, "ours": 0.60},
    "cones": {"a": 1.35, "b": 1.54, "c": 1.24, "d": 0.95, "e": 0.75, "ours": 0.70},
    "mixed": {"a": 1.13, "b": 1.39, "c": 1.14, "d": 0.59, "e": 0.62, "ours": 0.56},
}

# Table of the data set traceparts, with the evaluation of SPFN's authors; p-coverage and type accuracy in percent.
TRACEPARTS = {
    "SPFN without segmentation loss": {"p_coverage_001": 62.2, "p_coverage_002": 77.7, "type": 92.4},
    "SPFN": {"p_coverage_001": 88.3, "p_coverage_002": 96.3, "type": 96.9},
    "a": {"p_coverage_001": 65.7, "p_coverage_002": 88.6, "type": 52.9},
    "ours": {"p_coverage_001": 63.8, "p_coverage_002": 78.3, "type": 77.3},
}

# Table "Runtime in ms"; Efficient RANSAC without its search tree, which took another 220 to 240 ms. SPFN on a GPU.
RUNTIME = {
    "ours": {"joint": 79, "planes": 23, "spheres": 36, "cylinders": 38, "cones": 58},
    "a": {"joint": 283, "planes": 65, "spheres": 73, "cylinders": 304, "cones": 212},
    "a-2048": {"joint": 226, "planes": 7, "spheres": 14, "cylinders": 150, "cones": 93},
    "SPFN": {"joint": 95},
}

# Which of the paper's columns a method of ours stands beside.
COLUMN_OF = {"cgal": "a", "b": "b", "c": "c", "d": "d", "e": "e", "paper": "ours", "cgal-2048": "a-2048"}


def figure(table, *path):
    """The figure at this path of a table above, or None where the paper has none."""
    for step in path:
        if not isinstance(table, dict) or step not in table:
            return None
        table = table[step]
    return table
