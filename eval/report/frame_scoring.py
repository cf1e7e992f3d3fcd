# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Detections in a recorded frame against its hand-made labels.

A label is fitted by a detection of its kind when
  plane     its normal is within 6 deg, and it passes the labelled point within 15 mm,
  sphere    its centre is within 25 % of the radius of the labelled one, its radius within 15 %,
  cylinder  its axis is within 12 deg and passes the labelled centre within 20 % of the radius (at least 8 mm), its
            radius is within 15 %; a cone of a half angle below 6 deg serves as well,
  cone      as a cylinder, but its radius beside the labelled centre is within 25 %; labelled cones are slightly
            tapered cups, so that a cylinder serves as well.
A sphere, cylinder or cone that fits no label is a false alarm, unless the frame has a label of its kind that says
nothing of where it is. Planes are never false alarms: nobody labels every plane of a room.
"""
import numpy

PLANE_ANGLE_DEG, PLANE_DISTANCE = 6.0, 0.015  # m
SPHERE_CENTRE, RADIUS = 0.25, 0.15  # shares of the labelled radius
AXIS_ANGLE_DEG, AXIS_OFFSET, LEAST_AXIS_OFFSET = 12.0, 0.2, 0.008  # deg, share of the radius, m
SHARPEST_CUP_DEG, CUP_RADIUS = 6.0, 0.25


def unit(vector):
    """The same direction, of length one."""
    vector = numpy.array(vector, float)
    return vector / numpy.linalg.norm(vector)


def angle_deg(a, b):
    """Between two lines: 0 to 90 deg."""
    return numpy.degrees(numpy.arccos(min(1.0, abs(float(unit(a) @ unit(b))))))


def plane_point(label, lens):
    """The point of a labelled plane (m) that the labelled pixel shows, else the one closest to the camera."""
    normal, distance = numpy.array(label["plane"][:3]), label["plane"][3]
    if "pixel" not in label:
        return -distance * normal / (normal @ normal)
    fx, fy, cx, cy = lens
    ray = numpy.array([(label["pixel"][0] - cx) / fx, (label["pixel"][1] - cy) / fy, 1.0])
    return ray * (-distance / (normal @ ray))


def fits_plane(label, found, lens):
    """Same normal, same place."""
    offset = (numpy.array(found["point"]) - plane_point(label, lens)) @ unit(found["normal"])
    return angle_deg(label["plane"][:3], found["normal"]) < PLANE_ANGLE_DEG and abs(offset) < PLANE_DISTANCE


def fits_sphere(label, found):
    """Same centre, same radius."""
    radius = label["r_mm"] / 1000.0
    offset = numpy.linalg.norm(numpy.array(found["center"]) - label["centre"])
    return offset < SPHERE_CENTRE * radius and abs(found["radius"] - radius) < RADIUS * radius


def axis_offset(found, point):
    """From the axis of a cylinder or cone to a point, at right angles, and the place of its foot along the axis (m)."""
    start = numpy.array(found["apex"] if found["type"] == "cone" else found["point"])
    axis = unit(found["axis"])
    along = (numpy.array(point) - start) @ axis
    return numpy.linalg.norm(numpy.array(point) - start - along * axis), along


def radius_beside(found, label):
    """Radius of a detection (m); of a cone beside the labelled centre."""
    if found["type"] != "cone":
        return found["radius"]
    return axis_offset(found, label["centre"])[1] * numpy.tan(found["half_angle"])


def fits_round(label, found):
    """A cylinder or cone along the same axis that has the same radius."""
    radius, is_cup = label["r_mm"] / 1000.0, label["type"] == "cone"
    if found["type"] == "cone" and not is_cup and numpy.degrees(found["half_angle"]) >= SHARPEST_CUP_DEG:
        return False
    if label.get("axis") and angle_deg(label["axis"], found["axis"]) >= AXIS_ANGLE_DEG:
        return False
    near = axis_offset(found, label["centre"])[0] < max(AXIS_OFFSET * radius, LEAST_AXIS_OFFSET)
    return near and abs(radius_beside(found, label) - radius) < (CUP_RADIUS if is_cup else RADIUS) * radius


def has_place(label):
    """Does the label say where its shape is?"""
    return bool(label.get("plane") if label["type"] == "plane" else label.get("centre"))


def fits(label, found, lens):
    """Does the detection fit the label? lens: fx, fy, cx, cy of the frame in px."""
    if not has_place(label):
        return False
    if label["type"] == "plane":
        return found["type"] == "plane" and fits_plane(label, found, lens)
    if label["type"] == "sphere":
        return found["type"] == "sphere" and fits_sphere(label, found)
    return found["type"] in ("cylinder", "cone") and fits_round(label, found)


def score_label(label, detections, lens):
    """What became of a label. Of several detections that fit, the one with the most inliers is the one measured."""
    hits = [k for k, found in enumerate(detections) if fits(label, found, lens)]
    best = max(hits, key=lambda k: detections[k].get("inliers", 0), default=None)
    verdict = "found" if hits else "missed" if has_place(label) else "not judged"
    result = {"name": label["name"], "kind": label["type"], "must": label["must"], "verdict": verdict, "hits": hits,
              "pixel": label.get("pixel"), "remark": label.get("remark", ""), "label_radius_mm": label.get("r_mm"),
              "nominal_radius_mm": label.get("nominal_mm"), "radius_mm": None, "radius_error_mm": None}
    if best is not None and label.get("r_mm"):
        result["radius_mm"] = 1000.0 * radius_beside(detections[best], label)
        result["radius_error_mm"] = result["radius_mm"] - label["r_mm"]
    return result


def score_frame(frame, detections):
    """Both sides of a frame: {"labels": [see score_label], "verdicts": one for each detection}.

    Verdicts: "right" fits a label, "false" is a false alarm, "not judged" is neither. frame: see frame_labels.py.
    """
    labels = [score_label(label, detections, frame["lens"]) for label in frame["labels"]]
    used = {k for label in labels for k in label["hits"]}
    anywhere = {"plane"}
    if not frame["negative"]:
        anywhere |= frame["unknown"] | {label["type"] for label in frame["labels"] if not has_place(label)}
    verdicts = ["right" if k in used else "not judged" if found["type"] in anywhere else "false"
                for k, found in enumerate(detections)]
    return {"labels": labels, "verdicts": verdicts}


def describe(found):
    """A detection in a few words."""
    length = found.get("extent", {}).get("length")
    long_text = ", length %.0f mm" % (1000.0 * length) if length else ""
    if found["type"] == "plane":
        size = found.get("extent", {}).get("size")
        return "plane" + (" %.2f x %.2f m" % tuple(size) if size else "")
    if found["type"] == "cone":
        return "cone, half angle %.0f°" % numpy.degrees(found["half_angle"]) + long_text
    return "%s r %.0f mm" % (found["type"], 1000.0 * found["radius"]) + long_text
