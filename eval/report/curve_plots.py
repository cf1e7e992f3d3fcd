# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plots of accuracy: coverage, against noise, outliers, number of points, and time."""
import os

import numpy

from report import contestants, figures, plan, summary

TYPED = (("typed_precision", "precision (%)"), ("typed_recall", "recall (%)"))


def coverage(results, folder):
    """p- and s-coverage on the mixed clouds."""
    chosen = [e for e in summary.of_part(results, "paper") if e.recipe.set == "paper-mixed"]
    return coverage_of(results, chosen, "How well the shapes found cover the cloud: mixed clouds, noise 0.01 m",
                       os.path.join(folder, "coverage.png"),
                       ("truth", "default", "paper", "b", "cgal", "cgal-3sigma", "pcl-sac"))


def parts_coverage(results, folder):
    """The same on mechanical parts."""
    return coverage_of(results, summary.of_part(results, "parts"),
                       "How well the shapes found cover the cloud: mechanical parts",
                       os.path.join(folder, "parts_coverage.png"), ("truth", "default", "paper", "cgal", "pcl-sac"))


def coverage_of(results, chosen, title, path, methods):
    if not chosen:
        return None
    figure, axes = figures.panels(1, 2, 4.6)
    names = (("p_coverage", "p-coverage: points that lie near any found shape", "share of the cloud's points (%)"),
             ("s_coverage", "s-coverage: a shape's own points that lie near it", "mean share of a shape's points (%)"))
    for one, (name, heading, label) in zip(axes[0], names):
        for method in methods:
            values = summary.curve(summary.lines_of(results, chosen[0], method), name)
            if values is not None:
                distances = 1000 * summary.CURVE_STEP * numpy.arange(len(values))
                one.plot(distances, values, **dict(contestants.line_style(method), marker="", label=figures.label_of(
                    results, chosen[:1], method, methods)))
        one.set_title(heading, loc="left")
        one.set_xlabel("nearer than (mm)")
        one.set_xlim(0, 50)
        figures.percent_axis(one, label)
    return figures.finish(figure, title, path)


def against(axes, results, experiments, places, measure, methods, labelled=None):
    """One line a method: a measure at the place of each experiment. labelled: all experiments of the plot, if more."""
    for method in methods:
        points = []
        for experiment, place in zip(experiments, places):
            lines = summary.lines_of(results, experiment, method)
            value = summary.scores(lines)[measure] if lines else None
            if value is not None:
                points.append((place, value))
        if points:
            axes.plot(*zip(*points), **dict(contestants.line_style(method), label=figures.label_of(
                results, labelled or experiments, method, methods)))


def noise(results, folder):
    """With the scoring of the paper."""
    return noise_scored_within(results, plan.USUAL_ANGLE, os.path.join(folder, "noise.png"),
                               "Against noise, by the kind of shapes in the cloud")


def wide_noise(results, folder):
    """Scored so that normals may be further off."""
    return noise_scored_within(results, plan.WIDE_ANGLE, os.path.join(folder, "noise_wide.png"),
                               "Against strong noise, scored with normals up to %g degrees off" % plan.WIDE_ANGLE)


def noise_scored_within(results, angle, path, title):
    """Typed precision, recall and DOD against noise, a column for each kind."""
    experiments = [e for e in summary.of_part(results, "noise") if e.recipe.angle == angle]
    if not experiments:
        return None
    figure, axes = figures.panels(3, len(plan.KINDS), 7.6, sharex=True, sharey="row")
    measures = TYPED + (("typed_dod", "DOD (times noise)"),)
    for column, kind in enumerate(plan.KINDS):
        chosen = [e for e in experiments if e.recipe.set == "paper-" + kind]
        for row, (measure, label) in enumerate(measures):
            one = axes[row][column]
            against(one, results, chosen, [1000 * e.recipe.sigma for e in chosen], measure,
                    ("truth", "default", "paper", "cgal", "cgal-3sigma", "pcl-sac"), experiments)
            one.set_xticks(sorted({1000 * e.recipe.sigma for e in experiments}))
            one.set_ylabel(label if column == 0 else "")
        axes[0][column].set_title(kind)
        axes[2][column].set_xlabel("noise (mm)")
    # The rows share their axis: its limits are known when all is drawn.
    for row, limits in enumerate(((-3, 103), (-3, 103), (0, None))):
        axes[row][0].set_ylim(*limits)
    return figures.finish(figure, title, path,
                          note="Precision and recall count detections with the right type only. DOD: distance between "
                               "found and true surfaces, smaller is better.\n"
                               "The dotted line is what the scoring gives the truth itself: the recall that can be "
                               "reached.")


def variants(results, folder, name, chosen, places, label, title):
    """Typed precision, recall and DOD in three panels; returns None without experiments."""
    if len(chosen) < 2:
        return None
    figure, axes = figures.panels(1, 3, 3.9)
    for one, (measure, heading) in zip(axes[0], TYPED + (("typed_dod", "DOD (times noise)"),)):
        against(one, results, chosen, places, measure, ("truth", "default", "paper", "cgal"))
        one.set_ylabel(heading)
        one.set_xlabel(label)
        if measure == "typed_dod":
            one.set_ylim(bottom=0)
        else:
            one.set_ylim(-3, 103)
        if name == "points":
            one.set_xscale("log")
            one.set_xticks(places, ["{:,.0f}".format(place) for place in places])
            one.set_xticks([], minor=True)
    return figures.finish(figure, title, os.path.join(folder, name + ".png"),
                          note="Detections with the right type only. DOD: distance between found and true surfaces, "
                               "smaller is better.")


def outliers(results, folder):
    chosen = [e for e in summary.of_part(results, "variants") if e.recipe.set == "paper-mixed" and e.recipe.keep == 1.0]
    return variants(results, folder, "outliers", chosen, [100 * e.recipe.outliers for e in chosen],
                    "outliers (% of the points)", "Against outliers: mixed clouds with points thrown in anywhere")


def points(results, folder):
    chosen = [e for e in summary.of_part(results, "variants")
              if e.recipe.set == "paper-mixed" and e.recipe.outliers == 0.0]
    return variants(results, folder, "points", chosen, [160801 * e.recipe.keep for e in chosen],
                    "points in the cloud", "Against the number of points: mixed clouds thinned out")


def tabletop_noise(results, folder):
    chosen = summary.of_part(results, "tabletop")
    if len(chosen) < 2:
        return None
    figure, axes = figures.panels(1, 3, 3.9)
    for one, (measure, heading) in zip(axes[0], TYPED + (("typed_dod", "DOD (mm)"),)):
        against(one, results, chosen, [e.recipe.noise_scale for e in chosen], measure,
                ("truth", "default", "paper", "cgal", "cgal-3sigma", "pcl-planes", "pcl-sac"))
        one.set_xscale("log", base=2)
        one.set_xticks(plan.NOISE_SCALES, ["x 0.5", "x 1", "x 2"])
        one.set_xlabel("noise of the depth sensor")
        one.set_ylabel(heading)
        one.set_ylim(0 if measure == "typed_dod" else -3, None if measure == "typed_dod" else 103)
    return figures.finish(figure, "Simulated depth frames of cluttered tables: against sensor noise",
                          os.path.join(folder, "tabletop_noise.png"),
                          note="Detections with the right type only. PCL multi-plane looks for planes alone and is "
                               "scored on all kinds here.")


def samples(results, folder):
    """Typed F1 against time, our lines over the number of samples, peers as points."""
    experiments = summary.of_part(results, "samples")
    if not experiments:
        return None
    figure, axes = figures.panels(1, 2, 4.6)
    peers = ("cgal", "cgal-2048", "pcl-sac")
    titles = {"paper-mixed": "mixed clouds of 160,801 points", "tabletop": "simulated depth frames 640 x 480"}
    for one, experiment in zip(axes[0], experiments):
        for preset in ("default", "paper"):
            curve = [(time_and_f1(results, experiment, text), count)
                     for (name, count), text in plan.sample_methods().items() if name == preset]
            draw_counts(one, preset, [(place, count) for place, count in curve if place])
        for method in peers:
            place = time_and_f1(results, experiment, method)
            if place:
                label = figures.label_of(results, experiments, method, peers + tuple(plan.sample_methods().values()))
                one.plot(*place, **dict(contestants.line_style(method), linestyle="", markersize=9, label=label))
        one.set_xscale("log")
        figures.plain_log(one.xaxis, short=True)
        one.set_xlabel("median time for a cloud (ms)")
        one.set_title(titles.get(experiment.recipe.set, experiment.recipe.set), loc="left")
        figures.percent_axis(one, "F1, right type (%)")
    return figures.finish(figure, "Accuracy against time", os.path.join(folder, "samples.png"),
                          note="F1: harmonic mean of precision and recall. Numbers beside the lines: samples drawn in "
                               "a round. Up and to the left is better.\n"
                               "Peers: time without the making of the normals that they are given.")


def time_and_f1(results, experiment, method):
    lines = summary.lines_of(results, experiment, method)
    time, f1 = summary.median(summary.times(lines)), summary.scores(lines)["typed_f1"] if lines else None
    return None if time is None or f1 is None else (time, f1)


def draw_counts(axes, preset, curve):
    """A line through (time, F1) with the number of samples beside each point."""
    if not curve:
        return
    places = [place for place, _ in curve]
    axes.plot(*zip(*places), **contestants.line_style(preset))
    upright = 90 if preset == "default" else 0  # its times hardly differ: numbers side by side would cover each other
    for (x, y), count in curve:
        axes.annotate(str(count), (x, y), xytext=(0, -6), textcoords="offset points", ha="center", va="top",
                      rotation=upright, fontsize=8, color=contestants.COLOURS[preset])
