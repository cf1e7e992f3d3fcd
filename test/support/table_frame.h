// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A simulated frame of a cluttered table, and what the detector makes of it.
#pragma once

#include <cstdint>

#include "primitect/detector.h"
#include "synthetic/clutter.h"
#include "synthetic/frame.h"

namespace primitect::test {

struct TableFrame {
  synthetic::Frame frame;
  Cloud cloud;
  Detections found;

  explicit TableFrame(std::uint64_t seed, double noise_scale = 1.0) {
    const synthetic::PinholeCamera camera;
    synthetic::FrameParams params;
    params.noise.scale = noise_scale;
    frame = renderFrame(synthetic::clutteredTable(seed), camera, synthetic::clutterPose(seed), params, seed, 0);
    cloudFromDepth(frame.depth, camera, params.truth.range, cloud);
    Detector detector{Params()};
    found = detector.detect(cloud);
  }
};

}  // namespace primitect::test
