// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// As what a cloud is worked on: as the image or list that it is, as the image that it was, or as a list of its points.
#pragma once

#include <optional>

#include "core/image_rays.h"
#include "core/projected_image.h"
#include "primitect/cloud.h"

namespace primitect {

/// Of one frame after the other. Keeps its memory.
class Arrangement {
 public:
  /// The cloud to work on, valid until the next call:
  /// - itself, where it is the image of a camera at the origin, or a list that was none; of an image without the few
  ///   points (Cloud::liesBehind()) that lie where such a camera measures nothing;
  /// - the image that its points were seen in, where a filter left a list or a sparse image of it, unless the cloud
  ///   brings normals of its own, which such an image does not hold;
  /// - else its points as a list: of rows far apart, as of a laser scanner, of fewer than five rows or columns, and of
  ///   what was not seen from the origin.
  const Cloud& of(const Cloud& cloud, bool brings_normals);

  /// False when the points contradict it; of lists with normals only what lies behind the sensor does.
  bool seenFromOrigin() const { return seen_from_origin_; }

  /// Of the cloud, where it was found to be an image.
  const std::optional<ImageRays>& rays() const { return rays_; }

  /// What is worked on is the image that was found for a list, but its pixels are not those of the camera.
  bool isApproximate() const { return is_projected_ && !projected_.isExact(); }

  /// That image has a pixel for each of the list's points.
  bool holdsAllPoints() const { return is_projected_ && projected_.image().valid_count == projected_.pointCount(); }

  /// The image that the cloud was; null where it is worked on as anything else.
  const ProjectedImage* projected() const { return is_projected_ ? &projected_ : nullptr; }

 private:
  const Cloud& withoutStrays(const Cloud& cloud);
  const Cloud& asList(const Cloud& cloud);
  /// Of a cloud that is no image as it is: the image that its points were seen in, or a list where there is none.
  const Cloud& projectedOrList(const Cloud& cloud);

  ProjectedImage projected_;
  Cloud list_, in_front_;
  std::optional<ImageRays> rays_;
  bool is_projected_ = false, seen_from_origin_ = true;
};

/// Its points, at least one, are where a depth camera may have measured them: organized, in front of the sensor, and
/// not so far away that what is known of its noise would allow everything.
bool mayBeOfDepthCamera(const Cloud& cloud);

}  // namespace primitect
