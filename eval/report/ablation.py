# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What each step of the detector brings and costs: the figures with it less those without."""
from collections import namedtuple

from report import accuracy, store, summary, trust
from report.accuracy_plan import AXIS, DOD, FALSE_CURVED, HALF_ANGLE, PRECISION, RADIUS, RECALL
from report.kinds import KINDS
from report.plan import Experiment, Recipe
from report.tables import Table, cell

REPEAT = 5
MORE_REPEATS = (6,)  # of clouds whose times are told, later: of all runs the shortest counts
WHOLE = "default"
NEES = "nees"
# recipes: how many times --clouds of each
Group = namedtuple("Group", "name recipes measures")
# stage and meaning: as steps.def says; text: the method without it
Step = namedtuple("Step", "name stage meaning text")
# figures: by (group, measure); answers: by group, what tells whether anything changed; ms: by group, of each cloud
Figures = namedtuple("Figures", "figures answers ms")

STAGES = ("normals", "segment", "look closer", "measure")
FOUND = (PRECISION, RECALL)
TABLES, SCENES = "tables", "scenes"
TIMED = (TABLES, SCENES)
GROUPS = (
    Group(TABLES, {Recipe("tabletop"): 3}, FOUND + (RADIUS, AXIS, HALF_ANGLE, NEES)),
    Group("other cameras", {Recipe("tabletop", sensor="stereo"): 1, Recipe("tabletop", sensor="time_of_flight"): 1,
                            Recipe("tabletop", sensor="bent_structured_light"): 1,
                            Recipe("tabletop", noise_scale=3.0): 1,
                            Recipe("tabletop", noise_scale=2.0, noise_grain=5): 1}, FOUND + (NEES,)),
    Group("several parts", {Recipe("household"): 2, Recipe("household", sensor="stereo"): 2, Recipe("heap"): 1,
                            Recipe("hall"): 1}, FOUND),
    Group("cut out", {Recipe("objects"): 3}, FOUND),
    Group("clutter", {Recipe("clutter"): 2, Recipe("clutter", sensor="stereo"): 2}, (FALSE_CURVED,)),
    Group("lists", {Recipe("tabletop", shuffle=True): 1, Recipe("tabletop", voxel=0.005): 1,
                    Recipe("tabletop", robot_frame=True, shuffle=True): 1}, FOUND),
    Group(SCENES, {Recipe("paper-mixed"): 1, Recipe("paper-cones"): 0.5, Recipe("paper-cylinders"): 0.5,
                   Recipe("paper-mixed", outliers=0.3): 0.5, Recipe("small"): 1}, FOUND + (DOD, NEES)),
)
# Steps that are parameters.
OPTIONS = (
    Step("closer_samples", "look closer", "more samples where the shapes are", "closer_samples=0"),
    Step("improve_normals", "segment", "poor normals of lists measured anew", "improve_normals=false"),
)
# Column, digits, whether less is better.
COLUMNS = {PRECISION: ("P", 1, False), RECALL: ("R", 1, False), FALSE_CURVED: ("false curved", 2, True),
           RADIUS: ("radius mm", 3, True), AXIS: ("axis deg", 3, True), HALF_ANGLE: ("half angle deg", 3, True),
           DOD: ("DOD", 3, True), NEES: ("NEES", 2, True)}
NOTE = ("First row: with all steps. Others: by how much the figure is better with the step than without it, minus "
        "where it is worse; –: without it every detection is the same, or nothing can be said. ")


def steps_of(about):
    """Steps of a program that tells of itself what eval/report/environment.py asks."""
    told = [Step(one["name"], one["stage"], one["meaning"], "without:" + one["name"]) for one in about["steps"]]
    return OPTIONS + tuple(told)


def method_of(step):
    return "no-%s=preset:default,%s" % (step.name, step.text)


def experiments(steps, clouds, only=None):
    """One experiment for each recipe, and more of those that are timed."""
    methods = [WHOLE] + [method_of(step) for step in steps]
    wanted = [(group, recipe, dict.fromkeys(methods, max(1, round(share * clouds))))
              for group in GROUPS if not only or group.name in only for recipe, share in group.recipes.items()]
    return [Experiment("ablation", recipe, seeds, repeat) for repeat in (REPEAT, *MORE_REPEATS)
            for group, recipe, seeds in wanted if repeat == REPEAT or group.name in TIMED]


def normalised_error(lines):
    """Of all kinds together; see trust.normalised_error()."""
    each = [trust.normalised_error(lines, kind, "total") for kind in KINDS]
    count = sum(n for value, n in each if value is not None)
    return sum(value * n for value, n in each if value is not None) / count if count else None


def answer_of(line):
    """What was found and how well, to be compared."""
    return line["all"], line["errors"], line["detections"]


def cloud_of(line):
    """The same for all methods."""
    return store.key_of(line)._replace(method=None, repeat=None)


def shortest(lines):
    """Milliseconds by cloud."""
    times = {}
    for line in lines:
        cloud = cloud_of(line)
        times[cloud] = min(times.get(cloud, line["total_ms"]), line["total_ms"])
    return times


def figures_of(results, steps):
    """Figures of each method, WHOLE among them, for the groups that were measured."""
    of_methods = {}
    for method in [WHOLE] + [method_of(step) for step in steps]:
        figures, answers, times = {}, {}, {}
        for group in GROUPS:
            all_lines = [line for e in results.experiments if e.recipe in group.recipes
                         for line in summary.lines_of(results, e, method)]
            lines = [line for line in all_lines if line["repeat"] == REPEAT]
            if not lines:
                continue
            measured = accuracy.figures_of(lines, "all")
            measured[NEES] = normalised_error(lines)
            figures.update({(group.name, measure): measured[measure] for measure in group.measures})
            answers[group.name] = {cloud_of(line): answer_of(line) for line in lines}
            times[group.name] = shortest(all_lines)
        of_methods[method] = Figures(figures, answers, times)
    steady_times(of_methods)
    return of_methods


def steady_times(of_methods):
    """WHOLE's time of a cloud becomes the median of its own and of those without a step that changed nothing there: all
    of them did the same work but for that."""
    whole = of_methods[WHOLE]
    for group, answers in whole.answers.items():
        for cloud, answer in answers.items():
            same = [one.ms[group][cloud] for one in of_methods.values()
                    if group in one.answers and one.answers[group].get(cloud) == answer]
            whole.ms[group][cloud] = summary.median(same)


def better(whole, without, group, measure):
    """By how much, None where nothing changed or nothing can be said."""
    with_it, without_it = (one.figures.get((group, measure)) for one in (whole, without))
    if with_it is None or without_it is None or whole.answers[group] == without.answers[group]:
        return None
    if measure == NEES:  # 1 is right
        return abs(without_it - 1.0) - abs(with_it - 1.0)
    return without_it - with_it if COLUMNS[measure][2] else with_it - without_it


def cost(whole, without, group):
    """Milliseconds a cloud, the median of what clouds take longer with the step."""
    both = set(whole.ms.get(group, {})) & set(without.ms.get(group, {}))
    return summary.median([whole.ms[group][key] - without.ms[group][key] for key in both])


def cells(whole, without, columns, groups_with_times):
    row = []
    for group, measure in columns:
        value = better(whole, without, group, measure) if without else whole.figures.get((group, measure))
        row.append(cell(value, COLUMNS[measure][1]))
    for group in groups_with_times:
        value = cost(whole, without, group) if without else summary.median(list(whole.ms[group].values()))
        row.append(cell(value, 2))
    return row


def in_order(steps):
    """As a frame runs through them."""
    return sorted(steps, key=lambda step: STAGES.index(step.stage))


def rows_of(steps, whole, cells_of):
    """A row of all steps, then a heading for each stage and a row for each of its steps. whole: cells."""
    rows, stage = [("all steps", whole)], None
    for step in in_order(steps):
        if step.stage != stage:
            rows.append((step.stage, None))
            stage = step.stage
        rows.append(("%s (`%s`)" % (step.meaning, step.name), cells_of(step)))
    return rows


def table(figures, steps, key, title, note, measures):
    """These measures of all groups that were measured, and times; None where there are none. figures: figures_of()."""
    whole = figures[WHOLE]
    columns = [(group.name, measure) for group in GROUPS for measure in group.measures
               if measure in measures and group.name in whole.answers]
    if not columns:
        return None
    timed = [name for name in TIMED if name in whole.ms]
    rows = rows_of(steps, cells(whole, None, columns, timed),
                   lambda step: cells(whole, figures[method_of(step)], columns, timed))
    spans = [(name, sum(group == name for group, _ in columns)) for name in dict.fromkeys(g for g, _ in columns)]
    spans += [("ms", len(timed))] if timed else []
    return Table(key, title, NOTE + note, spans, [COLUMNS[measure][0] for _, measure in columns] + timed, rows)


def tables_of(results, steps):
    """What steps bring of what there is to find, and of how well it is measured."""
    figures = figures_of(results, steps)
    made = (table(figures, steps, "found", "What is found, by step",
                  "P, R: precision and recall with the right type, points of a percent; false curved: a frame less.",
                  (PRECISION, RECALL, FALSE_CURVED)),
            table(figures, steps, "measured", "How well it is measured, by step",
                  "Radius, axis, half angle: medians of the errors. DOD in multiples of the noise. NEES: mean "
                  "normalised squared error over its degrees of freedom; better: nearer to 1.",
                  (RADIUS, AXIS, HALF_ANGLE, DOD, NEES)))
    return [one for one in made if one]


def frame_figures(steps, score):
    """Figures of recorded frames, a list with those of each draw of the samples for WHOLE and for each step's method.
    score: (options of detect) -> the figures of all draws."""
    figures = {WHOLE: score([])}
    for step in steps:
        name, _, value = step.text.partition("=")
        figures[method_of(step)] = score(["--" + name, value] if value else ["--without", step.name])
    return figures


def difference(one, other):
    return None if one is None or other is None else one - other


def frames_table(figures, steps):
    """A row for each step. figures: as frame_figures() gives them."""
    def told(summaries):
        scored = [one for one in summaries if one["frames"]]
        if not scored:
            return None, None, None
        all_draws = accuracy.together(scored)
        must = all_draws["recall"]["all"]
        return (summary.share(must["found"], must["labels"]), all_draws["false_curved_per_frame"],
                all_draws["other_planes_per_frame"])

    def cells_of(step):
        recall_without, false_without, planes_without = told(figures[method_of(step)])
        return [cell(difference(recall, recall_without)), cell(difference(false_without, false_curved), 2),
                cell(difference(planes_without, planes), 2)]
    recall, false_curved, planes = told(figures[WHOLE])
    return Table("frames", "Recorded frames, by step",
                 "Over %d draws of the samples. First row: with all steps. Others: how much is better with the step: "
                 "must labels found, points of a percent; false curved shapes a frame less; and how many planes a "
                 "frame less fit no label: parts of round things, but a room's own, too." % len(figures[WHOLE]),
                 [("", 3)], ["R", "false curved", "other planes"],
                 rows_of(steps, [cell(recall), cell(false_curved, 2), cell(planes, 2)], cells_of))
