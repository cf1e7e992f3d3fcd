#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The README and the table of parameters tell the truth: commands, files, links and parameters exist."""
import os
import re
import sys

COMMANDS = ("scripts/demo", "scripts/test", "scripts/setup")


def parameters(root):
    """Defaults by name."""
    with open(os.path.join(root, "include/primitect/params.def"), encoding="utf-8") as file:
        rows = re.findall(r"^PRIMITECT_(?:CHOICE|BOOL|INT|REAL|TEXT)\((\w+), (.*)", file.read(), re.M)
    return {name: re.match(r'("[^"]*"|[^,]+),', rest).group(1).strip('"') or "empty" for name, rest in rows}


def defaults_in(page):
    """Of the parameters in a page's tables: names, one or several in the first column, and the second column."""
    rows = re.findall(r"^\| ((?:`\w+`(?:, )?)+) \| ([^|]+?) \|", page, re.M)
    return {name: default.strip("`") for names, default in rows for name in re.findall(r"\w+", names)}


def check(root):
    with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
        readme = file.read()
    faults = []
    for command in COMMANDS:
        path = os.path.join(root, command)
        if command not in readme:
            faults.append("README.md does not name " + command)
        if not os.access(path, os.X_OK):
            faults.append("README.md names %s, which cannot be run" % command)
    for link in re.findall(r"\]\(([^)#]+)\)", readme):
        if not link.startswith("http") and not os.path.exists(os.path.join(root, link)):
            faults.append("README.md links to %s, which is not there" % link)
    for launch in set(re.findall(r"\b(\w+\.launch)\b", readme)):
        if not os.path.exists(os.path.join(root, "launch", launch)):
            faults.append("README.md names %s, which is not there" % launch)
    for path in set(re.findall(r"`((?:src|include|config|docs|eval|test|scripts|launch|msg)/[\w./-]+)`", readme)):
        if not os.path.exists(os.path.join(root, path)):
            faults.append("README.md names %s, which is not there" % path)
    known = parameters(root)
    if len(known) < 20:
        faults.append("params.def could not be read")
    with open(os.path.join(root, "docs/parameters.md"), encoding="utf-8") as file:
        tables = {"README.md": defaults_in(readme), "docs/parameters.md": defaults_in(file.read())}
    for page, table in tables.items():
        for name in table:
            if name not in known:
                faults.append("%s has a parameter %s, which is none" % (page, name))
            elif table[name] != known[name]:
                faults.append("%s says %s is %s by default, it is %s" % (page, name, table[name], known[name]))
    for name in known:
        if name not in tables["docs/parameters.md"]:
            faults.append("docs/parameters.md lacks " + name)
    return faults


if __name__ == "__main__":
    found = check(sys.argv[1])
    print("\n".join(found) or "README.md and docs/parameters.md tell the truth")
    sys.exit(1 if found else 0)
