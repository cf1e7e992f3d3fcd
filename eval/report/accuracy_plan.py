# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What eval/accuracy measures, and what each row of its table must reach."""
from collections import namedtuple

from report.plan import Experiment, KINDS as PAPER_KINDS, Recipe, WIDE_ANGLE
from report.kinds import KINDS

REPEAT = 1  # times are told, not compared
# group: "all" or a kind of shape; targets: Targets
Row = namedtuple("Row", "section title recipe group targets")
# least or most: a number; like: title of the row whose figure may be missed by `slack`; ahead: of the best peer
Target = namedtuple("Target", "measure least most like slack", defaults=(None, None, None, 0.0))
AHEAD_OF_PEERS = "ahead of peers"

PRECISION, RECALL, DOD, RADIUS, AXIS, HALF_ANGLE, FALSE_CURVED, F1 = (
    "typed_precision", "typed_recall", "typed_dod", "radius", "axis", "half_angle", "false_curved", "typed_f1")
PEERS = ("cgal", "cgal-3sigma", "pcl-sac")
PEER_CLOUDS = 10  # at most, for rows with peers: they are slow, and all are compared on the same clouds
TABLES_PER_CLOUD = 4  # so many times as many tables as clouds of other sets: each has few cylinders, cones and spheres
UNEVEN, UNEVEN_FRAMES = 10.0, 3.0  # a depth frame gets holes
MIXED, TABLES = "mixed", "tables"


def precision_and_recall(precision, recall):
    return (Target(PRECISION, least=precision), Target(RECALL, least=recall))


def like(title, slack):
    """Precision and recall as good as in another row."""
    return (Target(PRECISION, like=title, slack=slack), Target(RECALL, like=title, slack=slack))


def paper_rows():
    section = "The paper's data set, noise 0.01 m"
    for kind in PAPER_KINDS:
        most = 0.10 if kind == "cones" else 0.08
        yield Row(section, kind, Recipe("paper-" + kind), "all",
                  precision_and_recall(98.5, 98.5) + (Target(DOD, most=most),))
    yield Row(section, "mixed, 30 % outliers", Recipe("paper-mixed", outliers=0.3), "all",
              precision_and_recall(97.0, 95.0))


def noise_rows():
    section = "Mixed scenes with other noise"
    yield Row(section, "0.005 m", Recipe("paper-mixed", 0.005), "all", like(MIXED, 0.0))
    for sigma in (0.02, 0.025):
        yield Row(section, "%g m" % sigma, Recipe("paper-mixed", sigma), "all", (Target(F1, like=AHEAD_OF_PEERS),))
        yield Row(section, "%g m, normals within %g deg" % (sigma, WIDE_ANGLE),
                  Recipe("paper-mixed", sigma, angle=WIDE_ANGLE), "all", (Target(F1, like=AHEAD_OF_PEERS),))


def small_rows():
    section = "Small objects, 0.3 to 2 % of the points each"
    for title, group in [("all kinds", "all")] + [(kind + "s", kind) for kind in KINDS]:
        yield Row(section, title, Recipe("small"), group, precision_and_recall(97.0, 90.0))


def tabletop_rows():
    section = "Simulated depth frames of cluttered tables"
    yield Row(section, TABLES, Recipe("tabletop"), "all", precision_and_recall(98.0, 97.0))
    sizes = {"plane": (), "sphere": (Target(RADIUS, most=0.5),),
             "cylinder": (Target(RADIUS, most=0.5), Target(AXIS, most=0.5)),
             "cone": (Target(AXIS, most=0.5), Target(HALF_ANGLE, most=0.5))}
    for kind in KINDS:
        yield Row(section, kind + "s on tables", Recipe("tabletop"), kind, (Target(DOD, most=5.0),) + sizes[kind])
    yield Row(section, "one thing cut out of a table", Recipe("objects"), "all", precision_and_recall(98.0, 97.0))
    yield Row(section, "nothing but clutter", Recipe("clutter"), "all", (Target(FALSE_CURVED, most=0.3),))
    yield Row(section, "heaps of things in all poses", Recipe("heap"), "all", precision_and_recall(98.0, 97.0))
    yield Row(section, "halls: large things, many cut by the border", Recipe("hall"), "all", ())
    yield Row(section, "things of several parts: jars, piled cans and books", Recipe("household"), "all", ())


def variant_rows():
    section = "The same points in another order, or unevenly many"
    for title, recipe, other in (
            ("mixed, shuffled", Recipe("paper-mixed", shuffle=True), MIXED),
            ("mixed, %g times thinner at one side" % UNEVEN, Recipe("paper-mixed", uneven=UNEVEN), MIXED),
            ("mixed, both", Recipe("paper-mixed", uneven=UNEVEN, shuffle=True), MIXED),
            ("tables, shuffled", Recipe("tabletop", shuffle=True), TABLES),
            ("tables as lists in a robot's frame", Recipe("tabletop", robot_frame=True, listed=True), TABLES),
            ("tables, %g times thinner at one side" % UNEVEN_FRAMES, Recipe("tabletop", uneven=UNEVEN_FRAMES), TABLES),
            ("tables, %g times thinner at one side" % UNEVEN, Recipe("tabletop", uneven=UNEVEN), TABLES)):
        yield Row(section, title, recipe, "all", like(other, 1.0))


def list_rows():
    """What is told only: clouds as filters and other frames leave them, without rows and columns."""
    section = "Lists: averaged by a voxel grid, or in a robot's frame and nothing tells the camera's place"
    for title, recipe in (("tables, voxels of 5 mm", Recipe("tabletop", voxel=0.005)),
                          ("tables, voxels of 10 mm", Recipe("tabletop", voxel=0.01)),
                          ("nothing but clutter, voxels of 5 mm", Recipe("clutter", voxel=0.005)),
                          ("tables in a robot's frame, shuffled", Recipe("tabletop", robot_frame=True, shuffle=True)),
                          ("... with voxels of 5 mm", Recipe("tabletop", robot_frame=True, voxel=0.005)),
                          ("nothing but clutter, in a robot's frame, shuffled",
                           Recipe("clutter", robot_frame=True, shuffle=True))):
        yield Row(section, title, recipe, "all", ())


def other_camera_rows():
    """What is told only."""
    section = "Tables seen by other cameras"
    for title, recipe in (("stereo", Recipe("tabletop", sensor="stereo")),
                          ("time of flight", Recipe("tabletop", sensor="time_of_flight")),
                          ("structured light, bent", Recipe("tabletop", sensor="bent_structured_light")),
                          ("... things of several parts, bent", Recipe("household", sensor="bent_structured_light")),
                          ("a fifth of the image lost in blots", Recipe("tabletop", blots=0.2)),
                          ("nothing but clutter, stereo", Recipe("clutter", sensor="stereo")),
                          ("nothing but clutter, time of flight", Recipe("clutter", sensor="time_of_flight")),
                          ("nothing but clutter, bent", Recipe("clutter", sensor="bent_structured_light"))):
        yield Row(section, title, recipe, "all", ())
    for scale, grain in ((2.0, 1), (3.0, 1), (2.0, 5), (3.0, 5)):
        title = "noise x %g" % scale + (", in grains of %d px" % grain if grain > 1 else "")
        yield Row(section, title, Recipe("tabletop", noise_scale=scale, noise_grain=grain), "all", ())


def rows():
    """All rows in the order of the table."""
    parts = (paper_rows, noise_rows, small_rows, tabletop_rows, variant_rows, list_rows, other_camera_rows)
    return [row for make in parts for row in make()]


def sets():
    """Names of the data sets of the rows, for --only."""
    return sorted({row.recipe.set for row in rows()})


def seeded(method, seed):
    """The text of a method of ours that draws with this seed, named after both: "default-seed-2=preset:default,seed=2"
    from "default" or from "NAME=preset:PRESET,parameter=value,..."."""
    name, _, settings = method.partition("=")
    return "%s-seed-%d=%s,seed=%d" % (name, seed, settings or "preset:" + name, seed)


def wants_peers(row):
    return any(target.like == AHEAD_OF_PEERS for target in row.targets)


def experiments(methods, clouds, peers, only=None):
    """One experiment for each recipe: the truth and all methods, and those of the peers that were built where a target
    asks for them."""
    result = {}
    for row in rows():
        if only and row.recipe.set not in only:
            continue
        compared = [peer for peer in PEERS if peer in peers and wants_peers(row)]
        names = ("truth", *methods, *compared)
        of_set = clouds * TABLES_PER_CLOUD if row.recipe.set == "tabletop" else clouds
        count = min(clouds, PEER_CLOUDS) if wants_peers(row) else of_set
        result[row.recipe] = Experiment("accuracy", row.recipe, dict.fromkeys(names, count), REPEAT)
    return list(result.values())
