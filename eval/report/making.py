# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""From kept lines to all results of a folder: CSV, plots, summary.md, report.html."""
import csv
import os

from report import (bar_plots, contestants, curve_plots, more_tables, page, paper_tables, pictures, plan, summary,
                    tables)
from report.kinds import KINDS

TABLES = (paper_tables.detection, paper_tables.dod, paper_tables.typed, paper_tables.segmentation,
          paper_tables.runtime, more_tables.samples, more_tables.tabletop, more_tables.tabletop_noise,
          more_tables.noise, more_tables.wide_noise, more_tables.outliers, more_tables.fewer_points,
          more_tables.concave, paper_tables.parts)
PLOTS = (curve_plots.coverage, curve_plots.noise, curve_plots.wide_noise, curve_plots.outliers, curve_plots.points,
         curve_plots.samples, curve_plots.tabletop_noise, curve_plots.parts_coverage, bar_plots.runtime,
         bar_plots.tabletop_errors)
# heading, tables and plots of each chapter of the page
CHAPTERS = (
    ("The paper's data set", ("detection", "dod", "typed", "segmentation"), ("coverage.png",)),
    ("Time", ("runtime", "samples"), ("runtime.png", "samples.png")),
    ("Depth frames", ("tabletop", "tabletop_noise"), ("tabletop_errors.png", "tabletop_noise.png")),
    ("Noise, outliers, fewer points, cavities", ("noise", "noise_wide", "outliers", "points", "concave"),
     ("noise.png", "noise_wide.png", "outliers.png", "points.png")),
    ("Mechanical parts", ("parts",), ("parts_coverage.png",)),
)
UNTYPED = ("precision", "f1", "dod")  # are nothing for a single kind
BUSY_LOAD = 1.5  # the measurement itself is 1
INTRODUCTION = (
    "All methods ran on the same clouds, in turn, on one thread. Every cloud is made from its seed with the truth of "
    "each point. A point belongs to the closest shape within 0.05 m (parts: 0.05, depth frames: 20 mm) whose normal "
    "agrees within 15 degrees (the tables and plots of strong noise that say so: 40). Parts and depth frames are "
    "scored on the points without noise, their coverage is that of the measured points. A detection is correct when "
    "it and a true region share 60 % of the points of both.")


def files_of_a_run(folder):
    """Paths of all tables, plots and pages that make() may write."""
    names = ["summary.md", "report.html", "scores.csv", "coverage.csv"]
    for _, keys, plots in CHAPTERS:
        names += [key + ".csv" for key in keys] + [os.path.join("plots", name) for name in plots]
    return [os.path.join(folder, name) for name in names]


def seeds_used(results):
    """The seeds of all that stands in a table or plot."""
    return {line["seed"] for _, _, lines in every(results) for line in lines}


def make(folder, results, environment, quick, faults, missing):
    """Writes everything into the folder and returns the path of the page. environment: see store.origin(); faults
    grows by the pictures that cannot be read."""
    plots = os.path.join(folder, "plots")
    os.makedirs(plots, exist_ok=True)
    made = [table for table in (make_table(results) for make_table in TABLES) if table.rows]
    for table in made:
        tables.write_csv(table, os.path.join(folder, table.key + ".csv"),
                         tables.head_lines(environment, tables.seeds_text(tables.seeds_of(table))))
    head = tables.head_lines(environment, tables.seeds_text(seeds_used(results)))
    write_scores(results, os.path.join(folder, "scores.csv"), head)
    write_coverage(results, os.path.join(folder, "coverage.csv"), head)
    for path in files_of_a_run(folder):
        if os.path.dirname(path) == plots and os.path.exists(path):
            os.remove(path)
    for draw in PLOTS:
        draw(results, plots)
    chapters = chapters_of(folder, made, quick, faults)
    warnings = warnings_of(results, faults, missing)
    with open(os.path.join(folder, "summary.md"), "w", encoding="utf-8") as file:
        file.write(summary_text(made, results, environment, quick, warnings))
    path = os.path.join(folder, "report.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write(report_page(chapters, results, environment, quick, warnings))
    return path


def warnings_of(results, faults, missing):
    """What a reader must know before trusting a row."""
    found = ["Not measured: %s is not built here." % contestants.title(name) for name in missing]
    found += faults
    busy = sum(1 for line in results.by_key.values() if line.get("load", 0) > BUSY_LOAD)
    if 10 * busy > len(results.by_key):
        found.append("The machine was busy with other work during %d of %d measurements (load above %g): times are too "
                     "long and cannot be compared." % (busy, len(results.by_key), BUSY_LOAD))
    given_up = {}
    for key, line in results.by_key.items():
        if line["failure"]:
            given_up.setdefault((key.recipe.set, line["method"], line["failure"]), []).append(key.seed)
    return found + ["%s gave up on %d clouds of %s (%s); they count as nothing found." % (
        contestants.title(method), len(seeds), name, why) for (name, method, why), seeds in sorted(given_up.items())]


def facts_of(results, environment, quick):
    clouds = {(experiment.recipe, line["seed"]) for experiment, _, lines in every(results) for line in lines}
    return (("Command", "eval/run --quick" if quick else "eval/run"), ("Date", environment["date"]),
            ("CPU", environment["cpu"]), ("Commit", environment["commit"]),
            ("Compiler", environment["compiler"]), ("Seeds", tables.seeds_text(seeds_used(results))),
            ("Clouds", str(len(clouds))))


def summary_text(made, results, environment, quick, warnings):
    """All tables as Markdown."""
    facts = "\n".join("- %s: %s" % pair for pair in facts_of(results, environment, quick) if pair[1])
    notes = "".join("- **Note:** %s\n" % text for text in warnings)
    return facts + "\n" + notes + "\n" + "\n".join(tables.markdown(table) for table in made)


def chapters_of(folder, made, quick, faults):
    """(heading, HTML) of each chapter; faults grows by the pictures that cannot be read."""
    by_key = {table.key: table for table in made}
    chapters = []
    for heading, keys, plots in CHAPTERS:
        paths = [os.path.join(folder, "plots", name) for name in plots]
        chapters.append((heading, "".join(tables.html_table(by_key[key]) for key in keys if key in by_key) + "".join(
            page.image(path, faults) for path in paths if os.path.exists(path))))
    chapters.insert(1, ("Pictures", "".join(
        page.image(path, faults, caption, wide=True) for path, caption in pictures.found_in(
            folder, quick, plan.FIRST_SEED["quick" if quick else "full"]))))
    return chapters


def report_page(chapters, results, environment, quick, warnings):
    head = page.facts(facts_of(results, environment, quick)) + '<p class="note">%s</p>' % INTRODUCTION
    return page.page("primitect: what was measured", head + "".join(page.warning(text) for text in warnings), chapters)


def every(results):
    """(experiment, method, lines) of all that was measured; recipes that several parts share come with each."""
    for experiment in results.experiments:
        for method in experiment.seeds:
            lines = summary.lines_of(results, experiment, method)
            if lines:
                yield experiment, method, lines


def write_scores(results, path, head):
    """One row for each experiment, method and kind, with every figure there is."""
    names = list(summary.scores([]))
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(head + "# percent, DOD in multiples of the noise (tabletop: mm), medians of ms\n"
                   "# of one kind: recall, missed, over and type by the true kind, noise and under by the found kind\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["part"] + list(plan.Recipe._fields) + ["method", "kind"] + names
                        + ["total_ms", "vote_ms", "tree_ms"])
        for experiment, method, lines in every(results):
            times = [summary.median(summary.times(lines, name)) for name in ("total_ms", "vote_ms", "prepare_ms")]
            for group in ("all",) + KINDS:
                figures = summary.scores(lines, group)
                if group != "all":  # correct ones are counted by the true kind, found ones by the found kind
                    figures.update(dict.fromkeys(UNTYPED))
                writer.writerow([experiment.part] + list(experiment.recipe) + [lines[0]["method"], group] + [
                    tables.csv_text(value) for value in [figures[name] for name in names] + times])


def write_coverage(results, path, head):
    """The curves: a row for each experiment, method and curve, a column for each distance."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(head + "# percent nearer than so many m\n")
        writer = csv.writer(file, lineterminator="\n")
        distances = ["%.3f" % (i * summary.CURVE_STEP) for i in range(26)]
        writer.writerow(["part"] + list(plan.Recipe._fields) + ["method", "curve"] + distances)
        for experiment, method, lines in every(results):
            for name in ("p_coverage", "s_coverage"):
                values = summary.curve(lines, name)
                if values is not None:
                    writer.writerow([experiment.part] + list(experiment.recipe) + [lines[0]["method"], name]
                                    + [tables.csv_text(value) for value in values])
