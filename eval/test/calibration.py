#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Logistic regression on made-up sets, which detections count as right, and the text that goes into the core."""
import os
import sys

import numpy as np

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.dirname(HERE), HERE]

from report import calibration, logistic, tables  # noqa: E402
from report_lines import line  # noqa: E402


def made_up(weights, count, seed=1):
    """Columns, and what is right with the probability that the weights give."""
    random = np.random.default_rng(seed)
    columns = np.column_stack([np.ones(count), random.normal(size=(count, len(weights) - 1))])
    right = (random.random(count) < logistic.probabilities(np.array(weights), columns)).astype(float)
    return columns, right


def evidence(right, random, own_noise=0.0):
    """Numbers that tell right from wrong, but not surely."""
    return [40.0 + 60.0 * right + 40.0 * random.random(), 0.7, 0.5 * random.random() - 0.2 * right + 0.2, 0.1, 0.1, 0.8,
            0.3, 0.1 + 0.1 * random.random(), own_noise, 0.0]


def found(kind, verdict, numbers=(50.0, 0.7, 0.1, 0.1, 0.1, 0.8, 0.3, 0.2, 0.0, 0.0), **more):
    return dict({"kind": kind, "verdict": verdict, "confidence": 0.5, "evidence": list(numbers)}, **more)


def test_a_made_up_set_gives_its_weights_back():
    truth = np.array([0.5, 1.0, -2.0, 0.0])
    columns, right = made_up(truth, 40000)
    # The standard deviation of a weight is about 2 / sqrt(count * variance) = 0.02 for the largest; four of these.
    assert np.abs(logistic.fit(columns, right, 0.0) - truth).max() < 0.08


def test_weights_do_not_depend_on_the_unit_of_a_feature():
    columns, right = made_up([0.3, 1.0, -1.0], 500)
    in_metres, in_millimetres = columns, columns * [1.0, 1000.0, 1.0]
    one, other = logistic.fit(in_metres, right, 1.0), logistic.fit(in_millimetres, right, 1.0)
    assert np.allclose(one, other * [1.0, 1000.0, 1.0], rtol=1e-6)


def test_a_weight_of_the_wrong_sign_is_left_out():
    columns, right = made_up([0.0, 1.0, -1.0], 2000)
    weights = logistic.fit(columns, right, 1.0, signs=(0, 1, 1))
    assert weights[2] == 0.0 and np.allclose(weights[:2], logistic.fit(columns[:, :2], right, 1.0))


def test_a_feature_that_is_never_there_has_no_weight():
    columns, right = made_up([0.0, 1.0, -1.0], 200)
    columns[:, 2] = 0.0
    assert logistic.fit(columns, right, 1.0, towards=np.array([0.0, 0.5, 0.5]))[2] == 0.0


def test_a_large_penalty_keeps_weights_where_they_are_wanted():
    columns, right = made_up([0.0, 1.0, -1.0], 2000)
    towards = np.array([0.0, 0.5, 0.5])
    assert np.abs(logistic.fit(columns, right, 1e9, towards=towards) - towards)[1:].max() < 1e-3


def test_weights_are_the_best_from_wherever_they_start():
    # With features far from all others whole steps of Newton's method go to and fro.
    for seed in range(5):
        source, towards = np.random.default_rng(seed), np.array([0.0, 1.0, 1.0, 1.0])
        columns = np.hstack([np.ones((200, 1)), source.standard_t(1.2, (200, 3))])
        right = (source.random(200) < logistic.probabilities(np.array([2.0, 1.0, -1.0, 0.5]), columns)).astype(float)
        weights = logistic.maximize(columns, right, 1.0, towards)
        slope = columns.T @ (right - logistic.probabilities(weights, columns)) - [0.0, *(weights - towards)[1:]]
        assert np.abs(slope).max() < 1e-4, (seed, slope)


def test_a_penalty_keeps_weights_finite_where_right_and_wrong_are_apart():
    columns = np.array([[1.0, -1.0], [1.0, 1.0]] * 10)
    weights = logistic.fit(columns, columns[:, 1].clip(0.0), 1.0)
    assert np.isfinite(weights).all() and 1.0 < weights[1] < 5.0


def test_measures_of_known_answers():
    right, sure = np.array([1.0, 1.0, 0.0, 0.0]), np.array([0.9, 0.6, 0.6, 0.1])
    # Of four pairs three are in order and one is even.
    assert logistic.area_under_curve(sure, right) == 3.5 / 4
    assert logistic.area_under_curve(sure, np.ones(4)) is None
    assert abs(logistic.log_loss(np.full(4, 0.5), right) - np.log(2.0)) < 1e-12
    # One right at 0.9, one wrong at 0.1, and of two at 0.6 one is right.
    assert abs(logistic.calibration_error(sure, right) - (0.1 + 0.1 + 0.2) / 4) < 1e-12


def test_only_detections_that_say_something_are_cases():
    silent = {"kind": "plane", "verdict": "right"}
    cases = calibration.cases_of([line(detections=[found("cone", "right"), silent, found("plane", "no matter")])])
    assert len(cases.right) == 1 and cases.numbers.shape == (1, len(calibration.EVIDENCE))


def test_weights_of_every_kind_become_rows_of_the_core():
    random = np.random.default_rng(2)
    detections = [found(kind, "right" if right else "wrong", evidence(right, random, own_noise))
                  for kind in calibration.KINDS for own_noise in (0.0, 1.0) for right in (0, 1) * 50]
    cases = calibration.cases_of([line(detections=detections)])
    weights = calibration.fit(cases)
    probability = calibration.probabilities(weights, cases)
    assert all(set(of_kinds) == set(calibration.KINDS) for of_kinds in weights.values())
    assert logistic.area_under_curve(probability, cases.right) > 0.9
    text = calibration.weights_text({own: {kind: 10.0 * own + calibration.KINDS.index(kind) + np.arange(8) / 100
                                           for kind in calibration.KINDS} for own in (0, 1)})
    camera, own_noise = text.split("constexpr Weights ")[1:]
    assert camera.startswith("kOfDepthCameras = {{\n    {{0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07}},  // plane\n")
    assert own_noise.startswith("kOfOwnNoise = {{\n    {{10, 10, 10, 10, 10, 10.1, 10.1, 10.1}},  // plane\n")
    assert [row.split()[-1] for row in camera.splitlines()[1:5]] == list(calibration.KINDS)
    assert len(weights[0]["plane"]) == calibration.features(cases).shape[1] == 8
    assert "held out" in tables.markdown(calibration.quality_table({"held out": (probability, cases)}))


def test_tables_tell_whose_noise_it_is():
    # Of depth cameras three planes, of which two are right; with noise of their own two, none of them right.
    of_own = (50.0, 0.7, 0.1, 0.1, 0.1, 0.8, 0.3, 0.2, 1.0, 0.0)
    cases = calibration.cases_of([line(detections=[found("plane", "right"), found("plane", "wrong"),
                                                   found("plane", "right"), found("plane", "wrong", of_own),
                                                   found("plane", "wrong", of_own)])])
    probability = np.array([0.8, 0.6, 0.4, 0.9, 0.2])
    rows = calibration.quality_table({"some": (probability, cases)}).rows
    assert [label for label, cells in rows if not cells] == ["some, noise of depth cameras", "some, the clouds' own noise"]
    counts = [(label, cells[0].value, round(cells[1].value, 1)) for label, cells in rows if cells]
    assert counts == [("all", 3, 66.7), ("plane", 3, 66.7), ("all", 2, 0.0), ("plane", 2, 0.0)]
    thresholds = calibration.threshold_table(probability, cases).rows
    # Above 0.5: one right and one wrong, half of the right ones are kept. Where none is right nothing is said.
    assert [label for label, _ in thresholds] == ["noise of depth cameras", "all", "plane", "the clouds' own noise"]
    assert [cell.value for cell in thresholds[1][1][4:6]] == [50.0, 50.0]


def test_frames_in_a_robots_frame_are_in_the_mix():
    moved = {recipe.set for recipe, _, _ in calibration.mix() if recipe.robot_frame}
    assert moved == {"tabletop", "clutter", "household", "heap", "hall"}


def test_clouds_with_noise_of_their_own_have_weights_of_their_own():
    # There what is against a shape tells nothing, and inliers do.
    random = np.random.default_rng(3)
    detections = []
    for kind in calibration.KINDS:
        for right in (0, 1) * 500:
            detections.append(found(kind, "right" if right else "wrong", evidence(right, random)))
            numbers = evidence(right, random, own_noise=1.0)
            numbers[2] = random.random()
            detections.append(found(kind, "right" if right else "wrong", numbers))
    cases = calibration.cases_of([line(detections=detections)])
    weights = calibration.fit(cases)
    for kind in calibration.KINDS:
        assert weights[0][kind][3] < 2.0 * weights[1][kind][3] <= 0.0, (kind, weights)
    for own in (0, 1):
        some = calibration.part(cases, calibration.has_noise(cases, own))
        assert len(some.right) == len(cases.right) / 2
        alone = calibration.probabilities({own: weights[own]}, some)
        assert (alone == calibration.probabilities(weights, cases)[calibration.has_noise(cases, own)]).all()


def test_what_is_against_many_samples_counts_less_of_planes_and_balls():
    def against(kind, inliers):
        numbers = (inliers, 0.7, 0.2) + (0.1,) * 7
        return calibration.features(calibration.cases_of([line(detections=[found(kind, "right", numbers)])]))[0, 3]
    for kind in calibration.KINDS:
        assert against(kind, 40.0) == against(kind, 150.0) == 0.2
        share = against(kind, 600.0) / against(kind, 150.0)
        assert abs(share - (0.5 if kind in ("plane", "sphere") else 1.0)) < 1e-12


def expect_that_it_speaks(name, kinds):
    """A number of the evidence that is 0 or 1: where it is 1 more is right that is as sure by all else."""
    column = calibration.EVIDENCE.index(name)
    random = np.random.default_rng(4)
    told = np.repeat([0.0, 1.0], 2000)
    right = random.random(4000) < np.where(told > 0.0, 0.9, 0.6)
    detections = []
    for kind in calibration.KINDS:
        for is_right, number in zip(right[::4], told[::4]):
            numbers = evidence(is_right, random)
            numbers[column] = number if kind in kinds else 0.0
            detections.append(found(kind, "right" if is_right else "wrong", numbers))
    cases = calibration.cases_of([line(detections=detections)])
    weights = {0: calibration.fit_kinds(cases, calibration.PENALTY)}
    numbers = cases.numbers.copy()
    numbers[:, column] = 0.0
    speaks = cases.numbers[:, column] > 0.0
    with_it = calibration.probabilities(weights, cases)
    without = calibration.probabilities(weights, cases._replace(numbers=numbers))
    assert (with_it > without)[speaks].all()
    assert np.allclose(with_it[~speaks], without[~speaks])


def test_that_they_stand_speaks_for_tubes_and_cones():
    expect_that_it_speaks("stands", ("cylinder", "cone"))


def test_a_kind_without_wrong_ones_cannot_be_fitted():
    of_own = (50.0, 0.7, 0.1, 0.1, 0.1, 0.8, 0.3, 0.2, 1.0, 0.0)
    detections = [found(kind, verdict, *numbers) for numbers in ((), (of_own,)) for kind in calibration.KINDS
                  for verdict in ("right", "wrong")]
    assert calibration.fit(calibration.cases_of([line(detections=detections)])) is not None
    assert calibration.fit(calibration.cases_of([line(detections=detections[:-1])])) is None


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
