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
  /// The cloud to work on, until the next call: what a filter made of a depth camera's image gets its image back; rows
  /// far apart, as of a laser scanner, fewer than five of them, or what was seen from elsewhere are no image, and their
  /// points are taken as they are. What brings normals of its own stays an image or a list.
  const Cloud& of(const Cloud& cloud, bool brings_normals);

  /// False when the points contradict it; of lists with normals only what lies behind the sensor does.
  bool seenFromOrigin() const { return !seen_elsewhere_; }

  /// Of the cloud, where it was found to be an image.
  const std::optional<ImageRays>& rays() const { return rays_; }

  /// The image that the cloud was; null where it is worked on as anything else.
  const ProjectedImage* projected() const { return is_projected_ ? &projected_ : nullptr; }

 private:
  const Cloud& asList(const Cloud& cloud);
  const Cloud& withoutImage(const Cloud& cloud);

  ProjectedImage projected_;
  Cloud list_;
  std::optional<ImageRays> rays_;
  bool is_projected_ = false, seen_elsewhere_ = false;
};

/// Its points, at least one, are where a depth camera may have measured them: organized, in front of the sensor, and
/// not so far away that what is known of its noise would allow everything.
bool mayBeOfDepthCamera(const Cloud& cloud);

}  // namespace primitect
