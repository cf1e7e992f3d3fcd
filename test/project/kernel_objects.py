#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What kernels compiled with flags of their own give to the linker: their table of functions and nothing else.

A weak symbol, say of a template or an inline function, could replace the common copy for the whole program, which then
stops on processors without these instructions.
"""
import re
import subprocess
import sys

COMMON_FLAGS = {"scalar.cpp.o", "dispatch.cpp.o", "loops.cpp.o"}
WEAK = set("WwVvu")


def symbols(listing):
    """(object, type, name) of each line of `nm -A` on an archive."""
    for line in listing.splitlines():
        match = re.match(r".*?:?([\w.]+\.o):\s*[0-9a-f]*\s+(\S)\s+(\S+)$", line)
        if match:
            yield match.groups()


def faults_of(listing):
    tables = set()
    for name, kind, symbol in symbols(listing):
        # Of the sanitizers, and a pointer to the run time's routine for exceptions: no code.
        if name in COMMON_FLAGS or symbol.startswith(("__odr_asan", "DW.ref.")):
            continue
        if kind in WEAK:
            yield "%s has a weak symbol: %s" % (name, symbol)
        elif re.fullmatch(r"_ZN9primitect7kernels\d+k[A-Z]\w*E", symbol):
            tables.add(name)
        else:
            yield "%s has a symbol that others can link to: %s" % (name, symbol)
    if "portable.cpp.o" not in tables:
        yield "no table of the portable kernel was seen"


def self_test():
    """The rules themselves must find what they forbid."""
    table = "lib.a:%s:0000000000000000 D _ZN9primitect7kernels9kPortableE\n"
    assert not list(faults_of(table % "portable.cpp.o")), "the test of kernel objects sees ghosts"
    leak = table % "portable.cpp.o" + "lib.a:avx2.cpp.o:0000000000000010 W _ZSt3maxIfERKT_S2_S2_\n"
    assert len(list(faults_of(leak))) == 1, "the test of kernel objects has gone blind"
    assert list(faults_of("")), "the test of kernel objects passes without any"


if __name__ == "__main__":
    self_test()
    found = list(faults_of(subprocess.run(["nm", "-A", "--defined-only", "--extern-only", sys.argv[1]], check=True,
                                          stdout=subprocess.PIPE, universal_newlines=True).stdout))
    print("\n".join(found) or "kernels keep to themselves")
    sys.exit(1 if found else 0)
