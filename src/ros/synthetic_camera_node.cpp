// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The simulated camera as a plain node: rosrun primitect synthetic_camera.
#include "run_node.h"
#include "synthetic_camera_nodelet.h"

int main(int argc, char** argv) {
  return primitect::ros_layer::runNode<primitect::ros_layer::SyntheticCameraNodelet>(argc, argv, "synthetic_camera");
}
