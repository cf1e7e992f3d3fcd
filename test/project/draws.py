#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Random draws: arguments of a call and operands are evaluated in any order, so that two draws among them make other
numbers with another compiler or processor. Between braces, and in statements of their own, they keep their order."""
import os
import re
import sys

FOLDERS = ("src", "eval", "test")
DRAW = re.compile(r"\brandom\s*\.\s*(uniform|gaussian|below|next)\b|[(,]\s*random\s*[,)]")
SILENT = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')  # comments, texts
NO_CALL = re.compile(r"\b(for|while|if|switch|return)\s*$")
OPENING, CLOSING = "([{", ")]}"
OPERATOR = re.compile(r"(?<= )[-+*/](?=\s)")


def parts_of(text, is_end):
    """The text between ends that stand in no bracket."""
    parts, depth, begin = [], 0, 0
    for place, letter in enumerate(text):
        depth += (letter in OPENING) - (letter in CLOSING)
        if depth == 0 and is_end(text, place):
            parts.append(text[begin:place])
            begin = place + 1
    return parts + [text[begin:]]


def draws(parts):
    return sum(1 for part in parts if DRAW.search(part))


def is_comma(text, place):
    return text[place] == ","


def is_operator(text, place):
    return OPERATOR.match(text, place) is not None


def places_of(text):
    """Where two arguments or two operands draw."""
    text = SILENT.sub(lambda match: " " * len(match.group()), text)
    opened = []
    for place, letter in enumerate(text):
        if letter == "(":
            opened.append(place)
        elif letter == ")" and opened:
            begin = opened.pop()
            if not NO_CALL.search(text, 0, begin) and draws(parts_of(text[begin + 1:place], is_comma)) > 1:
                yield begin
    for statement in re.finditer(r"[^;{}]+", text):
        for part in parts_of(statement.group(), is_comma):
            if draws(parts_of(part, is_operator)) > 1:
                yield statement.start() + statement.group().index(part)


def faults_of(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for place in places_of(text) if "random" in text else ():
        yield "%s:%d: draws in any order" % (path, text.count("\n", 0, place + 1) + 1)


def self_test():
    for wrong in ("f(random.uniform(), random.uniform());", "Vec3 v(1, random.below(2), g(random));",
                  "x = random.uniform() * a + random.uniform() * b;", "f(g(3, random), h(random));"):
        assert list(places_of(wrong)), "the test of draws has gone blind: " + wrong
    for right in ("Vec3 v{random.uniform(), random.uniform()};", "a = random.uniform(), b = random.uniform();",
                  "f({g(random), h(random)});", "f(random.uniform(-1, 1), 2); // random.uniform() + random.uniform()"):
        assert not list(places_of(right)), "the test of draws sees ghosts: " + right


def main(root):
    os.chdir(root)
    faults, files = [], 0
    for top in FOLDERS:
        for folder, _, names in sorted(os.walk(top)):
            for name in sorted(names):
                if name.endswith((".h", ".cpp", ".inc")):
                    files += 1
                    faults += faults_of(os.path.join(folder, name))
    print("\n".join(faults) or "%d files draw in order" % files)
    return 1 if faults or files < 100 else 0


if __name__ == "__main__":
    self_test()
    sys.exit(main(sys.argv[1]))
