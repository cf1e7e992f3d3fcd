#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What was built without ROS can be installed, and a project of its own finds and uses it.

    installed_library.py BUILD_FOLDER SOURCE_FOLDER COMPILER FLAGS
"""
import os
import subprocess
import sys
import tempfile


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit("%s:\n%s" % (" ".join(command), done.stdout))
    return done.stdout


def main():
    build, source, compiler, flags = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        prefix, own = os.path.join(folder, "prefix"), os.path.join(folder, "own")
        run("cmake", "--install", build, "--prefix", prefix, "--component", "library")
        run("cmake", "-S", os.path.join(source, "test", "project", "consumer"), "-B", own, "-DCMAKE_PREFIX_PATH=" + prefix,
            "-DCMAKE_CXX_COMPILER=" + compiler, "-DCMAKE_CXX_FLAGS=" + flags)
        run("cmake", "--build", own)
        found = run(os.path.join(own, "consumer"))
        library = run("ldd", os.path.join(own, "consumer"))
    if found != "plane\n":
        sys.exit("the wall is no plane but '%s'" % found)
    if os.path.join(prefix, "") not in library:
        sys.exit("it does not use the installed library:\n" + library)


if __name__ == "__main__":
    main()
