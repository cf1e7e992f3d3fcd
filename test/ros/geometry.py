# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors as tuples, for comparing messages."""
import math


def vector(p):
    return (p.x, p.y, p.z)


def dot(a, b):
    return sum(s * t for s, t in zip(a, b))


def minus(a, b):
    return tuple(s - t for s, t in zip(a, b))


def distance(a, b):
    return math.sqrt(dot(minus(a, b), minus(a, b)))


def between(a, b):
    """The angle of two unit vectors (rad)."""
    return math.acos(max(-1.0, min(1.0, dot(a, b))))


def away_from_line(point, on_line, direction):
    """How far a point is from a line with a direction of unit length."""
    there = minus(point, on_line)
    return math.sqrt(max(0.0, dot(there, there) - dot(there, direction) ** 2))


def z_axis(q):
    """The z axis of a frame with this orientation."""
    return (2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y))
