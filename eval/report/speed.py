# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""From the times of single frames to figures: medians, percentiles, ratios, and whether the targets are reached."""
from collections import namedtuple

import numpy

FRAME, WIDE_FRAME, CLUTTER, WALL = ("frame/%s" % name for name in (
    "tabletop-640/16", "tabletop-1280/16", "clutter-640/16", "wall-640/16"))
OURS, CGAL = "detect/paper/default", "peer/cgal/paper"
MILLION = 1000000
REACHED, MISSED, UNKNOWN = "yes", "no", "not measured"

# value: None when it was not measured. most, least: the bound that is set; stretch: the one that would be better still
Target = namedtuple("Target", "text unit value most least stretch", defaults=(None, None, None))


def median(values):
    """None of nothing."""
    return float(numpy.median(values)) if len(values) else None


def percentile(values, percent):
    """Between the two nearest ranks in proportion, as numpy does it; None of nothing."""
    return float(numpy.percentile(values, percent)) if len(values) else None


def ratio(one, other):
    """None when one of them is missing or there is nothing to divide by."""
    return one / other if one is not None and other else None


def figures_of(case):
    """What one case of the benchmark programs says: ms of processor time, allocations a frame, and its facts."""
    stages = {name: median(times) for name, times in case.get("stages_ms", {}).items()}
    times = case["cpu_ms"]
    return {"median_ms": median(times), "p95_ms": percentile(times, 95), "p99_ms": percentile(times, 99),
            "wall_ms": median(case["wall_ms"]), "frames": len(times), "stages_ms": stages,
            "allocations": median(case.get("allocations", ())),
            "allocated_bytes": median(case.get("allocated_bytes", ())),
            "facts": case.get("facts", {})}


def figure(figures, case, name="median_ms"):
    """A figure of a case; None when it was not measured."""
    return figures.get(case, {}).get(name)


def besides_reading(figures, case):
    """ms of a frame without the stage that reads the message."""
    total = figure(figures, case)
    return None if total is None else total - figures[case]["stages_ms"].get("read", 0.0)


def curve(figures, name):
    """[(place, median ms)] of a curve such as "points", from the smallest on."""
    places = sorted(int(case.split("/")[1]) for case in figures if case.startswith(name + "/"))
    return [(place, figure(figures, "%s/%d" % (name, place))) for place in places]


def worst_growth(points, factor=10, largest=None):
    """The largest ratio of times between a place and the one that is so many times it; None without such a pair."""
    times = dict(points)
    ratios = [ratio(times[place * factor], time) for place, time in points
              if place * factor in times and (largest is None or place * factor <= largest)]
    return max((r for r in ratios if r is not None), default=None)


def million_growth(figures, name):
    """Time besides reading at ten million against one million."""
    return ratio(besides_reading(figures, "%s/%d" % (name, 10 * MILLION)),
                 besides_reading(figures, "%s/%d" % (name, MILLION)))


def kernel_speedups(kernels):
    """{kernel: how many times faster than scalar}, of {kernel: [ms]}; empty without scalar."""
    base = median(kernels.get("scalar", ()))
    return {name: ratio(base, median(times)) for name, times in kernels.items()} if base else {}


def best_speedup(kernels):
    """Of the fastest kernel over scalar; None where there is no other."""
    return max((value for name, value in kernel_speedups(kernels).items() if name != "scalar"), default=None)


def targets(figures, kernels):
    """What was asked for, and what was measured of it."""
    tabletop = figure(figures, FRAME)
    return [
        Target("voting alone, 2048 x 2048, paper preset: faster than scalar", "x", best_speedup(kernels), least=14,
               stretch=20),
        Target("default, 160k points with normals: faster than CGAL Efficient RANSAC", "x",
               ratio(figure(figures, CGAL), figure(figures, OURS)), least=80, stretch=120),
        Target("640x480 frame, bytes to message, median", "ms", tabletop, most=4, stretch=2),
        Target("640x480 frame, bytes to message, p99", "ms", figure(figures, FRAME, "p99_ms"), most=8),
        Target("1280x720 frame, bytes to message, median", "ms", figure(figures, WIDE_FRAME), most=6),
        Target("pure clutter against tabletop, medians", "x", ratio(figure(figures, CLUTTER), tabletop), most=3),
        Target("flat wall against tabletop, medians", "x", ratio(figure(figures, WALL), tabletop), most=1),
        Target("10 x the points, up to 1M: time", "x", worst_growth(curve(figures, "points"), largest=MILLION), most=2),
        Target("10 x the pixels, up to 1M: time", "x", worst_growth(curve(figures, "pixels"), largest=MILLION), most=2),
        # A tenth more is what caches and noise may take; anything that looks at all points takes ten times as long.
        Target("10M against 1M points, without reading", "x", million_growth(figures, "points"), most=1.1),
        Target("10M against 1M pixels, without reading", "x", million_growth(figures, "pixels"), most=1.1),
        Target("allocations a frame, cloud to primitives", "",
               figure(figures, "detect/tabletop-640/default", "allocations"), most=0),
    ]


def within(value, target, bound):
    """Whether the value keeps a bound of the target's kind."""
    return value >= bound if target.least is not None else value <= bound


def verdict(target):
    """REACHED, MISSED or UNKNOWN."""
    if target.value is None:
        return UNKNOWN
    bound = target.least if target.least is not None else target.most
    return REACHED if within(target.value, target, bound) else MISSED


def stretch_verdict(target):
    """The same for the stretch; "" where there is none."""
    if target.stretch is None:
        return ""
    return UNKNOWN if target.value is None else REACHED if within(target.value, target, target.stretch) else MISSED


def bound_text(target):
    """">= 14 x, stretch 20 x"."""
    sign, bound = (">=", target.least) if target.least is not None else ("<=", target.most)
    unit = " " + target.unit if target.unit else ""
    text = "%s %g%s" % (sign, bound, unit)
    return text if target.stretch is None else "%s, stretch %g%s" % (text, target.stretch, unit)


def as_json(target):
    """Everything about a target."""
    return dict(target._asdict(), reached=verdict(target), stretch_reached=stretch_verdict(target))
