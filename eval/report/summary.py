# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""From measured lines to figures: sums over all clouds first, then the quotients."""
from collections import namedtuple

import numpy

from report import plan, store

COUNTS = ("truths", "found", "correct", "typed_correct", "missed", "noise", "over", "under", "type_right")
CURVE_STEP = 0.002  # m, coverage curves are taken at its multiples

# lines by key, and the first seed of the run
Results = namedtuple("Results", "by_key first_seed experiments")


def results_of(lines, first_seed, experiments):
    """Kept lines as the tables look them up; of equal keys the last one."""
    return Results({store.key_of(line): line for line in lines}, first_seed, experiments)


def lines_of(results, experiment, method, seeds=None):
    """The lines of a method in an experiment that were measured; of its first seeds only if a number is given."""
    keys = plan.keys_of(experiment, results.first_seed, method)[:seeds]
    return [results.by_key[key] for key in keys if key in results.by_key]


def of_part(results, part):
    """The experiments of a part that were started: peers alone may come from another part that shares their clouds."""
    return [e for e in results.experiments if e.part == part and lines_of(results, e, next(iter(e.seeds)))]


def share(part, whole):
    """Percent; None without a whole."""
    return 100.0 * part / whole if whole else None


def scores(lines, group="all"):
    """Figures of some clouds of one method: percent, DOD in units of the cloud. None where nothing can be said."""
    total = {name: sum(line[group][name] for line in lines) for name in COUNTS}
    dod, typed_dod = (sum(line[group][name] for line in lines) for name in ("dod", "typed_dod"))
    result = {"clouds": len(lines), "truths": total["truths"], "found": total["found"]}
    for prefix, correct in (("", total["correct"]), ("typed_", total["typed_correct"])):
        result[prefix + "precision"] = share(correct, total["found"])
        result[prefix + "recall"] = share(correct, total["truths"])
        result[prefix + "f1"] = share(2 * correct, total["found"] + total["truths"])
    result["missed"] = share(total["missed"], total["truths"])
    result["noise"] = share(total["noise"], total["found"])
    result["over"] = share(total["over"], total["truths"])
    result["under"] = share(total["under"], total["found"])
    result["type"] = share(total["type_right"], total["truths"])
    result["dod"] = dod / total["correct"] if total["correct"] else None
    result["typed_dod"] = typed_dod / total["typed_correct"] if total["typed_correct"] else None
    return result


def median(values):
    """The median, None of nothing."""
    return float(numpy.median(values)) if len(values) else None


def times(lines, name="total_ms"):
    """Times of the clouds on which the method did not give up, without -1: has no such stage. The truth takes none."""
    return [line[name] for line in lines if not line["failure"] and line[name] >= 0 and line["method"] != "truth"]


def times_without_tree(lines):
    """Times without the building of search trees."""
    return [line["total_ms"] - line["prepare_ms"] for line in lines if not line["failure"]]


def failures(lines):
    """On how many clouds the method gave up."""
    return sum(1 for line in lines if line["failure"])


def curve(lines, name):
    """Mean coverage (percent) over the clouds that have it, at the multiples of CURVE_STEP; None without any."""
    curves = [line[name] for line in lines if line[name] is not None]
    return 100.0 * numpy.mean(curves, axis=0) if curves else None


def coverage_at(lines, name, distance):
    """Mean coverage (percent) at a distance (m) that is a multiple of CURVE_STEP."""
    values = curve(lines, name)
    return None if values is None else float(values[int(round(distance / CURVE_STEP))])


def errors(lines, kind, measure):
    """All errors of a kind in one list: m or deg."""
    return [value for line in lines for value in line["errors"][kind].get(measure, ())]
