# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the labels.json of a folder of recorded frames, and says what is wrong in it.

labels.json is an object; each key is the name of a PCD without ".pcd", each value a frame:
  fx, fy, cx, cy  lens in px
  objects         list of labels
  title           optional, one line about the frame
  negative        optional, true: no sphere, cylinder or cone is there, all that are reported are false alarms
A label:
  type            plane, sphere, cylinder or cone
  name            what a person calls it
  must            true: a good detector finds it; false: fine to find, no miss otherwise
  plane           of planes: [a, b, c, d] with a x + b y + c z + d = 0, m
  centre, r_mm    of all others: a point on the axis, or the centre [x, y, z] in m, and the radius there
  axis            of cylinders, and of cones if known: [x, y, z]
  pixel           optional, [u, v]: where it is in the image
  nominal_mm, remark, negative  optional; a remark with "must report NO" makes the frame a negative one too
null stands for unknown; a 'must' label whose place is unknown is a fault. Other keys are ignored.
"""
import json
import os

from report.kinds import KINDS

LENS = ("fx", "fy", "cx", "cy")
NOTHING_CURVED = "must report NO"


def is_number(value):
    """True and false are no numbers."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e9


def is_vector(value, size):
    """A list of so many numbers, not all of them zero."""
    return isinstance(value, list) and len(value) == size and all(map(is_number, value)) and any(value)


WANTED = {
    "type": (lambda v: v in KINDS, "one of " + ", ".join(KINDS)),
    "name": (lambda v: isinstance(v, str) and v, "a text"),
    "must": (lambda v: isinstance(v, bool), "true or false"),
    "pixel": (lambda v: is_vector(v, 2), "[u, v]"),
    "plane": (lambda v: is_vector(v, 4) and any(v[:3]), "[a, b, c, d]"),
    "centre": (lambda v: is_vector(v, 3), "[x, y, z] in m"),
    "axis": (lambda v: is_vector(v, 3), "[x, y, z]"),
    "r_mm": (lambda v: is_number(v) and v > 0, "a radius in mm above 0"),
    "nominal_mm": (lambda v: is_number(v) and v > 0, "a radius in mm above 0"),
    "remark": (lambda v: isinstance(v, str), "a text"),
    "negative": (lambda v: isinstance(v, bool), "true or false"),
}


def needed_keys(label):
    """The keys that the label must have, given what it says."""
    keys = ["type", "name", "must"]
    kind = label.get("type")
    if kind == "plane":
        return keys + (["plane"] if label.get("must") else [])
    if label.get("must") or label.get("centre") is not None:
        keys += ["centre", "r_mm"] + (["axis"] if kind == "cylinder" else [])
    return keys


def label_faults(label):
    """What is wrong with a label: a list of texts that name the keys."""
    if not isinstance(label, dict):
        return ["must be an object"]
    faults = ["key '%s' is missing" % key for key in needed_keys(label) if label.get(key) is None]
    for key, (fine, wanted) in WANTED.items():
        if label.get(key) is not None and not fine(label[key]):
            faults.append("key '%s' is %s, must be %s" % (key, json.dumps(label[key]), wanted))
    return faults


def frame_faults(name, frame):
    """What makes a frame useless: a list of texts that name the keys."""
    if os.path.basename(name) != name or name in ("", ".", ".."):
        return ["must be the name of a PCD in this folder, without folders"]
    if not isinstance(frame, dict):
        return ["must be an object"]
    faults = ["key '%s' is missing or no number" % key for key in LENS if not is_number(frame.get(key))]
    faults += ["key '%s' must be above 0" % key for key in LENS[:2] if is_number(frame.get(key)) and frame[key] <= 0]
    if not isinstance(frame.get("objects"), list):
        faults.append("key 'objects' is missing or no list")
    if not isinstance(frame.get("negative", False), bool):
        faults.append("key 'negative' must be true or false")
    return faults


def read_frame(frame, where, faults):
    """A frame in the form that frame_scoring takes. Labels with faults are left out; their kind is then unknown."""
    labels, unknown = [], set()
    for index, label in enumerate(frame["objects"]):
        wrong = label_faults(label)
        who = label.get("name") if isinstance(label, dict) else None
        title = "label %d%s" % (index + 1, " '%s'" % who if isinstance(who, str) else "")
        faults += ["%s, %s: %s: left out" % (where, title, text) for text in wrong]
        if not wrong:
            labels.append({key: value for key, value in label.items() if value is not None})
        elif isinstance(label, dict) and label.get("type") in KINDS:
            unknown.add(label["type"])
        else:
            unknown.update(KINDS)
    negative = frame.get("negative", False) or any(
        label.get("negative", False) or NOTHING_CURVED in label.get("remark", "") for label in labels)
    return {"lens": tuple(frame[key] for key in LENS), "labels": labels, "unknown": unknown, "negative": negative,
            "title": str(frame.get("title", ""))}


def read_labels(folder):
    """All frames of a folder by name, and what is wrong with them: (frames, faults).

    A frame with a fault of its own is left out, one with a faulty label goes on without that label.
    Raises ValueError naming the file when labels.json cannot be used at all.
    """
    path = os.path.join(folder, "labels.json")
    try:
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
    except (OSError, ValueError) as error:
        raise ValueError("%s: cannot be read: %s" % (path, error)) from error
    if not isinstance(content, dict) or not content:
        raise ValueError("%s: must be an object with an entry for each frame" % path)
    frames, faults = {}, []
    for name, frame in sorted(content.items()):
        where = "%s, frame '%s'" % (path, name)
        wrong = frame_faults(name, frame)
        faults += ["%s: %s: not scored" % (where, text) for text in wrong]
        if not wrong:
            frames[name] = read_frame(frame, where, faults)
    return frames, faults
