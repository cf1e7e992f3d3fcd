#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Random draws: arguments of a call and operands are evaluated in any order, so that two draws among them make other
numbers with another compiler or processor. Between braces, and in statements of their own, they keep their order.
Draws of a generator that is called `random` are seen, not those in functions that keep one."""
import os
import re
import sys

FOLDERS = ("src", "eval", "test")
SILENT = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'""", re.DOTALL)  # comments, texts
TOKEN = re.compile(r"\brandom_?\s*\.\s*(?P<draw>uniform|gaussian|below|next)\b"
                   r"|(?<=[(,])\s*(?P<passed>random_?)\s*(?=[,)])"
                   r"|(?P<ordered>&&|\|\||<<|>>|[-+*/%&|^]=|(?<![<>=!])=(?!=)|[?;]|(?<!:):(?!:))"
                   r"|(?P<none>->|\+\+|--)"
                   r"|(?P<operator>[<>=!]=|[-+*/%<>&|^])"
                   r"|(?P<other>[(){}\[\],])")


class Group:
    """What stands between two brackets: how many operands draw since the last thing that keeps an order."""

    def __init__(self, bracket):
        self.bracket = bracket
        self.statements = self.draws = self.draws_at_all = False
        self.operands = 0

    def end_operand(self):
        self.operands += self.draws
        self.draws = False
        return self.operands > 1

    def keep_order(self):
        unordered = self.end_operand()
        self.operands = 0
        return unordered


def places_of(text):
    """Where operands or arguments draw, and no order is kept."""
    text = SILENT.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)
    groups = [Group("{")]
    for token in TOKEN.finditer(text):
        group = groups[-1]
        letter = token.group("other")
        if token.group("draw"):
            group.draws = group.draws_at_all = True
        elif token.group("passed"):  # who gets the generator draws after all arguments have their values
            group.draws_at_all = True
        elif token.group("ordered"):
            group.statements |= token.group() == ";"
            if group.keep_order():
                yield token.start()
        elif token.group("operator"):
            group.end_operand()
        elif letter == ",":
            if group.end_operand() if group.bracket == "(" else group.keep_order():
                yield token.start()
                group.operands = 0
        elif letter and letter in "([{":
            groups.append(Group(letter))
        elif letter and len(groups) > 1:
            if group.keep_order():
                yield token.start()
            groups.pop()
            if group.bracket == "{" and (group.statements or not group.draws_at_all):
                if groups[-1].bracket == "{" and groups[-1].keep_order():  # a function, a loop, a lambda
                    yield token.start()
            elif group.draws_at_all:
                groups[-1].draws = groups[-1].draws_at_all = True


def faults_of(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for place in places_of(text) if "random" in text else ():
        yield "%s:%d: draws in any order" % (path, text.count("\n", 0, place) + 1)


def self_test():
    for wrong in ("f(random.uniform(), random.uniform());", "Vec3 v(1, random.below(2), g(random));",
                  "x = random.uniform() * a + random.uniform() * b;", "f(g(3, random), h(random));",
                  "x += s * (random.gaussian() * a + random.gaussian() * b);", "s(random.uniform(1, 2) * g(random));",
                  "f(p, q + random.uniform(0, 1) * a + random.uniform(0, 1) * b);",
                  "add(pointOn(s, random.uniform(0, 1), a).p + 0.1 * Vec3{random.gaussian(), 0});",
                  "x = random.uniform() < random.uniform();", "f('\"', random.below(2), random.below(3));"):
        assert list(places_of("{ " + wrong + " }")), "the test of draws has gone blind: " + wrong
    for right in ("Vec3 v{random.uniform(), random.uniform()};", "a = random.uniform(), b = random.uniform();",
                  "f({g(random), h(random)});", "f(random.uniform(-1, 1), 2); // random.uniform() + random.uniform()",
                  "x = c ? random.uniform() * 2 : random.uniform() * 3;", "/* random.below(2) + */ y = random.below(3);",
                  "f(g(random), random);", "if (random.uniform() < 1 || random.uniform() > 2) f(random);",
                  "const auto g = [&] { return random.uniform(); }; y = g() + random.uniform();"):
        assert not list(places_of("{ " + right + " }")), "the test of draws sees ghosts: " + right


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
