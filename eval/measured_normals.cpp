// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points as samples, and their normals back; see measured_normals.h.
#include "eval/measured_normals.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "core/neighbors.h"
#include "core/normals.h"
#include "core/projected_image.h"
#include "core/samples.h"

namespace primitect::eval {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

/// Without normals.
Samples samplesAt(const std::vector<std::uint32_t>& points, const Cloud& cloud) {
  Samples samples;
  samples.resize(points.size());
  samples.index.assign(points.begin(), points.end());
  for (std::size_t k = 0; k < points.size(); ++k) {
    samples.x[k] = samples.px[k] = cloud.x[points[k]];
    samples.y[k] = samples.py[k] = cloud.y[points[k]];
    samples.z[k] = samples.pz[k] = cloud.z[points[k]];
    samples.nx[k] = samples.ny[k] = samples.nz[k] = kMissing;
  }
  return samples;
}

}  // namespace

void clearNormals(Cloud& cloud) {
  for (std::vector<float>* values : {&cloud.nx, &cloud.ny, &cloud.nz}) values->assign(cloud.size(), kMissing);
}

void measureNormals(const std::vector<std::uint32_t>& points, Cloud& cloud) {
  Params params;
  params.use_cloud_normals = false;
  ProjectedImage projected;
  const bool is_projected = projected.make(cloud);
  std::vector<std::uint32_t> held = points;
  if (is_projected) {
    const auto outside = [&](std::uint32_t point) { return projected.pixel()[point] == ProjectedImage::kNoPixel; };
    held.erase(std::remove_if(held.begin(), held.end(), outside), held.end());
  }
  Samples samples = samplesAt(held, cloud);
  if (is_projected) {
    for (std::uint32_t& index : samples.index) index = projected.pixel()[index];
  }
  NormalSource source;
  estimateNormals(is_projected ? projected.image() : cloud, params, source, samples);
  for (std::size_t k = 0; k < held.size(); ++k) cloud.setNormal(held[k], samples.nx[k], samples.ny[k], samples.nz[k]);
}

}  // namespace primitect::eval
