// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Bodies that one can look into, and those that are none of the four kinds.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "solids.h"
#include "synthetic/raycast.h"
#include "synthetic/truth.h"

namespace primitect::synthetic::hollow_bodies_test {
namespace {

const PinholeCamera kSmallCamera{160, 120, 142.6, 142.6, 79.5, 59.5};
const Eigen::Isometry3d kAtOrigin = Eigen::Isometry3d::Identity();

const std::vector<Solid> kHollow = {Cup{0.10, 0.07, 0.12, 0.03},    Cup{0.15, 0.14, 0.05, 0.01},
                                    Pot{0.3, 0.2, 0.4, 0.02, 0.22}, Pot{0.6, 0.05, 0.2, 0.015, 0.1},
                                    Bowl{0.15, 0.12, 0.0, -0.13},   Bowl{0.15, 0.13, 0.05, -0.14},
                                    Bowl{0.15, 0.13, -0.05, -0.14}};
const std::vector<Solid> kShapeless = {Ellipsoid{0.15, 0.1, 0.06}, Torus{0.12, 0.04}, Torus{0.1, 0.09},
                                       Lump{0.12, 0.2, 6.0, 1.0}, Lump{0.12, 0.3, 7.0, 4.0}};
const Cloth kCloth{0.13, 0.10, 0.02, {{{30.0, 10.0, 0.015, 0.3}, {-20.0, 40.0, 0.01, 1.0}, {5.0, -60.0, 0.004, 2.0}}}};
const std::vector<Limbs::Limb> kBranches = {{{-0.1, 0.0, 0.0}, {0.0, 0.0, 0.03}, 0.03, 0.02},
                                            {{0.0, 0.0, 0.03}, {0.1, 0.04, 0.0}, 0.02, 0.015},
                                            {{0.0, 0.0, 0.03}, {0.06, -0.08, 0.02}, 0.02, 0.02}};
const std::vector<Solid> kSoft = {kCloth, Leaf{0.13, 0.08, 0.02, 0.05, 0.03}, Leaf{0.1, 0.1, 0.03, -0.03, 0.06},
                                  joined(kBranches, 0.0)};

/// A random pose with the middle of the solid at 1 m.
Eigen::Isometry3d posed(const Solid& solid, Random& random) {
  const Pot* pot = std::get_if<Pot>(&solid);
  const double middle = pot ? 0.5 * (pot->begin + pot->end) : 0.0;
  return randomPose({0.05, -0.05, 1.0}, random) * Eigen::Translation3d(0.0, 0.0, -middle);
}

struct View {
  World world;
  Rendering rendering;
  const Body& body() const { return world.bodies()[0]; }
  Vec3 pointAt(std::size_t i) const {
    return kSmallCamera.ray(i % kSmallCamera.width, i / kSmallCamera.width) * static_cast<double>(rendering.depth[i]);
  }
};

View viewOf(const Solid& solid, Random& random) {
  View view;
  view.world.add("body", solid, posed(solid, random));
  render(view.world, kSmallCamera, kAtOrigin, view.rendering);
  return view;
}

/// The first depth from 0.6 m on where the body is, 0: none.
double walk(const Body& body, const Vec3& ray, double step) {
  for (double depth = 0.6; depth < 1.4; depth += step) {
    if (contains(body, depth * ray)) return depth;
  }
  return 0.0;
}

void expectFirstHits(const Solid& solid, Random& random) {
  constexpr double kStep = 0.002;
  const View view = viewOf(solid, random);
  for (std::size_t i = 0; i < kSmallCamera.pixelCount(); i += 31) {
    const Vec3 ray = kSmallCamera.ray(i % kSmallCamera.width, i / kSmallCamera.width);
    const double walked = walk(view.body(), ray, kStep);
    const float depth = view.rendering.depth[i];
    if (walked > 0.0) {
      ASSERT_LT(depth, walked + 1e-6) << "solid " << solid.index();
    }
    if (std::isnan(depth)) continue;
    // Where walking found less or nothing it has stepped over a corner: the hit is still on the border of the body.
    ASSERT_FALSE(contains(view.body(), ray * (depth - 1e-5)));
    if (std::abs(depth - walked) > kStep) {
      ASSERT_FALSE(contains(view.body(), ray * (depth + kStep)));
    }
  }
}

TEST(HollowBodies, AreHitWhereWalkingAlongTheRayMeetsThem) {
  Random random(1);
  for (const Solid& solid : kHollow) {
    for (int turn = 0; turn < 4; ++turn) expectFirstHits(solid, random);
  }
}

TEST(ShapelessBodies, AreHitWhereWalkingAlongTheRayMeetsThem) {
  Random random(2);
  for (const Solid& solid : kShapeless) {
    for (int turn = 0; turn < 4; ++turn) expectFirstHits(solid, random);
  }
}

TEST(SoftBodies, AreHitWhereWalkingAlongTheRayMeetsThem) {
  Random random(5);
  for (const Solid& solid : kSoft) {
    for (int turn = 0; turn < 4; ++turn) expectFirstHits(solid, random);
  }
}

/// What the tracer relies on: it must not step through a surface.
TEST(SoftBodies, TellADistanceThatIsNeverMoreThanThatToASurfacePoint) {
  Random random(6);
  for (const Solid& solid : {Solid(kCloth), kSoft[1], kSoft[3], Solid(joined(kBranches, 0.03))}) {
    const auto distanceTo = [&solid](const Vec3& p) {
      return std::visit(
          [&p](const auto& s) {
            if constexpr (std::is_same_v<decltype(s), const Cloth&> || std::is_same_v<decltype(s), const Leaf&> ||
                          std::is_same_v<decltype(s), const Limbs&>) {
              return s.distanceTo(p);
            } else {
              return 1e9;
            }
          },
          solid);
    };
    const View view = viewOf(solid, random);
    int seen = 0;
    for (std::size_t i = 0; i < kSmallCamera.pixelCount(); i += 3) {
      if (view.rendering.surface[i] == kNoSurface) continue;
      const Vec3 hit = view.body().world_from_body.inverse() * view.pointAt(i);
      const Vec3 p{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
      // Float depths near 1 m are 6e-8 m apart.
      ASSERT_LE(distanceTo(p), (p - hit).norm() + 1e-6) << "solid " << solid.index();
      ASSERT_NEAR(distanceTo(hit), 0.0, 1e-6) << "solid " << solid.index();
      ++seen;
    }
    EXPECT_GT(seen, 50) << "solid " << solid.index();
  }
}

TEST(SoftBodies, FlowIntoOneAnotherAtTheirJoints) {
  const Limbs hard = joined(kBranches, 0.0), soft = joined(kBranches, 0.03);
  const Vec3 crotch(0.04, -0.012, 0.02);
  EXPECT_LT(soft.distanceTo(crotch), hard.distanceTo(crotch) - 0.001);
  const Vec3 at_the_end(-0.13, 0.0, 0.0);
  EXPECT_NEAR(soft.distanceTo(at_the_end), hard.distanceTo(at_the_end), 1e-12);
}

TEST(HollowBodies, DepthLiesOnTheShapeOfItsSurfaceAndNormalsPointOutOfTheMaterial) {
  constexpr double kAside = 1e-4;
  Random random(3);
  for (const Solid& solid : kHollow) {
    int seen = 0, concave = 0, at_edges = 0;
    for (int turn = 0; turn < 12; ++turn) {
      const View view = viewOf(solid, random);
      for (std::size_t i = 0; i < kSmallCamera.pixelCount(); ++i) {
        if (view.rendering.surface[i] == kNoSurface) continue;
        const Surface& surface = view.world.surfaces()[view.rendering.surface[i]];
        const Vec3 p = view.pointAt(i);
        // Float depths near 1 m are 6e-8 m apart.
        ASSERT_NEAR(distance(surface.shape, p), 0.0, 1e-6);
        const Vec3 outward = (surface.concave ? -1.0 : 1.0) * normalAt(surface.shape, p);
        at_edges += !contains(view.body(), p - kAside * outward) || contains(view.body(), p + kAside * outward);
        concave += surface.concave;
        ++seen;
      }
    }
    EXPECT_GT(seen, 5000) << "solid " << solid.index();
    EXPECT_GT(concave, 300) << "solid " << solid.index();
    EXPECT_LT(at_edges, 0.02 * seen) << "solid " << solid.index();
  }
}

/// How far p (m, in the body's frame) is from the surface, by its equation.
struct Residual {
  Vec3 p;
  double operator()(const Ellipsoid& e) const {
    return (p.cwiseQuotient(Vec3(e.half_x, e.half_y, e.half_z)).norm() - 1.0) * e.half_z;
  }
  double operator()(const Torus& t) const {
    const double across = std::sqrt(p.x() * p.x() + p.y() * p.y()) - t.ring_radius;
    return std::sqrt(across * across + p.z() * p.z()) - t.tube_radius;
  }
  double operator()(const Lump& l) const { return p.norm() - l.reach(p.normalized()); }
  template <class Other>
  double operator()(const Other&) const {
    return 1.0;
  }
};

TEST(ShapelessBodies, AreHitToAMicrometre) {
  Random random(4);
  for (const Solid& solid : kShapeless) {
    int seen = 0;
    for (int turn = 0; turn < 5; ++turn) {
      const View view = viewOf(solid, random);
      for (std::size_t i = 0; i < kSmallCamera.pixelCount(); ++i) {
        if (view.rendering.surface[i] == kNoSurface) continue;
        const Vec3 p = view.body().world_from_body.inverse() * view.pointAt(i);
        ASSERT_NEAR(std::visit(Residual{p}, solid), 0.0, 1e-6) << "solid " << solid.index();
        ++seen;
      }
    }
    EXPECT_GT(seen, 1000) << "solid " << solid.index();
  }
}

TEST(Truth, SaysWhatIsConcaveAndLeavesOutWhatHasNoShape) {
  World world;
  const auto facing = [](double x) {  // z of the body towards the camera, a little aside
    return Eigen::Translation3d(x, 0.0, 1.0) * Eigen::Isometry3d(Eigen::AngleAxisd(M_PI - 0.5, Vec3::UnitY()));
  };
  world.add("cup", Cup{0.06, 0.055, 0.05, 0.005}, facing(-0.3));
  world.add("torus", Torus{0.06, 0.02}, facing(0.0));
  world.add("bowl", Bowl{0.08, 0.075, 0.0, -0.078}, facing(0.3));
  const PinholeCamera camera;
  Rendering rendering;
  render(world, camera, kAtOrigin, rendering);
  std::vector<int> surface_of_item;
  const Detections truth = truthOf(world, camera, kAtOrigin, rendering, {DepthRange{}, 200}, &surface_of_item);
  int concave_of_kind[kKindCount] = {};
  std::uint32_t pixels = 0;
  for (std::size_t i = 0; i < truth.items.size(); ++i) {
    const Surface& surface = world.surfaces()[surface_of_item[i]];
    EXPECT_TRUE(surface.primitive);
    EXPECT_EQ(truth.items[i].concave, surface.concave);
    concave_of_kind[truth.items[i].shape.index()] += truth.items[i].concave;
    pixels += truth.items[i].inlier_count;
  }
  EXPECT_EQ(concave_of_kind[0], 0);
  EXPECT_EQ(concave_of_kind[1], 1) << "the bowl";
  EXPECT_EQ(concave_of_kind[2], 1) << "the cup";
  EXPECT_GT(truth.points_used, pixels + 3000) << "the torus was measured too";
}

TEST(World, RefusesHollowBodiesWithoutRoomInside) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Solid> impossible = {Cup{0.1, 0.1, 0.1, 0.01},
                                         Cup{0.1, 0.09, 0.1, 0.2},
                                         Cup{0.1, nan, 0.1, 0.01},
                                         Pot{0.3, 0.2, 0.4, 0.2, 0.3},
                                         Pot{0.3, 0.2, 0.4, 0.02, 0.1},
                                         Bowl{0.1, 0.09, 0.095, -0.095},
                                         Bowl{0.1, 0.09, 0.0, -0.05},
                                         Ellipsoid{0.1, 0.0, 0.1},
                                         Torus{0.1, 0.1},
                                         Lump{0.1, 0.5, 3.0, 0.0},
                                         Leaf{0.1, 0.1, 0.0, 0.0, 0.0},
                                         Limbs{{}, 0.0, 0.1},
                                         joined({{Vec3::Zero(), Vec3::Zero(), 0.1, 0.1}}, 0.0)};
  World world;
  for (const Solid& solid : impossible) EXPECT_THROW(world.add("b", solid, kAtOrigin), std::invalid_argument);
  EXPECT_TRUE(world.surfaces().empty());
}

}  // namespace
}  // namespace primitect::synthetic::hollow_bodies_test
