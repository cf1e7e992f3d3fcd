#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""eval/accuracy: targets are judged by the figures that stand in the table, and what was measured is kept."""
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
EVAL = os.path.dirname(HERE)
sys.path[:0] = [EVAL, HERE]

from report import accuracy, accuracy_plan, frames, plan, store, summary  # noqa: E402
from report.accuracy_plan import AHEAD_OF_PEERS, DOD, F1, PRECISION, RECALL, Target  # noqa: E402
from report_lines import counts, kept  # noqa: E402
from report_resume import made_up_program  # noqa: E402

METHODS = ("default-seed-1=preset:default,seed=1", "default-seed-2=preset:default,seed=2")


def line_of(method, recipe, seed=7000, **given):
    """A kept line of this recipe."""
    told = {name: getattr(recipe, name) for name in recipe._fields if name != "angle"}
    return dict(kept(method, repeat=accuracy_plan.REPEAT, seed=seed, **given), angle=recipe.angle, **told)


def table_of(lines):
    experiments = accuracy_plan.experiments(METHODS, 2, ("cgal",))
    return accuracy.table(summary.results_of(lines, 7000, experiments), METHODS)


def row_of(lines, title):
    return {label: dict(zip(table_of(lines).columns, cells)) for label, cells in table_of(lines).rows if cells}[title]


def test_a_method_gets_its_seed_and_keeps_its_settings():
    assert accuracy_plan.seeded("default", 2) == METHODS[1]
    assert accuracy_plan.seeded("mine=preset:paper,samples=512", 3) == "mine-seed-3=preset:paper,samples=512,seed=3"
    assert frames.detect_options("preset:paper,samples=512") == ("paper", ["--samples", "512"])
    assert frames.detect_options("preset:default,without:facets") == ("default", ["--without", "facets"])
    try:
        frames.detect_options("samples")
        raise AssertionError("took it")
    except ValueError as error:
        assert "samples" in str(error)


def test_every_recipe_is_measured_once_and_peers_only_where_they_are_compared():
    rows, experiments = accuracy_plan.rows(), accuracy_plan.experiments(METHODS, 25, ("cgal", "pcl-sac"))
    assert {e.recipe for e in experiments} == {row.recipe for row in rows} and len(experiments) < len(rows)
    for experiment in experiments:
        compared = experiment.recipe.sigma >= 0.02
        assert ("cgal" in experiment.seeds) == compared and "cgal-3sigma" not in experiment.seeds
        own = 100 if experiment.recipe.set == "tabletop" else 25
        assert set(experiment.seeds.values()) == {10 if compared else own}, "all on the same clouds"
    assert {e.recipe.set for e in accuracy_plan.experiments(METHODS, 1, (), ["small"])} == {"small"}
    titles = [row.title for row in rows if row.group == "all"]
    assert len(titles) == len(set(titles)), "rows are looked up by their title"
    assert all(t.like in titles for row in rows for t in row.targets if t.like and t.like != AHEAD_OF_PEERS)


def test_seeds_of_the_algorithm_are_summed_and_the_worst_is_told():
    recipe = plan.Recipe("paper-spheres")
    row = row_of([line_of(METHODS[0], recipe, all=counts(truths=10, found=10, typed_correct=10, typed_dod=0.5)),
                  line_of(METHODS[1], recipe, all=counts(truths=10, found=10, typed_correct=8, typed_dod=0.4)),
                  line_of("truth", recipe, all=counts(truths=10, found=10, typed_correct=9))], "spheres")
    assert row["clouds"].value == 1 and row["P"].value == 90 and row["R"].value == 90
    assert row["F1, worst seed"].value == 80 and row["DOD"].value == 0.05 and row["truth R"].value == 90
    assert row["reached"].value == "no: P 90, R 90"


def test_all_targets_reached_is_yes_and_nothing_measured_is_no_row():
    recipe = plan.Recipe("paper-cones")
    lines = [line_of(METHODS[0], recipe, all=counts(truths=9, found=9, typed_correct=9, typed_dod=0.9))]
    assert row_of(lines, "cones")["reached"].value == "yes"
    assert [label for label, cells in table_of(lines).rows if cells] == ["cones"]


def test_a_variant_is_compared_with_its_own_ordered_clouds():
    perfect = counts(truths=100, found=100, typed_correct=100)
    lines = [line_of(METHODS[0], plan.Recipe("paper-mixed"), all=perfect)]
    for correct, reached in ((99, "yes"), (98, "no: P 98, R 98")):
        shuffled = line_of(METHODS[0], plan.Recipe("paper-mixed", shuffle=True),
                           all=counts(truths=100, found=100, typed_correct=correct))
        assert row_of(lines + [shuffled], "mixed, shuffled")["reached"].value == reached
        assert row_of([shuffled], "mixed, shuffled")["reached"].value == "–", "there is nothing to compare with"


def test_strong_noise_is_compared_with_the_best_peer():
    recipe = plan.Recipe("paper-mixed", 0.02)
    lines = [line_of(METHODS[0], recipe, all=counts(truths=10, found=10, typed_correct=5)),
             line_of("cgal", recipe, all=counts(truths=10, found=10, typed_correct=5))]
    row = row_of(lines, "0.02 m")
    assert row["peers F1"].value == 50 and row["reached"].value == "no: F1 50", "as good is not ahead"


def test_targets_are_judged_at_their_limits():
    figures = {PRECISION: 98.5, DOD: 0.08, F1: None}
    assert accuracy.missed(Target(PRECISION, least=98.5), figures, {}) == ""
    assert accuracy.missed(Target(DOD, most=0.08), figures, {}) == ""
    assert accuracy.missed(Target(DOD, most=0.0799), figures, {}) == "DOD 0.08"
    assert accuracy.missed(Target(F1, least=1.0), figures, {}) is None
    assert accuracy.missed(Target(PRECISION, like="mixed", slack=1.0), figures, {"mixed": {PRECISION: 99.6}})
    assert accuracy.verdict((), figures, {}) is None
    assert accuracy.verdict((Target(PRECISION, least=98), Target(F1, least=1)), figures, {}) is None


def test_medians_are_those_of_the_kinds_asked_for_in_millimetres():
    errors = {"plane": {"axis_deg": [9.0]}, "sphere": {"radius": [0.001, 0.003]},
              "cylinder": {"radius": [0.008], "axis_deg": [0.5]}, "cone": {"axis_deg": [1.5], "half_angle_deg": [0.2]}}
    line = line_of(METHODS[0], plan.Recipe("tabletop"), errors=errors, false_curved=3)
    both = accuracy.figures_of([line], "all")
    assert abs(both["radius"] - 3.0) < 1e-9 and both["axis"] == 1.0 and both["half_angle"] == 0.2
    assert both["false_curved"] == 3
    one = accuracy.figures_of([line], "plane")
    assert one["axis"] is None and one["radius"] is None and one["false_curved"] is None


def test_recorded_frames_fail_by_a_single_false_alarm_on_a_negative_one():
    figures = {"frames": 4, "recall": {"all": {"found": 100, "labels": 100}}, "false_curved_per_frame": 0.25,
               "other_planes_per_frame": 0.0,
               "false_on_negative_frames": {"board": 0}, "radius_error_mm": {"absolute": None}, "total_ms": None}
    rows = dict(accuracy.frame_rows({1: figures, 2: dict(figures, false_on_negative_frames={"board": 1})}))
    assert [rows["seed %d" % seed][-1].value for seed in (1, 2)] == ["yes", "no: 1 on negative"]
    assert rows["must labels, seeds 1, 2"][-1].value == "no: 1 on negative"
    missing = dict(figures, recall={"all": {"found": 90, "labels": 100}}, false_on_negative_frames={"board": 2})
    assert accuracy.frame_rows({1: missing})[1][1][-1].value == "no: R 90, 2 on negative"
    assert accuracy.frame_rows({}) == []


def test_recorded_frames_are_judged_over_all_seeds_and_shown_for_each():
    def figures(found, false):
        return {"frames": 4, "recall": {"all": {"found": found, "labels": 40}}, "false_curved_per_frame": false,
                "other_planes_per_frame": 0.0,
                "false_on_negative_frames": {}, "radius_error_mm": {"absolute": {"median": 0.5}}, "total_ms": None}
    rows = dict(accuracy.frame_rows({1: figures(40, 0.0), 2: figures(38, 0.5), 3: figures(40, 0.25)}))
    row = dict(zip([name for name, _ in accuracy.COLUMNS], rows["must labels, seeds 1, 2, 3"]))
    assert (row["clouds"].value, row["false curved"].value) == (12, 0.25)
    assert abs(row["R"].value - 100.0 * 118 / 120) < 1e-9
    verdicts = [cells[-1].value for cells in rows.values() if cells]
    assert verdicts == ["yes", "yes", "no: R 95, false curved 0.5", "yes"]


def eval_accuracy(folder, *arguments):
    command = [sys.executable, os.path.join(EVAL, "accuracy"), "--programs", folder, "--out",
               os.path.join(folder, "out"), "--clouds", "2"]
    return subprocess.run(command + list(arguments), capture_output=True, text=True, timeout=300)


def test_the_command_measures_once_and_leaves_a_table():
    with tempfile.TemporaryDirectory() as folder:
        made_up_program(folder)
        first = eval_accuracy(folder, "--only", "small", "--only", "paper-mixed", "--first-seed", "2000")
        assert first.returncode == 0, first.stderr
        lines = store.load(os.path.join(folder, "out", "lines.jsonl"))
        assert {line["seed"] for line in lines} == {2000, 2001} and {line["shuffle"] for line in lines} == {True, False}
        assert {line["text"] for line in lines} >= {"truth", "cgal", *METHODS, accuracy_plan.seeded("default", 3)}
        starts = os.path.getsize(os.environ["STARTS"])
        again = eval_accuracy(folder, "--only", "small", "--first-seed", "2000")
        assert again.returncode == 0 and os.path.getsize(os.environ["STARTS"]) == starts, "measured again what is kept"
        with open(os.path.join(folder, "out", "accuracy.md"), encoding="utf-8") as file:
            text = file.read()
        assert "| all kinds | 2 | 50.0 | 50.0 |" in text and "P >= 97; R >= 90 | no: P 50, R 50 |" in text, text
        assert "mixed" not in text.split("| all kinds")[0].split("|---|")[1]
        assert eval_accuracy(folder, "--report", "--first-seed", "2000").returncode == 0
        nothing = eval_accuracy(os.path.join(folder, "elsewhere"), "--report")
        assert nothing.returncode == 1 and "no measurements are kept" in nothing.stderr


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
