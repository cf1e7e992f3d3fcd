# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of eval/speed."""
from report import speed
from report.tables import Table, cell

GROUPS = (("detect", "Cloud in memory to primitives, by stage",
           "Medians over all frames, ms of processor time: the work has one thread. Passed: time by the clock, the "
           "same on a machine that does nothing else. Paper: 160,801 points with normals of the paper's mixed set; 640 "
           "and 1280: simulated frames of 640x480 and 1280x720. Allocations: a frame, when all buffers have grown."),
          ("frame", "Bytes of a PointCloud2 to the filled message, by stage",
           "As the nodelet does it, without topics; 16 or 32 bytes a point. Otherwise as above."))
CURVES = (("points", "Points with normals (one scene of the paper's set, resampled)"),
          ("pixels", "Pixels of a depth frame, from the message's bytes on"),
          ("samples", "Samples a round, paper's set"), ("objects", "Objects on a table, 640x480"))


def target_table(targets):
    rows = [(t.text, [cell(speed.bound_text(t)), cell(value_text(t)),
                      cell(speed.verdict(t)), cell(speed.stretch_verdict(t))]) for t in targets]
    return Table("targets", "Targets", "Ratios are of one run; absolute times are those of this machine.",
                 [("", 4)], ["target", "measured", "reached", "stretch reached"], rows)


def value_text(target):
    """"3.87 ms", "1,240", "–"."""
    if target.value is None:
        return "–"
    return ("{:,.0f} {}" if target.value >= 1000 else "{:.3g} {}").format(target.value, target.unit).strip()


def stage_names(figures, cases):
    """All stages in the order in which they first come."""
    names = []
    for case in cases:
        names += [name for name in figures[case]["stages_ms"] if name not in names]
    return names


def stage_table(figures, group, title, note):
    cases = [case for case in figures if case.startswith(group + "/")]
    names = stage_names(figures, cases)
    rows = []
    for case in cases:
        one = figures[case]
        cells = [cell(one["stages_ms"].get(name), 2) for name in names]
        cells += [cell(one[name], 2) for name in ("median_ms", "p95_ms", "p99_ms", "wall_ms")]
        cells += [cell(one["frames"], 0), cell(one["allocations"], 0), cell(one["facts"].get("detections"), 0)]
        rows.append((case[len(group) + 1:], cells))
    columns = names + ["total", "p95", "p99", "passed", "frames", "allocations", "primitives"]
    return Table(group, title, note, [("", len(columns))], columns, rows)


def peer_table(figures):
    ours = speed.figure(figures, speed.OURS)
    times = {case.split("/")[1]: figures[case]["median_ms"] for case in figures if case.startswith("peer/")}
    rows = [(name, [cell(time, 1), cell(speed.ratio(time, ours), 1)]) for name, time in times.items()]
    if ours is not None and rows:
        rows.insert(0, ("primitect, default", [cell(ours, 1), cell(1.0, 1)]))
    return Table("peers", "Other detectors on the same clouds in the same run",
                 "160,801 points with normals; cgal: Efficient RANSAC with its defaults and its search tree; pcl-sac: "
                 "PCL's SAC models in a loop on 4096 of the points.", [("", 2)], ["ms", "times ours"], rows)


def kernel_table(kernels):
    faster = speed.kernel_speedups(kernels)
    rows = [(name, [cell(speed.median(times), 2), cell(faster.get(name), 1), cell(len(times), 0)])
            for name, times in kernels.items()]
    return Table("kernels", "Voting alone by kernel",
                 "2048 references and 2048 samples, preset paper, one cloud of the paper's mixed set, peaks included.",
                 [("", 3)], ["ms", "times scalar", "runs"], rows)


def curve_table(figures, name, title):
    columns, rows = ["total"], [(place, [cell(time, 2)]) for place, time in speed.curve(figures, name)]
    if name == "pixels":
        columns += ["without reading"]
        for place, cells in rows:
            cells.append(cell(speed.besides_reading(figures, "%s/%d" % (name, place)), 2))
    rows = [("{:,}".format(place), cells) for place, cells in rows]
    return Table(name, title, "Medians, ms.", [("", len(columns))], columns, rows)


def memory_table(memory):
    rows = [(case, [cell(one["input_kb"] / 1024, 1), cell((one["peak_kb"] - one["input_kb"]) / 1024, 1)])
            for case, one in memory.items()]
    return Table("memory", "Peak memory", "A process for each case, MB: program and input, and what detecting takes on "
                 "top of it at its peak.", [("", 2)], ["before", "at the peak above it"], rows)


def recorded_table(figures, recorded):
    """Of recorded frames; those of which no point is in range take no time that would tell anything."""
    ours = speed.figure(figures, "detect/tabletop-640/default")
    used = {name: one for name, one in recorded.items() if one["points"] > 0}
    names = list(dict.fromkeys(name for one in used.values() for name in one["stages_ms"]))
    rows = [(name, [cell(one["points"], 0), cell(one["primitives"], 0)] +
             [cell(one["stages_ms"].get(stage), 2) for stage in names] +
             [cell(one["median_ms"], 2), cell(one["worst_ms"], 2), cell(speed.ratio(one["median_ms"], ours), 2)])
            for name, one in used.items()]
    columns = ["points", "primitives"] + names + ["total", "slowest", "times tabletop"]
    return Table("recorded", "Recorded frames, cloud in memory to primitives, by stage",
                 "Medians, ms by the clock; times tabletop: detect/tabletop-640/default of the same run.",
                 [("", len(columns))], columns, rows)


def all_tables(result):
    """Those that have rows."""
    figures = result["figures"]
    tables = [stage_table(figures, *group) for group in GROUPS]
    tables += [recorded_table(figures, result.get("recorded", {}))]
    tables += [peer_table(figures), kernel_table(result["kernels"])]
    tables += [curve_table(figures, *one) for one in CURVES] + [memory_table(result["memory"])]
    return [table for table in tables if table.rows]
