// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces that lie in one plane, apart from each other: a depth camera sees between them what is behind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/frame_memory.h"
#include "core/hull.h"
#include "core/label_runs.h"
#include "core/noise.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// The image of a depth camera at the origin, and what its points belong to (0: to nothing).
struct LabelledImage {
  const Cloud& cloud;
  const std::vector<std::uint32_t>& labels;
  const NoiseModel& noise;
  /// What lies beyond the far bound of the depth lies behind the plane that is asked for: that comes nowhere near it.
  bool far_is_behind;
};

/// The points of one plane in an image, in square cells of some pixels. Faces are one where they touch over three
/// cells, and where they may go on behind what hides them, or where nothing was measured; not where what lies behind
/// the plane is seen between them, nor where the gap is wider than both together are long. What is less than three
/// cells wide is no face, nor is the end of one.
class FacesApart {
 public:
  /// Of a plane whose points lie in this box: cells as small as takes little time.
  FacesApart(const PixelBox& box, std::uint32_t width);

  /// The same without points, in cells half as wide.
  FacesApart finer() const;
  bool finest() const { return edge_ <= kFinest; }

  /// Points of the plane: all of them, before anything is asked.
  void add(const LabelRun& run);

  /// Of all that was added (pixels).
  std::size_t count() const { return count_; }

  /// Looks for the faces of at least `least` pixels.
  void find(const LabelledImage& image, const Plane& plane, std::size_t least);

  /// Pixels of each face, the most first; less than two: the plane is not to be taken apart.
  const List<std::size_t>& faces() const { return faces_; }

  /// Share of the pixels that are of no face, where there are several; else of those that are in cells at a border: of
  /// strips all may be.
  double left() const;

  static constexpr int kNone = -1;
  /// Index of the face that a pixel of the plane belongs to, where it has several; kNone: to none.
  int faceAt(std::uint32_t pixel) const;

 private:
  static constexpr std::uint32_t kFinest = 2;  ///< edge of the smallest cells (px)
  using Cells = List<std::uint8_t>;            ///< 1: it is one of them
  /// Cells [begin, end) of one row that are cores.
  struct Span {
    std::size_t begin, end;
    std::size_t joined;  ///< an earlier span of the same piece, or itself
    int piece;
  };

  /// Of cells, all of them within.
  struct CellBox {
    std::size_t left, right, top, bottom;
  };

  static constexpr std::size_t kSteps = 2;  ///< that a piece grows by (cells)

  FacesApart(const PixelBox& box, std::uint32_t width, std::uint32_t edge);
  static std::uint32_t edgeOfCells(const PixelBox& box);
  std::size_t cellAt(std::uint32_t column, std::uint32_t row) const;
  template <class Use>
  void forNeighbors(std::size_t cell, const Use& use) const;
  Cells coresOf(const Cells& part) const;
  void findPieces(const Cells& cores);
  std::size_t firstOf(std::size_t span) const;
  void numberPieces();
  void markCells();
  void growPieces();
  bool areSeveral(std::size_t least) const;
  bool isBehind(std::size_t cell, const LabelledImage& image, const Plane& plane) const;
  List<Vec2> outline() const;
  Cells cellsInside(const List<Vec2>& outline) const;
  List<CellBox> boxesOfPieces() const;
  Cells cellsInReach() const;

  PixelBox box_;
  std::uint32_t width_;           ///< of the image (px)
  std::uint32_t edge_;            ///< of a cell (px)
  std::uint32_t columns_, rows_;  ///< of cells, with an empty one at either end
  std::size_t count_ = 0;
  List<std::uint32_t> points_;  ///< of each cell (pixels)
  List<Span> spans_;
  List<int> piece_;           ///< of each cell; kNone: it is no part of any
  List<std::size_t> pieces_;  ///< pixels of each
  List<int> face_of_piece_;
  List<std::size_t> faces_;
  std::size_t left_ = 0;  ///< pixels
};

}  // namespace primitect
