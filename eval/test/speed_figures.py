#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""eval/speed, eval/latency and eval/profile: medians, percentiles, ratios, drops, verdicts and shares, on times and
stacks made up for it."""
import os
import sys
import tempfile

sys.dont_write_bytecode = True
EVAL = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, EVAL)

from report import latency, profile, ros_session, speed, speed_page, speed_plots, speed_runs, tables  # noqa: E402


def case(times, stages=None, **facts):
    """A case as a benchmark program writes it."""
    return {"cpu_ms": times, "wall_ms": [2 * t for t in times], "stages_ms": stages or {}, "facts": facts,
            "allocations": [0] * len(times)}


def figures(**times):
    """Figures of cases with one frame each; "__" in a name stands for "/", "_" for "-"."""
    return {name.replace("__", "/").replace("_", "-"): speed.figures_of(case([ms])) for name, ms in times.items()}


def verdicts(of_figures, kernels=None):
    return {target.text: speed.verdict(target) for target in speed.targets(of_figures, kernels or {})}


def verdict_of(words, of_figures, kernels=None):
    return next(value for text, value in verdicts(of_figures, kernels).items() if words in text)


def test_percentiles_lie_between_the_nearest_ranks():
    frame = speed.figures_of(case([float(t) for t in range(101)]))
    assert (frame["median_ms"], frame["p95_ms"], frame["p99_ms"], frame["wall_ms"]) == (50.0, 95.0, 99.0, 100.0)
    assert speed.percentile([1.0, 2.0], 25) == 1.25
    assert speed.percentile([], 99) is None and speed.median([]) is None


def test_each_stage_has_the_median_of_its_own():
    told = speed.figures_of(case([5.0, 7.0, 9.0], {"vote": [1.0, 3.0, 2.0], "measure": [4.0, 1.0, 7.0]}, points=9))
    assert told["stages_ms"] == {"vote": 2.0, "measure": 4.0} and told["facts"] == {"points": 9}


def test_growth_is_judged_by_its_worst_decade():
    points = [(10, 1.0), (30, 1.0), (100, 1.5), (300, 2.5), (1000, 1.8)]
    assert speed.worst_growth(points) == 2.5
    assert speed.worst_growth(points, largest=100) == 1.5
    assert speed.worst_growth([(10, 1.0), (30, 1.0)]) is None


def test_what_grows_from_one_to_ten_million_is_looked_at_without_reading():
    grown = {"pixels/1000000": speed.figures_of(case([6.0], {"read": [2.0]})),
             "pixels/10000000": speed.figures_of(case([24.0], {"read": [20.0]}))}
    assert speed.million_growth(grown, "pixels") == 1.0
    assert speed.million_growth(grown, "points") is None
    assert verdict_of("10M against 1M pixels", grown) == speed.REACHED


def test_kernels_are_compared_with_scalar():
    kernels = {"scalar": [80.0, 90.0, 100.0], "portable": [45.0], "avx2": [6.0, 5.0, 100.0]}
    assert speed.kernel_speedups(kernels) == {"scalar": 1.0, "portable": 2.0, "avx2": 15.0}
    assert speed.best_speedup(kernels) == 15.0
    assert verdict_of("voting alone", {}, kernels) == speed.REACHED
    assert speed.best_speedup({"scalar": [80.0]}) is None and speed.best_speedup({"avx2": [6.0]}) is None


def test_targets_are_reached_at_their_bound_and_unknown_without_figures():
    assert set(verdicts({}).values()) == {speed.UNKNOWN}
    fast = figures(frame__tabletop_640__16=4.0, frame__clutter_640__16=12.1, detect__paper__default=4.0,
                   peer__cgal__paper=320.0)
    assert verdict_of("message, median", fast) == speed.REACHED
    assert verdict_of("pure clutter", fast) == speed.MISSED
    assert verdict_of("CGAL", fast) == speed.REACHED
    assert verdict_of("flat wall", fast) == speed.UNKNOWN
    goal = next(t for t in speed.targets(fast, {}) if "CGAL" in t.text)
    assert speed.stretch_verdict(goal) == speed.MISSED and speed.bound_text(goal) == ">= 80 x, stretch 120 x"
    assert speed.as_json(goal)["value"] == 80.0 and speed.as_json(goal)["reached"] == speed.REACHED


def test_a_ratio_needs_both_sides():
    assert speed.ratio(None, 1.0) is None and speed.ratio(1.0, None) is None and speed.ratio(1.0, 0.0) is None


def test_kernels_that_are_not_there_are_not_run():
    told = "available: scalar portable avx2\nin use: avx2, loops: avx512\n"
    assert speed_runs.parse_kernels(told) == ["scalar", "portable", "avx2"]
    assert speed_runs.parse_kernels("detect: unknown option") == []


def made_up(folder, name, text):
    """A program that is a shell script."""
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write("#!/bin/sh\n" + text)
    os.chmod(path, 0o755)
    return path


def test_kernels_are_asked_for_or_tried():
    measures = """while [ $# -gt 1 ]; do
      [ "$1" = --times ] && echo '{"objects/1": {"cpu_ms": [1]}}' >"$2"
      shift
    done
    """
    with tempfile.TemporaryDirectory() as folder:
        tells = made_up(folder, "tells", "echo 'available: scalar portable'")
        knows_no_option = made_up(folder, "old", "exit 2")
        refuses = "case $PRIMITECT_KERNELS in scalar|avx2) ;; *) exit 1 ;; esac\n"
        chooses = made_up(folder, "chooses", refuses + measures)
        ignores = made_up(folder, "ignores", measures)
        assert speed_runs.kernels_here(tells, ignores) == ["scalar", "portable"]
        assert speed_runs.kernels_here(knows_no_option, chooses) == ["scalar", "avx2"]
        assert speed_runs.kernels_here(knows_no_option, ignores) == ["scalar"]
        assert speed_runs.kernels_here("/nonexistent/detect", ignores) == ["scalar"]


def test_an_effort_leaves_out_large_clouds_and_slow_peers():
    cases = ["points/1000000", "points/10000000", "peer/cgal/paper", "peer/pcl-sac/paper", "detect/paper/default",
             "samples/2048"]
    assert speed_runs.chosen(cases, speed_runs.FULL) == cases
    assert speed_runs.chosen(cases, speed_runs.QUICK) == ["points/1000000", "peer/cgal/paper", "detect/paper/default"]


def test_recorded_frames_are_looked_for_before_anything_is_measured():
    with tempfile.TemporaryDirectory() as folder:
        for wrong, why in ((folder, "no PCD in it"), (os.path.join(folder, "nowhere"), "no folder")):
            try:
                speed_runs.recorded_frames(wrong)
                raise AssertionError("no failure")
            except speed_runs.Failed as error:
                assert str(error) == "%s: %s" % (wrong, why)
        for name in ("b.pcd", "a.PCD", "labels.json"):
            open(os.path.join(folder, name), "w", encoding="utf-8").close()
        assert [os.path.basename(path) for path in speed_runs.recorded_frames(folder)] == ["a.PCD", "b.pcd"]


def test_every_table_and_plot_is_made_of_what_there_is():
    some = {name: speed.figures_of(case([2.0, 3.0], {"sample": [1.0, 1.0], "vote": [1.0, 2.0]})) for name in (
        "detect/paper/default", "peer/cgal/paper", "points/10000", "points/100000")}
    result = {"figures": some, "kernels": {"scalar": [1.0]},
              "memory": {"detect/x": {"input_kb": 1024, "peak_kb": 3072}}}
    made = {table.key: table for table in speed_page.all_tables(result)}
    assert set(made) == {"detect", "peers", "kernels", "points", "memory"}
    assert "| paper/default | 1.00 | 1.50 | 2.50 |" in tables.markdown(made["detect"])
    assert "| cgal | 2.5 | 1.0 |" in tables.markdown(made["peers"])
    frame = {"points": 1200, "primitives": 3, "median_ms": 5.0, "worst_ms": 7.5, "stages_ms": {"vote": 2.0}}
    recorded = {"mug.pcd": frame, "far.pcd": {"points": 0, "primitives": 0, "median_ms": 0.0, "worst_ms": 0.0,
                                              "stages_ms": {}}}
    tabletop = dict(some, **{"detect/tabletop-640/default": some["detect/paper/default"]})
    table = speed_page.recorded_table(tabletop, recorded)
    assert [name for name, _ in table.rows] == ["mug.pcd"]
    assert "| mug.pcd | 1200 | 3 | 2.00 | 5.00 | 7.50 | 2.00 |" in tables.markdown(table)
    with tempfile.TemporaryDirectory() as folder:
        assert speed_plots.stages(some, folder) == "stages.png" and speed_plots.curves(some, folder) == "scaling.png"
        assert sorted(os.listdir(folder)) == ["scaling.png", "stages.png"]
        assert speed_plots.curves({}, folder) is None


def pair(sent, took=0.01, **answers):
    """Frames sent at these times; answers as f0=0.5: the answer to the first frame came at 0.5, after s of work."""
    return {"sent": sent, "answers": [[sent[int(k[1:])], at, took, 3, 2048] for k, at in answers.items()]}


def test_latencies_are_of_answered_frames_within_the_time():
    frames = latency.frames_of(pair([0.0, 1.0, 2.0, 3.0], f0=0.1, f1=1.2, f3=3.4), 0.5, 3.5)
    assert [stamp for stamp, _ in frames] == [1.0, 2.0, 3.0]
    assert [round(ms) for ms in latency.latencies_ms(frames)] == [200, 400]


def drops(told, sent, took=0.01, **answers):
    return latency.drops(latency.frames_of(pair(sent, took, **answers), 0, 9), told)


def test_a_frame_that_the_queue_threw_away_is_no_loss():
    # The first is worked on until 2.5: the third takes the place of the second. Of two in a row it says so once.
    assert drops([2.0], [0.0, 1.0, 2.0], f0=2.5, f2=4.0) == (1, 0)
    assert drops([2.0], [0.0, 1.0, 2.0, 2.2, 5.0], f0=2.5, f3=4.0, f4=6.0) == (2, 0)


def test_a_frame_that_no_queue_threw_away_is_lost():
    # Whether the detector was idle or busy meanwhile, and whatever the queue threw away at another time.
    for answered in (0.5, 2.5):
        assert drops([], [0.0, 1.0, 2.0], f0=answered, f2=4.0) == (0, 1)
        assert drops([0.4, 4.1], [0.0, 1.0, 2.0], f0=answered, f2=4.0) == (0, 1)


def test_what_is_thrown_away_during_the_work_on_a_frame_comes_after_it():
    # The third is worked on from 2 to 5, when the fifth takes the place of the fourth; nothing took that of the second.
    assert drops([4.0], [0.0, 1.0, 2.0, 3.0, 4.0], took=3.0, f0=0.5, f2=5.0, f4=8.0) == (1, 1)


def test_frames_before_the_first_and_after_the_last_answer_are_not_judged():
    assert drops([], [0.0, 1.0, 2.0], f1=1.5) == (0, 0)
    assert latency.drops([], []) == (0, 0)


def test_discards_are_read_from_what_nodes_say():
    said = ('\x1b[32m[DEBUG] [12.500000001] Incoming queue was full for topic "/a". Discarded oldest message (current '
            'queue size [0])\x1b[0m\n[DEBUG] [13.0] Incoming queue was full for topic "/b". Discarded\n'
            '[INFO] [14.0] Incoming\n')
    assert ros_session.discards_in(said, "/a") == [12.500000001] and ros_session.discards_in(said, "/c") == []


def test_a_scenario_adds_its_cameras_up():
    both = [pair([1.0, 2.0], f0=1.1, f1=2.1), pair([1.0, 2.0], f0=1.3, f1=2.3)]
    observed = {"origin": 100.0, "begin": 0.0, "end": 10.0, "pairs": both}
    got = latency.figures_of(observed, latency.cpu_share(100, 600, 10.0, 100), [[], []])
    assert (got["sent"], got["answered"], got["lost"], got["cpu_percent"]) == (4, 4, 0, 50.0)
    assert round(got["p50_ms"]) == 200 and round(got["busy_percent"], 6) == 0.4 and got["camera_hz"] == 0.2


def test_a_queue_counts_for_its_own_camera_by_the_clock():
    both = [pair([1.0, 2.0, 3.0], f0=2.5, f2=3.5), pair([1.0, 2.0, 3.0], f0=2.5, f2=3.5)]
    observed = {"origin": 100.0, "begin": 0.0, "end": 10.0, "pairs": both}
    got = latency.figures_of(observed, 0.0, [[103.0], []])
    assert (got["replaced"], got["lost"]) == (1, 1)


def test_four_cameras_and_memory_have_targets():
    observed = {"origin": 0.0, "begin": 0.0, "end": 1.0, "pairs": [pair([k / 30 for k in range(30)], f0=0.1)]}
    result = {"scenarios": {"four cameras, nodelets, 30 Hz": latency.figures_of(observed, 61.0, [[]])},
              "memory": {"empty_mb": 30.0, "peak_mb": 90.0}}
    assert [speed.verdict(t) for t in latency.targets(result)] == [
        speed.REACHED, speed.REACHED, speed.MISSED, speed.REACHED]
    assert {speed.verdict(t) for t in latency.targets({"scenarios": {}})} == {speed.UNKNOWN}


# As perf script prints them: two stacks of known steps, one of none, one cut off, one of the program that measures.
STACKS = """
            1 primitect::(anonymous namespace)::kernel
            2 primitect::estimateNormals
            3 primitect::Detector::detect
            4 main

            1 primitect::Labeling::findUnexplained
            2 primitect::Detector::Workspace::lookCloser
            3 primitect::Detector::detect

            1 memset
            2 primitect::Detector::detect

            1 primitect::measureSharedNoise
            2 [unknown]

            1 primitect::synthetic::estimateNormals
            2 main
"""


def test_a_profile_gives_each_stack_of_a_frame_to_one_step():
    shares = profile.shares_of(list(profile.stacks_of(STACKS)))
    named = {step.stage if step else step: share for step, share in shares.items()}
    assert named == {"normals": 0.25, "sample": 0.25, None: 0.25, "measure": 0.25}, named


def test_a_profile_of_nothing_has_no_shares():
    assert profile.shares_of(list(profile.stacks_of("\n"))) == {}


def test_a_profile_lists_steps_in_order_with_their_part_of_the_frame():
    shares = profile.shares_of(list(profile.stacks_of(STACKS)))
    rows = profile.table(shares, "a case", 8.0).rows
    assert [cells[0].value for _, cells in rows] == ["sample", "normals", "measure", ""]
    assert {cells[2].value for _, cells in rows} == {2.0} and rows[-1][0] == profile.OTHER


def test_the_functions_that_a_profile_looks_for_are_there():
    source = ""
    for folder, _, files in os.walk(os.path.join(os.path.dirname(EVAL), "src", "core")):
        for name in files:
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                source += file.read()
    for step in profile.STEPS:
        for function in step.functions:
            last = [part for part in function.split("::") if part][-1]
            assert last in source, function


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
