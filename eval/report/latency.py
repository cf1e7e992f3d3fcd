# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""From stamps to figures: latencies, drops that a queue of one explains and such that it does not, CPU shares."""
from report.speed import Target, percentile
from report.tables import Table, cell

MILLISECONDS = 1000.0
PERCENT = 100.0


def frames_of(pair, begin, end):
    """[(stamp, answer or None)] of the frames sent within a time, in order. An answer is [stamp, received, ...]."""
    answers = {answer[0]: answer for answer in pair["answers"]}
    # camera_info may be lost where a cloud was not.
    stamps = sorted({stamp for stamp in list(pair["sent"]) + list(answers) if begin <= stamp <= end})
    return [(stamp, answers.get(stamp)) for stamp in stamps]


def latencies_ms(frames):
    """From publication to the primitives' arrival."""
    return [MILLISECONDS * (answer[1] - stamp) for stamp, answer in frames if answer]


def drops(frames, discards):
    """(replaced, lost): frames without answer that a queue of one threw away for a newer one, as it must, and frames
    that were lost for another reason. discards: when it said so, which it does once for all in a row: one that is lost
    among such counts as replaced. What came after the last answer is not judged, nor what came before the first."""
    replaced = lost = 0
    waiting, answered_before = [], False
    for stamp, answer in frames:
        if not answer:
            waiting.append(stamp)
            continue
        taken = answer[1] - answer[2]  # from then on others wait
        if waiting and answered_before:
            if any(waiting[0] <= moment <= taken for moment in discards):
                replaced += len(waiting)
            else:
                lost += len(waiting)
        waiting, answered_before = [], True
    return replaced, lost


def cpu_share(ticks_begin, ticks_end, seconds, ticks_per_second):
    """Percent of one core."""
    return PERCENT * (ticks_end - ticks_begin) / ticks_per_second / seconds


def figures_of(observed, cpu_percent, discards):
    """Figures of one scenario, over all cameras. discards: of each camera's queue, s since 1970."""
    begin, end = observed["begin"], observed["end"]
    frames = [frames_of(pair, begin, end) for pair in observed["pairs"]]
    times = [ms for one in frames for ms in latencies_ms(one)]
    processing = [answer[2] for one in frames for _, answer in one if answer]
    dropped = [drops(one, [moment - observed["origin"] for moment in of_queue])
               for one, of_queue in zip(frames, discards)]
    sent = sum(len(one) for one in frames)
    return {"sent": sent, "answered": len(times), "camera_hz": sent / len(frames) / (end - begin),
            "p50_ms": percentile(times, 50), "p95_ms": percentile(times, 95), "p99_ms": percentile(times, 99),
            "processing_ms": percentile([MILLISECONDS * p for p in processing], 50),
            "busy_percent": PERCENT * sum(processing) / (end - begin), "cpu_percent": cpu_percent,
            "replaced": sum(r for r, _ in dropped), "lost": sum(lo for _, lo in dropped)}


def targets(result):
    """Of the scenario "four" and of memory; values None where they were not measured."""
    four = result["scenarios"].get("four cameras, nodelets, 30 Hz", {})
    memory = result.get("memory", {})
    above = memory["peak_mb"] - memory["empty_mb"] if memory else None
    return [Target("four cameras at 30 Hz in one manager: frames lost beyond a queue of one", "", four.get("lost"),
                   most=0),
            # Less, and the cameras were the bottleneck.
            Target("four cameras at 30 Hz: what each really sent", "Hz", four.get("camera_hz"), least=29.5),
            Target("four cameras at 30 Hz: the manager's CPU, of one core", "%", four.get("cpu_percent"), most=60),
            Target("640x480: peak memory above an empty manager", "MB", above, most=64)]


def scenario_table(scenarios):
    names = ("camera_hz", "p50_ms", "p95_ms", "p99_ms", "processing_ms", "cpu_percent", "sent", "answered", "replaced",
             "lost")
    digits = (1, 1, 1, 1, 1, 0, 0, 0, 0, 0)
    rows = [(title, [cell(one[name], d) for name, d in zip(names, digits)]) for title, one in scenarios.items()]
    note = ("640x480, 16 bytes a point. Latency: from the cloud's publication to the arrival of its primitives in "
            "another process, ms. Processing: what the detector itself says, median ms. CPU: of the process with the "
            "detector, percent of one core; a nodelet's manager has the camera in it, which repeats rendered clouds "
            "and costs next to nothing. Replaced: thrown away for a newer frame by the detector's queue of one, as "
            "roscpp says, once for all in a row: one that is lost among them counts as replaced; lost: without that. "
            "Frames after the last answer, which were under way, are neither.")
    columns = ["camera Hz", "p50", "p95", "p99", "processing", "CPU %", "sent", "answered", "replaced", "lost"]
    return Table("latency", "Through a real master", note, [("", len(names))], columns, rows)


def memory_table(memory):
    empty, peak = memory["empty_mb"], memory["peak_mb"]
    rows = [(name, [cell(value, 1)]) for name, value in (
        ("empty nodelet manager", empty), ("with the detector", peak), ("difference", peak - empty))]
    return Table("latency_memory", "Peak resident memory, MB",
                 "The camera is another process, so what comes in through TCP is counted.", [("", 1)], ["peak"], rows)
