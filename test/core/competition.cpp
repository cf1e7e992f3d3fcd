// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which kind a depth camera can tell at all.
#include "core/competition.h"

#include <gtest/gtest.h>

#include "test/support/hypotheses.h"

namespace primitect::competition_test {
namespace {

constexpr double kLargest = 1.0;  // m

NoiseModel depthCamera() {
  NoiseModel noise = {0.0, 0.002};
  noise.angle = 0.3;
  return noise;
}

/// The kind that wins on these points, from the plane across the line of sight at this depth (m).
std::optional<Kind> winnerOn(const std::vector<test::SurfacePoint>& points, double depth) {
  const NoiseModel noise = depthCamera();
  const Samples samples = test::samplesWith(noise, points);
  const Params params;
  Hypothesis hypothesis;
  hypothesis.shape = Plane{Vec3(0, 0, depth), -Vec3::UnitZ()};
  const ProposalRules rules = {noise, {params, kLargest}, 1.0, kLargest};
  if (!bestOfKinds(samples, HeldGains(samples.size(), 0.0f), test::allOf(samples), rules, hypothesis)) return {};
  return kindOf(hypothesis.shape);
}

/// A patch of .2 m of a rod across the line of sight, as far round as a camera sees it; its front is at this depth (m).
/// In the middle it has this radius (m), and it tapers by an angle (rad, 0: a tube).
struct Rod {
  double radius, depth, taper = 0.0, noise_along_rays = 0.0;

  std::vector<test::SurfacePoint> points() const {
    Random random(81);
    std::vector<test::SurfacePoint> points;
    for (int i = 0; i < 150; ++i) {
      const double turn = random.uniform(-1.2, 1.2);  // rad
      const Vec3 out(0, std::sin(turn), -std::cos(turn));
      const Vec3 stray(0, 0, noise_along_rays * random.gaussian());
      const double along = random.uniform(-0.1, 0.1);
      const Vec3 on_axis(along, 0, depth + radius);
      const Vec3 normal = std::cos(taper) * out - std::sin(taper) * Vec3::UnitX();
      points.push_back({on_axis + (radius + along * std::tan(taper)) * out + stray, normal});
    }
    return points;
  }
};

/// The kind that wins on it.
std::optional<Kind> winnerOn(const Rod& rod) { return winnerOn(rod.points(), rod.depth); }

/// Of a ball of 90 mm whose front is 1 m away: what lies as far (m) above and below, and as far round as a camera sees.
std::vector<test::SurfacePoint> bandOfBall(double half_width) {
  constexpr double kRadius = 0.09;
  Random random(85);
  std::vector<test::SurfacePoint> points;
  for (int i = 0; i < 200; ++i) {
    const double turn = random.uniform(-1.2, 1.2), up = random.uniform(-half_width, half_width) / kRadius;
    const double level = std::sqrt(1.0 - up * up);
    const Vec3 normal(level * std::sin(turn), up, -level * std::cos(turn));
    points.push_back({Vec3(0, 0, 1.0 + kRadius) + kRadius * normal, normal});
  }
  return points;
}

/// Of a strip 1 m away, so narrow that its noise tilts a plane through its points by 6 deg across.
std::vector<test::SurfacePoint> askewStrip(double turn_of_normals) {
  constexpr double kAskew = 0.1;  // rad
  const Vec3 normal(0, std::sin(turn_of_normals), -std::cos(turn_of_normals));
  Random random(82);
  std::vector<test::SurfacePoint> points;
  for (int i = 0; i < 100; ++i) {
    const double across = random.uniform(-0.005, 0.005);
    points.push_back({Vec3(random.uniform(-0.05, 0.05), across, 1.0 + kAskew * across), normal});
  }
  return points;
}

/// The normal of the plane that wins on these points.
std::optional<Vec3> normalOfPlaneOn(const std::vector<test::SurfacePoint>& points) {
  const NoiseModel noise = depthCamera();
  const Samples samples = test::samplesWith(noise, points);
  const Params params;
  Hypothesis hypothesis;
  hypothesis.shape = Plane{points[0].point, points[0].normal};
  const ProposalRules rules = {noise, {params, kLargest}, 1.0, kLargest};
  if (!bestOfKinds(samples, HeldGains(samples.size(), 0.0f), test::allOf(samples), rules, hypothesis)) return {};
  const Plane* plane = std::get_if<Plane>(&hypothesis.shape);
  return plane ? std::optional<Vec3>(plane->normal) : std::nullopt;
}

/// A plane of 0.2 m x 0.2 m around (0, 0, 1) that turns so far (rad) out of the line of sight.
std::vector<test::SurfacePoint> nearlyEdgeOn(double turn) {
  const Vec3 along(0, std::sin(turn), std::cos(turn)), normal(0, std::cos(turn), -std::sin(turn));
  Random random(83);
  std::vector<test::SurfacePoint> points;
  for (int i = 0; i < 100; ++i) {
    const double aside = random.uniform(-0.1, 0.1), ahead = random.uniform(-0.1, 0.1);
    points.push_back({Vec3::UnitZ() + aside * Vec3::UnitX() + ahead * along, normal});
  }
  return points;
}

TEST(Competition, LeavesOutAPlaneThatIsSeenEdgeOn) {
  EXPECT_TRUE(normalOfPlaneOn(nearlyEdgeOn(0.05)));
  EXPECT_FALSE(normalOfPlaneOn(nearlyEdgeOn(0.01)));
}

TEST(Competition, LaysAPlaneOnANarrowStripAsItsNormalsSay) {
  const std::optional<Vec3> normal = normalOfPlaneOn(askewStrip(0.0));
  ASSERT_TRUE(normal);
  EXPECT_NEAR(normal->y(), 0.0, 0.01);
}

TEST(Competition, LaysAPlaneThroughThePointsWhereNormalsAgreeWithThem) {
  const std::optional<Vec3> normal = normalOfPlaneOn(askewStrip(0.1));
  ASSERT_TRUE(normal);
  EXPECT_NEAR(normal->y(), std::sin(0.1), 0.01);
}

TEST(Competition, FindsAThinTubeThatTurnsFar) {
  // 17 mm at 1 m are 9 standard deviations of the noise; over a patch that turns by 138 degrees the points stray by 1.7
  // of them across the plane through them.
  EXPECT_EQ(winnerOn(Rod{0.017, 1.0}), Kind::cylinder);
}

/// Whether so much (rad) of a tube wins, with noise that is everywhere the same, a fifth of the radius.
bool isTube(double arc, bool fitted_normals) {
  constexpr double kRadius = 0.01;
  const NoiseModel noise = {0.2 * kRadius, 0.0, 0.36};
  const Cylinder tube = {Vec3(0, 0, 1), Vec3::UnitX(), kRadius};
  Random random(84);
  std::vector<test::SurfacePoint> points;
  for (int i = 0; i < 300; ++i) {
    points.push_back(test::pointOn(tube, {random.uniform(-0.1, 0.1), random.uniform(0.0, arc)}));
  }
  const Samples samples = test::samplesWith(noise, test::measured(points, noise.distance, 0.05, random));
  Hypothesis hypothesis;
  hypothesis.shape = tube;
  const Params params;
  ProposalRules rules = {noise, {params, kLargest}, 1.0, kLargest};
  rules.fitted_normals = fitted_normals;
  const bool any = bestOfKinds(samples, HeldGains(samples.size(), 0.0f), test::allOf(samples), rules, hypothesis);
  return any && kindOf(hypothesis.shape) == Kind::cylinder;
}

TEST(Competition, TakesNoEdgeForATubeWhereNormalsAreFitted) {
  EXPECT_TRUE(isTube(0.5 * M_PI, false));
  EXPECT_FALSE(isTube(0.5 * M_PI, true)) << "as round as the edge of a box";
  EXPECT_TRUE(isTube(M_PI, true)) << "no edge turns that far";
}

/// Of a cone of 25 deg, an arc of 80 deg and a fifth of the way to its apex, with noise of 1 mm that is everywhere the
/// same: normals are off by 7 deg about each axis. Seen from inside: the normals point to the axis.
struct ConeOnAnArc {
  Params params;
  NoiseModel noise = {0.001, 0.0, 0.36};
  Samples samples;

  ConeOnAnArc(std::uint64_t seed, bool inside) {
    constexpr double kHalfAngle = 25.0 * test::kDegree, kNormals = 0.12, kFront = -0.5 * M_PI;
    const Cone cone = {Vec3(0, 0, 1), Vec3(0, 1, 0), kHalfAngle};
    Random random(seed);
    std::vector<test::SurfacePoint> points;
    for (int i = 0; i < 400; ++i) {
      const double slant = random.uniform(0.11, 0.16), turn = random.uniform(-0.7, 0.7);
      points.push_back(test::pointOn(cone, slant * std::cos(kHalfAngle), kFront + turn));
      if (inside) points.back().normal *= -1.0;
    }
    samples = test::samplesWith(noise, test::measured(points, noise.distance, kNormals, random));
  }

  /// The kind that wins, from a plane.
  std::optional<Kind> winner() const {
    Hypothesis hypothesis;
    hypothesis.shape = Plane{samples.point(0), samples.normal(0)};
    const ProposalRules rules = {noise, {params, kLargest}, 1.0, kLargest};
    if (!bestOfKinds(samples, HeldGains(samples.size(), 0.0f), test::allOf(samples), rules, hypothesis)) return {};
    return kindOf(hypothesis.shape);
  }
};

TEST(Competition, FindsAConeOnANarrowArcWithNoisyNormals) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) EXPECT_EQ(ConeOnAnArc(seed, false).winner(), Kind::cone) << seed;
}

TEST(Competition, FindsTheConeWithoutCylinders) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ConeOnAnArc arc(seed, false);
    arc.params.detect_cylinders = false;
    EXPECT_EQ(arc.winner(), Kind::cone) << seed;
  }
}

TEST(Competition, FindsItFromInside) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ConeOnAnArc arc(seed, true);
    arc.params.convexity = "both";
    EXPECT_EQ(arc.winner(), Kind::cone) << seed;
  }
}

TEST(Competition, TakesNoBallForABandThatMayBeARim) {
  // The noise is 2 mm: 11 mm either side of the middle the surface is .7 mm behind it, 40 mm to the side 9 mm.
  EXPECT_NE(winnerOn(bandOfBall(0.011), 1.0), Kind::sphere);
  EXPECT_EQ(winnerOn(bandOfBall(0.040), 1.0), Kind::sphere);
}

// The noise of points 1.8 m away and more is 5 mm: 28 mm are less than 6.5 times that, 40 mm are more.
constexpr double kFar = 1.8, kNoise = 0.004;

TEST(Competition, TakesNoCylinderForARoundedEdgeFarAway) {
  EXPECT_NE(winnerOn(Rod{0.028, kFar, 0.0, kNoise}), Kind::cylinder);
  EXPECT_EQ(winnerOn(Rod{0.040, kFar, 0.0, kNoise}), Kind::cylinder);
}

TEST(Competition, TakesNoConeForARoundedEdgeFarAwayThatTapers) {
  constexpr double kTaper = 8.0 * test::kDegree;  // 14 mm over a half of its length
  EXPECT_NE(winnerOn(Rod{0.023, kFar, kTaper, kNoise}), Kind::cone);
  EXPECT_EQ(winnerOn(Rod{0.040, kFar, kTaper, kNoise}), Kind::cone);
}

TEST(Limits, HoldNoPlaneInWhichTheSensorLies) {
  const Params params;
  const auto hold = [&params](double distance, double min_distance) {
    return Limits{params, 1.0, 0.0, min_distance}.hold(Plane{Vec3(0.3, -distance, 1.0), Vec3::UnitY()});
  };
  EXPECT_FALSE(hold(0.004, 0.005));
  EXPECT_FALSE(hold(-0.004, 0.005));
  EXPECT_TRUE(hold(0.006, 0.005));
  EXPECT_TRUE(hold(0.0, 0.0)) << "of a cloud that no sensor at the origin saw";
}

}  // namespace
}  // namespace primitect::competition_test
