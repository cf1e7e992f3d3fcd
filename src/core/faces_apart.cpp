// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Connected cells; see faces_apart.h.
#include "core/faces_apart.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace primitect {
namespace {

/// In columns of cells.
struct Between {
  double left, right;
};

/// The part of a row within a convex outline, which is counter-clockwise.
Between within(const List<Vec2>& hull, double row) {
  constexpr double kRounding = 1e-6;
  Between span = {-INFINITY, INFINITY};
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec2& corner = hull[k];
    const Vec2 side = (hull[(k + 1) % hull.size()] - corner).normalized();
    const double left_of_it = side.x() * (row - corner.y()) + kRounding;  // less side.y() a column from the corner on
    if (side.y() > 0.0) span.right = std::min(span.right, corner.x() + left_of_it / side.y());
    if (side.y() < 0.0) span.left = std::max(span.left, corner.x() + left_of_it / side.y());
    if (side.y() == 0.0 && left_of_it < 0.0) return {INFINITY, -INFINITY};
  }
  return span;
}

}  // namespace

/// Of a plane that fills 640 x 480 pixels cells are 9 of them wide: there gaps of 17 pixels are seen wherever they are,
/// and faces of 19 are faces.
std::uint32_t FacesApart::edgeOfCells(const PixelBox& box) {
  constexpr double kMostCells = 4096.0;
  const double area = static_cast<double>(box.right - box.left + 1) * static_cast<double>(box.bottom - box.top + 1);
  return std::max(kFinest, static_cast<std::uint32_t>(std::ceil(std::sqrt(area / kMostCells))));
}

FacesApart::FacesApart(const PixelBox& box, std::uint32_t width) : FacesApart(box, width, edgeOfCells(box)) {}

FacesApart::FacesApart(const PixelBox& box, std::uint32_t width, std::uint32_t edge)
    : box_(box),
      width_(width),
      edge_(edge),
      columns_((box.right - box.left) / edge_ + 3),
      rows_((box.bottom - box.top) / edge_ + 3),
      points_(static_cast<std::size_t>(columns_) * rows_, 0) {}

FacesApart FacesApart::finer() const { return {box_, width_, std::max(kFinest, edge_ / 2)}; }

std::size_t FacesApart::cellAt(std::uint32_t column, std::uint32_t row) const {
  return static_cast<std::size_t>((row - box_.top) / edge_ + 1) * columns_ + (column - box_.left) / edge_ + 1;
}

void FacesApart::add(const LabelRun& run) {
  forRows(run, width_, [this](std::uint32_t row, std::uint32_t begin, std::uint32_t end) {
    count_ += end - begin;
    const std::size_t first = cellAt(begin, row), last = cellAt(end - 1, row);
    for (std::size_t cell = first; cell <= last; ++cell) points_[cell] += edge_;
    points_[first] -= (begin - box_.left) % edge_;
    points_[last] -= edge_ - 1 - (end - 1 - box_.left) % edge_;
  });
}

/// Those that share a side with it: a cell that is not at the border of all.
template <class Use>
void FacesApart::forNeighbors(std::size_t cell, const Use& use) const {
  use(cell - columns_), use(cell - 1), use(cell + 1), use(cell + columns_);
}

/// Cells that are part of the plane with all their neighbours: a row or two of pixels where another surface passes
/// through the plane do not join faces.
FacesApart::Cells FacesApart::coresOf(const Cells& part) const {
  Cells cores(part.size(), 0);
  const std::uint8_t* const here = part.data();
  for (std::size_t cell = columns_; cell + columns_ < part.size(); ++cell) {
    cores[cell] = here[cell] & here[cell - 1] & here[cell + 1] & here[cell - columns_] & here[cell + columns_];
  }
  return cores;
}

/// Cores that hang together are one piece: spans of a row are joined to those of the row before that they touch, which
/// takes a third of the time that going from cell to cell does.
void FacesApart::findPieces(const Cells& cores) {
  spans_.clear();
  std::size_t before = 0;  // first of the row above
  for (std::size_t row = 1; row + 1 < rows_; ++row) {
    const std::size_t first = spans_.size(), end = (row + 1) * columns_;
    std::size_t above = before;
    for (std::size_t cell = row * columns_; cell < end; ++cell) {
      if (!cores[cell]) continue;
      const std::size_t begin = cell;
      while (cores[cell]) ++cell;  // as far as the empty one at the end of the row
      const auto number = spans_.size();
      spans_.push_back({begin, cell, number, kNone});
      for (; above < first && spans_[above].end + columns_ <= begin; ++above) continue;
      for (std::size_t k = above; k < first && spans_[k].begin + columns_ < cell; ++k) {
        const std::size_t one = firstOf(k), other = firstOf(number);
        spans_[std::max(one, other)].joined = std::min(one, other);
      }
    }
    before = first;
  }
  numberPieces();
}

/// The first of the spans that this one is joined to.
std::size_t FacesApart::firstOf(std::size_t span) const {
  while (spans_[span].joined != span) span = spans_[span].joined;
  return span;
}

void FacesApart::numberPieces() {
  pieces_.clear();
  for (std::size_t k = 0; k < spans_.size(); ++k) {
    Span& span = spans_[k];
    const std::size_t first = firstOf(k);
    if (first == k) pieces_.push_back(0);
    span.piece = first == k ? static_cast<int>(pieces_.size()) - 1 : spans_[first].piece;
    pieces_[span.piece] = std::accumulate(points_.begin() + static_cast<std::ptrdiff_t>(span.begin),
                                          points_.begin() + static_cast<std::ptrdiff_t>(span.end), pieces_[span.piece]);
  }
}

/// Only where there are several.
void FacesApart::markCells() {
  piece_.assign(points_.size(), kNone);
  for (const Span& span : spans_) {
    std::fill(piece_.begin() + static_cast<std::ptrdiff_t>(span.begin),
              piece_.begin() + static_cast<std::ptrdiff_t>(span.end), span.piece);
  }
}

/// By cells around them, which are no cores as they lie at the border: from the corner of a square it is two steps to
/// its core. Not by more: a longer end may be where another surface passes through the plane, which fronts of boxes
/// would have along the table.
void FacesApart::growPieces() {
  struct Joining {
    std::size_t cell;
    int piece;
  };
  List<Joining> joining;
  for (std::size_t step = 0; step < kSteps; ++step) {
    joining.clear();
    for (std::size_t cell = columns_; cell + columns_ < points_.size(); ++cell) {
      if (points_[cell] == 0 || piece_[cell] != kNone) continue;
      int piece = kNone;
      forNeighbors(cell, [&](std::size_t other) { piece = std::max(piece, piece_[other]); });
      if (piece != kNone) joining.push_back({cell, piece});
    }
    for (const Joining& one : joining) {
      piece_[one.cell] = one.piece;
      pieces_[one.piece] += points_[one.cell];
    }
  }
}

bool FacesApart::areSeveral(std::size_t least) const {
  return std::count_if(pieces_.begin(), pieces_.end(), [least](std::size_t n) { return n >= least; }) > 1;
}

/// Of a few of its pixels at least half lie behind the plane: clearly, or on something else. That meets the plane, as
/// the table does at the foot of two fronts; seen from above it is not clearly behind for some rows.
bool FacesApart::isBehind(std::size_t cell, const LabelledImage& image, const Plane& plane) const {
  constexpr double kClearly = 2.0 * kInlierDeviations, kOnAnother = 1.0;  // standard deviations
  const double away = plane.normal.dot(plane.point) > 0.0 ? 1.0 : -1.0;   // from the sensor, along the normal
  const auto column = box_.left + static_cast<std::uint32_t>(cell % columns_ - 1) * edge_,
             row = box_.top + static_cast<std::uint32_t>(cell / columns_ - 1) * edge_;
  int measured = 0, behind = 0;
  for (const std::uint32_t down : {edge_ / 4, 3 * edge_ / 4}) {
    for (const std::uint32_t along : {edge_ / 4, 3 * edge_ / 4}) {
      if (row + down > box_.bottom || column + along > box_.right) continue;
      const std::size_t i = static_cast<std::size_t>(row + down) * width_ + column + along;
      if (image.far_is_behind && image.cloud.isBeyond(i)) ++measured, ++behind;
      if (!image.cloud.valid(i)) continue;
      const Vec3 point(image.cloud.x[i], image.cloud.y[i], image.cloud.z[i]);
      const double least = image.labels[i] > 0 ? kOnAnother : kClearly;
      ++measured;
      behind += away * distance(plane, point) > least * image.noise.at(point) ? 1 : 0;
    }
  }
  return behind > 0 && 2 * behind >= measured;
}

/// Around all cells with points, in columns and rows of cells.
List<Vec2> FacesApart::outline() const {
  List<Vec2> ends;
  for (std::uint32_t row = 0; row < rows_; ++row) {
    const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(row) * columns_, end = begin + columns_;
    const auto holds = [](std::uint32_t n) { return n > 0; };
    const auto first = std::find_if(begin, end, holds);
    if (first == end) continue;
    const auto last = std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(begin), holds);
    ends.emplace_back(first - begin, row);
    ends.emplace_back(last.base() - begin - 1, row);
  }
  return convexHull(ends, 0.0);
}

/// Beside the outline another surface may be nearer than the plane without hiding it, as the table before the fronts of
/// two boxes.
FacesApart::Cells FacesApart::cellsInside(const List<Vec2>& outline) const {
  Cells inside(points_.size(), 0);
  for (std::uint32_t row = 1; row + 1 < rows_; ++row) {
    const Between span = within(outline, row);
    for (double column = std::ceil(std::max(span.left, 1.0)); column <= std::min(span.right, columns_ - 2.0);
         ++column) {
      inside[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)] = 1;
    }
  }
  return inside;
}

/// As far from the box around a piece as that is long, and as a piece grows: two that are farther from each other than
/// both together are long, as two lids with a crate before all that is between them, do not tell of a face that leads
/// from one to the other.
FacesApart::Cells FacesApart::cellsInReach() const {
  Cells reached(points_.size(), 0);
  for (const CellBox& box : boxesOfPieces()) {
    const std::size_t reach = std::max(box.right - box.left, box.bottom - box.top) + 1 + kSteps;
    const std::size_t left = box.left - std::min(box.left, reach), top = box.top - std::min(box.top, reach);
    const auto right = std::min<std::size_t>(box.right + reach, columns_ - 1);
    const auto bottom = std::min<std::size_t>(box.bottom + reach, rows_ - 1);
    for (std::size_t row = top; row <= bottom; ++row) {
      std::fill_n(reached.begin() + static_cast<std::ptrdiff_t>(row * columns_ + left), right - left + 1, 1);
    }
  }
  return reached;
}

List<FacesApart::CellBox> FacesApart::boxesOfPieces() const {
  List<CellBox> boxes(pieces_.size(), CellBox{columns_, 0, rows_, 0});
  for (const Span& span : spans_) {
    CellBox& box = boxes[static_cast<std::size_t>(span.piece)];
    const std::size_t row = span.begin / columns_;
    box.left = std::min(box.left, span.begin % columns_);
    box.right = std::max(box.right, (span.end - 1) % columns_);
    box.top = std::min(box.top, row);
    box.bottom = std::max(box.bottom, row);
  }
  return boxes;
}

void FacesApart::find(const LabelledImage& image, const Plane& plane, std::size_t least) {
  constexpr std::size_t kOfCores = 13;  // a single core and the cells that are at most two steps away
  faces_.clear();
  Cells part(points_.size());
  for (std::size_t cell = 0; cell < part.size(); ++cell) part[cell] = points_[cell] > 0 ? 1 : 0;
  findPieces(coresOf(part));
  left_ = count_ - std::accumulate(pieces_.begin(), pieces_.end(), std::size_t{0});
  if (!areSeveral(least / kOfCores)) return;
  const Cells inside = cellsInside(outline()), reached = cellsInReach();
  for (std::size_t cell = 0; cell < part.size(); ++cell) {
    if (!part[cell] && inside[cell] && reached[cell] && !isBehind(cell, image, plane)) part[cell] = 1;
  }
  findPieces(coresOf(part));
  markCells();
  growPieces();
  if (!areSeveral(least)) return;
  List<std::size_t> order(pieces_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return pieces_[a] != pieces_[b] ? pieces_[a] > pieces_[b] : a < b;
  });
  face_of_piece_.assign(pieces_.size(), kNone);
  for (const std::size_t piece : order) {
    if (pieces_[piece] < least) break;
    face_of_piece_[piece] = static_cast<int>(faces_.size());
    faces_.push_back(pieces_[piece]);
  }
  left_ = count_ - std::accumulate(faces_.begin(), faces_.end(), std::size_t{0});
}

double FacesApart::left() const { return static_cast<double>(left_) / static_cast<double>(count_); }

int FacesApart::faceAt(std::uint32_t pixel) const {
  if (faces_.size() < 2) return kNone;
  const int piece = piece_[cellAt(pixel % width_, pixel / width_)];
  return piece == kNone ? kNone : face_of_piece_[piece];
}

}  // namespace primitect
