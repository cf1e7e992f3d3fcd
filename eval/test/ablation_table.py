#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""eval/ablation: what a step brings is the figure with it less the one without; its cost is that of the same clouds."""
import os
import sys
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.dirname(HERE), HERE]

from report import ablation, summary, tables  # noqa: E402
from report.plan import Recipe  # noqa: E402
from report_lines import counts, kept  # noqa: E402

ABOUT = {"steps": [{"name": "facets", "stage": "look closer", "meaning": "joined"},
                   {"name": "upright", "stage": "measure", "meaning": "made upright"}]}
STEPS = ablation.steps_of(ABOUT)
FACETS, UPRIGHT = (ablation.method_of(step) for step in STEPS if step.name in ("facets", "upright"))


def line_of(method, recipe, seed=300, **given):
    told = {name: getattr(recipe, name) for name in recipe._fields if name != "angle"}
    return dict(kept(method, repeat=ablation.REPEAT, seed=seed, **given), angle=recipe.angle, **told)


def made(lines, clouds=2):
    results = summary.results_of(lines, 300, ablation.experiments(STEPS, clouds))
    return {table.key: table for table in ablation.tables_of(results, STEPS)}


def row_of(table, name):
    headings = tables.headings(table)
    return next(dict(zip(headings, cells)) for label, cells in table.rows if cells and name in label)


def found(correct, confidence=0.9):
    return {"all": counts(truths=10, found=10, typed_correct=correct),
            "detections": [{"kind": "sphere", "verdict": "right", "confidence": confidence}]}


def test_steps_are_those_that_the_program_tells_of_and_parameters():
    assert [step.name for step in STEPS] == ["closer_samples", "improve_normals", "facets", "upright"]
    assert FACETS == "no-facets=preset:default,without:facets"
    assert ablation.method_of(STEPS[0]) == "no-closer_samples=preset:default,closer_samples=0"


def test_every_method_is_measured_on_every_cloud_and_those_that_are_timed_several_times():
    for experiment in ablation.experiments(STEPS, 20):
        assert len(set(experiment.seeds.values())) == 1 and len(experiment.seeds) == len(STEPS) + 1
    again = [e.recipe.set for e in ablation.experiments(STEPS, 20) if e.repeat == ablation.MORE_REPEATS[-1]]
    assert "tabletop" in again and "paper-mixed" in again and "household" not in again
    only = ablation.experiments(STEPS, 20, ["cut out"])
    assert [e.recipe for e in only] == [Recipe("objects")] and only[0].seeds[ablation.WHOLE] == 60


def test_more_with_a_step_is_what_it_brings():
    recipe = Recipe("tabletop")
    row = row_of(made([line_of(ablation.WHOLE, recipe, **found(9)), line_of(FACETS, recipe, **found(7)),
                       line_of(UPRIGHT, recipe, **found(10))])["found"], "facets")
    assert row["tables P"].value == 20 and row["tables R"].value == 20
    row = row_of(made([line_of(ablation.WHOLE, recipe, **found(9)), line_of(UPRIGHT, recipe, **found(10))])["found"],
                 "upright")
    assert row["tables P"].value == -10


def test_fewer_false_ones_and_smaller_errors_are_better():
    clutter, table = Recipe("clutter"), Recipe("tabletop")
    lines = [line_of(ablation.WHOLE, clutter, false_curved=1), line_of(FACETS, clutter, false_curved=3, **found(0))]
    assert row_of(made(lines)["found"], "facets")["clutter false curved"].value == 2
    errors = {"plane": {}, "sphere": {"radius": [0.001]}, "cylinder": {}, "cone": {}}
    more = dict(errors, sphere={"radius": [0.003]})
    lines = [line_of(ablation.WHOLE, table, errors=errors), line_of(UPRIGHT, table, errors=more)]
    assert abs(row_of(made(lines)["measured"], "upright")["tables radius mm"].value - 2.0) < 1e-9


def test_a_covariance_is_better_where_it_is_nearer_to_right():
    def judged(value):
        return [{"kind": "sphere", "verdict": "right", "confidence": 0.9, "nees": {"total": [value, 4]}}]
    table = Recipe("tabletop")
    lines = [line_of(ablation.WHOLE, table, detections=judged(3.2)), line_of(UPRIGHT, table, detections=judged(6.0))]
    assert abs(row_of(made(lines)["measured"], "all steps")["tables NEES"].value - 0.8) < 1e-9
    assert abs(row_of(made(lines)["measured"], "upright")["tables NEES"].value - 0.3) < 1e-9


def test_nothing_is_said_where_all_detections_are_the_same():
    recipe = Recipe("tabletop")
    same = row_of(made([line_of(ablation.WHOLE, recipe, **found(9)), line_of(UPRIGHT, recipe, **found(9))])["found"],
                  "upright")
    assert same["tables P"].value is None
    other = row_of(made([line_of(ablation.WHOLE, recipe, **found(9)),
                         line_of(UPRIGHT, recipe, **found(9, confidence=0.8))])["found"], "upright")
    assert other["tables P"].value == 0, "it does something, but neither finds more nor less"


def test_the_cost_is_the_middle_of_what_the_same_clouds_take_longer():
    recipe = Recipe("tabletop")
    lines = [line_of(method, recipe, seed=300 + i, total_ms=ms, **found(9, confidence=confidence))
             for method, confidence, times in ((ablation.WHOLE, 0.9, (10, 20, 30)), (UPRIGHT, 0.8, (9, 18, 5)))
             for i, ms in enumerate(times)]
    row = row_of(made(lines)["found"], "upright")
    assert row["ms tables"].value == 2 and row_of(made(lines)["found"], "all steps")["ms tables"].value == 20
    quicker = dict(line_of(UPRIGHT, recipe, seed=301, total_ms=10, **found(1)), repeat=ablation.MORE_REPEATS[0])
    row = row_of(made(lines + [quicker])["found"], "upright")
    assert row["ms tables"].value == 10, "the shortest of all runs counts"
    assert row["tables P"].value == 0, "but what is found is told of the first alone"
    same = [line_of(FACETS, recipe, seed=300 + i, total_ms=ms, **found(9)) for i, ms in enumerate((12, 22, 32))]
    row = row_of(made(lines + same)["found"], "upright")
    assert row["ms tables"].value == 3, "what a step does not change takes as long as all of them, and steadies it"


def test_recorded_frames_are_told_over_all_draws():
    def figures(found, false, planes):
        return {"frames": 2, "recall": {"all": {"found": found, "labels": 10}}, "false_curved_per_frame": false,
                "other_planes_per_frame": planes,
                "false_on_negative_frames": {}, "radius_error_mm": {"absolute": None}, "total_ms": None}
    asked = []

    def score(options):
        asked.append(options)
        return [figures(8, 0.5, 3), figures(9, 0.5, 2)] if "upright" in options else [figures(10, 0.0, 1.5)] * 2
    table = ablation.frames_table(ablation.frame_figures(STEPS, score), STEPS)
    row = row_of(table, "upright")
    assert row["R"].value == 15 and row["false curved"].value == 0.5 and row["other planes"].value == 1
    assert row_of(table, "all steps")["R"].value == 100 and row_of(table, "facets")["R"].value == 0
    assert asked == [[], ["--closer_samples", "0"], ["--improve_normals", "false"], ["--without", "facets"],
                     ["--without", "upright"]]


def test_frames_without_any_result_say_nothing():
    nothing = {"frames": 0, "recall": {"all": {"found": 0, "labels": 0}}, "false_curved_per_frame": None,
               "other_planes_per_frame": None}
    table = ablation.frames_table(ablation.frame_figures(STEPS, lambda options: [nothing]), STEPS)
    assert row_of(table, "all steps")["R"].value is None and row_of(table, "upright")["false curved"].value is None


def test_tables_tell_only_of_what_was_measured():
    clutter = [line_of(method, Recipe("clutter"), false_curved=1) for method in (ablation.WHOLE, UPRIGHT)]
    assert list(made(clutter)) == ["found"], "of clutter nothing is measured"
    assert tables.headings(made(clutter)["found"]) == ["clutter false curved"]
    assert row_of(made(clutter)["found"], "facets")["clutter false curved"].value is None, "was not measured"


def test_steps_stand_below_their_stages_in_the_order_of_a_frame():
    recipe = Recipe("tabletop")
    rows = made([line_of(method, recipe, **found(9)) for method in (ablation.WHOLE, UPRIGHT)])["found"].rows
    assert [label for label, row in rows if row is None] == ["segment", "look closer", "measure"]
    assert "improve_normals" in rows[2][0] and "upright" in rows[-1][0]


def test_the_command_names_steps_that_there_are_not():
    loader = SourceFileLoader("ablation_command", os.path.join(os.path.dirname(HERE), "ablation"))
    command = module_from_spec(spec_from_loader(loader.name, loader))
    loader.exec_module(command)
    assert [step.name for step in command.chosen(STEPS, ["upright"])] == ["upright"]
    assert command.chosen(STEPS, None) == STEPS
    try:
        command.chosen(STEPS, ["facet"])
        raise AssertionError("took it")
    except ValueError as error:
        assert "facet;" in str(error) and "facets" in str(error)


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
