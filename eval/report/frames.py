# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Recorded, labelled frames: runs `detect` on a folder of PCDs with a labels.json, scores and draws what it found.

The format of labels.json is in frame_labels.py, the rules of scoring in frame_scoring.py.
"""
import csv
import json
import os
import subprocess
import tempfile

import numpy

from report import frame_images, frame_labels, frame_pictures, frame_scoring
from report.kinds import KINDS

REPEAT = 3  # times are medians of so many runs
COLUMNS = ("preset", "frame", "item", "kind", "name", "must", "verdict", "reported", "label_radius_mm",
           "nominal_radius_mm", "radius_mm", "radius_error_mm", "total_ms")


def detect_options(settings):
    """Preset and options of the program from "preset:NAME,parameter=value,...", as compare takes it."""
    preset, options = "default", []
    for part in settings.split(","):
        name, _, value = part.partition("=")
        if part.startswith("preset:"):
            preset = part[len("preset:"):]
        elif part.startswith("without:"):
            options += ["--without", part[len("without:"):]]
        elif value:
            options += ["--" + name, value]
        else:
            raise ValueError("method setting %r: must be preset:NAME, parameter=value or without:STEP" % part)
    return preset, options


def run_detect(program, paths, preset, scratch, options=()):
    """Runs the program on all files at once; it leaves NAME.json in scratch. Returns what went wrong."""
    command = [program] + paths + ["--preset", preset, "--repeat", str(REPEAT), "--json", scratch + "/", *options]
    try:
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=60 + 20 * len(paths), errors="replace")
    except subprocess.TimeoutExpired as error:
        return ["preset %s: %s gave no answer in %d s" % (preset, program, error.timeout)]
    except OSError as error:
        raise ValueError("%s: cannot be run: %s" % (program, error)) from error
    faults = ["preset %s: %s" % (preset, line) for line in done.stderr.splitlines() if line.strip()]
    if done.returncode and not faults:
        faults = ["preset %s: %s ended with code %d" % (preset, program, done.returncode)]
    return faults


def read_report(path):
    """Detections, time (ms) and status from what the program wrote about a file. Raises ValueError naming the file."""
    try:
        with open(path, encoding="utf-8") as file:
            report = json.load(file)
        if report.get("error"):
            raise ValueError(report["error"])
        return {"detections": report["primitives"], "total_ms": report.get("timing_ms", {}).get("total"),
                "status": report.get("status", "")}
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise ValueError("%s: no result: %s" % (os.path.basename(path), error)) from error


def scored(frames, preset, scratch, faults):
    """Name, frame and scored result of all frames that have one."""
    for name, frame in frames.items():
        try:
            result = read_report(os.path.join(scratch, name + ".json"))
            result.update(frame_scoring.score_frame(frame, result["detections"]))
        except (ValueError, KeyError, TypeError) as error:
            faults.append("preset %s, frame '%s': not scored: %s" % (preset, name, error))
            continue
        yield name, frame, result


def score_preset(frames, preset, scratch, out_dir, faults):
    """Scores and draws all frames that have a result. Returns [(name, frame, result, image)]."""
    entries = []
    for name, frame, result in scored(frames, preset, scratch, faults):
        image = None
        try:
            image = frame_images.read_labelled_image(os.path.join(scratch, name + ".ply"))
        except ValueError as error:
            faults.append("preset %s, frame '%s': scored, not drawn: %s" % (preset, name, error))
        result["picture"] = os.path.join(out_dir, "frame_%s_%s.png" % (name, preset))
        frame_pictures.draw_frame(name, preset, frame, result, image, result["picture"])
        entries.append((name, frame, result, image))
    return entries


def tally(labels):
    """Of some labels: how many, how many found, and the names of the missed ones. labels: (frame, label)."""
    missed = ["%s: %s" % (name, label["name"]) for name, label in labels if label["verdict"] == "missed"]
    judged = [label for _, label in labels if label["verdict"] != "not judged"]
    return {"labels": len(judged), "found": len(judged) - len(missed), "missed": missed}


def spread(values):
    """Median, 90 % quantile and largest of some values; None without any."""
    values = numpy.array([value for value in values if value is not None], float)
    if not values.size:
        return None
    return {"count": int(values.size), "median": float(numpy.median(values)), "p90": float(numpy.quantile(values, 0.9)),
            "largest": float(values.max())}


def false_alarms(result):
    """What was reported that is not there, in words."""
    return [frame_scoring.describe(found)
            for found, verdict in zip(result["detections"], result["verdicts"]) if verdict == "false"]


def summarise(entries):
    """The figures of one preset."""
    labels = [(name, label) for name, _, result, _ in entries for label in result["labels"]]
    must = [(name, label) for name, label in labels if label["must"]]
    alarms = {name: false_alarms(result) for name, _, result, _ in entries}
    count = sum(map(len, alarms.values()))
    negative = {name: len(alarms[name]) for name, frame, _, _ in entries if frame["negative"]}
    planes = sum(found["type"] == "plane" and verdict != "right" for _, _, result, _ in entries
                 for found, verdict in zip(result["detections"], result["verdicts"]))
    errors = {kind: [label["radius_error_mm"] for _, label in labels if label["kind"] == kind
                     and label["radius_error_mm"] is not None] for kind in KINDS[1:]}
    every = sum(errors.values(), [])
    return {
        "frames": len(entries),
        "recall": {"all": tally(must), **{kind: tally([(name, label) for name, label in must if label["kind"] == kind])
                                          for kind in KINDS}},
        "optional": tally([(name, label) for name, label in labels if not label["must"]]),
        "reported_twice": sum(len(label["hits"]) > 1 for _, label in labels),
        "false_curved": count, "false_curved_per_frame": count / len(entries) if entries else None,
        "other_planes_per_frame": planes / len(entries) if entries else None,
        "false_alarms": {name: texts for name, texts in alarms.items() if texts},
        "false_on_negative_frames": negative,
        "radius_error_mm": {"absolute": spread(map(abs, every)), "mean": float(numpy.mean(every)) if every else None,
                            **{kind: spread(map(abs, values)) for kind, values in errors.items()}},
        "total_ms": spread(result["total_ms"] for _, _, result, _ in entries),
    }


def table_rows(preset, entries):
    """One row for each label, and one for each detection that fits none, by COLUMNS."""
    for name, _, result, _ in entries:
        common = {"preset": preset, "frame": name, "total_ms": result["total_ms"]}
        for label in result["labels"]:
            yield {**common, "item": "label", "reported": len(label["hits"]),
                   **{key: label[key] for key in COLUMNS if key in label}}
        for found, verdict in zip(result["detections"], result["verdicts"]):
            if verdict != "right":
                radius = {"radius_mm": 1000.0 * found["radius"]} if "radius" in found else {}
                yield {**common, "item": "detection", "kind": found["type"], "name": frame_scoring.describe(found),
                       "verdict": verdict, **radius}


def files_of(folder, frames, faults):
    """Paths of the PCDs that have labels; says what lacks its other half, and takes frames without PCD out."""
    files = sorted(name[:-4] for name in os.listdir(folder) if name.endswith(".pcd"))
    labelled_files = [name for name in files if name in frames]
    for name in sorted(set(frames) - set(files)):
        faults.append("%s: is missing, but has labels: not scored" % os.path.join(folder, name + ".pcd"))
        del frames[name]
    said = " ".join(faults)
    faults += ["%s: labels.json says nothing usable about it: not scored" % os.path.join(folder, name + ".pcd")
               for name in files if name not in frames and "frame '%s'" % name not in said]
    return [os.path.join(folder, name + ".pcd") for name in labelled_files]


def write_tables(out_dir, rows, summary):
    """frames.csv and frames_summary.json."""
    with open(os.path.join(out_dir, "frames.csv"), "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows({key: round(value, 3) if isinstance(value, float) else value for key, value in row.items()}
                         for row in rows)
    with open(os.path.join(out_dir, "frames_summary.json"), "w", encoding="utf-8") as file:
        json.dump(summary, file, indent=1, ensure_ascii=False)


def labelled_files(folder, faults):
    """Labels by frame, and paths of the PCDs that have some. Raises ValueError when there are none."""
    frames, said = frame_labels.read_labels(folder)
    paths = files_of(folder, frames, said)
    faults += said
    if not paths:
        raise ValueError("%s: no PCD with usable labels. %s" % (folder, " | ".join(said)))
    return frames, paths


def score(frames, paths, detect_program, preset, options, faults):
    """The figures of frames and files of labelled_files(), as summarise() gives them; faults grows."""
    with tempfile.TemporaryDirectory() as scratch:
        faults += run_detect(detect_program, paths, preset, scratch, options)
        return summarise([(*entry, None) for entry in scored(frames, preset, scratch, faults)])


def score_and_draw(folder, detect_program, out_dir, presets=("default", "paper"), options=()):
    """Scores and draws every labelled PCD of a folder with each preset. options: more of the program's arguments.

    Writes out_dir/frames.csv, frames_summary.json, frame_NAME_PRESET.png and frames_PRESET.png (all frames on one
    sheet; "contact_sheet" is the first preset's). Returns
      {"folder", "frames": names that were scored, "presets": {preset: see summarise}, "pictures": {preset: {name:
       path}}, "sheets": {preset: path}, "contact_sheet": path or None, "faults": texts, one for all that could not be
       used}.
    Raises ValueError naming file or program when there is nothing to score with.
    """
    faults = []
    frames, paths = labelled_files(folder, faults)
    os.makedirs(out_dir, exist_ok=True)
    rows, summary = [], {"folder": os.path.basename(os.path.abspath(folder)), "frames": sorted(frames), "presets": {},
                         "pictures": {}, "sheets": {}, "contact_sheet": None, "faults": faults}
    for preset in presets:
        with tempfile.TemporaryDirectory() as scratch:
            faults += run_detect(detect_program, paths, preset, scratch, ["--labels", scratch + "/", *options])
            entries = score_preset(frames, preset, scratch, out_dir, faults)
        summary["presets"][preset] = summarise(entries)
        summary["pictures"][preset] = {name: result["picture"] for name, _, result, _ in entries}
        if entries:
            summary["sheets"][preset] = os.path.join(out_dir, "frames_%s.png" % preset)
            frame_pictures.draw_sheet(preset, entries, summary["sheets"][preset])
        rows += table_rows(preset, entries)
    summary["contact_sheet"] = summary["sheets"].get(presets[0]) if presets else None
    write_tables(out_dir, rows, summary)
    return summary
