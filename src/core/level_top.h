// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The tops of several things, where one plane leads over all of them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

#include "core/frame_memory.h"
#include "core/point_noise.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Takes a plane apart by height where the samples could not: they were too few, or too noisy to tell heights that
/// thousands of points tell apart. A connected piece of its points that lies level about as well as it lies in the
/// plane is a top; then the plane is tilted only because it reaches to pieces a little higher or lower, or to clutter.
class LevelTops {
 public:
  /// points: rising indices in the cloud; level: the normal of what things stand on.
  LevelTops(const Cloud& cloud, const Plane& plane, const Vec3& level, const PointNoise& sigma,
            const List<std::uint32_t>& points);

  /// All pieces of one height.
  struct Top {
    Plane plane;            ///< level
    std::size_t count = 0;  ///< of its points
  };
  /// First that of the piece with the most level points. None where the plane is steep, really is tilted, or has all of
  /// its points at one height.
  const List<Top>& tops() const { return tops_; }

  static constexpr int kNone = -1;
  /// Index of the top that a point of the plane, one that was given or another, belongs to; kNone: it is clutter.
  int topAt(const Vec3& point) const;

 private:
  /// Square cells over the plane, with a few points in each.
  struct Grid {
    int cells;  ///< along each side
    Vec3 across, down;
    Eigen::Vector2d low, per_meter;

    Grid(const Cloud& cloud, const Plane& plane, const List<std::uint32_t>& points);
    int cellAt(const Vec3& point) const;
  };
  struct Piece {
    List<std::uint32_t> points;
    Vec3 mean = Vec3::Zero();
    double misfit = 0.0;  ///< where it lies level
    double uneven = 0.0;  ///< its unevenness there
    int top = kNone;
  };

  template <class Use>
  void forCellsAround(int cell, const Use& use) const;
  void findPieces(const Cloud& cloud, const List<std::uint32_t>& points);
  void measurePieces(const Cloud& cloud, const Vec3& level, const PointNoise& sigma);
  const Piece* mostLevel(double most_uneven) const;
  void gatherTop(const Cloud& cloud, const Plane& at, const PointNoise& sigma);

  Grid grid_;
  List<int> piece_of_cell_;
  List<Piece> pieces_;
  List<Top> tops_;
};

}  // namespace primitect
