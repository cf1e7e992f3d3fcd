# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The depth image of a recorded frame, as `detect --labels` writes it: PLY with the image as a range grid."""
import numpy

PLY_TYPES = {"float": "<f4", "uchar": "u1", "uint": "<u4", "int": "<i4"}
LIGHT = numpy.array([0.45, 0.55, 0.7])  # towards it, of length one
SLOPE_STEP = 3  # px to either side: slopes of neighbours are noise


def read_ply_header(file):
    """Columns of the vertices as a numpy type, the number of vertices, and columns x rows of the image."""
    columns, sizes, element = [], {}, ""
    for line in iter(file.readline, b"end_header\n"):
        words = line.decode("ascii", "replace").split()
        if not words:
            raise ValueError("the header of the points does not end")
        if words[0] == "element":
            element = words[1]
            sizes[element] = int(words[2])
        elif words[0] == "property" and element == "vertex":
            columns.append((words[2], PLY_TYPES[words[1]]))
        elif words[0] == "obj_info" and words[1] in ("num_cols", "num_rows"):
            sizes[words[1]] = int(words[2])
    if "range_grid" not in sizes:
        raise ValueError("the points are no image")
    return columns, sizes["vertex"], (sizes["num_rows"], sizes["num_cols"])


def grid_of(entries, shape):
    """Which pixels have a point, from the image part of the file: for each pixel a 0, or a 1 and the point's index."""
    measured, place = numpy.zeros(shape[0] * shape[1], bool), 0
    for pixel in range(measured.size):
        if entries[place]:
            measured[pixel] = True
            place += 4
        place += 1
    return measured.reshape(shape)


def read_labelled_image(path):
    """What `detect --labels` writes about an image: points (rows x columns x 3 in m, NaN: missing), and for each pixel
    the index of its detection, -1: none. Raises ValueError naming the file when it is something else."""
    try:
        with open(path, "rb") as file:
            columns, count, shape = read_ply_header(file)
            vertices = numpy.fromfile(file, numpy.dtype(columns), count)
            measured = grid_of(file.read(), shape)
        if measured.sum() != count:
            raise ValueError("%d points for %d pixels" % (count, measured.sum()))
        points, labels = numpy.full(shape + (3,), numpy.nan), numpy.full(shape, -1)
        points[measured] = numpy.stack([vertices[axis] for axis in "xyz"], axis=1)
        labels[measured] = vertices["label"].astype(int) - 1
    except (OSError, ValueError, KeyError, IndexError) as error:
        raise ValueError("%s: cannot be drawn: %s" % (path, error)) from error
    return points, labels


def shaded(points):
    """A grey image of the points, as if lit from the camera's upper left; white: not measured."""
    step = SLOPE_STEP
    across = (points[:, 2 * step:] - points[:, :-2 * step])[step:-step]
    down = (points[2 * step:] - points[:-2 * step])[:, step:-step]
    normals = numpy.cross(across, down)
    with numpy.errstate(invalid="ignore", divide="ignore"):
        light = numpy.abs(normals @ LIGHT) / numpy.linalg.norm(normals, axis=2)
    grey = numpy.where(numpy.isfinite(points[..., 2]), 0.6, 1.0)
    inner = grey[step:-step, step:-step]
    inner[:] = numpy.where(numpy.isfinite(light) & (inner < 1.0), 0.42 + 0.46 * light, inner)
    return numpy.repeat(grey[..., None], 3, axis=2)
