# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Which step of a frame a stack of calls belongs to, and how much of the frame each step takes."""
from collections import Counter, namedtuple

from report.tables import Table, cell

NAMESPACE = "primitect::"
WHOLE = NAMESPACE + "Detector::detect"
OTHER = "everything else"
PERCENT = 100.0

# The first one whose functions a stack holds is its step: what is called from several comes first.
Step = namedtuple("Step", "stage name functions")
STEPS = (
    Step("sample", "the image of a cloud that lost its order", ("ProjectedImage::make",)),
    Step("sample", "runs of the cloud's points", ("findRuns", "findSomeRuns", "Labeling::begin")),
    Step("sample", "points of large planes, left out of the closer look", ("Labeling::findUnexplained",)),
    Step("sample", "draw, order along a curve", ("Sampler::",)),
    Step("normals", "windows of the image, or the cloud's own normals", ("estimateNormals",)),
    Step("vote", "pairs, features, votes, peaks", ("PairVoting::",)),
    Step("segment", "neighbours of the samples", ("SampleGraph::build",)),
    Step("segment", "noise", ("measureNoise",)),
    Step("segment", "fits of the four kinds to candidates", ("Proposer::propose",)),
    Step("segment", "what is known already against new samples", ("Verification::addSamples",)),
    Step("look closer", "fits again", ("Verification::refit", "Verification::joinFacets")),
    Step("look closer", "tops and tubes taken apart", ("Verification::separate",)),
    Step("look closer", "evidence, rivals, confidence", ("Verification::assess",)),
    Step("look closer", "choice of what explains the samples best", (
        "selectHypotheses", "selectAgain", "Verification::select", "Verification::conclude")),
    Step("look closer", "parts that nothing explains", ("Verification::unexplained",)),
    Step("measure", "labels of the cloud's points", ("Labeling::label",)),
    Step("measure", "points on far sides", ("markFarSides",)),
    Step("measure", "points of each shape, clear ones", ("pointsOfLabels", "ClearPoints::", "LevelTops")),
    Step("measure", "last fit", ("Measurement::fitted",)),
    Step("measure", "extent, outline", ("measureExtent", "measureToTheEnds", "endWhereItBends")),
    Step("measure", "coverage", ("measureCoverage",)),
    Step("measure", "share that the image shows", ("seenShare",)),
    Step("measure", "truncation", ("TruncationFinder::",)),
    Step("measure", "covariance", ("measureUncertainty", "measureSharedNoise")),
    Step("measure", "the rest of it", ("Detector::Workspace::measureOnCloud",)),
)


def stacks_of(text):
    """Lists of function names, the innermost first, of what perf script -F ip,sym prints."""
    stack = []
    for line in text.splitlines():
        words = line.split(None, 1)
        if words:
            stack.append(words[1] if len(words) > 1 else "")
        elif stack:
            yield stack
            stack = []
    if stack:
        yield stack


def step_of(stack):
    """A Step, None for what is in no step, False for what is no part of a frame. perf keeps 64 kB of a stack: of what
    has more below it the step may be known, but not that it was called from a frame."""
    for step in STEPS:
        if any(name.startswith(NAMESPACE + function) for name in stack for function in step.functions):
            return step
    return None if any(name.startswith(WHOLE) for name in stack) else False


def shares_of(stacks):
    """{Step or None: share of the frame}."""
    counts = Counter(step for step in map(step_of, stacks) if step is not False)
    total = sum(counts.values())
    return {step: count / total for step, count in counts.items()}


def table(shares, case, frame_ms):
    """frame_ms: median of a frame without the profiler."""
    listed = [(step.name, step.stage, shares[step]) for step in STEPS if step in shares]
    if None in shares:
        listed.append((OTHER, "", shares[None]))
    rows = [(name, [cell(stage), cell(PERCENT * share), cell(share * frame_ms, 2)]) for name, stage, share in listed]
    note = ("%s: shares of the samples of perf within a frame, times its median without perf (%.1f ms). Stage: that "
            "of the tables above which most of the step is in." % (case, frame_ms))
    return Table("profile", "Where the time of a frame goes", note, [("", 3)], ["stage", "%", "ms"], rows)
