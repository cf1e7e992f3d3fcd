# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The table of eval/accuracy: what was reached of what must be reached."""
import statistics

from report import accuracy_plan, summary
from report.accuracy_plan import (AHEAD_OF_PEERS, AXIS, DOD, F1, FALSE_CURVED, HALF_ANGLE, PRECISION, RADIUS, RECALL)
from report.kinds import KINDS
from report.tables import Table, cell, measured_on

MILLIMETRES = 1000.0
SHORT = {PRECISION: "P", RECALL: "R", F1: "F1", DOD: "DOD", RADIUS: "radius", AXIS: "axis", HALF_ANGLE: "half angle",
         FALSE_CURVED: "false curved"}
COLUMNS = (("clouds", 0), ("P", 1), ("R", 1), ("F1, worst seed", 1), ("DOD", 3), ("radius mm", 2), ("axis deg", 2),
           ("half angle deg", 2), ("false curved", 2), ("ms", 1))
NOTE = ("P, R: precision and recall with the right type, percent, over %d seeds of the algorithm on each cloud; "
        "worst seed: the smallest F1 of one of them. DOD in multiples of the noise, on depth frames in mm. Radius "
        "(spheres and cylinders), axis (curved shapes) and half angle: medians of the absolute errors. False curved: "
        "spheres, cylinders and cones a cloud that are wrong. Truth R: recall of the truth handed in, what the scoring "
        "leaves. Thinner at one side: the density falls smoothly across the cloud by this factor. Peers F1: of the "
        "best of %s.")


def figures_of(lines, group):
    """All measures of some clouds, None where nothing can be said."""
    result = summary.scores(lines, group)
    kinds = KINDS if group == "all" else (group,)
    errors = {measure: [e for kind in chosen if kind in kinds for e in summary.errors(lines, kind, name)]
              for measure, name, chosen in ((RADIUS, "radius", KINDS), (AXIS, "axis_deg", KINDS[1:]),
                                            (HALF_ANGLE, "half_angle_deg", KINDS))}
    result.update({measure: summary.median(values) for measure, values in errors.items()})
    if result[RADIUS] is not None:
        result[RADIUS] *= MILLIMETRES
    counts = [line["false_curved"] for line in lines if "false_curved" in line]
    result[FALSE_CURVED] = sum(counts) / len(counts) if counts and group == "all" else None
    result["ms"] = summary.median(summary.times(lines))
    return result


def target_text(target):
    """"P >= 98.5"."""
    name = SHORT[target.measure]
    if target.like == AHEAD_OF_PEERS:
        return "%s above the best peer" % name
    if target.like:
        return "%s as %s%s" % (name, target.like, " - %g" % target.slack if target.slack else "")
    return "%s >= %g" % (name, target.least) if target.least is not None else "%s <= %g" % (name, target.most)


def missed(target, figures, others):
    """"" when the target is reached, else by which figure it is not, or None when that cannot be said.

    figures: of the row; others: figures of other rows by title, of the best peer under AHEAD_OF_PEERS."""
    value, least, most = figures.get(target.measure), target.least, target.most
    if target.like:
        other = others.get(target.like, {}).get(target.measure)
        least = None if other is None else other - target.slack
    if value is None or (least is None and most is None):
        return None
    reached = value > least if target.like == AHEAD_OF_PEERS else least is None or value >= least
    reached = reached and (most is None or value <= most)
    return "" if reached else "%s %.3g" % (SHORT[target.measure], value)


def verdict(targets, figures, others):
    """"yes", "no: P 97.1, DOD 0.12", or nothing when no target can be judged."""
    results = [missed(target, figures, others) for target in targets]
    failed = [text for text in results if text]
    if failed:
        return "no: " + ", ".join(failed)
    return "yes" if results and None not in results else None


def best_peer(lines_of):
    """The largest F1 of the peers, as figures. lines_of: method -> lines."""
    scores = [summary.scores(lines_of(peer))[F1] for peer in accuracy_plan.PEERS if lines_of(peer)]
    return {F1: max((score for score in scores if score is not None), default=None)}


def row_cells(row, each, truth, others):
    """The cells of a row; each: the lines of each algorithm seed."""
    lines = [line for some in each for line in some]
    figures = figures_of(lines, row.group)
    worst = min((summary.scores(some, row.group)[F1] or 0.0 for some in each if some), default=None)
    numbers = [len({line["seed"] for line in lines}), figures[PRECISION], figures[RECALL], worst, figures[DOD],
               figures[RADIUS], figures[AXIS], figures[HALF_ANGLE], figures[FALSE_CURVED], figures["ms"]]
    cells = [cell(number, digits) for number, (_, digits) in zip(numbers, COLUMNS)]
    peer = others.get(AHEAD_OF_PEERS, {}).get(F1)
    cells += [cell(summary.scores(truth, row.group)[RECALL] if truth else None), cell(peer),
              cell("; ".join(map(target_text, row.targets))), cell(verdict(row.targets, figures, others) or "–")]
    return measured_on(cells, lines)


def table(results, methods):
    """All rows that were measured, then the recorded frames. methods: texts, one an algorithm seed."""
    experiments = {e.recipe: e for e in results.experiments}
    others, result, section = {}, [], None
    for row in accuracy_plan.rows():
        if row.recipe not in experiments:
            continue

        def lines_of(method, experiment=experiments[row.recipe]):
            return summary.lines_of(results, experiment, method)
        each = [lines_of(method) for method in methods]
        if not any(each):
            continue
        if row.section != section:
            result.append((row.section, None))
            section = row.section
        others[AHEAD_OF_PEERS] = best_peer(lines_of) if accuracy_plan.wants_peers(row) else {}
        if row.group == "all":
            others[row.title] = figures_of([line for some in each for line in some], "all")
        result.append((row.title, row_cells(row, each, lines_of("truth"), others)))
    columns = [name for name, _ in COLUMNS] + ["truth R", "peers F1", "target", "reached"]
    return Table("accuracy", "Accuracy: what is reached of what must be",
                 NOTE % (len(methods), ", ".join(accuracy_plan.PEERS)), [("", len(columns))], columns, result)


def together(summaries):
    """The figures of several algorithm seeds as those of one: frames, objects and alarms of all of them."""
    def total(of):
        return sum(map(of, summaries))

    def middle(of):
        values = [value for value in map(of, summaries) if value is not None]
        return {"median": statistics.median(values)} if values else None
    frames = total(lambda one: one["frames"])
    return {"frames": frames,
            "recall": {"all": {key: total(lambda one, key=key: one["recall"]["all"][key])
                               for key in ("found", "labels")}},
            **{key: total(lambda one, key=key: one[key] * one["frames"]) / frames
               for key in ("false_curved_per_frame", "other_planes_per_frame")},
            "false_on_negative_frames": {"all": total(lambda one: sum(one["false_on_negative_frames"].values()))},
            "radius_error_mm": {
                "absolute": middle(lambda one: (one["radius_error_mm"]["absolute"] or {}).get("median"))},
            "total_ms": middle(lambda one: (one["total_ms"] or {}).get("median"))}


def frame_cells(figures):
    """Those of one row for recorded frames."""
    must = figures["recall"]["all"]
    recall = summary.share(must["found"], must["labels"])
    on_negative = sum(figures["false_on_negative_frames"].values())
    radius, time = figures["radius_error_mm"]["absolute"] or {}, figures["total_ms"] or {}
    said = {RECALL: recall, FALSE_CURVED: figures["false_curved_per_frame"]}
    targets = (accuracy_plan.Target(RECALL, least=97.0), accuracy_plan.Target(FALSE_CURVED, most=0.3))
    reached = verdict(targets, said, {})
    if on_negative:
        reached = ("%s, " % reached if reached and reached != "yes" else "no: ") + "%d on negative" % on_negative
    return [cell(figures["frames"], 0), cell(None), cell(recall), cell(None), cell(None, 3),
            cell(radius.get("median"), 2), cell(None), cell(None), cell(said[FALSE_CURVED], 2),
            cell(time.get("median")), cell(None), cell(None),
            cell("; ".join(map(target_text, targets)) + "; none on negative"), cell(reached or "–")]


def frame_rows(summaries):
    """Rows for recorded frames: one for all algorithm seeds, as the rows above, and one for each, as their objects are
    so few that one of them is 3 %. summaries: seed -> figures of frames.score_and_draw()."""
    rows = [("Recorded frames", None)] if summaries else []
    if len(summaries) > 1:
        seeds = ", ".join(map(str, summaries))
        rows.append(("must labels, seeds %s" % seeds, frame_cells(together(summaries.values()))))
    rows += [("seed %d" % seed, frame_cells(figures)) for seed, figures in summaries.items()]
    return rows
