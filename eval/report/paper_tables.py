# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the paper, measured anew, with its own figures beside ours."""
from report import contestants, plan, published, summary
from report.tables import Table, cell, clouds_text, mark_best, mark_columns, measured_on

DETECTION_COLUMNS = (("cgal", "(a)"), ("b", "(b)"), ("paper", "ours"), ("default", "default"))
DOD_COLUMNS = (("cgal", "(a)"), ("b", "(b)"), ("c", "(c)"), ("d", "(d)"), ("e", "(e)"), ("paper", "ours"),
               ("default", "default"))
WHO = ("(a) CGAL Efficient RANSAC, (b) Drost* baseline, ours: the paper's method (preset paper), default: this "
       "package's default. In brackets the figure printed in the paper; bold: best of this run. ")


def rows_by_kind(results):
    """Label with the number of clouds, kind and experiment of each set of the paper."""
    for experiment in summary.of_part(results, "paper"):
        kind = experiment.recipe.set.replace("paper-", "")
        clouds = len(summary.lines_of(results, experiment, "default"))
        yield "%s (%s)" % (kind, clouds_text(clouds)), kind, experiment


def detection(results):
    """Precision, recall, missed-rate and noise-rate, whatever the type, in percent."""
    measures = (("precision", True), ("recall", True), ("missed", False), ("noise", False))
    rows = []
    for label, kind, experiment in rows_by_kind(results):
        cells = []
        for measure, higher in measures:
            group = []
            for method, _ in DETECTION_COLUMNS:
                lines = summary.lines_of(results, experiment, method)
                value = summary.scores(lines)[measure]
                known = published.figure(published.DETECTION, kind, measure, published.COLUMN_OF.get(method))
                group += measured_on([cell(value, 1, known)], lines)
            cells += mark_best(group, higher)
        rows.append((label, cells))
    return Table("detection", "Detection on the paper's data set, noise 0.01 (percent)", WHO +
                 "A detection is correct when it and a true region overlap by 60 % of both, of whatever type.",
                 [(name, len(DETECTION_COLUMNS)) for name, _ in measures],
                 [name for _, name in DETECTION_COLUMNS] * len(measures), rows)


def dod(results):
    """The data-aware object distance with the ablations."""
    rows = []
    for label, kind, experiment in rows_by_kind(results):
        cells = []
        for method, _ in DOD_COLUMNS:
            lines = summary.lines_of(results, experiment, method)
            value = summary.scores(lines)["dod"]
            known = published.figure(published.DOD, kind, published.COLUMN_OF.get(method))
            cells += measured_on([cell(value, 2, known)], lines)
        rows.append((label, mark_best(cells, False)))
    return Table("dod", "Distance between found and true surfaces (DOD, multiples of the noise) with ablations", WHO +
                 "(c) NMS clustering instead of averaging, (d) no averages over bins, (e) no spreading of votes. Mean "
                 "over correct detections; smaller is better.",
                 [("", len(DOD_COLUMNS))], [name for _, name in DOD_COLUMNS], rows)


def typed(results):
    """Precision and recall with the right type, all methods."""
    rows, higher = [], (None, True, True, True, True, True, False)
    for _, kind, experiment in rows_by_kind(results):
        block = []
        for method in experiment.seeds:
            lines = summary.lines_of(results, experiment, method)
            if lines:
                figures = summary.scores(lines)
                names = ("precision", "recall", "typed_precision", "typed_recall", "typed_f1")
                block.append((contestants.title(method), measured_on([cell(figures["clouds"], 0)] + [
                    cell(figures[name]) for name in names] + [cell(figures["typed_dod"], 2)], lines)))
        rows += [(kind, None)] + mark_columns(block, higher)
    return Table("typed", "Detection with the right type on the paper's data set, noise 0.01 (percent)",
                 "Typed: a correct detection must also be of the true type. F1: harmonic mean of typed precision and "
                 "recall. The truth's own row shows what the scoring allows at best. A row with fewer clouds was "
                 "measured on the first ones only and takes no part in bold." +
                 contestants.note_on_wider(label for label, _ in rows),
                 [("", 1), ("any type", 2), ("right type", 4)],
                 ["clouds", "precision", "recall", "precision", "recall", "F1", "DOD (noise)"], rows)


def segmentation(results):
    """Coverage and segmentation errors on the mixed clouds."""
    rows = []
    for experiment in [e for e in summary.of_part(results, "paper") if e.recipe.set == "paper-mixed"]:
        for method in experiment.seeds:
            lines = summary.lines_of(results, experiment, method)
            if lines:
                figures = summary.scores(lines)
                rows.append((contestants.title(method), measured_on([cell(figures["clouds"], 0)] + [
                    cell(summary.coverage_at(lines, name, distance))
                    for name in ("p_coverage", "s_coverage") for distance in (0.01, 0.02)] + [
                    cell(figures[name]) for name in ("over", "under", "missed", "noise")], lines)))
    rows = mark_columns(rows, (None, True, True, True, True, False, False, False, False))
    return Table("segmentation", "Coverage and segmentation errors, mixed clouds, noise 0.01 (percent)",
                 "p-coverage: points that lie so near (m) to any found shape; s-coverage: a found shape's own points "
                 "that do. Over: true shapes found in several pieces; under: detections over several true shapes; "
                 "missed: true shapes without, noise: detections without a counterpart.",
                 [("", 1), ("p-coverage", 2), ("s-coverage", 2), ("", 4)],
                 ["clouds", "0.01", "0.02", "0.01", "0.02", "over", "under", "missed", "noise"], rows)


def runtime(results):
    """Joint and for each kind alone: ms and how many times faster than Efficient RANSAC on the full cloud."""
    experiments = summary.of_part(results, "runtime")
    columns = plan.RUNTIME_COLUMNS
    if not experiments:
        return Table("runtime", "Runtime", "Not measured.", [("", 1)], [""], [])
    texts, experiment = plan.kind_methods(), experiments[0]

    def ms(method, column, times=summary.times):
        return summary.median(times(summary.lines_of(results, experiment, texts[method, column])))

    def row(method, times=summary.times, known=None):
        cells = []
        for column in columns:
            value, full = ms(method, column, times), ms("cgal", column, summary.times_without_tree)
            printed = published.figure(published.RUNTIME, known, column)
            compared = published.figure(published.RUNTIME, "a", column)
            ratio = full / value if value and full else None
            cells += measured_on([cell(value, 1, printed), cell(ratio, 1, compared / printed if printed else None)],
                                 summary.lines_of(results, experiment, texts[method, column]))
        return cells

    def votes_of(lines):
        return summary.times(lines, "vote_ms")

    rows = [("primitect, default", row("default")), ("primitect, paper preset", row("paper", known="ours")),
            ("CGAL, all points, without search tree", row("cgal", summary.times_without_tree, "a")),
            ("CGAL, 2048 points, without search tree", row("cgal-2048", summary.times_without_tree, "a-2048"))]
    rows = mark_columns(rows, [False, None] * len(columns), ()) + [
        ("of it voting: default", row("default", votes_of)), ("of it voting: paper preset", row("paper", votes_of)),
        ("CGAL, all points, with search tree", row("cgal")), ("CGAL, 2048 points, with search tree", row("cgal-2048")),
        ("SPFN on a GPU, printed in the paper", [cell(None, 1, published.figure(published.RUNTIME, "SPFN", column))
                                                 for name in columns for column in (name, "speed-up")])]
    clouds = len(summary.lines_of(results, experiment, "default"))
    return Table("runtime", "Runtime on %s of 160,801 points, mixed, one thread (ms)" % clouds_text(clouds),
                 "Median over the clouds, best of %d runs on each. Speed-up: how many times faster than CGAL on all "
                 "points without its search tree, in the same column. In brackets the paper's figures, on another "
                 "machine; its RANSAC times leave out the search tree. The normals come with the cloud, for all "
                 "methods." % experiment.repeat,
                 [(column, 2) for column in columns], ["ms", "speed-up"] * len(columns), rows)


def parts(results):
    """In the layout of the paper's table for traceparts."""
    rows = []
    for experiment in summary.of_part(results, "parts"):
        for method in experiment.seeds:
            lines = summary.lines_of(results, experiment, method)
            if not lines:
                continue
            figures = summary.scores(lines)
            column = published.COLUMN_OF.get(method) if method in ("cgal", "paper") else None
            rows.append((contestants.title(method), measured_on([
                cell(figures["clouds"], 0),
                cell(summary.coverage_at(lines, "p_coverage", 0.01), 1,
                     published.figure(published.TRACEPARTS, column, "p_coverage_001")),
                cell(summary.coverage_at(lines, "p_coverage", 0.02), 1,
                     published.figure(published.TRACEPARTS, column, "p_coverage_002")),
                cell(figures["type"], 1, published.figure(published.TRACEPARTS, column, "type")),
                cell(figures["typed_precision"]), cell(figures["typed_recall"]),
                cell(summary.median(summary.times(lines)), 1)], lines)))
    rows = mark_columns(rows, (None, True, True, True, True, True, False))
    for name in ("SPFN", "SPFN without segmentation loss") if rows else ():
        known = published.TRACEPARTS[name]
        rows.append((name + ", printed in the paper", [cell(None), cell(None, 1, known["p_coverage_001"]),
                                                       cell(None, 1, known["p_coverage_002"]),
                                                       cell(None, 1, known["type"])] + [cell(None)] * 3))
    return Table("parts", "Mechanical parts, 8096 points (percent)",
                 "THE DATA IS NOT THE SAME: the figures in brackets were measured on traceparts (CAD parts, with the "
                 "evaluation of SPFN's authors), ours on generated parts of that style. They show the order of "
                 "magnitude only; SPFN was not run here. Right type: true shapes whose best overlapping detection has "
                 "their type. Scored on the points without noise, within 0.05 of a shape; coverage is that of the "
                 "measured points.",
                 [("", 1), ("p-coverage", 2), ("", 1), ("typed", 2), ("", 1)],
                 ["clouds", "within 0.01", "within 0.02", "right type", "precision", "recall", "ms"], rows)
