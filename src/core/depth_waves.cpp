// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Squares of second differences between cells, by their distance (cf. the variogram of Matheron, 1963); see
// depth_waves.h.
#include "core/depth_waves.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/float_range.h"
#include "core/frame_memory.h"

namespace primitect {
namespace {

/// Points of one cell of the image: relative errors of their depths.
struct ImageCell {
  float count = 0.0f, sum = 0.0f, squares = 0.0f;

  bool tells() const { return count >= 2.0f; }
  double mean() const { return sum / count; }
  /// Of the mean, by the noise of its points.
  double variance() const { return (squares - sum * mean()) / (count - 1.0f) / count; }
};

/// Where points are seen (x / z, y / z), and 1 / z, which of a plane is linear in these.
struct InverseDepths {
  List<float> u, v, inverse;

  explicit InverseDepths(const SeenPoints& points) {
    for (List<float>* values : {&u, &v, &inverse}) values->resize(points.size());
    const Eigen::Vector3f origin = points.origin.cast<float>();
    for (std::size_t k = 0; k < points.size(); ++k) {
      inverse[k] = 1.0f / (origin.z() + points.z[k]);
      u[k] = (origin.x() + points.x[k]) * inverse[k];
      v[k] = (origin.y() + points.y[k]) * inverse[k];
    }
  }
};

/// Relative errors of the depths, from the plane for which their squares are least.
List<float> errorsOf(const InverseDepths& p, float middle_u, float middle_v) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const auto rowOf = [&](std::size_t k) -> Eigen::Vector3f {
    return Eigen::Vector3f(p.u[k] - middle_u, p.v[k] - middle_v, 1.0f) / p.inverse[k];
  };
  for (std::size_t k = 0; k < p.u.size(); ++k) {
    const Eigen::Vector3d row = rowOf(k).cast<double>();
    normal += row * row.transpose();
    right += row;
  }
  const Eigen::Vector3f plane = normal.ldlt().solve(right).cast<float>();
  List<float> errors(p.u.size());
  for (std::size_t k = 0; k < errors.size(); ++k) errors[k] = plane.dot(rowOf(k)) - 1.0f;
  return errors;
}

/// Cells of the image of one plane.
class ImageCells {
 public:
  ImageCells(const InverseDepths& p, const FloatRange& u, const FloatRange& v, float edge)
      : columns_(static_cast<int>((u.high - u.low) / edge) + 1),
        rows_(static_cast<int>((v.high - v.low) / edge) + 1),
        cells_(static_cast<std::size_t>(columns_ * rows_)) {
    const List<float> errors = errorsOf(p, 0.5f * (u.low + u.high), 0.5f * (v.low + v.high));
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const int column = static_cast<int>((p.u[k] - u.low) / edge), row = static_cast<int>((p.v[k] - v.low) / edge);
      ImageCell& cell = cells_[static_cast<std::size_t>(row * columns_ + column)];
      cell.count += 1.0f, cell.sum += errors[k], cell.squares += errors[k] * errors[k];
    }
  }

  int telling() const {
    return static_cast<int>(std::count_if(cells_.begin(), cells_.end(), [](const ImageCell& c) { return c.tells(); }));
  }

  /// Calls use(before, cell, after) for all three in a row or a column that tell and are so many cells apart.
  template <class Use>
  void forThree(int apart, const Use& use) const {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        if (column >= apart && column + apart < columns_) useThree(column, row, apart, 0, use);
        if (row >= apart && row + apart < rows_) useThree(column, row, 0, apart, use);
      }
    }
  }

 private:
  const ImageCell& at(int column, int row) const { return cells_[static_cast<std::size_t>(row * columns_ + column)]; }

  template <class Use>
  void useThree(int column, int row, int right, int down, const Use& use) const {
    const ImageCell &before = at(column - right, row - down), &after = at(column + right, row + down);
    if (before.tells() && at(column, row).tells() && after.tells()) use(before, at(column, row), after);
  }

  int columns_, rows_;
  List<ImageCell> cells_;
};

constexpr double kAlone = 6.0;  // mean square of a bend, of independent errors with variance 1

}  // namespace

/// Mean squares of bends of cells so far apart, of each unknown with variance 1.
WaveFinder::Numbers WaveFinder::bendsAt(double apart) {
  Numbers bends;
  for (std::size_t k = 0; k + 1 < kUnknowns; ++k) {
    const auto alikeAt = [k](double distance) {
      return DepthWaves::alike(DepthWaves::kReaches[k], distance * distance);
    };
    bends[k] = kAlone - 8.0 * alikeAt(apart) + 2.0 * alikeAt(2.0 * apart);
  }
  bends[kUnknowns - 1] = kAlone;
  return bends;
}

void WaveFinder::see(const SeenPoints& plane) {
  constexpr std::size_t kFewestPoints = 256;
  constexpr float kSmallestCell = 0.03f, kPointsInCell = 4.0f;  // 16 pixels of a usual camera
  constexpr float kLargestImage = 6.0f;                         // of x / z, more than any camera's
  constexpr int kFewestCells = 40;
  if (plane.size() < kFewestPoints) return;
  const InverseDepths p(plane);
  const FloatRange u(p.u.data(), p.u.size()), v(p.v.data(), p.v.size());
  const float width = u.high - u.low, height = v.high - v.low;
  if (!(width < kLargestImage && height < kLargestImage)) return;
  const float edge =
      std::max(kSmallestCell, std::sqrt(kPointsInCell * width * height / static_cast<float>(plane.size())));
  if (width * height < kFewestCells * edge * edge) return;
  const ImageCells cells(p, u, v, edge);
  if (cells.telling() < kFewestCells) return;
  for (const int apart : {1, 2, 3, 4, 6, 8, 12}) {
    double weights = 0.0, squares = 0.0, chance = 0.0;
    cells.forThree(apart, [&](const ImageCell& before, const ImageCell& cell, const ImageCell& after) {
      const double weight = 1.0 / (1.0 / before.count + 4.0 / cell.count + 1.0 / after.count);
      const double bend = before.mean() - 2.0 * cell.mean() + after.mean();
      const double noise = before.variance() + 4.0 * cell.variance() + after.variance();
      weights += weight;
      squares += weight * (bend * bend - noise);
      chance += 2.0 * weight * weight * noise * noise;
    });
    const Numbers bends = bendsAt(apart * static_cast<double>(edge));
    normal_ += weights * bends * bends.transpose();
    right_ += squares * bends;
    chance_ += chance * bends * bends.transpose();
  }
}

/// Whether waves of this field alone would be more than chance makes, beside errors that only the points of a cell
/// share, as they do in grains.
bool WaveFinder::isSure(std::size_t field) const {
  // Bends have cells in common, and the noise of these is known from a few points each. With 4 none of 250 frames of
  // tables, households and halls without waves has some (seeds 300 and following; with 3 nine), and all of 40 tables
  // that a stereo camera sees.
  constexpr double kDeviations = 4.0;
  Numbers contrast = Numbers::Zero();
  contrast[field] = 1.0;
  contrast[kUnknowns - 1] = -normal_(field, kUnknowns - 1) / normal_(kUnknowns - 1, kUnknowns - 1);
  return contrast.dot(right_) > kDeviations * std::sqrt(contrast.dot(chance_ * contrast));
}

/// Least squares without negative variances: of all choices of unknowns the best one that has none.
DepthWaves WaveFinder::waves() const {
  DepthWaves waves;
  bool sure = false;
  for (std::size_t field = 0; field + 1 < kUnknowns; ++field) sure = sure || isSure(field);
  if (!sure) return waves;
  double most = 0.0;  // by how much the squares get less
  for (unsigned chosen = 1; chosen < 1u << kUnknowns; ++chosen) {
    Square normal = normal_;
    Numbers right = right_;
    for (std::size_t k = 0; k < kUnknowns; ++k) {
      if (chosen >> k & 1u) continue;
      normal.row(k).setZero(), normal.col(k).setZero();
      normal(k, k) = 1.0, right[k] = 0.0;
    }
    const Numbers variances = normal.ldlt().solve(right);
    if (!(variances.minCoeff() >= 0.0 && variances.dot(right) > most)) continue;
    most = variances.dot(right);
    std::copy_n(variances.data(), waves.variances.size(), waves.variances.begin());
  }
  return waves;
}

}  // namespace primitect
