# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What every command that measures does: find the programs, keep others out of the folder, measure what is missing."""
import fcntl
import os
import sys

from report import environment, measure, plan, store
from report.environment import ROOT
from report.progress import Progress, clock_text

LINES = "lines.jsonl"
BUILT = os.path.join(ROOT, "build", "devel", "lib", "primitect")  # where programs are unless told


def count_from(text):
    """A whole number above 0, for argparse."""
    if int(text) < 1:
        raise ValueError(text)
    return int(text)


def program(folder, name):
    """Path of a built program; ends with what builds it when it is not there."""
    path = os.path.join(folder, name)
    if not os.access(path, os.X_OK):
        sys.exit("%s is not built (looked for %s). Build it with: scripts/setup" % (name, path))
    return path


def locked(folder):
    """Keeps other runs out of the folder until this one ends; the lock is on the folder itself, so no file stays."""
    lock = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(lock)
        raise ValueError("another eval/run works in %s: wait for it, or use another folder with --out" % folder)
    return lock


def measure_missing(compare, experiments, first_seed, path, lines, here):
    """Runs what is not kept yet; returns what failed."""
    calls = plan.calls(experiments, first_seed, {store.key_of(line) for line in lines})
    seconds = sum(call.seconds for call in calls)
    print("%d measurements kept, %d clouds to go, very roughly %s" % (
        len(lines), sum(call.count for call in calls), clock_text(seconds)), file=sys.stderr)
    if not calls:
        return []
    progress = Progress(seconds)
    faults = measure.run_calls(compare, calls, path, here, lines, progress)
    progress.finish()
    return ["A call failed, its clouds are missing: " + fault for fault in faults]


def warn_if_stale(built):
    """Says so when the program is older than its sources."""
    newer = environment.stale_sources(ROOT, built)
    if newer:
        print("Warning: %d sources, such as %s, are newer than %s; scripts/setup builds it anew."
              % (len(newer), newer[0], os.path.basename(built)), file=sys.stderr)
