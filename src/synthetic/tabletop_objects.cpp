// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sizes and poses of single objects.
#include "synthetic/tabletop_objects.h"

#include <cmath>

#include "synthetic/poses.h"

namespace primitect::synthetic {
namespace {

Object drawBall(Random& random) {
  const double radius = random.uniform(0.040, 0.090);
  return {"sphere", Ball{radius}, at(0.0, radius), 0.0, radius};
}

Object drawRod(Random& random) {
  const double share = random.uniform();
  const double radius = 0.025 + 0.065 * share * share;  // more slim ones than stout ones
  const double half_length = random.uniform(0.050, 0.100);
  const bool lying = random.below(2) == 1;
  if (lying) return {"cylinder", Rod{radius, half_length}, at(0.0, radius) * tilted(kPi / 2), half_length, radius};
  return {"cylinder", Rod{radius, half_length}, at(0.0, half_length), 0.0, radius};
}

Object drawFrustum(Random& random) {
  const double half_angle = random.uniform(10.0, 35.0) * kDegree;
  const double radius = random.uniform(0.050, 0.090);
  const double end = radius / std::tan(half_angle);
  const double tallest = random.uniform(0.120, 0.180);
  const bool blunt = random.below(3) == 0;
  double begin = blunt ? end * random.uniform(0.2, 0.5) : 0.0;
  if (end - begin > tallest) begin = end - tallest;
  // At least 12 mm narrower at one end than at the other: less would look like a cylinder.
  if ((1.0 - begin / end) * radius < 0.012) begin = end - 0.012 / std::tan(half_angle);
  const Frustum frustum{half_angle, begin, end};
  const bool lying = random.below(2) == 1;
  // Upside down: the apex is up and the wide end is on the table.
  if (!lying) return {"cone", frustum, at(0.0, end) * tilted(kPi), 0.0, radius};
  // The apex is on the table and the axis rises by the half angle, so that a line of the mantle lies on the table.
  const double middle = 0.5 * (begin + end) * std::cos(half_angle);
  const double half_line = 0.5 * (end - begin) * std::cos(half_angle);
  return {"cone", frustum, at(-middle, 0.0) * tilted(kPi / 2 - half_angle), half_line, radius};
}

Object drawTableBox(Random& random) {
  const double half_x = random.uniform(0.035, 0.070);
  const double half_y = random.uniform(0.030, half_x);
  const double half_z = random.uniform(0.025, 0.070);
  return {"box", Box{half_x, half_y, half_z}, at(0.0, half_z), half_x, half_y};
}

}  // namespace

std::vector<Object> drawObjects(Random& random) {
  std::vector<Object> objects;
  const auto draw = [&](int least, Object (*drawOne)(Random&)) {
    const int count = least + static_cast<int>(random.below(2));
    for (int i = 0; i < count; ++i) objects.push_back(drawOne(random));
  };
  draw(1, drawTableBox);
  draw(1, drawFrustum);
  draw(2, drawRod);
  draw(2, drawBall);
  return objects;
}

}  // namespace primitect::synthetic
