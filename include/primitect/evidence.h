// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What speaks for and against a shape.
#pragma once

namespace primitect {

/// Numbers that tell a surface that ends where the shape does from a part of another surface that merely looks alike.
struct Evidence {
  float inliers = 0.0f;          ///< samples that the shape owns; in a crowded image each counts for up to two
  float gain = 0.0f;             ///< mean gain of these, at most 1: how well distances and normals fit
  float against = 0.0f;          ///< losses at samples near it that do not fit and that nothing explains, per inlier
  float runs_on = 0.0f;          ///< border where the surface runs on smoothly into nothing known, 1 = that of a disk
  float runs_into = 0.0f;        ///< the same into another shape
  float border_residual = 0.0f;  ///< mean |distance| along that border in standard deviations; noise alone: 0.8
  float turn = 0.0f;             ///< 1 - |mean normal|: 0 of a plane, 0.5 of half a sphere
  float lead = 0.0f;             ///< score over that of the best other kind tried, per inlier, at most 1; planes: 0
  float own_noise = 0.0f;        ///< 1: the noise is the cloud's own; 0: it is that of depth cameras
  float stands = 0.0f;           ///< [0, 1], how far a cylinder or cone stands on a plane or has one for its top
};

}  // namespace primitect
