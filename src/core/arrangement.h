// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// As what a cloud is worked on: as the image or list that it is, as the image that it was, or as a list of its points.
#pragma once

#include "core/projected_image.h"
#include "primitect/cloud.h"

namespace primitect {

/// Of one frame after the other. Keeps its memory.
class Arrangement {
 public:
  /// The cloud to work on, until the next call: what a filter made of a depth camera's image gets its image back; rows
  /// far apart, as of a laser scanner, or fewer than five of them, are no image, and their points are taken as they
  /// are. What brings normals of its own stays an image or a list.
  const Cloud& of(const Cloud& cloud, bool brings_normals);

  /// The image that the cloud was; null where it is worked on as anything else.
  const ProjectedImage* projected() const { return is_projected_ ? &projected_ : nullptr; }

 private:
  const Cloud& asList(const Cloud& cloud);

  ProjectedImage projected_;
  Cloud list_;
  bool is_projected_ = false;
};

/// Its points, at least one, are where a depth camera may have measured them: organized, in front of the sensor, and
/// not so far away that what is known of its noise would allow everything.
bool mayBeOfDepthCamera(const Cloud& cloud);

}  // namespace primitect
