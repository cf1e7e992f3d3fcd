# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tables beyond the paper's: depth frames, noise, outliers, fewer points, cavities, numbers of samples."""
from report import contestants, plan, summary
from report.kinds import KINDS
from report.tables import Table, cell, clouds_text, mark_columns, measured_on

# kind -> its parameter errors: (name in the lines, heading, factor to the unit of the heading)
ERRORS = {
    "plane": (("position", "offset mm", 1000), ("axis_deg", "normal deg", 1)),
    "sphere": (("position", "centre mm", 1000), ("radius", "radius mm", 1000)),
    "cylinder": (("position", "axis mm", 1000), ("axis_deg", "axis deg", 1), ("radius", "radius mm", 1000)),
    "cone": (("apex", "apex mm", 1000), ("axis_deg", "axis deg", 1), ("half_angle_deg", "half angle deg", 1)),
}
TYPED = ("typed_precision", "typed_recall")


def tabletop(results):
    """Each kind of the simulated depth frames, at the sensor's usual noise."""
    experiments = [e for e in summary.of_part(results, "tabletop") if e.recipe.noise_scale == 1.0]
    rows = []
    for group in ("all",) + KINDS:
        for experiment in experiments:
            block = [(contestants.title(method), tabletop_cells(summary.lines_of(results, experiment, method), group))
                     for method in experiment.seeds if summary.lines_of(results, experiment, method)]
            rows += [(section_title(group), None)]
            rows += mark_columns(block, (None, None, True, True, True, False, False, False, False, False, False))
    return Table("tabletop", "Simulated depth frames of cluttered tables, 640 x 480",
                 "Percent with the right type; DOD: mean distance between found and true surface; errors: medians "
                 "over detections with the right type, in the order written beside the kind. Time: median per frame "
                 "from cloud to shapes. Ours makes its normals within that time; the peers are given normals, whose "
                 "making is not in theirs. PCL multi-plane looks for planes only. A method that finds fewer shapes "
                 "finds the easy ones: read DOD and errors with the recall. A row with fewer frames was measured on "
                 "the first ones only and takes no part in bold. Scored on the points without noise, within 20 mm of a "
                 "shape." + contestants.note_on_wider(label for label, _ in rows),
                 [("", 2), ("right type", 3), ("", 2), ("median parameter errors", 3), ("", 1)],
                 ["frames", "true shapes", "precision", "recall", "F1", "DOD mm", "noise %", "1st", "2nd", "3rd", "ms"],
                 rows)


def section_title(group):
    """"sphere: errors of 1st centre mm, 2nd radius mm"."""
    if group == "all":
        return "all kinds together"
    return group + ": errors " + ", ".join("%s %s" % pair for pair in zip(("1st", "2nd", "3rd"),
                                                                         (text for _, text, _ in ERRORS[group])))


def tabletop_cells(lines, group):
    figures = summary.scores(lines, group)
    cells = [cell(figures["clouds"], 0), cell(figures["truths"], 0), cell(figures["typed_precision"]),
             cell(figures["typed_recall"]), cell(figures["typed_f1"]), cell(figures["typed_dod"], 2),
             cell(figures["noise"])]
    medians = []
    for measure, _, factor in ERRORS.get(group, ()):
        value = summary.median(summary.errors(lines, group, measure))
        medians.append(cell(None if value is None else factor * value, 2))
    medians += [cell("")] * (3 - len(medians))
    times = cell(summary.median(summary.times(lines)) if group == "all" else "", 1)
    return measured_on(cells + medians + [times], lines)


def crossed(results, chosen, key, title, note, heading, dod_text):
    """Methods as rows; for each experiment, [(heading, experiment)] of a section, typed precision, recall and DOD."""
    rows, groups = [], []
    for section, experiments in chosen:
        groups = [(heading(e), 3) for e in experiments]
        methods = [m for m in experiments[0].seeds if any(summary.lines_of(results, e, m) for e in experiments)]
        block = []
        for method in methods:
            cells = []
            for experiment in experiments:
                lines = summary.lines_of(results, experiment, method)
                figures = summary.scores(lines)
                cells += measured_on([cell(figures[name]) for name in TYPED] + [cell(figures["typed_dod"], 2)], lines)
            counts = [len(summary.lines_of(results, e, method)) for e in experiments]
            text = (clouds_text(counts[0]) if len(set(counts)) == 1 else
                    ", ".join(map(str, counts)) + " clouds")
            block.append(("%s (%s)" % (contestants.title(method), text), cells))
        truth_rows = [label for label, _ in block if label.startswith(contestants.TITLES["truth"])]
        rows += ([(section, None)] if section else []) + mark_columns(block, (True, True, False) * len(experiments),
                                                                      truth_rows)
    return Table(key, title, note + " P, R: precision and recall with the right type in percent; DOD of these in "
                 + dod_text + ". Bold: the best of those measured on all clouds." +
                 contestants.note_on_wider(label for label, _ in rows), groups, ["P", "R", "DOD"] * len(groups), rows)


def noise(results):
    """The paper's sets at five noise levels."""
    return noise_scored_within(results, plan.USUAL_ANGLE, "noise", "Noise: the paper's sets at five levels",
                               "The truth handed in loses, too: with more noise the normals of the cloud leave the 15 "
                               "degrees of the scoring, so it marks what can be reached at most.")


def wide_noise(results):
    """The same, scored with normals that may be further off."""
    return noise_scored_within(results, plan.WIDE_ANGLE, "noise_wide",
                               "Strong noise, scored within %g degrees" % plan.WIDE_ANGLE,
                               "A point's normal may be %g degrees off instead of 15, so that the scoring no longer "
                               "hides what was found." % plan.WIDE_ANGLE)


def noise_scored_within(results, angle, key, title, note):
    experiments = [e for e in summary.of_part(results, "noise") if e.recipe.angle == angle]
    chosen = [(kind, [e for e in experiments if e.recipe.set == "paper-" + kind]) for kind in plan.KINDS]
    return crossed(results, [pair for pair in chosen if pair[1]], key, title, note,
                   lambda e: "noise %g" % e.recipe.sigma, "multiples of the noise")


def outliers(results):
    chosen = [e for e in summary.of_part(results, "variants") if e.recipe.set == "paper-mixed" and e.recipe.keep == 1.0]
    return crossed(results, [("", chosen)] if chosen else [], "outliers", "Outliers: mixed clouds with points anywhere",
                   "Points thrown evenly into the bounding box.",
                   lambda e: "%g %% outliers" % (100 * e.recipe.outliers), "multiples of the noise")


def fewer_points(results):
    chosen = [e for e in summary.of_part(results, "variants")
              if e.recipe.set == "paper-mixed" and e.recipe.outliers == 0.0]
    return crossed(results, [("", chosen)] if chosen else [], "points", "Fewer points: mixed clouds thinned out",
                   "A share of the 160,801 points drawn at random.", lambda e: "%g %% kept" % (100 * e.recipe.keep),
                   "multiples of the noise")


def concave(results):
    chosen = [e for e in summary.of_part(results, "variants") if e.recipe.set in plan.CONCAVE]
    return crossed(results, [("", chosen)] if chosen else [], "concave", "Cavities: the same shapes seen from inside",
                   "The paper's method votes for convex shapes only, by construction.",
                   lambda e: e.recipe.set.replace("concave-", ""), "multiples of the noise")


def tabletop_noise(results):
    chosen = summary.of_part(results, "tabletop")
    return crossed(results, [("", chosen)] if chosen else [], "tabletop_noise",
                   "Depth frames with less and more sensor noise", "All kinds together.",
                   lambda e: "sensor noise x %g" % e.recipe.noise_scale, "mm")


def samples(results):
    """Accuracy and time for several numbers of samples."""
    rows = []
    for experiment in summary.of_part(results, "samples"):
        block = []
        for method in experiment.seeds:
            lines = summary.lines_of(results, experiment, method)
            if lines:
                figures = summary.scores(lines)
                block.append((contestants.title(method), measured_on([
                    cell(figures["clouds"], 0), cell(summary.median(summary.times(lines)), 1),
                    cell(figures["typed_precision"]), cell(figures["typed_recall"]), cell(figures["typed_f1"]),
                    cell(figures["typed_dod"], 2)], lines)))
        rows += [(experiment.recipe.set, None)] + mark_columns(block, (None, False, True, True, True, False))
    return Table("samples", "Accuracy against time: several numbers of samples",
                 "Percent with the right type; median time per cloud; DOD in multiples of the noise, on tabletop in "
                 "mm.",
                 [("", 2), ("right type", 4)], ["clouds", "ms", "precision", "recall", "F1", "DOD"], rows)
