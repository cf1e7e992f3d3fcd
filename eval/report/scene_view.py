# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""How a scene is looked at: a depth frame as its image, the paper's scenes from above, a part from two sides."""
import numpy

FAR = {"frame": 0.02, "wide": 0.1, "part": 0.05}  # m, dark red: depth frames, the paper's scenes, mechanical parts
WIDE_SCENE = 2.0  # m across
PART_EYES = (numpy.array([0.3, -0.5, 0.81]), numpy.array([-0.3, -0.5, -0.81]))  # long, middle, short side of the part
LEAST_NAMED = {"frame": 0.002, "wide": 0.004, "part": 0.015}  # share of the points from which on a shape gets letters


def on_grid(points):
    """Rows and columns when most points lie on a square grid seen from above, x along the rows; None otherwise."""
    side = int(round(len(points) ** 0.5))
    if side < 50 or side * side != len(points) or not numpy.isfinite(points).all():
        return None
    column = numpy.tile(numpy.arange(side), side)
    return (side, side) if abs(numpy.corrcoef(points[:, 0], column)[0, 1]) > 0.4 else None


def lit(colors, normals, light):
    """Darker where the surface turns away from the light."""
    shade = numpy.nan_to_num(normals @ (light / numpy.linalg.norm(light)), nan=0.3)
    return numpy.clip(colors * (0.5 + 0.55 * numpy.clip(shade, 0, 1))[:, None], 0, 1)


def part_places(points, normals):
    """A part from two sides, beside each other: for each side the points that face the eye from far to near, their
    places on paper (m), and the direction to the eye."""
    _, directions = numpy.linalg.eigh(numpy.cov(points.T))
    sides = directions[:, ::-1] * numpy.sign(directions[:, ::-1].sum(axis=0))  # long, middle, short
    result, right = [], 0.0
    for eye in (sides @ eye for eye in PART_EYES):
        up = sides[:, 1] - (sides[:, 1] @ eye) * eye
        flat = numpy.stack([points @ numpy.cross(up, eye), points @ up], axis=1) / numpy.linalg.norm(up)
        flat += [right, 0.0] - flat.min(axis=0)
        right = flat[:, 0].max() + 0.08
        seen = numpy.nonzero(normals @ eye > 0)[0]
        seen = seen[numpy.argsort(points[seen] @ eye)]
        result.append((seen, flat[seen], eye))
    return result


def frame_limits(scene, measured):
    """Columns and rows of a depth frame around all that is not its largest shape, with some margin."""
    labels = scene["surface"]
    largest = numpy.bincount(labels[labels >= 0]).argmax() if (labels >= 0).any() else -2
    chosen = (measured & (labels != largest)).reshape(scene["shape"])
    if not chosen.any():
        chosen = numpy.ones(scene["shape"], bool)
    limits = []
    for flags in (chosen.any(axis=0), chosen.any(axis=1)):
        first, last = numpy.nonzero(flags)[0][[0, -1]]
        margin = 0.12 * (last - first) + 5
        limits.append((max(-0.5, first - margin), min(len(flags) - 0.5, last + margin)))
    return limits


class View:
    """Places of a scene's points on paper; the same for all its pictures."""

    def __init__(self, scene):
        self.points, self.normals = scene["points"], scene["normals"]
        self.measured = numpy.isfinite(self.points).all(axis=1)
        if not self.measured.any():
            raise ValueError("%s: no measured point" % scene["title"])
        extent = numpy.ptp(self.points[self.measured], axis=0).max()
        self.kind = "frame" if scene["shape"][0] > 1 else "wide" if extent > WIDE_SCENE else "part"
        self.far = FAR[self.kind]
        self.image_shape = scene["shape"] if self.kind == "frame" else on_grid(self.points)
        if self.kind == "part":
            self.sides = part_places(self.points, self.normals)
            places = numpy.concatenate([places for _, places, _ in self.sides])
            self.limits = [(low - 0.03, high + 0.03) for low, high in zip(places.min(axis=0), places.max(axis=0))]
        elif self.kind == "frame":
            self.limits = frame_limits(scene, self.measured)
        elif self.image_shape:
            self.limits = [(-0.5, side - 0.5) for side in self.image_shape]
        else:
            low, high = self.points[self.measured, :2].min(axis=0), self.points[self.measured, :2].max(axis=0)
            self.limits = list(zip(low, high))
        (left, right), (low, high) = self.limits
        self.aspect = (high - low) / (right - left)

    def show(self, axes, colors, shaded=True):
        """Draws all points in their colours."""
        axes.set_axis_off()
        axes.set_aspect("equal")
        if self.kind == "part":
            for seen, places, eye in self.sides:
                own = lit(colors[seen], self.normals[seen], eye + 0.4 * self.sides[0][2]) if shaded else colors[seen]
                axes.scatter(*places.T, s=11, lw=0, c=own)
        else:
            light = numpy.array([-0.4, -0.5, -0.77] if self.kind == "frame" else [-0.5, 0.5, 0.7])
            self.show_flat(axes, lit(colors, self.normals, light) if shaded else colors)
        axes.set_xlim(*self.limits[0])
        axes.set_ylim(*self.limits[1][::-1 if self.kind == "frame" else 1])

    def show_flat(self, axes, colors):
        """As an image where the points lie on a grid, else as dots."""
        if self.image_shape:
            image = numpy.where(self.measured[:, None], colors, 1.0).reshape(tuple(self.image_shape) + (3,))
            axes.imshow(image, origin="upper" if self.kind == "frame" else "lower", interpolation="nearest")
        else:
            size = min(20.0, 1e5 / len(self.points))
            axes.scatter(self.points[:, 0], self.points[:, 1], s=size, lw=0, c=colors)

    def place_of(self, chosen):
        """Where the middle of some points is in the picture: one of them; None when they are few or out of sight."""
        if chosen.sum() < LEAST_NAMED[self.kind] * self.measured.sum():
            return None
        if self.kind == "part":
            seen, places, _ = max(self.sides, key=lambda side: chosen[side[0]].sum())
            places = places[chosen[seen]]
        elif self.image_shape:
            places = numpy.argwhere((chosen & self.measured).reshape(self.image_shape))[:, ::-1]
        else:
            places = self.points[chosen & self.measured, :2]
        if not len(places):
            return None
        return places[((places - numpy.median(places, axis=0)) ** 2).sum(axis=1).argmin()]
