// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The faults of a depth camera, pass by pass: shadows, edges, slant, range, waves, noise, quantisation, blots.
#include "synthetic/noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/random.h"
#include "synthetic/depth_faults.h"
#include "synthetic/noise_field.h"
#include "synthetic/poses.h"

namespace primitect::synthetic {
namespace {

void require(bool holds, const char* name, double value, const char* range) {
  if (holds) return;
  throw std::invalid_argument("noise: " + std::string(name) + " = " + std::to_string(value) + ", must be " + range);
}

void requireOdd(const char* name, int value, int most) {
  require(value >= 1 && value <= most && value % 2 == 1, name, value,
          ("1 to " + std::to_string(most) + " px, odd").c_str());
}

void check(const NoiseParams& params, const PinholeCamera& camera, const std::vector<float>& depth) {
  require(params.scale >= 0.0 && params.scale <= 100.0, "scale", params.scale, "0 to 100");
  requireOdd("grain", params.grain, 31);
  require(params.disparity_noise >= 0.0 && params.disparity_noise <= 10.0, "disparity_noise", params.disparity_noise,
          "0 to 10 px");
  require(params.sideways >= 0.0 && params.sideways <= 10.0, "sideways", params.sideways, "0 to 10 px");
  require(params.baseline > 0.0 && params.baseline <= 10.0, "baseline", params.baseline, "above 0, to 10 m");
  require(params.disparity_step >= 0.0 && params.disparity_step <= 10.0, "disparity_step", params.disparity_step,
          "0 to 10 px");
  requireOdd("footprint", params.footprint, 31);
  require(params.waves >= 0.0 && params.waves <= 0.1, "waves", params.waves, "0 to 0.1");
  requireOdd("wave_length", params.wave_length, 255);
  require(params.blots >= 0.0 && params.blots <= 1.0, "blots", params.blots, "0 to 1");
  requireOdd("blot_grain", params.blot_grain, 255);
  require(params.max_incidence_deg > 0.0 && params.max_incidence_deg <= 90.0, "max_incidence_deg",
          params.max_incidence_deg, "above 0, to 90 deg");
  require(params.min_depth >= 0.0 && params.min_depth <= 1000.0, "min_depth", params.min_depth, "0 to 1000 m");
  require(params.max_depth >= 0.0 && params.max_depth <= 1000.0, "max_depth", params.max_depth, "0 to 1000 m");
  require(depth.size() == camera.pixelCount(), "pixels of depth", static_cast<double>(depth.size()),
          "width * height of the camera");
}

std::uint64_t frameSeed(std::uint64_t seed, std::uint64_t frame_index) { return Random(seed).next() + frame_index; }

/// The steeper of the two one-sided slopes of inverse depth; a neighbour that saw nothing is an infinite step.
float steeper(float here, float before, float after) {
  const float slope_before = here - before;
  const float slope_after = after - here;
  return std::abs(slope_before) > std::abs(slope_after) ? slope_before : slope_after;
}

/// Inverse depth with 0 for pixels that saw nothing, so that they are infinitely far away.
std::vector<float> inverseDepth(const std::vector<float>& depth) {
  std::vector<float> inverse(depth.size());
  for (std::size_t i = 0; i < depth.size(); ++i) inverse[i] = depth[i] > 0.0f ? 1.0f / depth[i] : 0.0f;
  return inverse;
}

/// Removes pixels on too slanted surfaces. On a plane n p = h, with p = z (a, b, 1), inverse depth w = 1 / z is linear
/// in the ray's a and b, and its derivatives give n / h = (w_a, w_b, w - a w_a - b w_b). The incidence angle then
/// has cos = |h| / (|n| |p|).
void removeSlanted(const NoiseParams& params, const PinholeCamera& camera, std::vector<float>& depth) {
  const std::vector<float> inverse = inverseDepth(depth);
  const double cos_limit = std::cos(params.max_incidence_deg * kDegree);
  const float limit = static_cast<float>(1.0 / (cos_limit * cos_limit));
  for (int v = 0; v < camera.height; ++v) {
    const float b = static_cast<float>((v - camera.cy) / camera.fy);
    const std::size_t row = static_cast<std::size_t>(v) * camera.width;
    const float* here = &inverse[row];
    // At the image border, the pixel itself stands in for the neighbour that is not there.
    const float* above = v > 0 ? here - camera.width : here;
    const float* below = v + 1 < camera.height ? here + camera.width : here;
    for (int u = 0; u < camera.width; ++u) {
      const float w = here[u];
      const float a = static_cast<float>((u - camera.cx) / camera.fx);
      const float left = here[u > 0 ? u - 1 : u];
      const float right = here[u + 1 < camera.width ? u + 1 : u];
      const float w_a = steeper(w, left, right) * static_cast<float>(camera.fx);
      const float w_b = steeper(w, above[u], below[u]) * static_cast<float>(camera.fy);
      const float w_c = w - a * w_a - b * w_b;
      const float slant = (w_a * w_a + w_b * w_b + w_c * w_c) * (1.0f + a * a + b * b);
      if (slant > limit * w * w) depth[row + u] = kMissing;
    }
  }
}

void removeOutOfRange(const NoiseParams& params, std::vector<float>& depth) {
  const float min = static_cast<float>(params.min_depth);
  const float max = params.max_depth > 0.0 ? static_cast<float>(params.max_depth) : std::numeric_limits<float>::max();
  for (float& z : depth) {
    if (!(z > 0.0f && min <= z && z <= max)) z = kMissing;
  }
}

/// m, at depth z.
double sigmaAt(double z, const NoiseParams& params, double fx) {
  return params.disparity_noise > 0.0 ? params.disparity_noise * z * z / (fx * params.baseline) : axialSigma(z);
}

/// By how much the depth changes from pixel to pixel (m), to the neighbour that differs less where both saw something:
/// on the pixel's own surface but for what is a pixel wide. 0 at the image's border.
std::vector<float> stepsOf(const std::vector<float>& depth, const PinholeCamera& camera) {
  std::vector<float> steps(depth.size());
  const auto gentler = [&depth](std::size_t before, std::size_t i, std::size_t after) {
    // A neighbour that saw nothing, NaN, is not taken: fmin takes the other one.
    return std::fmin(std::abs(depth[i] - depth[before]), std::abs(depth[i] - depth[after]));
  };
  const auto width = static_cast<std::size_t>(camera.width);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const std::size_t u = i % width, v = i / width, last = static_cast<std::size_t>(camera.height) - 1;
    const float across = u > 0 && u + 1 < width ? gentler(i - 1, i, i + 1) : 0.0f;
    const float down = v > 0 && v < last ? gentler(i - width, i, i + width) : 0.0f;
    steps[i] = std::hypot(std::fmax(across, 0.0f), std::fmax(down, 0.0f));
  }
  return steps;
}

/// Where slanted surfaces have it, on top of the noise along the rays.
void addSidewaysNoise(const NoiseParams& params, const PinholeCamera& camera, std::uint64_t seed,
                      std::vector<float>& depth) {
  const std::vector<float> field = noiseField(params.grain, camera, seed), steps = stepsOf(depth, camera);
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] += static_cast<float>(params.sideways) * steps[i] * field[i];
}

void addAxialNoise(const NoiseParams& params, const PinholeCamera& camera, std::uint64_t seed,
                   std::vector<float>& depth) {
  const std::vector<float> field = noiseField(params.grain, camera, seed);
  const float factor = static_cast<float>(params.scale);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    depth[i] += factor * static_cast<float>(sigmaAt(depth[i], params, camera.fx)) * field[i];
  }
}

void quantize(const NoiseParams& params, double fx, std::vector<float>& depth) {
  for (float& z : depth) z = static_cast<float>(quantizedDepth(z, params, fx));
}

}  // namespace

double axialSigma(double z) { return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4); }

double quantizedDepth(double z, const NoiseParams& params, double fx) {
  const double depth_of_one_step = fx * params.baseline / params.disparity_step;
  // Rounded down after adding a half: a library call to round() would take most of the frame's time.
  const double steps = std::floor(depth_of_one_step / z + 0.5);
  return steps >= 1.0 ? depth_of_one_step / steps : std::numeric_limits<double>::quiet_NaN();
}

void addNoise(const NoiseParams& params, const PinholeCamera& camera, std::uint64_t seed, std::uint64_t frame_index,
              std::vector<float>& depth) {
  check(params, camera, depth);
  if (params.shadows) removeShadows(params.baseline, camera, depth);
  if (params.footprint > 1) mixNeighbors(params.footprint, camera, depth);
  if (params.max_incidence_deg < 90.0) removeSlanted(params, camera, depth);
  removeOutOfRange(params, depth);
  if (params.waves > 0.0) bend(params.waves, params.wave_length, camera, ~seed, depth);
  if (params.sideways > 0.0) addSidewaysNoise(params, camera, frameSeed(~seed, frame_index), depth);
  if (params.scale > 0.0) addAxialNoise(params, camera, frameSeed(seed, frame_index), depth);
  if (params.disparity_step > 0.0) quantize(params, camera.fx, depth);
  if (params.blots > 0.0) removeBlots(params.blots, params.blot_grain, camera, ~frameSeed(seed, frame_index), depth);
  removeOutOfRange(params, depth);
}

}  // namespace primitect::synthetic
