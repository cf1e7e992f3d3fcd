# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the calls of a plan one after the other, alone, so that times are honest, and keeps what they answer."""
import json
import subprocess
import tempfile

from report import store
from report.plan import Recipe

GIVE_UP_AFTER = 3  # calls in a row that fail: then it is not the cloud


class Failed(Exception):
    """The program fails again and again."""


def command_of(program, call):
    """The command line of a call."""
    recipe = call.recipe
    command = [program, "--set", recipe.set, "--seeds", "%d:%d" % (call.first, call.count),
               "--sigma", repr(recipe.sigma), "--noise-scale", repr(recipe.noise_scale),
               "--outliers", repr(recipe.outliers), "--keep", repr(recipe.keep), "--max-angle-deg", repr(recipe.angle),
               "--repeat", str(call.repeat)]
    if recipe.uneven != 1.0:
        command += ["--uneven", repr(recipe.uneven)]
    if recipe.noise_grain != 1:
        command += ["--noise-grain", str(recipe.noise_grain)]
    if recipe.sensor != "structured_light":
        command += ["--sensor", recipe.sensor]
    if recipe.blots:
        command += ["--blots", str(recipe.blots)]
    for method in call.methods:
        command += ["--method", method]
    if recipe.voxel:
        command += ["--voxel", repr(recipe.voxel)]
    if recipe.listed:
        command.append("--list")
    if recipe.shuffle:
        command.append("--shuffle")
    if recipe.robot_frame:
        command.append("--robot-frame")
    return command + ["--json", "-"]


def task_text(call):
    """"paper-mixed, seed 1000, outliers 0.3": only what is not as usual."""
    usual = Recipe(call.recipe.set)

    def said(value):
        return value if isinstance(value, str) else "%g" % value

    special = ["%s %s" % (name.replace("_", " "), said(value)) for name, value, normal in zip(
        Recipe._fields, call.recipe, usual) if value != normal]
    return ", ".join([call.recipe.set, "seed %d" % call.first] + special)


def run_call(program, call, path, environment, lines, advance):
    """Keeps every line of a call as it comes. Returns what went wrong, or an empty text."""
    expected, got = call.count * len(call.methods), 0
    with tempfile.TemporaryFile("w+") as errors:
        process = subprocess.Popen(command_of(program, call), stdout=subprocess.PIPE, stderr=errors, text=True)
        try:
            for text in process.stdout:
                line = store.stamped(json.loads(text), call, environment)
                store.append(path, line)
                lines.append(line)
                got += 1
                advance(call.seconds / expected)
            code = process.wait()
        finally:
            if process.poll() is None:
                process.kill()
                process.wait()
        errors.seek(0)
        said = errors.read().strip()[-500:]
    advance(call.seconds * (expected - got) / expected)
    if code == 0 and got == expected:
        return ""
    return "%s: exit code %d, %d of %d lines. %s" % (" ".join(command_of(program, call)), code, got, expected, said)


def run_calls(program, calls, path, environment, lines, progress):
    """Runs all calls; lines grows. Returns the faults of those that failed. Raises Failed when several in a row did."""
    faults, in_a_row = [], 0
    for call in calls:
        progress.say(task_text(call))
        try:
            fault = run_call(program, call, path, environment, lines, progress.advance)
        except ValueError as error:
            fault = "%s: %s" % (" ".join(command_of(program, call)), error)
        in_a_row = in_a_row + 1 if fault else 0
        if fault:
            faults.append(fault)
            progress.note("FAILED " + fault)
        if in_a_row >= GIVE_UP_AFTER:
            raise Failed("%d calls in a row failed, the last one: %s" % (in_a_row, fault))
    return faults
