// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The planes on which a detector says that axes end.
#include <gtest/gtest.h>

#include <cmath>

#include "test/support/table_frame.h"

namespace primitect::end_faces_test {
namespace {

/// Checks that the end of an axis lies on the plane that is named for it; false: none is.
bool liesOnItsFace(const Detections& found, const Extent& extent, std::int32_t face, double side) {
  if (face == kNoFace) return false;
  EXPECT_GE(face, 0);
  if (face < 0 || static_cast<std::size_t>(face) >= found.items.size()) {
    ADD_FAILURE() << face << " is no detection";
    return false;
  }
  const Plane* const plane = std::get_if<Plane>(&found.items[static_cast<std::size_t>(face)].shape);
  if (!plane) {
    ADD_FAILURE() << face << " is no plane";
    return false;
  }
  const Vec3 end = extent.origin + 0.5 * side * extent.size.z() * extent.rotation.col(2);
  EXPECT_LT(std::abs(distance(*plane, end)), 0.005);
  return true;
}

TEST(DetectorFaces, AreThosePlanesOnWhichAxesEnd) {
  int axes = 0, ends = 0;
  for (std::uint64_t seed = 2500; seed < 2520; ++seed) {
    const Detections found = test::TableFrame(seed).found;
    for (const Detection& item : found.items) {
      const Extent& extent = item.extent;
      if (kindOf(item.shape) == Kind::plane || kindOf(item.shape) == Kind::sphere) {
        EXPECT_EQ(extent.face_at_minus_z, kNoFace);
        EXPECT_EQ(extent.unseen_ends, 0);
        continue;
      }
      ++axes;
      const bool below = liesOnItsFace(found, extent, extent.face_at_minus_z, -1.0);
      const bool above = liesOnItsFace(found, extent, extent.face_at_plus_z, 1.0);
      ends += (below ? 1 : 0) + (above ? 1 : 0);
      EXPECT_FALSE(below && (extent.unseen_ends & kEndAtMinusZ)) << "it was seen";
      EXPECT_FALSE(above && (extent.unseen_ends & kEndAtPlusZ)) << "it was seen";
    }
  }
  EXPECT_GT(axes, 40);
  EXPECT_GT(ends, axes / 2);
}

}  // namespace
}  // namespace primitect::end_faces_test
