// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Asks the image along rings around the axis; see seen_ends.h.
#include "core/seen_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace primitect {
namespace {

constexpr int kRingsOfLength = 48, kPlacesOnRing = 32;

/// Looks at rings around the axis.
class RingsInImage {
 public:
  RingsInImage(const Cylinder& cylinder, bool concave, const Extent& extent, const AskedImage& image)
      : cylinder_(cylinder),
        concave_(concave),
        extent_(extent),
        image_(image),
        looking_(cylinder, extent.origin.z() - cylinder.radius, image) {}

  /// Whether the surface is not there, in most of the places that tell.
  bool isGone(double height) const {
    constexpr int kFewest = 5;
    int surface = 0, asked = 0;
    for (int k = 0; k < kPlacesOnRing; ++k) {
      const std::optional<Sight> sight = at(height, 2.0 * M_PI * k / kPlacesOnRing);
      if (!sight || *sight == Sight::unknown || *sight == Sight::blot || *sight == Sight::hole) continue;
      ++asked;
      surface += *sight == Sight::surface ? 1 : 0;
    }
    return asked >= kFewest && 3 * surface < 2 * asked;
  }

 private:
  /// Nothing outside of the image, on the side that is turned away, and at the limb.
  std::optional<Sight> at(double height, double angle) const {
    const Eigen::Matrix3d& frame = extent_.rotation;
    const Vec3 out = std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1);
    const Vec3 point = extent_.origin + height * frame.col(2) + cylinder_.radius * out;
    if (!(point.z() > 0.0) || !faces(cylinder_, concave_, point)) return std::nullopt;
    const ImageRays& rays = image_.rays;
    const Eigen::Vector2d pixel = rays.pixelOf(point);
    const double column = std::round(pixel.x()), row = std::round(pixel.y());
    if (!(0.0 <= column && column < image_.cloud.width && 0.0 <= row && row < image_.cloud.height)) return std::nullopt;
    const int c = static_cast<int>(column), r = static_cast<int>(row);
    const Vec3 ray = rays.through(c, r);
    const std::optional<double> z = depthOn(cylinder_, ray, point.z());
    return z ? std::optional<Sight>(looking_.at(c, r, *z * ray)) : std::nullopt;
  }

  const Cylinder& cylinder_;
  bool concave_;
  const Extent& extent_;
  const AskedImage& image_;
  Looking<Cylinder> looking_;
};

}  // namespace

std::optional<AxisPart> seenEnds(const Cylinder& cylinder, bool concave, const Extent& extent,
                                 const AskedImage& image) {
  constexpr double kMost = 0.3;  // of the length
  constexpr int kFewest = 2;     // rings: the last one may be half beyond the end
  const double length = extent.size.z();
  const double pixel = std::max(std::abs(image.rays.x_scale), std::abs(image.rays.y_scale)) * extent.origin.z();
  if (!image.rays.known || !(length > 0.0) || !(pixel > 0.0)) return std::nullopt;
  const double step = std::max(length / kRingsOfLength, pixel);
  const RingsInImage rings(cylinder, concave, extent, image);
  // How much is left out at the end that lies in this direction; m.
  const auto goneAt = [&](double direction) {
    int gone = 0;
    while ((gone + 1) * step <= kMost * length && rings.isGone(direction * (0.5 * length - (gone + 0.5) * step)))
      ++gone;
    return gone < kFewest ? 0.0 : gone * step;
  };
  const double low = goneAt(-1.0), high = goneAt(1.0);
  if (low == 0.0 && high == 0.0) return std::nullopt;
  constexpr float kNone = std::numeric_limits<float>::infinity();
  return AxisPart{low > 0.0 ? static_cast<float>(low - 0.5 * length) : -kNone,
                  high > 0.0 ? static_cast<float>(0.5 * length - high) : kNone};
}

}  // namespace primitect
