#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""From lines to figures: sums before quotients, marks of the best, the paper's figures, the plan."""
import csv
import os
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.dirname(HERE), HERE]

from report import (contestants, figures, making, paper_tables, pictures, plan, published, store,  # noqa: E402
                    summary, tables)
from report_lines import counts, kept, line  # noqa: E402


def close(one, other):
    return abs(one - other) < 1e-9


def test_sums_come_before_quotients():
    small = line(all=counts(truths=1, found=1, correct=1, typed_correct=1, dod=3.0, typed_dod=3.0, type_right=1))
    large = line(all=counts(truths=9, found=4, correct=2, typed_correct=1, missed=6, noise=2, dod=1.0, typed_dod=0.5))
    shares = summary.scores([small, large])
    # The mean of the clouds' own shares would be 75 % precision and 61 % recall.
    assert close(shares["precision"], 60) and close(shares["recall"], 30)
    assert close(shares["typed_precision"], 40) and close(shares["typed_recall"], 20)
    assert close(shares["typed_f1"], 2 * 40 * 20 / 60) and close(shares["missed"], 60) and close(shares["noise"], 40)
    assert close(shares["dod"], 4 / 3) and close(shares["typed_dod"], 3.5 / 2) and close(shares["type"], 10)


def test_nothing_found_is_no_precision_and_no_distance():
    shares = summary.scores([line(all=counts(truths=3, missed=3))])
    assert shares["precision"] is None and shares["dod"] is None and shares["recall"] == 0
    assert tables.shown(shares["precision"], 1) == "–"


def test_each_kind_has_its_own_counts():
    one = line(sphere=counts(truths=2, found=2, correct=2, typed_correct=1))
    assert summary.scores([one], "sphere")["typed_recall"] == 50 and summary.scores([one])["truths"] == 0


def test_times_are_medians_without_clouds_given_up():
    lines = [line(total_ms=t) for t in (1.0, 2.0, 90.0)] + [line(total_ms=5000.0, failure="too slow")]
    assert summary.median(summary.times(lines)) == 2.0
    assert summary.times([line(vote_ms=-1.0)], "vote_ms") == [] and summary.failures(lines) == 1
    assert summary.times_without_tree([line(total_ms=300.0, prepare_ms=200.0)]) == [100.0]


def test_coverage_is_the_mean_over_clouds_that_have_it():
    lines = [line(s_coverage=[0.2] * 26), line(s_coverage=[0.4] * 26), line(s_coverage=None)]
    assert close(summary.coverage_at(lines, "s_coverage", 0.01), 30)
    rising = line(p_coverage=[i / 100 for i in range(26)])
    assert close(summary.coverage_at([rising], "p_coverage", 0.01), 5)
    assert close(summary.coverage_at([rising], "p_coverage", 0.02), 10)
    assert summary.curve([line(s_coverage=None)], "s_coverage") is None


def test_the_best_is_marked_also_where_a_peer_is_best_and_when_two_print_alike():
    cells = tables.mark_best([tables.cell(90.0), tables.cell(94.96), tables.cell(None), tables.cell(94.99)], True)
    assert [c.best for c in cells] == [False, True, False, True]
    rows = tables.mark_columns([("truth handed in", [tables.cell(100.0)]), ("a", [tables.cell(1.0)]),
                                ("b", [tables.cell(2.0)])], (True,))
    assert [cells[0].best for _, cells in rows] == [False, False, True]
    assert not any(c.best for c in tables.mark_best([tables.cell(0.0), tables.cell(0.0)], True))


def test_detection_table_puts_the_papers_figure_beside_ours():
    experiment = plan.Experiment("paper", plan.Recipe("paper-mixed"), {"default": 1, "paper": 1, "cgal": 1, "b": 1}, 2)
    lines = [kept(text, seed=1000, all=counts(truths=10, found=found, correct=5))
             for text, found in (("default", 5), ("paper", 10), ("cgal", 20), ("b", 8))]
    table = paper_tables.detection(summary.results_of(lines, 1000, [experiment]))
    (label, cells), = table.rows
    assert label == "mixed (1 cloud)" and [c.value for c in cells[:4]] == [25, 62.5, 50, 100]
    assert [c.published for c in cells[:4]] == [61.0, 63.8, 74.7, None]
    assert [c.best for c in cells[:4]] == [False, False, False, True]
    assert "50.0 [74.7]" in tables.markdown(table) and '[74.7]</span>' in tables.html_table(table)
    with tempfile.NamedTemporaryFile("r") as file:
        tables.write_csv(table, file.name, "# cpu: x\n")
        text = file.read().split("\n")
    assert text[0] == "# cpu: x" and "precision (a),precision (a) (paper),precision (b)" in text[2]
    assert text[3].startswith(",mixed (1 cloud),25,61,62.5,63.8,")


def test_published_figures_are_complete():
    kinds = {"spheres", "cylinders", "cones", "mixed"}
    assert set(published.DETECTION) == kinds == set(published.DOD)
    for measures in published.DETECTION.values():
        assert set(measures) == {"precision", "recall", "missed", "noise"}
        for figures in measures.values():
            assert set(figures) == {"a", "b", "ours"} and all(0 < value < 100 for value in figures.values())
    assert all(set(figures) == {"a", "b", "c", "d", "e", "ours"} for figures in published.DOD.values())
    assert all(len(published.RUNTIME[name]) == 5 for name in ("ours", "a", "a-2048"))
    assert published.RUNTIME["SPFN"] == {"joint": 95}
    assert len(published.TRACEPARTS) == 4 and all(len(figures) == 3 for figures in published.TRACEPARTS.values())


def test_published_figures_hold_together():
    # What the paper says of its own tables.
    for kind, measures in published.DETECTION.items():
        assert max(measures["precision"], key=measures["precision"].get) == "ours", kind
        assert min(measures["missed"], key=measures["missed"].get) == "a", kind
        assert min(published.DOD[kind], key=published.DOD[kind].get) == "ours", kind
        for method in ("a", "b", "ours"):
            # Correct and missed are different objects; correct detections and noise, too. Figures are rounded.
            assert measures["recall"][method] + measures["missed"][method] <= 100.1, (kind, method)
            assert measures["precision"][method] + measures["noise"][method] <= 100.1, (kind, method)


def test_measured_seeds_were_not_used_for_development():
    for quick in (True, False):
        first = plan.FIRST_SEED["quick" if quick else "full"]
        seeds = {first + i for e in plan.experiments(quick) for count in e.seeds.values() for i in range(count)}
        seeds |= {seed for _, seed in pictures.wanted(quick, first)}
        assert max(seeds) == (104 if quick else 1099)
        assert not [seed for seed in seeds for low, high in plan.LOOKED_AT if low <= seed <= high]


def test_samples_share_no_line_with_other_parts_so_that_all_methods_run_in_one_call():
    for quick in (True, False):
        keys = {True: set(), False: set()}
        for e in plan.experiments(quick):
            keys[e.part == "samples"].update(key for m in e.seeds for key in plan.keys_of(e, 1000, m))
        assert keys[True] and not keys[True] & keys[False]


def test_rows_with_fewer_clouds_take_no_part_in_bold():
    few, many = [line(seed=1)], [line(seed=1), line(seed=2)]
    rows = [("a", tables.measured_on([tables.cell(90.0)], many)), ("b", tables.measured_on([tables.cell(80.0)], many)),
            ("c", tables.measured_on([tables.cell(99.0)], few))]
    assert [cells[0].best for _, cells in tables.mark_columns(rows, (True,))] == [True, False, False]
    table = tables.Table("t", "", "", [], [], [("section", None)] + rows)
    assert tables.seeds_of(table) == {1, 2} and tables.seeds_text({1000, 1001, 1002, 7}) == "7, 1000 to 1002"


def test_a_legend_tells_who_has_fewer_clouds():
    experiment = plan.Experiment("paper", plan.Recipe("paper-mixed"), {"default": 2, "pcl-sac": 1}, 2)
    lines = [kept(seed=1000), kept(seed=1001), kept("pcl-sac", seed=1000)]
    results, methods = summary.results_of(lines, 1000, [experiment]), ("default", "pcl-sac", "cgal-3sigma")
    labels = [figures.label_of(results, [experiment], method, methods) for method in methods]
    assert labels == ["primitect, default", "PCL SAC loop, 4096 points (1 cloud)", "CGAL Eff. RANSAC, epsilon 3 sigma"]


def test_one_kind_has_no_untyped_precision_in_the_scores():
    experiment = plan.Experiment("paper", plan.Recipe("paper-mixed"), {"default": 1}, 2)
    results = summary.results_of([kept(seed=1000, all=counts(truths=1, found=1, correct=1),
                                       sphere=counts(truths=1, found=1, correct=1))], 1000, [experiment])
    with tempfile.NamedTemporaryFile("r") as file:
        making.write_scores(results, file.name, "")
        rows = {row["kind"]: row for row in csv.DictReader(text for text in file if not text.startswith("#"))}
    assert rows["all"]["precision"] == "100" and rows["sphere"]["precision"] == rows["sphere"]["f1"] == ""
    assert rows["sphere"]["typed_precision"] == "0" and rows["sphere"]["recall"] == "100"


def test_heads_tell_of_the_kept_lines():
    told = store.origin([kept(), dict(kept(seed=2), date="2026-01-03", compiler="g")])
    assert told == {"commit": "c1", "cpu": "cpu 1", "compiler": "g", "date": "2026-01-01 to 2026-01-03"}


def test_the_plan_asks_each_question_once_and_nothing_that_is_kept():
    experiments = plan.experiments(False)
    asked = [plan.Key(call.recipe, call.first + i, method, call.repeat) for call in plan.calls(experiments, 1000, ())
             for i in range(call.count) for method in call.methods]
    wanted = {key for e in experiments for method in e.seeds for key in plan.keys_of(e, 1000, method)}
    assert len(asked) == len(set(asked)) and set(asked) == wanted
    assert plan.calls(experiments, 1000, wanted) == []
    left, = plan.calls(experiments, 1000, wanted - {asked[17]})
    one = asked[17]
    assert (left.recipe, left.first, left.count, left.methods) == (one.recipe, one.seed, 1, (one.method,))


def test_every_part_is_planned_and_every_method_has_a_name_and_a_colour():
    for quick in (True, False):
        experiments = plan.experiments(quick)
        assert {e.part for e in experiments} | {"pictures"} == set(plan.PARTS)
        for method in {method for e in experiments for method in e.seeds}:
            assert contestants.base(method) in contestants.COLOURS and contestants.title(method), method
    assert plan.experiments(True, ["noise"])[0].part == "noise" and store.key_of(kept("b", seed=7)).seed == 7


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
