# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Logistic regression and what tells how good its probabilities are."""
import numpy as np

BINS = 10


def probabilities(weights, columns):
    """One probability a row; columns: rows of features, the first of them 1."""
    return 1.0 / (1.0 + np.exp(-np.clip(columns @ weights, -500.0, 500.0)))


def maximize(columns, right, penalty, towards, most_steps=100):
    """Newton's method. Weights with the largest likelihood of right, less half the penalty times the squares of all
    differences but the first from the weights `towards`. A step that leads down is halved until it leads up: where
    nearly all are right, whole ones went to and fro, and the weights after the last of them were anything."""
    ridge = np.full(columns.shape[1], float(penalty))
    ridge[0] = 1e-9
    sign = 1.0 - 2.0 * right

    def height(at):
        return -np.logaddexp(0.0, sign * (columns @ at)).sum() - 0.5 * ridge @ (at - towards) ** 2

    weights = towards.copy()
    for _ in range(most_steps):
        expected = probabilities(weights, columns)
        gradient = columns.T @ (right - expected) - ridge * (weights - towards)
        hessian = (columns * (expected * (1.0 - expected))[:, None]).T @ columns + np.diag(ridge + 1e-9)
        step = np.linalg.solve(hessian, gradient)
        here, least = height(weights), 1e-9 * np.abs(step).max()
        while not height(weights + step) >= here - 1e-9 * abs(here) and np.abs(step).max() > least:
            step *= 0.5
        weights += step
        if np.abs(step).max() < 1e-8:
            break
    return weights


def fit(columns, right, penalty, signs=None, towards=None):
    """Weights that make right (0 or 1 a row) likely. columns: rows of features, the first of them 1.

    penalty: on weights, in units of the standard deviation of their feature, that are far from 0 or from `towards`.
    signs: +1 or -1 for each weight, 0 for either; a feature whose weight would have the other sign gets none, nor does
    one that is 0 in every row."""
    count = columns.shape[1]
    signs = np.zeros(count) if signs is None else np.asarray(signs)
    scale = columns.std(axis=0)
    scale[scale <= 1e-9 * np.abs(columns).max(axis=0)] = 1.0  # the same everywhere
    start = np.zeros(count) if towards is None else towards * scale
    used = columns.any(axis=0)
    while True:
        weights = np.zeros(count)
        weights[used] = maximize((columns / scale)[:, used], right, penalty, start[used])
        if not (weights * signs < 0.0).any():
            return weights / scale
        used &= weights * signs >= 0.0


def log_loss(probability, right):
    """Mean of -ln of the probability of what is so; 0.69 of a coin."""
    sure = np.clip(probability, 1e-9, 1.0 - 1e-9)
    return float(-np.mean(np.where(right, np.log(sure), np.log(1.0 - sure))))


def area_under_curve(probability, right):
    """Chance that a right one has a larger probability than a wrong one; None when there are not both."""
    good, bad = np.sort(probability[right > 0.5]), np.sort(probability[right < 0.5])
    if not len(good) or not len(bad):
        return None
    below = np.searchsorted(bad, good, "left") + np.searchsorted(bad, good, "right")
    return float(below.mean() / (2.0 * len(bad)))


def calibration_error(probability, right):
    """Expected calibration error over BINS bins of equal width."""
    of_bin = np.minimum((probability * BINS).astype(int), BINS - 1)
    off = [abs((probability - right)[of_bin == k].sum()) for k in range(BINS)]
    return float(sum(off) / len(right))
