// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The detector as a plain node: rosrun primitect detector.
#include "detector_nodelet.h"
#include "run_node.h"

int main(int argc, char** argv) {
  return primitect::ros_layer::runNode<primitect::ros_layer::DetectorNodelet>(argc, argv, "detector");
}
