#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Layers: which folder may include what. On Debian the compiler would not notice, ROS headers sit in /usr/include."""
import os
import re
import sys

ROS = re.compile(
    r"(ros|roscpp|rosbag|sensor_msgs|std_msgs|geometry_msgs|visualization_msgs|diagnostic_msgs|diagnostic_updater|nodelet|"
    r"pluginlib|tf2|tf2_ros|tf2_eigen|tf2_geometry_msgs|pcl_ros|pcl_conversions|dynamic_reconfigure|image_transport|"
    r"message_filters|xmlrpcpp)/|(XmlRpcValue|XmlRpc)\.h")
GENERATED = re.compile(r"primitect/[A-Z]\w*\.h")  # messages and the dynamic_reconfigure configuration
LAYERS = {  # folder -> layers that it may include
    "src/kernels": {"kernels"},
    "src/core": {"core", "kernels"},
    "src/io": {"io", "core"},
    "src/synthetic": {"synthetic", "core"},
    "src/tools": {"tools", "ros", "io", "synthetic", "core"},  # of ros those headers that include no ROS themselves
    "src/ros": {"ros", "io", "synthetic", "core"},
    "include/primitect": set(),
}
KERNEL_HEADERS = re.compile(r"immintrin\.h|arm_neon\.h|cstddef|cstdint|cmath|kernels/\w+\.(h|inc)")
DISPATCH_HEADERS = {"cstdlib", "cstring", "stdexcept", "string"}  # of the files in src/kernels that are no kernels
DISPATCH_FILES = ("dispatch.cpp", "loops.cpp")
# Loading these, with libgdal and a hundred libraries more, takes longer than all that `detect` does with a frame.
SLOW_TO_LOAD = re.compile(r"opencv2/(imgcodecs|highgui|opencv)\b.*")
FLAGS = re.compile(r"-march=native|-ffast-math")


def includes(path):
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            match = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
            if match:
                yield number, match.group(1)


def is_ros(header):
    return bool(ROS.match(header) or GENERATED.match(header))


def own_without_ros(header):
    """One of src/ros that shows nothing of ROS."""
    path = os.path.join("src", header)
    return header.startswith("ros/") and os.path.exists(path) and not any(
        is_ros(name) or os.path.exists(os.path.join("src/ros", name)) for _, name in includes(path))


def faults_of(folder, path):
    for number, header in includes(path):
        where = "%s:%d includes %s" % (path, number, header)
        if folder != "src/ros" and is_ros(header) and not own_without_ros(header):
            yield where + ": ROS outside of src/ros"
        layer = header.split("/")[0]
        if "/" in header and layer in {"kernels", "core", "io", "synthetic", "tools", "ros"} and "src/" + layer in LAYERS:
            if layer not in LAYERS[folder] and not (layer == "ros" and ROS.match(header)):
                yield where + ": not a layer below"
        if SLOW_TO_LOAD.fullmatch(header):
            yield where + ": io/png_image.h reads and writes images"
        if header in {"immintrin.h", "arm_neon.h"} and folder != "src/kernels":
            yield where + ": intrinsics outside of src/kernels"
        allowed = KERNEL_HEADERS.fullmatch(header) or (header in DISPATCH_HEADERS and path.endswith(DISPATCH_FILES))
        if folder == "src/kernels" and not allowed:
            yield where + ": kernels include the least"


def check():
    faults, files = [], 0
    for folder in LAYERS:
        for name in sorted(os.listdir(folder)):
            if name.endswith((".h", ".cpp", ".def", ".inc")):
                files += 1
                faults += faults_of(folder, os.path.join(folder, name))
    for folder, _, names in os.walk("."):
        if folder.startswith(("./build", "./.git")):
            continue
        for name in names:
            if name in ("CMakeLists.txt",) or name.endswith(".cmake"):
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    if FLAGS.search(file.read()):
                        faults.append("%s/%s uses a compiler flag that the design rules out" % (folder, name))
    return faults, files


def self_test():
    """The rules themselves must find what they forbid."""
    import tempfile
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as file:
        file.write('#include <ros/ros.h>\n#include "primitect/Primitive.h"\n#include "io/report.h"\n#include <immintrin.h>\n')
        file.flush()
        assert len(list(faults_of("src/core", file.name))) == 4, "the layers test has gone blind"
        file.seek(0)
        file.truncate()
        file.write('#include "ros/bag_job.h"\n#include "ros/messages.h"\n')
        file.flush()
        assert len(list(faults_of("src/tools", file.name))) == 1, "tools see more of src/ros than they may"
        file.seek(0)
        file.truncate()
        file.write("#include <opencv2/core.hpp>\n#include <opencv2/imgcodecs.hpp>\n#include <opencv2/imgproc.hpp>\n")
        file.flush()
        assert len(list(faults_of("src/io", file.name))) == 1, "image codecs are not seen"


if __name__ == "__main__":
    os.chdir(sys.argv[1])
    self_test()
    found, count = check()
    print("\n".join(found) or "%d files keep to their layers" % count)
    sys.exit(1 if found or count < 30 else 0)
