# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is measured: which data sets with how many seeds, by which methods, and for which table or plot.

The seeds in LOOKED_AT were used while developing. Those measured here, 100 to 104 (quick) and 1000 to 1099 (full),
were not; of the latter only the truth, without any detector, was looked at, to check the scoring.
"""
from collections import namedtuple

from report import trust

LOOKED_AT = ((1, 99), (300, 303), (500, 539), (2000, 2099), (4000, 4039))  # first and last
FIRST_SEED = {"quick": 100, "full": 1000}
PARTS = ("paper", "noise", "variants", "tabletop", "parts", "runtime", "samples", "pictures")
KINDS = ("spheres", "cylinders", "cones", "planes", "mixed")
RUNTIME_COLUMNS = ("joint", "planes", "spheres", "cylinders", "cones")  # in the paper's order
SAMPLE_COUNTS = (340, 680, 1360, 2720, 5440)
SIGMAS = (0.005, 0.01, 0.015, 0.02, 0.025)
USUAL_ANGLE = 15.0  # deg, the paper's
# From noise 0.02 on, the normals of the cloud are so bad that the usual angle hides what was found.
WIDE_ANGLE, WIDE_SIGMAS = 40.0, (0.015, 0.02, 0.025)
OUTLIERS = (0.0, 0.1, 0.2, 0.3, 0.4)
KEEPS = (1.0, 0.1, 0.01)
NOISE_SCALES = (0.5, 1.0, 2.0)
CONCAVE = ("concave-spheres", "concave-cylinders", "concave-cones", "concave-mixed")
ABLATIONS = ("b", "c", "d", "e")

# How a cloud is made, and within how many degrees a point's normal must agree with its shape when scoring.
Recipe = namedtuple("Recipe", "set sigma noise_scale outliers keep angle uneven shuffle noise_grain sensor blots "
                    "robot_frame voxel listed",
                    defaults=(0.01, 1.0, 0.0, 1.0, USUAL_ANGLE, 1.0, False, 1, "structured_light", 0.0, False, 0.0,
                              False))
# seeds: method text -> number of seeds, from FIRST_SEED on.
Experiment = namedtuple("Experiment", "part recipe seeds repeat")
Key = namedtuple("Key", "recipe seed method repeat")
# One start of the program: all methods on each of a few clouds in turn.
Call = namedtuple("Call", "recipe first count methods repeat seconds")

# s for one cloud, roughly, for the progress bar alone.
SECONDS = {"truth": 0.05, "default": 0.1, "cgal": 0.5, "cgal-2048": 0.25, "cgal-3sigma": 0.5, "pcl-sac": 3.0,
           "pcl-planes": 0.1}


def seeds_of(methods, count, **fewer):
    """count seeds for each method; fewer for some, named with _ instead of -."""
    return {method: min(count, fewer.get(method.replace("-", "_"), count)) for method in methods}


def kind_methods():
    """Joint detection and each kind alone, of ours and of Efficient RANSAC: texts by (method, column)."""
    texts = {}
    for preset in ("paper", "default"):
        texts[preset, "joint"] = preset
        for kind in KINDS[:-1]:
            off = ",".join("detect_%s=false" % other for other in KINDS[:-1] if other != kind)
            texts[preset, kind] = "%s-%s=preset:%s,%s" % (preset, kind, preset, off)
    for peer in ("cgal", "cgal-2048"):
        texts[peer, "joint"] = peer
        for kind in KINDS[:-1]:
            texts[peer, kind] = "%s:%s" % (peer, kind)
    return texts


def sample_methods():
    """Ours with several numbers of samples: texts by (preset, count). Every sample of the paper is a reference."""
    texts = {}
    for count in SAMPLE_COUNTS:
        closer = count * 17 // 5  # as many times the samples as in the preset
        texts["default", count] = "default-%d=preset:default,samples=%d,closer_samples=%d" % (count, count, closer)
        texts["paper", count] = "paper-%d=preset:paper,samples=%d,references=%d" % (count, count, count)
    return texts


def paper_experiments(quick):
    methods = ("truth", "default", "paper") + ABLATIONS + ("cgal", "cgal-3sigma", "cgal-2048", "pcl-sac")
    for kind in KINDS:
        count = 2 if quick else 75 if kind == "mixed" else 25
        seeds = seeds_of(methods, count, pcl_sac=1 if quick else 10, cgal_3sigma=25)
        yield Experiment("paper", Recipe("paper-" + kind), seeds, 2)


def noise_experiments(quick):
    methods = ("truth", "default", "paper", "cgal", "cgal-3sigma") + (() if quick else ("pcl-sac",))
    for kind in KINDS:
        for sigma in SIGMAS:
            yield Experiment("noise", Recipe("paper-" + kind, sigma),
                             seeds_of(methods, 1 if quick else 10, pcl_sac=2), 2)
    for kind in KINDS:
        for sigma in WIDE_SIGMAS:
            yield Experiment("noise", Recipe("paper-" + kind, sigma, angle=WIDE_ANGLE),
                             seeds_of(methods[:5], 1 if quick else 10), 1)


def variant_experiments(quick):
    seeds = seeds_of(("truth", "default", "paper", "cgal"), 1 if quick else 10)
    for outliers in OUTLIERS:
        yield Experiment("variants", Recipe("paper-mixed", outliers=outliers), seeds, 2)
    for keep in KEEPS[1:]:
        yield Experiment("variants", Recipe("paper-mixed", keep=keep), seeds, 2)
    for name in CONCAVE:
        yield Experiment("variants", Recipe(name), seeds, 2)


def tabletop_experiments(quick):
    methods = ("truth", "default", "paper", "cgal", "cgal-3sigma", "pcl-planes", "pcl-sac")
    for scale in NOISE_SCALES:
        if quick:
            seeds = seeds_of(methods, 3 if scale == 1.0 else 1, pcl_sac=1)
        else:
            seeds = seeds_of(methods, 100 if scale == 1.0 else 25, cgal=25, cgal_3sigma=25, pcl_sac=10)
        yield Experiment("tabletop", Recipe("tabletop", noise_scale=scale), seeds, 2)


def parts_experiments(quick):
    seeds = seeds_of(("truth", "default", "paper", "cgal", "pcl-sac"), 5 if quick else 100, pcl_sac=1 if quick else 10)
    yield Experiment("parts", Recipe("parts"), seeds, 2)


def runtime_experiments(quick):
    yield Experiment("runtime", Recipe("paper-mixed"), seeds_of(kind_methods().values(), 1 if quick else 10), 5)


def samples_experiments(quick):
    """Repeats of no other part: so no line is shared, and all methods run on a cloud in one call."""
    methods = tuple(sample_methods().values()) + ("cgal-2048", "cgal", "pcl-sac")
    for name in ("paper-mixed", "tabletop"):
        yield Experiment("samples", Recipe(name), seeds_of(methods, 1 if quick else 10), 3)


def experiments(quick, parts=PARTS):
    """All experiments of these parts, in the order of PARTS. The part "pictures" has none: see pictures.py."""
    makers = {"paper": paper_experiments, "noise": noise_experiments, "variants": variant_experiments,
              "tabletop": tabletop_experiments, "parts": parts_experiments, "runtime": runtime_experiments,
              "samples": samples_experiments}
    return [experiment for part in PARTS if part in parts and part in makers for experiment in makers[part](quick)]


def keys_of(experiment, first_seed, method):
    """The keys of one method of an experiment."""
    return [Key(experiment.recipe, first_seed + i, method, experiment.repeat)
            for i in range(experiment.seeds.get(method, 0))]


def seconds_of(recipe, methods, repeat):
    """What one cloud takes, roughly."""
    small = 0.2 if recipe.set in trust.FRAMES + ("parts", "objects") else 1.0
    each = [SECONDS["default"] if "=preset:default" in method
            else SECONDS.get(method.split("=")[0].split(":")[0], 0.2) for method in methods]
    return small + repeat * sum(each) * (0.5 if small < 1.0 else 1.0)


def calls(plan, first_seed, done, most_seconds=20.0):
    """The calls that are missing: each key of the plan once, those in done not at all.

    Clouds in a row with the same methods share a call as long as it stays short.
    """
    wanted, result = set(done), []
    for experiment in plan:
        for i in range(max(experiment.seeds.values(), default=0)):
            seed, methods = first_seed + i, []
            for method, count in experiment.seeds.items():
                key = Key(experiment.recipe, seed, method, experiment.repeat)
                if i < count and key not in wanted:
                    wanted.add(key)
                    methods.append(method)
            if methods:
                append_call(result, experiment, seed, tuple(methods), most_seconds)
    return result


def append_call(result, experiment, seed, methods, most_seconds):
    """Adds a cloud to the last call where it fits, else starts a new one."""
    seconds = seconds_of(experiment.recipe, methods, experiment.repeat)
    last = result[-1] if result else None
    if (last and (last.recipe, last.methods, last.repeat) == (experiment.recipe, methods, experiment.repeat)
            and last.first + last.count == seed and last.seconds + seconds <= most_seconds):
        result[-1] = last._replace(count=last.count + 1, seconds=last.seconds + seconds)
    else:
        result.append(Call(experiment.recipe, seed, 1, methods, experiment.repeat, seconds))
