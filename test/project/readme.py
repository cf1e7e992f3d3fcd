#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The README and the pages of docs/ and eval/ tell the truth: commands, files, links and parameters exist."""
import os
import re
import sys

COMMANDS = ("scripts/demo", "scripts/test", "scripts/setup")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def parameters(root):
    """Defaults by name."""
    table = read(os.path.join(root, "include/primitect/params.def"))
    rows = re.findall(r"^PRIMITECT_(?:CHOICE|BOOL|INT|REAL|TEXT)\((\w+), (.*)", table, re.M)
    return {name: re.match(r'("[^"]*"|[^,]+),', rest).group(1).strip('"') or "empty" for name, rest in rows}


def defaults_in(page):
    """Of the parameters in a page's tables: names, one or several in the first column, and the second column."""
    rows = re.findall(r"^\| ((?:`\w+`(?:, )?)+) \| ([^|]+?) \|", page, re.M)
    return {name: default.strip("`") for names, default in rows for name in re.findall(r"\w+", names)}


def anchors_of(page):
    """As the headings of a page are linked to."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", page, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def faults_in(root, name):
    """Links, launch files and paths that a page names and that are not there."""
    page = read(os.path.join(root, name))
    for link, anchor in re.findall(r"\]\(([^)#]*)(?:#([^)]*))?\)", page):
        path = os.path.join(root, os.path.dirname(name), link) if link else os.path.join(root, name)
        if link.startswith("http"):
            continue
        if not os.path.exists(path):
            yield "%s links to %s, which is not there" % (name, link)
        elif anchor and anchor not in anchors_of(read(path)):
            yield "%s links to #%s, which %s does not have" % (name, anchor, link or "it")
    for launch in set(re.findall(r"\b(\w+\.launch)\b", page)):
        if not os.path.exists(os.path.join(root, "launch", launch)):
            yield "%s names %s, which is not there" % (name, launch)
    for path in set(re.findall(r"`((?:src|include|config|docs|eval|test|scripts|launch|msg)/[\w./-]+)`", page)):
        made = path.startswith("eval/results/")  # by the commands of the page
        if not made and not os.path.exists(os.path.join(root, path)):
            yield "%s names %s, which is not there" % (name, path)


def check(root):
    readme = read(os.path.join(root, "README.md"))
    faults = []
    for command in COMMANDS:
        path = os.path.join(root, command)
        if command not in readme:
            faults.append("README.md does not name " + command)
        if not os.access(path, os.X_OK):
            faults.append("README.md names %s, which cannot be run" % command)
    pages = ["README.md"]
    for folder in ("docs", "eval"):
        pages += sorted(folder + "/" + page for page in os.listdir(os.path.join(root, folder)) if page.endswith(".md"))
    for page in pages:
        faults += faults_in(root, page)
    known = parameters(root)
    if len(known) < 20:
        faults.append("params.def could not be read")
    tables = {"README.md": defaults_in(readme),
              "docs/parameters.md": defaults_in(read(os.path.join(root, "docs/parameters.md")))}
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
    print("\n".join(found) or "README.md, docs/ and eval/ tell the truth")
    sys.exit(1 if found else 0)
