// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which points of a detection nothing else can have brought there: those that its last fit and its covariance rest on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/false_border.h"
#include "core/frame_memory.h"
#include "core/noise.h"
#include "core/observed_part.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// How normals that the cloud brings are taken.
struct CloudNormals {
  bool taken = true;           ///< false: as if there were none
  bool towards_sensor = true;  ///< turned to the origin first
};

/// With fewer points a fit would lose more than it is spoilt by the others.
bool enoughClear(std::size_t clear, std::size_t all);

/// Of one frame. Labels go by distance alone: within the noise of a shape lie also points of what it touches, and where
/// two shapes meet, noise decides to which a point is given. Few as they are, such points all err to the same side, and
/// thousands of others do not average that away.
class ClearPoints {
 public:
  /// All must stay; `labels` are those of the detections, as markFarSides() (far_sides.h) leaves them, `has_far_side`
  /// what it says of each detection; empty: none has one. kept: which detections others are kept apart from; empty:
  /// all. cut: points at other depths are missing.
  ClearPoints(const Cloud& cloud, const CloudNormals& normals, const std::vector<Detection>& detections,
              const List<bool>& kept, const std::vector<std::uint32_t>& labels, List<bool> has_far_side,
              const NoiseModel& noise, const DepthRange& cut = {});

  /// Those of a detection's points (indices in the cloud)
  ///   depth camera         with no other label on a ring of eight pixels of its image, as far away as the noise
  ///                        reaches, and not on the rim of a wall whose inside is seen, too; nor where the surface is
  ///                        so near the cut that only points which noise moved away from it are left
  ///   any other cloud      whose place on the surface is far from all other detections, beyond the noise,
  ///                        and from where their axes may go on, and whose own normal, if it has one, is about the
  ///                        surface's
  /// all of them where too few would be left.
  List<std::uint32_t> of(std::size_t detection, const List<std::uint32_t>& points) const;

  /// Those of a detection's clear points that lie on the curved shape which was fitted to them, in an image of a depth
  /// camera: without the border where it proves to be another surface's (false_border.h). All of them where these are
  /// few, or too few would be left. What holds for every fit is found once, which takes 1 to 3 % of a recorded frame's
  /// instructions less.
  class OnSurface {
   public:
    /// clear: what of() finds of this detection; it and what found it must stay.
    OnSurface(const ClearPoints& finder, std::size_t detection, const List<std::uint32_t>& clear);

    List<std::uint32_t> operator()(const Shape& fit);

   private:
    LabelledShape labelled() const;
    bool mayHaveFalseBorder(const Shape& fit);

    const ClearPoints& finder_;
    std::uint32_t label_;
    const List<std::uint32_t>& clear_;
    std::optional<FalseBorder> of_some_, of_all_;
  };

 private:
  bool mayEndBeside(const List<std::uint32_t>& points) const;
  bool endsBeside(const Shape& shape, std::uint32_t point) const;
  bool inImage() const { return noise_.ofDepthCamera() && cloud_.organized(); }
  List<std::uint32_t> surrounded(std::uint32_t label, const List<std::uint32_t>& points) const;
  List<std::uint32_t> apart(std::size_t detection, const List<std::uint32_t>& points) const;

  const Cloud& cloud_;
  CloudNormals normals_;
  const std::vector<Detection>& detections_;
  const std::vector<std::uint32_t>& labels_;
  NoiseModel noise_;
  DepthRange cut_;
  List<bool> has_far_side_;          ///< of each detection; or empty
  List<std::uint32_t> others_;       ///< kept detections of any other cloud
  List<kernels::FlatShape> shapes_;  ///< the same
  List<ObservedPart> parts_;         ///< the same
};

}  // namespace primitect
