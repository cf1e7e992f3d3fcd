# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measured lines, one JSON object each, kept in a file as they come, so that a run can stop and go on."""
import json
import os

from report.plan import Key, Recipe


class Mixed(Exception):
    """Kept lines were measured with another commit or on another machine."""


def load(path):
    """All whole lines of the file; none without file. A last line that was cut off while writing is removed from it.

    Raises ValueError naming file and line when any other line cannot be read.
    """
    if not os.path.exists(path):
        return []
    with open(path, "rb") as file:
        text = file.read()
    whole = text.rfind(b"\n") + 1
    if whole < len(text):
        with open(path, "r+b") as file:
            file.truncate(whole)
    lines = []
    for number, line in enumerate(text[:whole].split(b"\n")[:-1], 1):
        try:
            lines.append(json.loads(line))
            key_of(lines[-1])
        except (ValueError, KeyError, TypeError) as error:
            raise ValueError("%s:%d cannot be read (%s): mend it, or start again with --fresh" % (path, number, error))
    return lines


def key_of(line):
    """What makes a kept line the answer to one question."""
    recipe = Recipe(line["set"], line["sigma"], line["noise_scale"], line["outliers"], line["keep"],
                    line["angle"])
    return Key(recipe, line["seed"], line["text"], line["repeat"])


def check_same(lines, environment):
    """Raises Mixed, saying what differs, when a line comes from another commit or CPU than now."""
    for what in ("commit", "cpu"):
        kept = sorted({str(line.get(what)) for line in lines} - {environment[what]})
        if kept:
            raise Mixed("%s of the kept measurements: %s; now: %s. They are not mixed: start again with --fresh, "
                        "or keep them and measure into another folder with --out."
                        % (what, ", ".join(kept), environment[what]))


def stamped(line, call, environment):
    """A line of the program with all that its key and check_same() need. Raises ValueError when it fits no question."""
    texts = {text.split("=")[0]: text for text in call.methods}
    if line.get("method") not in texts:
        raise ValueError("the program answered for method %r, asked were %s" % (line.get("method"), sorted(texts)))
    kept = dict(line, text=texts[line["method"]], repeat=call.repeat, commit=environment["commit"],
                cpu=environment["cpu"], date=environment["date"], load=round(os.getloadavg()[0], 2))
    # The program prints what it was given, but perhaps not to the last digit.
    kept.update(call.recipe._asdict())
    return kept


def append(path, line):
    """Writes one line at once, so that a stop leaves at most one half line."""
    with open(path, "ab") as file:
        file.write(json.dumps(line, separators=(",", ":")).encode() + b"\n")
