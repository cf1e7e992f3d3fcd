# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Recorded frames: what frames.py found, as a table and one HTML page with every picture."""
import os
import sys

from report import environment, page, tables
from report.kinds import KINDS
from report.tables import Table, cell


def run(folder, detect, out):
    """Scores and draws a folder of labelled frames. Returns the exit code: 1 when a file could not be used."""
    from report import frames
    summary = frames.score_and_draw(folder, detect, out)
    here = environment.describe(environment.ROOT, detect)
    table = summary_table(summary)
    tables.write_csv(table, os.path.join(out, "frames_table.csv"), tables.head_lines(here, "none, recorded"))
    path = os.path.join(out, "frames.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write(frames_page(summary, table, here))
    for fault in summary["faults"]:
        print("eval/run: %s" % fault, file=sys.stderr)
    print(tables.markdown(table))
    print(path)
    return 1 if summary["faults"] else 0


def found_text(tally):
    """"12 of 13"; nothing where there is nothing to find."""
    return "%d of %d" % (tally["found"], tally["labels"]) if tally["labels"] else None


def summary_table(summary):
    """A row for each preset."""
    rows = []
    for preset, figures in summary["presets"].items():
        radius, time = figures["radius_error_mm"]["absolute"] or {}, figures["total_ms"] or {}
        found = [found_text(figures["recall"][kind]) for kind in ("all",) + KINDS] + [found_text(figures["optional"])]
        rows.append(("primitect, " + preset, [cell(text) for text in found] + [
            cell(figures["false_curved_per_frame"], 2), cell(figures["reported_twice"], 0),
            cell(radius.get("median"), 1), cell(radius.get("p90"), 1), cell(time.get("median"), 1)]))
    return Table("frames_table", "%d recorded frames with labels" % len(summary["frames"]),
                 "Found: objects that must be found, by kind, then those that may be. False: curved shapes a frame "
                 "that are no object. Radius errors: absolute. Time: median, from cloud to shapes.",
                 [("objects found", 6), ("", 2), ("radius error mm", 2), ("", 1)],
                 ["all", "planes", "spheres", "cylinders", "cones", "optional", "false per frame", "found twice",
                  "median", "90 %", "ms"], rows)


def missed_and_false(figures):
    """What went wrong, in words."""
    parts = [("Missed", "; ".join(figures["recall"]["all"]["missed"]) or "nothing")]
    parts += [("False on " + name, ", ".join(texts)) for name, texts in figures["false_alarms"].items()]
    return page.facts(parts)


def frames_page(summary, table, here):
    chapters = [("Summary", tables.html_table(table))]
    for preset, figures in summary["presets"].items():
        pictures = "".join(page.image(path, summary["faults"], name, wide=True)
                           for name, path in summary["pictures"][preset].items() if os.path.exists(path))
        chapters.append(("Preset " + preset, missed_and_false(figures) + pictures))
    head = page.facts((("Folder", summary["folder"]), ("Date", here["date"]), ("CPU", here["cpu"]),
                       ("Commit", here["commit"])))
    warnings = "".join(page.warning(fault) for fault in summary["faults"])
    return page.page("primitect: recorded frames", head + warnings, chapters)
