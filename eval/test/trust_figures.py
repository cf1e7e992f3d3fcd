#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What detections say of themselves against what they are: bins, calibration error, normalised errors, their plots."""
import os
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.dirname(HERE), HERE]

from report import trust, trust_plots  # noqa: E402
from report_lines import line  # noqa: E402


def found(confidence, verdict, kind="sphere", **nees):
    entry = {"kind": kind, "verdict": verdict, "confidence": confidence}
    return dict(entry, nees=nees) if nees else entry


def close(one, other):
    return abs(one - other) < 1e-9


def test_a_bin_tells_what_it_holds():
    bins = trust.reliability([line(detections=[found(0.92, "right"), found(0.98, "wrong")]),
                              line(detections=[found(1.0, "right"), found(0.05, "wrong")])])
    assert len(bins) == 10 and bins[9].count == 3 and bins[0].count == 1 and bins[5] == trust.Bin(0, None, None)
    assert close(bins[9].right, 2 / 3) and close(bins[9].confidence, 2.9 / 3) and bins[0].right == 0


def test_what_says_nothing_is_left_out():
    silent = {"kind": "plane", "verdict": "right"}
    lines = [line(detections=[found(0.5, "no matter"), silent]), {"set": "paper-mixed"}]
    assert sum(one.count for one in trust.reliability(lines)) == 0
    assert trust.calibration_error(trust.reliability(lines)) is None


def test_what_need_not_be_found_is_right_when_its_kind_is():
    assert trust.is_right(found(0.9, "right", "cone"))
    assert not trust.is_right(dict(found(0.9, "wrong", "cone"), on="cone"))
    alike, other = (dict(found(0.9, "no matter", "cone"), on=kind) for kind in ("cone", "cylinder"))
    assert trust.is_right(alike) and not trust.is_right(other)
    assert trust.reliability([line(detections=[alike, other])])[9] == trust.Bin(2, 0.9, 0.5)


def test_calibration_error_is_weighted_by_the_counts():
    # 0.1 off in one bin with three, 0.25 off in one with one.
    lines = [line(detections=[found(0.9, "right")] * 3 + [found(0.25, "wrong")])]
    assert close(trust.calibration_error(trust.reliability(lines)), (3 * 0.1 + 0.25) / 4)


def test_calibrated_detections_have_no_calibration_error():
    lines = [line(detections=[found(0.75, "right")] * 3 + [found(0.75, "wrong")])]
    assert close(trust.calibration_error(trust.reliability(lines)), 0.0)


def test_normalised_errors_are_sums_over_sums_of_degrees():
    lines = [line(detections=[found(0.9, "right", total=[8.0, 4], radius=[1.0, 1]), found(0.9, "right", total=[1.0, 2]),
                              found(0.9, "right", "cone", total=[90.0, 6]), found(0.9, "right", total=[None, 4])])]
    value, count = trust.normalised_error(lines, "sphere", "total")
    assert close(value, 9.0 / 6.0) and count == 2
    assert trust.normalised_error(lines, "plane", "total") == (None, 0)
    table = trust.nees_table(lines)
    assert [label for label, _ in table.rows] == ["scenes", "spheres", "cones"]
    assert [cells[-1].value for _, cells in table.rows if cells] == ["no", "no"]
    fine = trust.nees_table([line(detections=[found(0.9, "right", total=[4.4, 4])])])
    assert fine.rows[1][1][-1].value == "yes"


def test_depth_frames_stand_apart():
    lines = [line(set="tabletop", detections=[found(0.9, "wrong")]), line(detections=[found(0.9, "right")])]
    groups = trust.groups(lines)
    assert sorted(groups) == ["depth frames", "scenes"]
    assert trust.calibration_error(trust.reliability(groups["scenes"])) < 0.11
    assert trust.calibration_error(trust.reliability(groups["depth frames"])) > 0.89
    assert [label for label, cells in trust.reliability_table(lines).rows if not cells] == [
        "scenes: expected calibration error 0.100", "depth frames: expected calibration error 0.900"]


def test_frames_in_a_robots_frame_stand_apart():
    lines = [line(set="tabletop", robot_frame=True, shuffle=shuffle, detections=[found(0.9, "right")])
             for shuffle in (False, True)]
    lines.append(line(set="tabletop", voxel=0.005, detections=[found(0.9, "right")]))
    assert {name: len(some) for name, some in trust.groups(lines).items()} == {"frames in a robot's frame": 2,
                                                                               "frames in voxels": 1}


def test_frames_of_noisier_cameras_stand_apart():
    cameras = ((1.0, 1), (2.0, 1), (2.0, 5))
    lines = [line(set="tabletop", noise_scale=scale, noise_grain=grain, detections=[found(0.9, "right")])
             for scale, grain in cameras]
    of_group = {name: [(one["noise_scale"], one["noise_grain"]) for one in some]
                for name, some in trust.groups(lines).items()}
    assert of_group == {"depth frames": [(1.0, 1)], "frames with more noise": [(2.0, 1)],
                        "frames with noise in grains": [(2.0, 5)]}


def test_frames_of_other_sensors_stand_apart():
    cameras = (("structured_light", 0.0), ("stereo", 0.0), ("structured_light", 0.2))
    lines = [line(set="tabletop", sensor=sensor, blots=blots, detections=[found(0.9, "right")])
             for sensor, blots in cameras]
    of_group = {name: [(one["sensor"], one["blots"]) for one in some] for name, some in trust.groups(lines).items()}
    assert of_group == {"depth frames": [("structured_light", 0.0)],
                        "frames of other sensors, and with blots": [("stereo", 0.0), ("structured_light", 0.2)]}


def test_frames_that_were_shuffled_stand_apart():
    for given, group in (({"robot_frame": True}, "shuffled frames"), ({}, "shuffled frames"),
                         ({"robot_frame": True, "shuffle": True}, "frames in a robot's frame"),
                         ({"robot_frame": True, "voxel": 0.005}, "frames in a robot's frame"),
                         ({"voxel": 0.005}, "frames in voxels"), ({"sensor": "stereo"}, trust.OTHER_SENSORS),
                         ({"sensor": "bent_structured_light"}, trust.BENT)):
        assert trust.group_of(line(set="tabletop", listed=True, **given)) == group, given
    lines = [line(set="tabletop", shuffle=shuffle, detections=[found(0.9, "right", total=[error, 4])])
             for shuffle, error in ((False, 4.0), (True, 40.0))]
    values = {name: trust.normalised_error(some, "sphere", "total") for name, some in trust.groups(lines).items()}
    assert values == {"depth frames": (1.0, 1), "shuffled frames": (10.0, 1)}


def test_titles_are_as_wide_as_their_panels():
    title = trust_plots.title_of("frames of other sensors, and with blots", 0.005)
    assert title.split("\n")[-1] == "ECE 0.005" and " ".join(title.split("\n")[:-1]).endswith("and with blots")
    assert max(map(len, title.split("\n"))) <= 18


def test_plots_are_drawn_of_what_there_is_and_of_nothing_none():
    with tempfile.TemporaryDirectory() as folder:
        nothing = [line(detections=[{"kind": "plane", "verdict": "right"}])]
        assert trust_plots.reliability(nothing, folder) is None
        assert trust_plots.normalised_errors(nothing, folder) is None and os.listdir(folder) == []
        lines = [line(set=name, detections=[found(0.1 * k, "right" if k > 4 else "wrong", kind, total=[3.0 * k, 3])
                                            for k in range(1, 10) for kind in trust.KINDS])
                 for name in ("paper-mixed", "tabletop")]
        assert trust_plots.reliability(lines, folder) == "reliability.png"
        assert trust_plots.normalised_errors(lines, folder) == "nees.png"
        assert all(os.path.getsize(os.path.join(folder, name)) > 10000 for name in ("reliability.png", "nees.png"))


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
