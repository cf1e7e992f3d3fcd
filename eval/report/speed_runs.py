# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmark programs. Whatever becomes a ratio is measured in one run, with repetitions in mixed order."""
import json
import os
import re
import subprocess
import tempfile
from collections import namedtuple

KERNELS = ("scalar", "portable", "avx2", "avx512")
SUFFIX = "/manual_time"  # Google Benchmark appends it to the names

# seconds, curve_seconds: measured in each repetition of a case; inputs: different clouds of a case;
# largest: points of a cloud; rounds: of every kernel; repeats: of a recorded frame; peers: who else runs;
# cases, memory: patterns of what is measured
Effort = namedtuple("Effort", "seconds curve_seconds repetitions inputs largest rounds repeats peers cases memory")
FULL = Effort(1.0, 0.3, 5, 8, 10000000, 5, 60, ("cgal", "pcl-sac"), r".*", r"(detect|frame)/.*|(points|pixels)/10*")
QUICK = Effort(0.1, 0.05, 2, 2, 1000000, 2, 10, ("cgal",), r"detect/.*|peer/.*|vote/.*|frame/.*|points/1.*|pixels/10*|"
               r"samples/(1280|5120)|objects/(1|8|24)", r"detect/(tabletop-640|paper)/default|frame/tabletop-640/16")
SMOKE = Effort(0.001, 0.001, 1, 1, 100000, 1, 2, (), r"detect/(wall|clutter)-640/.*|vote/paper|frame/wall-640/16|"
               r"points/10000|pixels/10000|samples/1280|objects/1", r"detect/wall-640/default")


class Failed(Exception):
    """A program did not do what it should."""


def run(command, environment=None):
    """Standard output; raises Failed with what the program said."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          env=dict(os.environ, **(environment or {})))
    if done.returncode != 0:
        raise Failed("%s: exit code %d. %s" % (" ".join(command), done.returncode, done.stderr.strip()[-500:]))
    return done.stdout


def cases_of(program):
    """Names of all cases that a program has."""
    names = run([program, "--benchmark_list_tests=true"]).split()
    return [name[:-len(SUFFIX)] if name.endswith(SUFFIX) else name for name in names]


def chosen(cases, effort):
    """The cases that this effort measures."""
    def wanted(case):
        group, place = case.split("/")[:2]
        if group == "peer" and place not in effort.peers:
            return False
        return bool(re.fullmatch(effort.cases, case)) and not (
            group in ("points", "pixels") and int(place) > effort.largest)
    return [case for case in cases if wanted(case)]


def times_of(program, cases, effort, seconds, environment=None):
    """The program's times of these cases, {case: {...}}, measured in one run. Raises Failed when one is missing."""
    if not cases:
        return {}
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "times.json")
        pattern = "^(%s)%s$" % ("|".join(map(re.escape, cases)), SUFFIX)
        said = run([program, "--benchmark_filter=" + pattern.replace("\\-", "-"), "--benchmark_min_time=%g" % seconds,
                    "--benchmark_repetitions=%d" % effort.repetitions, "--benchmark_enable_random_interleaving=true",
                    "--inputs", str(effort.inputs), "--times", path], environment)
        with open(path, encoding="utf-8") as file:
            times = json.load(file)
    missing = [case for case in cases if not times.get(case, {}).get("cpu_ms")]
    if missing:
        errors = [line for line in said.splitlines() if "ERROR" in line]
        raise Failed("%s measured nothing of %s. %s" % (program, ", ".join(missing), " ".join(errors[:3])))
    return times


def parse_kernels(text):
    """Names of the voting kernels that can run here, of what `detect --kernels` prints: those in its line "available:".
    """
    lines = [line for line in text.splitlines() if line.startswith("available:")]
    return lines[0].split()[1:] if lines else []


def accepts(program, kernel):
    """Whether the benchmark program runs with this value of PRIMITECT_KERNELS."""
    try:
        return bool(times_of(program, ["objects/1"], SMOKE, 0.001, {"PRIMITECT_KERNELS": kernel}))
    except Failed:
        return False


def kernels_here(detect, program):
    """Kernels that can be chosen by PRIMITECT_KERNELS: as `detect --kernels` tells, or by trying where it does not;
    ["scalar"] where there is no such choice."""
    try:
        told = parse_kernels(run([detect, "--kernels"]))
    except (Failed, OSError):
        told = []
    if told:
        return told
    if accepts(program, "no-such-kernel"):
        return ["scalar"]
    return [kernel for kernel in KERNELS if accepts(program, kernel)]


def voting_times(program, kernels, effort, note):
    """{kernel: [ms]} of voting alone. The kernel is chosen at start: a process each, in turns."""
    times = {kernel: [] for kernel in kernels}
    for number in range(effort.rounds):
        note("voting, round %d of %d: %s" % (number + 1, effort.rounds, ", ".join(kernels)))
        for k in range(len(kernels)):
            kernel = kernels[(k + number) % len(kernels)]
            case = times_of(program, ["vote/paper"], effort._replace(repetitions=1), 0.3 * effort.seconds,
                            {"PRIMITECT_KERNELS": kernel})
            times[kernel] += case["vote/paper"]["cpu_ms"]
    return times


def memory_cases(cases, effort):
    """The cases whose memory is measured."""
    groups = ("detect", "frame", "points", "pixels")
    return [case for case in cases if case.split("/")[0] in groups and re.fullmatch(effort.memory, case)]


def memory_of(program, case, effort):
    """{"input_kb", "peak_kb", ...} of a case in a process of its own."""
    return json.loads(run([program, "--memory", case, "--inputs", str(effort.inputs)]))


def recorded_frames(folder):
    """Paths of all PCDs in a folder. Raises Failed without any."""
    if not os.path.isdir(folder):
        raise Failed("%s: no folder" % folder)
    names = sorted(name for name in os.listdir(folder) if name.lower().endswith(".pcd"))
    if not names:
        raise Failed("%s: no PCD in it" % folder)
    return [os.path.join(folder, name) for name in names]


def recorded_times(detect, paths, effort):
    """{file: {"points", "primitives", "median_ms", "worst_ms", "stages_ms"}} of PCDs, cloud in memory to primitives, by
    the clock."""
    recorded = {}
    with tempfile.TemporaryDirectory() as results:
        report = os.path.join(results, "found.json")
        for path in paths:
            run([detect, path, "--repeat", str(effort.repeats), "--json", report])
            with open(report, encoding="utf-8") as file:
                found = json.load(file)
            stages = {stage: time for stage, time in found["timing_ms"].items() if stage not in ("read", "total")}
            recorded[os.path.basename(path)] = {
                "points": found["points_used"], "primitives": len(found["primitives"]),
                "median_ms": found["timing_ms"]["total"], "worst_ms": found["timing_max_ms"]["total"],
                "stages_ms": stages}
    return recorded
