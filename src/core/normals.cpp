// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where each sample's normal comes from; see normals.h.
#include "core/normals.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/flying_pixels.h"
#include "core/lower_quartile.h"
#include "core/neighbors.h"
#include "core/noise.h"
#include "core/ramp.h"

namespace primitect {
namespace {

void orientTowardsSensor(const Vec3& point, Vec3& normal) {
  if (normal.dot(point) > 0.0) normal = -normal;
}

void store(const Vec3& normal, std::size_t i, Samples& samples) {
  samples.nx[i] = static_cast<float>(normal.x());
  samples.ny[i] = static_cast<float>(normal.y());
  samples.nz[i] = static_cast<float>(normal.z());
}

void placePoint(const Vec3& point, std::size_t i, Samples& samples) {
  samples.x[i] = static_cast<float>(point.x());
  samples.y[i] = static_cast<float>(point.y());
  samples.z[i] = static_cast<float>(point.z());
}

void placeNormal(const Vec3& place, std::size_t i, Samples& samples) {
  samples.px[i] = static_cast<float>(place.x());
  samples.py[i] = static_cast<float>(place.y());
  samples.pz[i] = static_cast<float>(place.z());
}

void takeCloudNormals(const Cloud& cloud, bool orient, Samples& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t k = samples.index[i];
    Vec3 normal(cloud.nx[k], cloud.ny[k], cloud.nz[k]);
    if (orient) orientTowardsSensor(samples.point(i), normal);
    store(normal, i, samples);
  }
}

bool anyNormal(const Samples& samples) {
  return std::any_of(samples.nx.begin(), samples.nx.end(), [](float nx) { return nx == nx; });
}

/// Half widths of the windows that normals are fitted to.
class WindowSizes {
 public:
  /// at_one_meter: px, of usual images
  WindowSizes(int at_one_meter, const ImageRays& rays, const NormalSource& source)
      : pitch_(rays.known ? std::abs(rays.x_scale) : 0.0), noise_per_turn_(noisePerTurn(source)) {
    constexpr double kSmallestWindow = 3.0, kFewestPixels = 2.0;
    const double share = shareOfUsualWindows(rays);
    // Twice the half width and one is the width.
    at_one_meter_ = share * (at_one_meter + 0.5) - 0.5;
    smallest_ = std::max(std::min(share * kSmallestWindow, at_one_meter_), kFewestPixels);
    // Never larger than 1.5 times the value at 1 m: nearer than that the noise no longer asks for it.
    largest_ = std::max(smallest_, std::floor(1.5 * at_one_meter_));
  }

  /// At this depth (m).
  int at(double depth) const {
    const double usual = std::clamp(at_one_meter_ / depth, smallest_, largest_);
    return static_cast<int>(std::lround(std::max(usual, std::min(forGrains(depth), kLargestForGrains))));
  }

 private:
  static constexpr double kLargestForGrains = 20.0;  // px

  /// Of noise that neighbours share a window holds less that is independent. The noise in standard deviations of
  /// axialNoise(), times its grain, divided by the turn of normals (rad) that it may cause; 0: it has no grain.
  static double noisePerTurn(const NormalSource& source) {
    // Of 200 draws of a recorded checkerboard, up to 2 m away, none carries a curved shape. With 0.07 instead of 0.055
    // clutter whose noise five pixels share (compare --set clutter --noise-grain 5 --seeds 3000:60) is 82.3 / 99.4 %
    // right and found instead of 83.5 / 99.1, tables (2700:60) 96.9 / 96.6 instead of 97.3 / 96.9.
    constexpr double kMostTurn = 0.15, kMostUsualTurn = 0.055;  // one standard deviation
    const double grainy = source.grain > 1.0 ? source.grain / kMostTurn : 0.0;
    const double usual = source.usual_grain > 1.0 ? source.usual_grain / kMostUsualTurn : 0.0;
    return source.noise_scale * std::max(grainy, usual);
  }

  /// Larger where as much noise as is tolerated would turn the normals too far. Over w^2 pixels the slope has the
  /// deviation sqrt(12) sigma grain / (pitch z w^2). Where the pitch is not known windows are as usual.
  double forGrains(double depth) const {
    if (pitch_ == 0.0) return 0.0;
    return 0.5 * (std::sqrt(std::sqrt(12.0) * noise_per_turn_ * axialNoise(depth) / (pitch_ * depth)) - 1.0);
  }

  double pitch_, noise_per_turn_;
  double at_one_meter_, smallest_, largest_;
};

void fitWindows(const Cloud& image, const Params& params, NormalSource& source, Samples& samples) {
  // With all of the grain of a block matcher, 7, precision on the tables that it sees is less by 3 %.
  constexpr double kMostSaid = 3.0;
  // Where normals are good, too, it would cost some shapes (compare --set tabletop
  // --seeds 2300:40: 98.2 / 97.9 -> 97.9 / 96.9 with 2 everywhere).
  constexpr double kGood = 0.02, kPoor = 0.04;  // rad
  const ImageRays& rays = raysOf(image, source);
  const PixelPitch& pitch = pixelPitch(image, source);
  const WindowSizes sizes(params.normal_window, rays, source);
  const ImageOfCamera camera = {image, rays, source.noise_scale, shareOfUsualWindows(rays)};
  const double grain = std::min(source.grain, kMostSaid);
  const bool find_flying = params.does(Step::flying_pixels);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t pixel = samples.index[i];
    const Vec3 point = samples.point(i);
    const auto normal =
        windowNormal(image, pixel, point, sizes.at(point.z()), pitch, source.noise_scale, source.steadying);
    if (!normal || (find_flying && fliesBetween(camera, pixel, point, normal->direction))) continue;
    store(normal->direction, i, samples);
    placePoint(normal->point, i, samples);
    placeNormal(normal->place, i, samples);
    const double usual = 1.0 + (source.usual_grain - 1.0) * ramp(kGood, kPoor, normal->sigma);
    samples.normal_sigma[i] = static_cast<float>(std::max(grain, usual) * normal->sigma);
  }
}

/// To the side of the given normal, or where there is none (0) towards the sensor.
void orient(Vec3& normal, const Vec3& point, const Vec3& given) {
  if (given.isZero()) return orientTowardsSensor(point, normal);
  if (normal.dot(given) < 0.0) normal = -normal;
}

/// Little more than a degree from the ray: a surface that is seen so shows next to nothing of itself.
bool isAlongRay(const Vec3& normal, const Vec3& point) {
  constexpr double kSine = 0.02;
  return std::abs(normal.dot(point)) < kSine * point.norm();
}

/// Where a sensor at the origin sees rows that are far apart, as of a laser scanner, all neighbours may be of one row:
/// the plane through them is that of the scan, along its rays. Then of four times as many; none where these are no
/// better.
std::optional<Vec3> normalAround(const Cloud& cloud, std::uint32_t point, int count, NormalSource& source,
                                 List<std::uint32_t>& neighbors) {
  constexpr int kMore = 4;
  for (const int wanted : {count, kMore * count}) {
    source.neighbors->nearest(cloud, point, wanted, neighbors);
    const std::optional<Vec3> normal = planeNormal(cloud, neighbors);
    if (!source.from_origin || (normal && !isAlongRay(*normal, cloud.point(point)))) return normal;
  }
  return std::nullopt;
}

/// keep_sides: those of normals that the samples have already.
void fitNeighborhoods(const Cloud& cloud, int count, bool keep_sides, NormalSource& source, Samples& samples) {
  List<std::uint32_t> neighbors;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::optional<Vec3> normal = normalAround(cloud, samples.index[i], count, source, neighbors);
    if (!normal) continue;
    orient(*normal, samples.point(i), keep_sides && samples.hasNormal(i) ? samples.normal(i) : Vec3(Vec3::Zero()));
    store(*normal, i, samples);
  }
}

}  // namespace

std::optional<Vec3> planeNormal(const Cloud& cloud, const List<std::uint32_t>& points) {
  if (points.size() < 3) return std::nullopt;
  const Vec3 origin = cloud.point(points.front());
  Vec3 sum = Vec3::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : points) {
    const Vec3 offset = cloud.point(i) - origin;
    sum += offset;
    squares.noalias() += offset * offset.transpose();
  }
  const Eigen::Matrix3d scatter = squares - sum * sum.transpose() / static_cast<double>(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  // Points on a line, or all the same, have no second direction.
  if (!(solver.eigenvalues()(1) > 1e-9 * solver.eigenvalues()(2)) || !(solver.eigenvalues()(2) > 0.0))
    return std::nullopt;
  return Vec3(solver.eigenvectors().col(0));
}

const ImageRays& raysOf(const Cloud& cloud, NormalSource& source) {
  if (!source.rays) source.rays = findRays(cloud);
  return *source.rays;
}

const PixelPitch& pixelPitch(const Cloud& image, NormalSource& source) {
  if (!source.pitch) source.pitch = pitchOf(raysOf(image, source));
  return *source.pitch;
}

bool isDepthImage(const Cloud& cloud) {
  // The image window needs depth along z, as in an optical frame.
  return cloud.organized() && cloud.behind_count == 0;
}

int neighborsFor(const Cloud& cloud, const Samples& samples, double sigma, double wanted, NormalSource& source) {
  constexpr std::size_t kLookedAt = 64;
  constexpr int kNearest = 11;
  constexpr double kFewest = 12.0, kMost = 300.0;
  if (!source.neighbors) source.neighbors = std::make_unique<NeighborSearch>(cloud);
  List<double> radii;
  List<std::uint32_t> nearest;
  for (std::size_t i = 0; i < samples.size(); i += samples.size() / kLookedAt + 1) {
    source.neighbors->nearest(cloud, samples.index[i], kNearest, nearest);
    double radius = 0.0;
    for (const std::uint32_t k : nearest) {
      radius = std::max(radius, (cloud.point(k) - samples.point(i)).norm());
    }
    radii.push_back(radius);
  }
  const double spacing = median(radii) * std::sqrt(M_PI / kNearest);
  return static_cast<int>(std::clamp(2.0 * std::sqrt(M_PI) * sigma / (spacing * wanted), kFewest, kMost));
}

void estimateNormals(const Cloud& cloud, const Params& params, NormalSource& source, Samples& samples) {
  if (samples.size() == 0) return;  // as where nothing is left to look closer at: no tree is built
  const bool takes_own = params.use_cloud_normals && cloud.hasNormals();
  if (takes_own) {
    takeCloudNormals(cloud, params.orient_normals, samples);
    // Fields that are there but hold zeros or NaN throughout are as good as none.
    if (anyNormal(samples) && source.neighbor_count <= 0) return;
  }
  if (source.neighbor_count <= 0 && isDepthImage(cloud)) {
    return fitWindows(cloud, params, source, samples);
  }
  if (!source.neighbors) source.neighbors = std::make_unique<NeighborSearch>(cloud);
  const int count = source.neighbor_count > 0 ? source.neighbor_count : params.normal_neighbors;
  fitNeighborhoods(cloud, count, takes_own && !params.orient_normals, source, samples);
}

bool mostFaceAway(const Samples& samples) {
  constexpr double kMost = 0.75;
  double normals = 0.0, away = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!samples.hasNormal(i)) continue;
    normals += 1.0;
    away += samples.normal(i).dot(samples.point(i)) > 0.0 ? 1.0 : 0.0;
  }
  return normals > 0.0 && away >= kMost * normals;
}

}  // namespace primitect
