# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measured lines, one JSON object each, kept in a file as they come, so that a run can stop and go on."""
import json
import math
import os

from report.plan import Key, Recipe


# Older lines do not have these.
LATER = {"uneven": 1.0, "shuffle": False, "noise_grain": 1, "sensor": "structured_light", "blots": 0.0,
         "robot_frame": False, "voxel": 0.0, "listed": False}


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
    # Rounded: the program prints what it was given, but perhaps not to the last digit.
    recipe = Recipe(line["set"], *(round(line[name], 9) for name in Recipe._fields[1:-len(LATER)]),
                    *(line.get(name, usual) for name, usual in LATER.items()))
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
    check_recipe(line, call)
    return dict(line, text=texts[line["method"]], repeat=call.repeat, angle=call.recipe.angle,
                commit=environment["commit"], cpu=environment["cpu"], date=environment["date"],
                compiler=compiler_of(environment.get("about", {})), load=round(os.getloadavg()[0], 2))


def check_recipe(line, call):
    """Raises ValueError, saying what differs, when a line tells of another cloud than the call asked for."""
    if line.get("set") != call.recipe.set:
        raise ValueError("the program answered for set %r, asked was %r" % (line.get("set"), call.recipe.set))
    if line.get("seed") not in range(call.first, call.first + call.count):
        raise ValueError("the program answered for seed %r, asked were %d of them from %d on"
                         % (line.get("seed"), call.count, call.first))
    for name in ("sigma", "noise_scale", "outliers", "keep", *LATER):
        told, asked = line.get(name, LATER.get(name)), getattr(call.recipe, name)
        numbers = isinstance(told, (int, float)) and isinstance(asked, (int, float))
        if not (math.isclose(told, asked, abs_tol=1e-12) if numbers else told == asked):
            raise ValueError("the program answered for %s %r, asked was %r" % (name, told, asked))


def compiler_of(about):
    """How the program was built, as far as it tells."""
    return ", ".join(str(about[name]) for name in ("compiler", "build", "flags") if name in about)


def origin(lines):
    """Commit, CPU, compiler and dates of kept lines, for the heads of the files; "" where they do not tell."""
    found = {name: ", ".join(sorted({str(line[name]) for line in lines if line.get(name)}))
             for name in ("commit", "cpu", "compiler")}
    dates = sorted({line["date"] for line in lines if line.get("date")})
    return dict(found, date=" to ".join(dates[:1] + dates[1:][-1:]))


def append(path, line):
    """Writes one line at once, so that a stop leaves at most one half line."""
    with open(path, "ab") as file:
        file.write(json.dumps(line, separators=(",", ":")).encode() + b"\n")
