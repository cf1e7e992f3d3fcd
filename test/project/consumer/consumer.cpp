// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A wall 1 m away: one plane.
#include <cstdio>

#include "primitect/detector.h"

int main() {
  const primitect::Params params;
  primitect::Cloud cloud;
  cloud.reset(160, 120, false);
  for (int i = 0; i < 160 * 120; ++i) {
    const float column = static_cast<float>(i % 160), row = static_cast<float>(i / 160);
    cloud.setPoint(i, 0.007f * (column - 79.5f), 0.007f * (row - 59.5f), 1.0f, primitect::depthRangeOf(params));
  }
  primitect::Detector detector{params};
  const primitect::Detections& found = detector.detect(cloud);
  for (const primitect::Detection& item : found.items) std::puts(kindName(kindOf(item.shape)));
}
