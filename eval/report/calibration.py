# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""How the weights of src/core/evidence.cpp are made: the clouds, which detections are right, the features, the text."""
from collections import namedtuple

import numpy as np

from report import logistic, trust
from report.kinds import KINDS
from report.plan import Experiment, Recipe
from report.tables import Table, cell

# Nothing is refused, so that what is wrong is seen, too.
ALL = "all=preset:default,min_confidence=0"
ALL_BOTH = "all-both=preset:default,min_confidence=0,convexity=both"
FULL, SOME, FEW = 1.0, 0.5, 0.25  # shares of the clouds
PENALTY = 5.0
# Of the weights. Otherwise what is common in clouds where all detections are right would speak for a shape, even if it
# is a flaw.
SIGNS = (0, 1, 1, -1, -1, 1, 1, 1)
MANY = 150.0  # samples of a plane or ball: losses of a larger one count less
THRESHOLDS = (0.1, 0.3, 0.5, 0.7, 0.9)
EVIDENCE = ("inliers", "gain", "against", "runs_on", "runs_into", "border_residual", "turn", "lead",
            "own_noise", "stands")  # as compare's

# Whose noise a cloud has, by own_noise: weights are fitted for each by itself. Texts, and names of tables in the core.
WHOSE_NOISE = {0: "noise of depth cameras", 1: "the clouds' own noise"}
TABLES = {0: "kOfDepthCameras", 1: "kOfOwnNoise"}

# numbers: those of EVIDENCE, a row a detection; right: 0 or 1 each; kind: index in KINDS
Cases = namedtuple("Cases", "numbers right kind")


def mix():
    """What is looked at: recipe, method and share of the clouds. Depth frames and clutter count most: there is most to
    get wrong."""
    yield Recipe("tabletop"), ALL, FULL
    yield Recipe("tabletop"), ALL_BOTH, SOME
    yield Recipe("clutter"), ALL, FULL
    yield Recipe("clutter"), ALL_BOTH, FEW
    yield Recipe("tabletop", noise_scale=2.0), ALL, FEW
    # What is made of several parts: a part's end is no flaw of it.
    yield Recipe("household"), ALL, SOME
    # The noise of recorded frames is shared by some pixels, and up to so much more than the usual.
    for name in trust.FRAMES:
        yield Recipe(name, noise_grain=5), ALL, SOME
        yield Recipe(name, noise_scale=1.5, noise_grain=5), ALL, FEW
    yield Recipe("tabletop", sensor="stereo"), ALL, FEW
    yield Recipe("tabletop", sensor="time_of_flight"), ALL, FEW
    yield Recipe("tabletop", shuffle=True), ALL, FEW
    yield Recipe("clutter", shuffle=True), ALL, FEW
    # Of clouds in another frame than the camera's the noise is their own.
    for name, share in (("tabletop", FULL), ("clutter", FULL), ("household", SOME), ("heap", FEW), ("hall", FEW)):
        yield Recipe(name, robot_frame=True), ALL, share
        yield Recipe(name, robot_frame=True, shuffle=True), ALL, FEW
    yield Recipe("clutter", robot_frame=True), ALL_BOTH, FEW
    yield Recipe("tabletop", robot_frame=True, noise_scale=2.0), ALL, FEW
    yield Recipe("tabletop", robot_frame=True, sensor="stereo"), ALL, FEW
    yield Recipe("tabletop", robot_frame=True, sensor="time_of_flight"), ALL, FEW
    for kind in ("spheres", "cylinders", "cones", "planes", "mixed"):
        yield Recipe("paper-" + kind), ALL, SOME
    yield Recipe("paper-mixed", outliers=0.3), ALL, FEW
    # With so much noise the normals of the cloud are worse than the usual angle of the scoring.
    yield Recipe("paper-mixed", sigma=0.02, angle=40.0), ALL, FEW
    yield Recipe("concave-mixed"), ALL_BOTH, FEW
    yield Recipe("small"), ALL, SOME
    yield Recipe("small", outliers=0.2), ALL, FEW
    # Dozens of small faces on one body.
    yield Recipe("parts", sigma=0.003), ALL, FULL


def experiments(clouds, only=None):
    """One for each recipe; clouds: of those that count most."""
    result = {}
    for recipe, method, share in mix():
        if not only or recipe.set in only:
            result.setdefault(recipe, {})[method] = max(1, round(share * clouds))
    return [Experiment("calibrate", recipe, seeds, 1) for recipe, seeds in result.items()]


def cases_of(lines):
    """All detections with evidence."""
    chosen = [found for line in lines for found in line["detections"]
              if "evidence" in found and trust.is_right(found) is not None]
    return Cases(np.array([found["evidence"] for found in chosen], float).reshape(-1, len(EVIDENCE)),
                 np.array([trust.is_right(found) for found in chosen], float),
                 np.array([KINDS.index(found["kind"]) for found in chosen], int))


def part(cases, chosen):
    """Those cases for which chosen is true."""
    return Cases(*(values[chosen] for values in cases))


def is_kind(cases, kind):
    """Of each case whether it has this kind; all have "all"."""
    return np.full(len(cases.kind), True) if kind == "all" else cases.kind == KINDS.index(kind)


def has_noise(cases, own):
    """Of each case whether its noise is the cloud's own (1), or that of depth cameras (0)."""
    return (cases.numbers[:, EVIDENCE.index("own_noise")] > 0.5) == bool(own)


def root(numbers):
    return np.sqrt(np.maximum(numbers, 0.0))


def features(cases):
    """What the weights are for, a row a detection: the same as featuresOf() of src/core/evidence.cpp."""
    inliers, gain, against, _, runs_into, _, turn, lead, _, stands = cases.numbers.T
    curved = cases.kind != KINDS.index("plane")
    # A flaw of a large ball or plane grows with it, and chance does not. For cylinders and cones that made no
    # difference.
    grows = np.isin(cases.kind, [KINDS.index(kind) for kind in ("plane", "sphere")])
    losses = np.where(grows, against * np.sqrt(MANY / np.maximum(inliers, MANY)), against)
    return np.column_stack([np.ones(len(inliers)), np.log(np.maximum(inliers, 1.0)), gain, losses,
                            root(runs_into), curved * root(turn), curved * root(lead), stands])


def fit(cases, penalty=PENALTY):
    """Weights by whose noise it is (a key of WHOSE_NOISE) and kind. None when one of these lacks right or wrong
    ones."""
    result = {own: fit_kinds(part(cases, has_noise(cases, own)), penalty) for own in WHOSE_NOISE}
    return result if all(result.values()) else None


def fit_kinds(cases, penalty):
    """Weights by kind. There are few wrong detections of a kind: the weights of curved ones stay near those that serve
    all of them best. None when a kind lacks right or wrong ones."""
    parts = {kind: part(cases, is_kind(cases, kind)) for kind in KINDS}
    if not all(0 < some.right.sum() < len(some.right) for some in parts.values()):
        return None
    curved = part(cases, cases.kind > 0)
    of_others = np.column_stack([curved.kind == KINDS.index(kind) for kind in KINDS[2:]])
    shared = logistic.fit(np.column_stack([features(curved), of_others]), curved.right, penalty,
                          SIGNS + (0,) * of_others.shape[1])
    result = {}
    for kind, some in parts.items():
        towards = None if kind == "plane" else shared[:len(SIGNS)]
        result[kind] = logistic.fit(features(some), some.right, penalty, SIGNS, towards)
    return result


def probabilities(weights, cases):
    """One a detection."""
    rows, sums = features(cases), np.zeros(len(cases.right))
    for own, of_kinds in weights.items():
        for kind, values in of_kinds.items():
            chosen = has_noise(cases, own) & is_kind(cases, kind)
            sums[chosen] = rows[chosen] @ values
    return logistic.probabilities(np.ones(1), sums[:, None])


def weights_text(weights):
    """The tables of weights in src/core/evidence.cpp."""
    texts = []
    for own, name in TABLES.items():
        rows = ("    {{%s}},  // %s\n" % (", ".join("%.3g" % value for value in weights[own][kind]), kind)
                for kind in KINDS)
        texts.append("constexpr Weights %s = {{\n%s}};\n" % (name, "".join(rows)))
    return "\n".join(texts)


def by_noise_and_kind(cases):
    """Whose noise it is, and for "all" and each kind of which cases it holds."""
    for own, whose in WHOSE_NOISE.items():
        yield whose, [(kind, has_noise(cases, own) & is_kind(cases, kind)) for kind in ("all",) + KINDS]


def quality_cells(p, right):
    return [cell(len(right), 0), cell(100.0 * right.mean()), cell(logistic.area_under_curve(p, right), 3),
            cell(logistic.log_loss(p, right), 3), cell(logistic.calibration_error(p, right), 3)]


def quality_table(parts):
    """Rows for each kind and all, by whose noise it is. parts: name -> (probabilities, cases)."""
    rows = []
    for name, (probability, cases) in parts.items():
        for whose, kinds in by_noise_and_kind(cases):
            rows.append(("%s, %s" % (name, whose), None))
            rows += [(kind, quality_cells(probability[chosen], cases.right[chosen]))
                     for kind, chosen in kinds if chosen.any()]
    return Table("calibration", "How well the confidence tells right from wrong",
                 "Right: percent of the detections when nothing is refused. AUC: chance that a right one has more "
                 "confidence than a wrong one. ECE: expected calibration error.",
                 [("", 5)], ["detections", "right", "AUC", "log loss", "ECE"], rows)


def threshold_cells(p, right):
    cells = []
    for threshold in THRESHOLDS:
        kept = p >= threshold
        cells += [cell(100.0 * right[kept].mean() if kept.any() else None),
                  cell(100.0 * right[kept].sum() / right.sum())]
    return cells


def threshold_table(probability, cases):
    """What is left above a threshold: precision, and the share of the right ones that is kept."""
    rows = []
    for whose, kinds in by_noise_and_kind(cases):
        rows.append((whose, None))
        rows += [(kind, threshold_cells(probability[chosen], cases.right[chosen]))
                 for kind, chosen in kinds if cases.right[chosen].any()]
    return Table("thresholds", "Precision and share of the right ones kept over min_confidence", "Percent.",
                 [("", 1)] + [(">= %g" % threshold, 2) for threshold in THRESHOLDS],
                 ["precision", "kept"] * len(THRESHOLDS), rows)
