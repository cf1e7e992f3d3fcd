# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a few clouds with what each method found, drawn by clouds.py."""
import os
import re
import shutil
import subprocess

PICTURES = (("paper-mixed", 2), ("tabletop", 2), ("parts", 1))  # data set, how many of its first seeds
METHODS = ("default", "paper", "cgal", "pcl-sac")
CAPTIONS = {"paper-mixed": "Mixed cloud of the paper's data set", "tabletop": "Simulated depth frame",
            "parts": "Mechanical part"}


def wanted(quick, first_seed):
    """(data set, seed) of each picture."""
    return [(name, first_seed + i) for name, count in PICTURES for i in range(1 if quick else count)]


def draw(program, folder, quick, first_seed, methods, note):
    """Draws the pictures that are not there yet into folder/pictures. Returns what could not be drawn, and why."""
    try:
        from report import clouds
    except ImportError as error:
        return ["No pictures of clouds: %s" % error]
    dumps, out, faults = os.path.join(folder, "dump"), os.path.join(folder, "pictures"), []
    os.makedirs(dumps, exist_ok=True)
    os.makedirs(out, exist_ok=True)
    try:
        for name, seed in wanted(quick, first_seed):
            png = os.path.join(out, "%s_%d.png" % (name, seed))
            if os.path.exists(png):
                continue
            note("picture of %s, seed %d" % (name, seed))
            unfinished = os.path.join(dumps, "unfinished.png")
            try:
                dump(program, name, seed, methods, dumps)
                clouds.draw_scene(os.path.join(dumps, "%s_%d.json" % (name, seed)), list(methods), unfinished)
                os.replace(unfinished, png)
            except (subprocess.CalledProcessError, OSError, ValueError, KeyError) as error:
                faults.append("No picture of %s, seed %d: %s" % (name, seed, getattr(error, "stderr", None) or error))
                note(faults[-1])
    finally:
        remove_dump(folder)
    return faults


def remove_dump(folder):
    """Dumps are large, and made again at once."""
    shutil.rmtree(os.path.join(folder, "dump"), ignore_errors=True)


def drawn(folder):
    """Paths of all pictures that runs have drawn into the folder."""
    out = os.path.join(folder, "pictures")
    pattern = re.compile(r"(%s)_\d+\.png" % "|".join(name for name, _ in PICTURES))
    return [os.path.join(out, name) for name in (os.listdir(out) if os.path.isdir(out) else ())
            if pattern.fullmatch(name)]


def dump(program, name, seed, methods, folder):
    """Lets the program write one cloud and what each method found."""
    command = [program, "--set", name, "--seeds", "%d:1" % seed, "--write", folder]
    for method in methods:
        command += ["--method", method]
    subprocess.run(command, check=True, capture_output=True, text=True)


def found_in(folder, quick, first_seed):
    """(path, caption) of the pictures that are there."""
    result = []
    for name, seed in wanted(quick, first_seed):
        path = os.path.join(folder, "pictures", "%s_%d.png" % (name, seed))
        if os.path.exists(path):
            result.append((path, "%s, seed %d" % (CAPTIONS[name], seed)))
    return result
