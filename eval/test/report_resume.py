#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stopping and going on: cut-off lines, other commits, failing programs, and eval/run itself with a made-up program."""
import fcntl
import json
import os
import signal
import stat
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
EVAL = os.path.dirname(HERE)
sys.path[:0] = [EVAL, HERE]

from report import measure, plan, store  # noqa: E402
from report.progress import Progress  # noqa: E402
from report_lines import kept  # noqa: E402

# Answers as compare does; fails for seeds in FAIL, is slow when told, and counts its starts.
MADE_UP = """#!/usr/bin/python3
import json, os, sys, time
sys.dont_write_bytecode = True
sys.path.insert(0, %r)
from report_lines import counts, line
if "--about" in sys.argv:
    print(json.dumps({"compiler": "none", "build": "made up", "peers": ["cgal", "cgal-2048", "pcl-planes"]}))
    sys.exit()
options = list(zip(sys.argv[1::2], sys.argv[2::2]))
value = dict(options)
if "--write" in value:
    sys.exit("draws nothing")
first, count = map(int, value["--seeds"].split(":"))
open(os.environ["STARTS"], "a").write("x")
for seed in range(first, first + count):
    if str(seed) in os.environ.get("FAIL", "").split():
        sys.exit("seed %%d is made to fail" %% seed)
    for method in [text for name, text in options if name == "--method"]:
        time.sleep(float(os.environ.get("SLOW", "0")))
        print(json.dumps(line(method.split("=")[0], seed, set=value["--set"], sigma=float(value["--sigma"]),
                              noise_scale=float(value["--noise-scale"]), outliers=float(value["--outliers"]),
                              keep=float(value["--keep"]), uneven=float(value.get("--uneven", 1)),
                              shuffle="--shuffle" in sys.argv, noise_grain=int(value.get("--noise-grain", 1)),
                              sensor=value.get("--sensor", "structured_light"), blots=float(value.get("--blots", 0)),
                              robot_frame="--robot-frame" in sys.argv, voxel=float(value.get("--voxel", 0)),
                              listed="--list" in sys.argv,
                              all=counts(truths=2, found=2, correct=1, typed_correct=1))), flush=True)
""" % HERE
COMMIT = {"commit": "c1", "cpu": "cpu 1", "date": "2026-01-01"}


def made_up_program(folder):
    path = os.path.join(folder, "compare")
    with open(path, "w", encoding="utf-8") as file:
        file.write(MADE_UP)
    os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
    os.environ.update(STARTS=os.path.join(folder, "starts"), FAIL="", SLOW="0")
    return path


def eval_run(folder, *arguments):
    command = [sys.executable, os.path.join(EVAL, "run"), "--programs", folder, "--out", os.path.join(folder, "out")]
    return subprocess.run(command + list(arguments), capture_output=True, text=True, timeout=300)


def kept_lines(folder):
    return store.load(os.path.join(folder, "out", "lines.jsonl"))


def test_a_cut_off_last_line_is_dropped_and_the_file_goes_on_whole():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "lines.jsonl")
        assert store.load(path) == []
        for seed in (1, 2):
            store.append(path, kept(seed=seed))
        with open(path, "ab") as file:
            file.write(json.dumps(kept(seed=3)).encode()[:100])
        assert [line["seed"] for line in store.load(path)] == [1, 2]
        store.append(path, kept(seed=3))
        assert [line["seed"] for line in store.load(path)] == [1, 2, 3]


def test_a_broken_line_in_the_middle_is_named():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "lines.jsonl")
        for broken in (b"{nonsense\n", b'{"set":"tabletop"}\n', b"[]\n"):
            with open(path, "wb") as file:
                file.write(json.dumps(kept()).encode() + b"\n" + broken + json.dumps(kept(seed=2)).encode() + b"\n")
            try:
                store.load(path)
                raise AssertionError("took %r" % broken)
            except ValueError as error:
                assert "lines.jsonl:2" in str(error) and "--fresh" in str(error)


def test_other_commits_and_cpus_are_not_mixed():
    store.check_same([kept(), kept(seed=2)], COMMIT)
    for other in (kept(commit="c0"), kept(cpu="cpu 2")):
        try:
            store.check_same([kept(), other], COMMIT)
            raise AssertionError("mixed")
        except store.Mixed as error:
            assert "--fresh" in str(error) and ("c0" in str(error) or "cpu 2" in str(error))


def test_a_call_asks_for_all_of_its_recipe():
    def arguments(**unusual):
        return measure.command_of("compare", plan.Call(plan.Recipe("tabletop", **unusual), 1, 1, ("default",), 1, 1.0))
    usual = arguments()
    for unusual, wanted in (({"shuffle": True}, ["--shuffle"]), ({"robot_frame": True}, ["--robot-frame"]),
                            ({"listed": True}, ["--list"]), ({"voxel": 0.005}, ["--voxel", "0.005"]),
                            ({"uneven": 3.0}, ["--uneven", "3.0"]), ({"noise_grain": 5}, ["--noise-grain", "5"]),
                            ({"sensor": "stereo"}, ["--sensor", "stereo"]), ({"blots": 0.2}, ["--blots", "0.2"])):
        assert [text for text in arguments(**unusual) if text not in usual] == wanted, unusual


def test_an_answer_to_another_question_is_refused():
    call = plan.Call(plan.Recipe("parts"), 1, 1, ("default-512=preset:default,samples=512",), 2, 1.0)
    good = store.stamped(dict(kept("default-512"), set="parts"), call, COMMIT)
    assert store.key_of(good) == plan.Key(plan.Recipe("parts"), 1, call.methods[0], 2)
    try:
        store.stamped(kept("paper"), call, COMMIT)
        raise AssertionError("took it")
    except ValueError as error:
        assert "paper" in str(error)
    for other in ({"set": "tabletop"}, {"seed": 2}, {"sigma": 0.02}, {"noise_scale": 2.0}, {"outliers": 0.1},
                  {"keep": 0.5}, {"keep": None}, {"uneven": 10.0}, {"shuffle": True}, {"noise_grain": 5},
                  {"sensor": "stereo"}, {"blots": 0.1}, {"robot_frame": True},
                  {"voxel": 0.005}, {"listed": True}):
        try:
            store.stamped(dict(kept("default-512"), **{"set": "parts", **other}), call, COMMIT)
            raise AssertionError("took %r" % other)
        except ValueError as error:
            assert next(iter(other)) in str(error)
    nearly = store.stamped(dict(kept("default-512"), set="parts", sigma=0.01 + 1e-15), call, COMMIT)
    assert store.key_of(nearly) == store.key_of(good)


def test_a_fresh_start_removes_only_what_a_run_made():
    with tempfile.TemporaryDirectory() as folder:
        made_up_program(folder)
        out = os.path.join(folder, "out")
        for name in ("notes.md", "my.csv", "typed.csv", "plots/mine.png", "plots/noise.png", "pictures/me.png"):
            os.makedirs(os.path.dirname(os.path.join(out, name)), exist_ok=True)
            with open(os.path.join(out, name), "w", encoding="utf-8") as file:
                file.write("x")
        arguments = ("--quick", "--only", "parts", "--fresh")
        assert eval_run(folder, *arguments).returncode == 0
        assert os.path.exists(os.path.join(out, "typed.csv")), "no measurements were kept: not the folder of a run"
        assert eval_run(folder, *arguments).returncode == 0
        there = {name: os.path.exists(os.path.join(out, name)) for name in (
            "notes.md", "my.csv", "plots/mine.png", "pictures/me.png", "typed.csv", "plots/noise.png", "report.html")}
        assert [name for name, is_there in there.items() if not is_there] == ["typed.csv", "plots/noise.png"], there


def test_pictures_that_fail_or_are_broken_are_told_and_the_report_is_made():
    with tempfile.TemporaryDirectory() as folder:
        made_up_program(folder)
        out = os.path.join(folder, "out")
        done = eval_run(folder, "--quick", "--only", "parts", "--only", "pictures")
        assert done.returncode == 1 and "No picture of parts, seed 100: draws nothing" in done.stderr
        assert not os.path.exists(os.path.join(out, "dump")) and os.listdir(os.path.join(out, "pictures")) == []
        with open(os.path.join(out, "pictures", "parts_100.png"), "wb") as file:
            file.write(b"\x89PNG\r\n")
        done = eval_run(folder, "--quick", "--report")
        with open(os.path.join(out, "report.html"), encoding="utf-8") as file:
            assert done.returncode == 1 and "parts_100.png cannot be read" in file.read()


def test_report_needs_lines_but_no_program_and_options_that_do_not_go_together_are_refused():
    with tempfile.TemporaryDirectory() as folder:
        assert "no measurements are kept" in eval_run(folder, "--report").stderr
        os.makedirs(os.path.join(folder, "out"))
        for method in ("truth", "default"):
            store.append(os.path.join(folder, "out", "lines.jsonl"), dict(kept(method, seed=100), set="parts"))
        assert eval_run(folder, "--quick", "--report").returncode == 0
        with open(os.path.join(folder, "out", "parts.csv"), encoding="utf-8") as file:
            assert file.readline() == "# cpu: cpu 1 date: 2026-01-01 commit: c1 seeds: 100\n"
        for wrong in (("--frames", folder, "--quick"), ("--frames", folder, "--only", "parts"),
                      ("--frames", folder, "--report"), ("--report", "--fresh")):
            assert eval_run(folder, *wrong).returncode == 2, wrong


def test_two_runs_in_one_folder_are_refused():
    with tempfile.TemporaryDirectory() as folder:
        made_up_program(folder)
        os.makedirs(os.path.join(folder, "out"))
        lock = os.open(os.path.join(folder, "out"), os.O_RDONLY)
        fcntl.flock(lock, fcntl.LOCK_EX)
        done = eval_run(folder, "--quick", "--only", "parts")
        os.close(lock)
        assert done.returncode == 1 and "another eval/run works in" in done.stderr, done.stderr
        assert kept_lines(folder) == []


def test_a_failing_call_is_told_and_the_rest_goes_on_until_it_is_hopeless():
    with tempfile.TemporaryDirectory() as folder:
        program, path, lines = made_up_program(folder), os.path.join(folder, "lines.jsonl"), []
        calls = [plan.Call(plan.Recipe("parts"), seed, 1, ("default",), 1, 1.0) for seed in range(1, 8)]
        with open(os.devnull, "w", encoding="utf-8") as quiet:
            os.environ["FAIL"] = "2 4"
            faults = measure.run_calls(program, calls, path, COMMIT, lines, Progress(7, quiet))
            assert len(faults) == 2 and "seed 2 is made to fail" in faults[0] and len(lines) == 5
            os.environ["FAIL"] = "2 3 4"
            try:
                measure.run_calls(program, calls, path, COMMIT, lines, Progress(7, quiet))
                raise AssertionError("went on")
            except measure.Failed as error:
                assert "seed 4 is made to fail" in str(error)


def test_progress_tells_what_remains():
    now = [0.0]
    with open(os.devnull, "w", encoding="utf-8") as quiet:
        progress = Progress(10.0, quiet, lambda: now[0])
        now[0] = 60.0
        progress.advance(2.5)
        assert progress.status() == (0.25, " 25 %, 1:00 elapsed, about 3:00 left")


def test_the_command_measures_once_makes_a_report_and_refuses_another_commit():
    with tempfile.TemporaryDirectory() as folder:
        made_up_program(folder)
        first = eval_run(folder, "--quick", "--only", "parts", "--only", "variants")
        assert first.returncode == 0, first.stderr
        lines, out = kept_lines(folder), os.path.join(folder, "out")
        starts = os.path.getsize(os.environ["STARTS"])
        assert {line["set"] for line in lines} >= {"parts", "paper-mixed"} and all(line["seed"] < 500 for line in lines)
        with open(os.path.join(out, "report.html"), encoding="utf-8") as file:
            text = file.read()
        assert "data:image/png;base64," in text and "THE DATA IS NOT THE SAME" in text and 'src="/' not in text
        assert "PCL SAC loop, 4096 points is not built here" in text
        with open(os.path.join(out, "parts.csv"), encoding="utf-8") as file:
            assert file.readline().startswith("# cpu: ")
        assert eval_run(folder, "--quick", "--only", "parts").returncode == 0
        assert os.path.getsize(os.environ["STARTS"]) == starts, "measured again what is kept"
        with open(os.path.join(out, "lines.jsonl"), "w", encoding="utf-8") as file:
            file.writelines(json.dumps(dict(line, commit="another")) + "\n" for line in lines)
        refused = eval_run(folder, "--quick", "--only", "parts")
        assert refused.returncode == 1 and "another" in refused.stderr and "--fresh" in refused.stderr, refused.stderr
        assert eval_run(folder, "--quick", "--report").returncode == 0
        assert eval_run(folder, "--quick", "--only", "parts", "--fresh").returncode == 0
        assert {line["set"] for line in kept_lines(folder)} == {"parts"}


def test_a_stopped_run_says_how_to_go_on_and_does():
    with tempfile.TemporaryDirectory() as folder:
        made_up_program(folder)
        os.environ["SLOW"] = "0.2"
        command = [sys.executable, os.path.join(EVAL, "run"), "--quick", "--only", "parts", "--programs", folder,
                   "--out", os.path.join(folder, "out")]
        process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True,
                                   start_new_session=True)
        path = os.path.join(folder, "out", "lines.jsonl")
        while not os.path.exists(path) and process.poll() is None:
            time.sleep(0.05)
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does it: to all of them
        said = process.communicate(timeout=60)[1]
        assert process.returncode == 130 and "goes on from there" in said and "Traceback" not in said, said
        before, os.environ["SLOW"] = len(kept_lines(folder)), "0"
        again = eval_run(folder, "--quick", "--only", "parts")
        assert again.returncode == 0 and "%d measurements kept" % before in again.stderr, again.stderr
        keys = [store.key_of(line) for line in kept_lines(folder)]
        assert len(keys) == len(set(keys)) > before


def test_what_is_not_built_is_said_with_the_command_that_builds_it():
    with tempfile.TemporaryDirectory() as folder:
        done = eval_run(folder, "--quick")
        assert done.returncode == 1 and "scripts/setup" in done.stderr and "Traceback" not in done.stderr


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
