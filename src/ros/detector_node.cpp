// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The detector as a plain node: rosrun primitect detector.
#include "detector_nodelet.h"
#include "run_node.h"

namespace {

constexpr const char* kAbout =
    "Finds planes, spheres, cylinders and cones in the clouds of a depth camera, as a ROS node.\n\n"
    "  detector ~input:=/camera/depth/points _max_depth:=1.5\n\n"
    "~input is the cloud; ~primitives and ~markers are what was found. Parameters, here with '_' before the name, are\n"
    "those of `detect --help`; docs/ros_api.md has them all. Without ROS, `detect` reads files.\n";

}  // namespace

int main(int argc, char** argv) {
  return primitect::ros_layer::runNode<primitect::ros_layer::DetectorNodelet>(argc, argv, "detector", kAbout);
}
