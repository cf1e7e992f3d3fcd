# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""On what and of what a measurement was made: CPU, commit, compiler."""
import datetime
import hashlib
import json
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# What the measured program is built from: a commit of other files leaves measurements valid.
MEASURED = ("src", "include", "cmake", "CMakeLists.txt", "eval/*.cpp", "eval/*.h", "eval/CMakeLists.txt")


def cpu_model():
    """The name of the processor, "unknown" where the system does not tell."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            names = [line.split(":", 1)[1].strip() for line in file if line.startswith(("model name", "Hardware"))]
    except OSError:
        names = []
    return "%s, %d cores" % (names[0] if names else "unknown", os.cpu_count() or 0)


def git(root, *arguments):
    """Output of a git command, or None when this is no work tree."""
    try:
        done = subprocess.run(("git", "-C", root) + arguments, capture_output=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return done.stdout


def commit_of(root):
    """The last commit that changed the measured code, with "-dirty-" and a digest of changes since, if any."""
    head = git(root, "log", "-1", "--format=%h", "--", *MEASURED)
    if head is None:
        return "unknown (no git)"
    difference = git(root, "diff", "HEAD", "--", *MEASURED) or b""
    for name in (git(root, "ls-files", "--others", "--exclude-standard", "--", *MEASURED) or b"").split(b"\n"):
        if name:
            with open(os.path.join(root, os.fsdecode(name)), "rb") as file:
                difference += name + file.read()
    name = head.decode().strip()
    return name if not difference else "%s-dirty-%s" % (name, hashlib.sha1(difference).hexdigest()[:6])


def about(program):
    """What the program tells of itself with --about (a JSON object); empty when it does not."""
    try:
        done = subprocess.run([program, "--about"], capture_output=True, timeout=60, check=True)
        told = json.loads(done.stdout)
    except (OSError, ValueError, subprocess.SubprocessError):
        return {}
    return told if isinstance(told, dict) else {}


def describe(root, program):
    """All of it, as written into the head of each file."""
    return {"cpu": cpu_model(), "commit": commit_of(root), "date": datetime.date.today().isoformat(),
            "about": about(program)}


def stale_sources(root, program):
    """Sources that are newer than the program: it may not be what the commit says."""
    built, newer = os.path.getmtime(program), []
    for folder in ("src", "include"):
        for where, _, names in os.walk(os.path.join(root, folder)):
            newer += [os.path.relpath(os.path.join(where, name), root) for name in names
                      if os.path.getmtime(os.path.join(where, name)) > built]
    return sorted(newer)
