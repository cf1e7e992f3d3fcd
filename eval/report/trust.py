# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Can one believe what a detection says of itself? Confidence against the share that is right, errors against the
covariance."""
from collections import namedtuple

from report.kinds import KINDS
from report.tables import Table, cell

BINS = 10
# count of detections, their mean confidence, the share of them that is right (both in [0, 1], None without any)
Bin = namedtuple("Bin", "count confidence right")
PARTS = ("total", "origin", "axis", "radius", "half_angle")  # see eval/nees.h
CALIBRATED = (0.8, 1.2)
# Sets of depth frames: noise of neighbours is alike there.
FRAMES = ("tabletop", "clutter", "household", "heap", "hall")
CUT_OUT = "objects"
SCENES, DEPTH_FRAMES, SHUFFLED = "scenes", "depth frames", "shuffled frames"
CUT_OUTS, NOISY, GRAINY = "cut out of frames", "frames with more noise", "frames with noise in grains"
OTHER_SENSORS = "frames of other sensors, and with blots"
BENT = "frames that the sensor bends"
MOVED, VOXELS = "frames in a robot's frame", "frames in voxels"


def detections(lines):
    """All detections of some clouds."""
    return [found for line in lines for found in line.get("detections", ())]


def is_right(found):
    """Whether a detection is right; None for what says nothing. What lies on a shape that need not be found is right
    when it has its kind: without these, all that is wrong would count and not all that is right, least of all where
    confidence is low, as it is of what is small or hardly seen."""
    if found["verdict"] != "no matter":
        return found["verdict"] == "right"
    return found["on"] == found["kind"] if "on" in found else None


def reliability(lines):
    """BINS bins of equal width over the confidence."""
    sums = [[0, 0.0, 0] for _ in range(BINS)]
    for found in detections(lines):
        right = is_right(found)
        if "confidence" not in found or right is None:
            continue
        one = sums[min(int(found["confidence"] * BINS), BINS - 1)]
        one[0] += 1
        one[1] += found["confidence"]
        one[2] += right
    return [Bin(n, total / n if n else None, right / n if n else None) for n, total, right in sums]


def calibration_error(bins):
    """Expected calibration error: the mean distance of confidence and share right, weighted by the counts; None without
    detections."""
    count = sum(one.count for one in bins)
    return sum(one.count * abs(one.confidence - one.right) for one in bins if one.count) / count if count else None


def normalised_error(lines, kind, part):
    """Mean normalised squared error of the right detections of a kind over its degrees of freedom (1 when covariances
    are right), and of how many detections; None without any."""
    errors = [found["nees"][part] for found in detections(lines)
              if found["kind"] == kind and part in found.get("nees", {}) and None not in found["nees"][part]]
    degrees = sum(degree for _, degree in errors)
    return (sum(value for value, _ in errors) / degrees if degrees else None), len(errors)


def group_of(line):
    """Name of the group that a cloud belongs to: paper-like scenes, depth frames, and what is unlike these. Frames that
    were shuffled, or are lists, have no rows any more, and the detector makes an image of them again; nor have those
    that a voxel grid averaged, which err less than it expects; of those in another frame than the camera's, unless they
    are lists in their order, it does not know how they were seen; in grains noise errs alike in neighbours, farther
    than covariances expect, and all sensors but the usual one bend what they see, one of them nothing else."""
    if line["set"] == CUT_OUT:
        return CUT_OUTS
    if line["set"] not in FRAMES:
        return SCENES
    if line.get("robot_frame") and not (line.get("listed") and not line.get("shuffle") and not line.get("voxel")):
        return MOVED
    if line.get("voxel", 0.0) > 0.0:
        return VOXELS
    if line.get("shuffle"):
        return SHUFFLED
    if line.get("sensor") == "bent_structured_light":
        return BENT
    if line.get("sensor", "structured_light") != "structured_light" or line.get("blots", 0.0) > 0.0:
        return OTHER_SENSORS
    if line.get("noise_grain", 1) > 1:
        return GRAINY
    if line.get("listed"):
        return SHUFFLED
    return NOISY if line.get("noise_scale", 1.0) > 1.0 else DEPTH_FRAMES


def groups(lines):
    """Lines with detections by the name of their group."""
    chosen = {name: [] for name in (SCENES, DEPTH_FRAMES, SHUFFLED, VOXELS, MOVED, CUT_OUTS, NOISY, GRAINY,
                                 OTHER_SENSORS, BENT)}
    for line in lines:
        chosen[group_of(line)].append(line)
    return {name: some for name, some in chosen.items() if detections(some)}


def reliability_table(lines):
    """A row for each group and bin."""
    rows = []
    for name, some in groups(lines).items():
        bins = reliability(some)
        error = calibration_error(bins)
        if error is None:
            continue
        rows.append(("%s: expected calibration error %.3f" % (name, error), None))
        rows += [("%.1f to %.1f" % (k / BINS, (k + 1) / BINS),
                  [cell(one.count, 0), cell(one.confidence, 3), cell(one.right, 3)]) for k, one in enumerate(bins)]
    return Table("reliability", "Confidence",
                 "Right: of the right type, and it and the true shape share 60 % of the points of both; on a shape "
                 "that need not be found: of its type.",
                 [("", 3)], ["detections", "mean confidence", "share right"], rows)


def nees_table(lines):
    """A row for each group and kind."""
    rows = []
    for name, some in groups(lines).items():
        kinds = [(kind, [normalised_error(some, kind, part) for part in PARTS]) for kind in KINDS]
        kinds = [(kind, figures) for kind, figures in kinds if any(count for _, count in figures)]
        if kinds:
            rows.append((name, None))
        for kind, figures in kinds:
            total = figures[0][0]
            reached = "–" if total is None else "yes" if CALIBRATED[0] <= total <= CALIBRATED[1] else "no"
            rows.append((kind + "s", [cell(max(count for _, count in figures), 0)]
                         + [cell(value, 2) for value, _ in figures] + [cell(reached)]))
    return Table("nees", "Covariance",
                 "Mean normalised squared error of right detections over its degrees of freedom: 1 when the covariance "
                 "is right, larger when it promises too much. Total: over all parameters of the kind. Target: 0.8 to "
                 "1.2.",
                 [("", 7)], ["detections", "total", "origin", "axis", "radius", "half angle", "reached"], rows)
