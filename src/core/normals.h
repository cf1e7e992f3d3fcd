// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals of the samples: the cloud's own, or a plane fit to the image window or to the nearest neighbours.
#pragma once

#include <memory>
#include <optional>

#include "core/frame_memory.h"
#include "core/neighbors.h"
#include "core/samples.h"
#include "core/window_normal.h"
#include "primitect/cloud.h"
#include "primitect/params.h"

namespace primitect {

/// What normals are measured with, made when it is needed and kept for the frame.
struct NormalSource {
  std::unique_ptr<NeighborSearch> neighbors;
  std::optional<ImageRays> rays;    ///< of the organized cloud
  std::optional<PixelPitch> pitch;  ///< the same
  bool from_origin = false;         ///< the cloud was seen by a sensor there
  double noise_scale = 1.0;         ///< of the image, times axialNoise()
  double grain = 1.0;               ///< grainOf() the image
  double usual_grain = 1.0;         ///< usualGrainOf() it
  double steadying = 0.0;           ///< steadyingOf() it
  int neighbor_count =
      0;  ///< above 0: measured anew from so many neighbours, instead of the cloud's own or normal_neighbors

  void reset() { *this = {}; }
};

/// Found once a frame.
const ImageRays& raysOf(const Cloud& cloud, NormalSource& source);

/// The same, of an organized cloud.
const PixelPitch& pixelPitch(const Cloud& image, NormalSource& source);

/// The cloud is the image of a depth camera at the origin.
bool isDepthImage(const Cloud& cloud);

/// How many neighbours make a normal this good (rad, about each axis) of points with this noise (m): the slope of a
/// plane through k points, evenly spread around at this mean distance d of neighbours, has the deviation 2 sqrt(pi)
/// sigma / (k d).
int neighborsFor(const Cloud& cloud, const Samples& samples, double sigma, double wanted, NormalSource& source);

/// Fills the normals of the samples: from the cloud where it brings any that are usable, else from the image window,
/// else from the nearest neighbours. Measured normals point towards the sensor; with source.neighbor_count to the side
/// of those that the cloud brings, where these are not to be turned. Where none can be had, or only one
/// perpendicular to the ray of a sensor at the origin (source.from_origin), it stays missing, and that sample does not
/// vote. Samples with a window of a noisy image move (source.steadying): once a draw.
void estimateNormals(const Cloud& cloud, const Params& params, NormalSource& source, Samples& samples);

/// Three quarters of the normals or more: of whole objects, seen through, little more than half do.
bool mostFaceAway(const Samples& samples);

/// Normal of the plane through the points (least squares), sign not known; nothing when they do not span a plane.
std::optional<Vec3> planeNormal(const Cloud& cloud, const List<std::uint32_t>& points);

}  // namespace primitect
