// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Recorded frames as other cameras would have seen them: mirrored, upside down, held on end, with half as many pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "io/point_files.h"
#include "primitect/detector.h"
#include "primitect/transforms.h"

namespace primitect::recorded_frames_test {
namespace {

/// In the folder "shared" beside the project; may be missing.
std::vector<std::string> recordedFrames() {
  const std::filesystem::path folder = std::filesystem::path(PRIMITECT_SHARED) / "frames";
  std::vector<std::string> paths;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
    if (entry.path().extension() == ".pcd") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// How another camera sees the same: which pixel of the image becomes which, and where its point is.
struct View {
  const char* name;
  Eigen::Matrix3d turn;  ///< its own inverse
  bool on_end;           ///< rows become columns
  std::uint32_t every;   ///< so many-th pixel
};

Eigen::Matrix3d onEnd() {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << 0, 1, 1, 0;
  return turn;
}

const std::vector<View> kViews = {{"mirrored", Vec3(-1, 1, 1).asDiagonal(), false, 1},
                                  {"upside down", Vec3(1, -1, 1).asDiagonal(), false, 1},
                                  {"on end", onEnd(), true, 1},
                                  {"every second pixel", Eigen::Matrix3d::Identity(), false, 2}};

Cloud seen(const Cloud& image, const View& view, const DepthRange& range) {
  const std::uint32_t width = image.width / view.every, height = image.height / view.every;
  Cloud result;
  result.reset(view.on_end ? height : width, view.on_end ? width : height, false);
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const std::size_t from = static_cast<std::size_t>(row) * view.every * image.width + column * view.every;
      std::uint32_t c = view.turn(0, 0) < 0.0 ? width - 1 - column : column;
      std::uint32_t r = view.turn(1, 1) < 0.0 ? height - 1 - row : row;
      if (view.on_end) std::swap(c, r);
      const Vec3 point = view.turn * image.point(from);
      result.setPoint(static_cast<std::size_t>(r) * result.width + c, static_cast<float>(point.x()),
                      static_cast<float>(point.y()), static_cast<float>(point.z()), range);
    }
  }
  return result;
}

/// As far as the scorer of such frames would ask.
struct Alike {
  static constexpr double kTurn = 0.15, kLength = 0.015, kShare = 0.15;  // rad, m, of a radius

  static bool along(const Vec3& a, const Vec3& b) { return a.cross(b).norm() < std::sin(kTurn); }
  static bool size(double a, double b) { return std::abs(a - b) < kShare * std::max(a, b); }

  const Vec3& where;  ///< on the first

  bool isOnAxis(const Vec3& point, const Vec3& axis) const { return (where - point).cross(axis).norm() < kLength; }

  bool operator()(const Plane& a, const Plane& b) const {
    return along(a.normal, b.normal) && std::abs(distance(b, where)) < kLength;
  }
  bool operator()(const Sphere& a, const Sphere& b) const {
    return (a.center - b.center).norm() < std::max(kLength, kShare * a.radius) && size(a.radius, b.radius);
  }
  bool operator()(const Cylinder& a, const Cylinder& b) const {
    return along(a.axis, b.axis) && size(a.radius, b.radius) && isOnAxis(b.point, b.axis);
  }
  bool operator()(const Cone& a, const Cone& b) const {
    return along(a.axis, b.axis) && std::abs(a.half_angle - b.half_angle) < kTurn && isOnAxis(b.apex, b.axis);
  }
  template <class A, class B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

struct Counts {
  int sure = 0, found = 0;
};

/// Sure ones of the first, and how many of these the second has, however sure.
void count(const Detections& first, const Eigen::Matrix3d& turn, const Detections& second, Counts& counts) {
  constexpr float kSure = 0.95f;
  for (const Detection& one : first.items) {
    if (one.confidence < kSure) continue;
    const Shape shape = transformed(Eigen::Isometry3d(turn), one.shape);
    const Vec3 where = turn * one.extent.origin;
    ++counts.sure;
    counts.found += std::any_of(second.items.begin(), second.items.end(),
                                [&](const Detection& other) { return std::visit(Alike{where}, shape, other.shape); });
  }
}

TEST(RecordedFrames, GiveTheSameHoweverTheCameraIsHeld) {
  const std::vector<std::string> paths = recordedFrames();
  if (paths.empty()) GTEST_SKIP() << "without ../shared/frames";
  const Params params;
  const DepthRange range = depthRangeOf(params);
  std::vector<Counts> kept(kViews.size()), added(kViews.size());
  for (const std::string& path : paths) {
    const Cloud whole = io::readPointFile(path).cloud;
    Cloud image;
    io::cutAtDepth(whole, range, image);
    Detector as_recorded(params), as_seen(params);
    const Detections& recorded = as_recorded.detect(image);
    for (std::size_t k = 0; k < kViews.size(); ++k) {
      const Detections& found = as_seen.detect(seen(whole, kViews[k], range));
      count(recorded, kViews[k].turn, found, kept[k]);
      count(found, kViews[k].turn, recorded, added[k]);
    }
  }
  for (std::size_t k = 0; k < kViews.size(); ++k) {
    printf("%s: of %d sure ones %d are kept, of %d %d are not new\n", kViews[k].name, kept[k].sure, kept[k].found,
           added[k].sure, added[k].found);
    EXPECT_GT(kept[k].sure, 30) << kViews[k].name;
    EXPECT_GT(added[k].sure, 30) << kViews[k].name;
    EXPECT_GE(kept[k].found, 0.9 * kept[k].sure) << kViews[k].name;
    EXPECT_GE(added[k].found, 0.9 * added[k].sure) << kViews[k].name;
  }
}

}  // namespace
}  // namespace primitect::recorded_frames_test
