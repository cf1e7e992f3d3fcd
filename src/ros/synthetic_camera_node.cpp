// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The simulated camera as a plain node: rosrun primitect synthetic_camera.
#include "run_node.h"
#include "synthetic_camera_nodelet.h"

namespace {

constexpr const char* kAbout =
    "Simulates a depth camera above a table, as a ROS node.\n\n"
    "  synthetic_camera __ns:=camera _seed:=2 _rate:=10\n\n"
    "Sends depth/points, depth/image_raw, depth/camera_info and ~truth. Parameters, here with '_' before the name, "
    "are\n"
    "in docs/ros_api.md.\n";

}  // namespace

int main(int argc, char** argv) {
  return primitect::ros_layer::runNode<primitect::ros_layer::SyntheticCameraNodelet>(argc, argv, "synthetic_camera",
                                                                                     kAbout);
}
