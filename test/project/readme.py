#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The README tells the truth: its commands, files, links, parameters and topics exist."""
import os
import re
import sys

COMMANDS = ("scripts/demo", "scripts/test", "scripts/setup")


def parameters(root):
    with open(os.path.join(root, "include/primitect/params.def"), encoding="utf-8") as file:
        return re.findall(r"^PRIMITECT_(?:CHOICE|BOOL|INT|REAL|TEXT)\((\w+), (.*)", file.read(), re.M)


def check(root):
    with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
        readme = file.read()
    faults = []
    for command in COMMANDS:
        path = os.path.join(root, command)
        if command not in readme:
            faults.append("does not name " + command)
        if not os.access(path, os.X_OK):
            faults.append(command + " cannot be run")
    for link in re.findall(r"\]\(([^)#]+)\)", readme):
        if not link.startswith("http") and not os.path.exists(os.path.join(root, link)):
            faults.append("links to %s, which is not there" % link)
    for launch in set(re.findall(r"\b(\w+\.launch)\b", readme)):
        if not os.path.exists(os.path.join(root, "launch", launch)):
            faults.append("names %s, which is not there" % launch)
    for path in set(re.findall(r"`((?:src|include|config|docs|eval|test|scripts|launch|msg)/[\w./-]+)`", readme)):
        if not os.path.exists(os.path.join(root, path)):
            faults.append("names %s, which is not there" % path)
    known = parameters(root)
    table = dict(re.findall(r"^\| `(\w+)` \| ([^|]+?) \|", readme, re.M))
    for name, rest in known:
        default = re.match(r'("[^"]*"|[^,]+),', rest).group(1).strip('"') or "empty"
        if name not in table:
            faults.append("its parameter table lacks " + name)
        elif table[name].strip("`") != default:
            faults.append("says %s is %s by default, it is %s" % (name, table[name], default))
    if len(known) < 20:
        faults.append("params.def could not be read")
    return faults


if __name__ == "__main__":
    found = check(sys.argv[1])
    print("\n".join("README.md " + fault for fault in found) or "README.md tells the truth")
    sys.exit(1 if found else 0)
