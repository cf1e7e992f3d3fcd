// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals from the window, from neighbours, from the cloud.
#include "core/normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/projected_image.h"
#include "core/sampling.h"
#include "primitect/detector.h"
#include "test/support/exact_shapes.h"

namespace primitect::normals_test {
namespace {

using test::cameraCloud;
using test::kDegree;
using test::patchOf;

/// Points along the same rays, with noise of so much of the depth.
void addNoise(double share, std::uint64_t seed, Cloud& cloud) {
  Random random(seed);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float factor = 1.0f + static_cast<float>(share * random.gaussian());
    for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) (*values)[i] *= factor;
  }
}

TEST(WindowNormals, AreExactOnSlantedPlanesAndPointToTheSensor) {
  for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(0.5, 0, 1), Vec3(-0.3, 0.8, 1), Vec3(0.0, 1.5, 1)}) {
    const Vec3 normal = direction.normalized();
    const Cloud cloud = cameraCloud(normal, 0.6);
    const std::optional<WindowNormal> found = windowNormal(cloud, 60 * 160 + 80, 5);
    ASSERT_TRUE(found);
    EXPECT_LT((found->direction + normal).norm(), 1e-4) << direction.transpose();
  }
}

TEST(WindowNormals, AreNotBentByTheSurfaceBehindAnEdge) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (int row = 0; row < 120; ++row) {
    for (int column = 83; column < 160; ++column) {
      const std::size_t i = row * 160 + column;
      for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) (*values)[i] *= 1.5f;
    }
  }
  const std::optional<WindowNormal> found = windowNormal(cloud, 60 * 160 + 80, 5);
  ASSERT_TRUE(found);
  EXPECT_LT((found->direction + Vec3::UnitZ()).norm(), 1e-4);
}

TEST(WindowNormals, OfASmallWindowLeadNotOverAStep) {
  // Two walls that face the camera, all of them measured: a steep plane leaves little of the step in seven pixels.
  constexpr float kNear = 3.0f, kStep = 0.2f;
  Cloud cloud;
  cloud.reset(80, 60, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float u = (static_cast<float>(i % 80) - 39.5f) / 525.0f, v = (static_cast<float>(i / 80) - 29.5f) / 525.0f;
    const float z = i % 80 < 40 ? kNear : kNear + kStep;
    cloud.setPoint(i, u * z, v * z, z, {});
  }
  for (std::uint32_t column = 34; column < 46; ++column) {
    const auto found = windowNormal(cloud, 30 * 80 + column, 3, {1.0f / 525.0f, 1.0f / 525.0f});
    ASSERT_TRUE(found) << column;
    EXPECT_LT(test::angle(found->direction, -Vec3::UnitZ()), 0.02) << column;
  }
}

TEST(WindowNormals, AreMissingWhereThePixelStandsAlone) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  const std::size_t pixel = 60 * 160 + 80;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i != pixel) cloud.z[i] = std::numeric_limits<float>::quiet_NaN();
  }
  EXPECT_FALSE(windowNormal(cloud, pixel, 5));
}

TEST(WindowNormals, AreRobustAgainstStragglersInTheWindow) {
  Cloud cloud = cameraCloud(Vec3(0.3, 0, 1).normalized(), 1.0);
  // One side of the window stands off by 2 cm: within the first pass' reach, beyond the noise.
  for (int row = 55; row <= 65; ++row) {
    for (int column = 83; column <= 85; ++column) {
      const std::size_t i = row * 160 + column;
      for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) (*values)[i] *= 1.02f;
    }
  }
  const std::optional<WindowNormal> found = windowNormal(cloud, 60 * 160 + 80, 5);
  ASSERT_TRUE(found);
  EXPECT_LT((found->direction + Vec3(0.3, 0, 1).normalized()).norm(), 1e-3);
}

TEST(WindowNormals, LookAtAWiderWindowNearby) {
  // Noise of half a millimetre in a checkerboard; a wider window averages more of it away.
  const auto errorAt = [](double depth) {
    Cloud cloud = cameraCloud(Vec3::UnitZ(), depth);
    addNoise(0.002, 39, cloud);
    Samples samples;
    drawSamples(cloud, 300, 1, samples);
    NormalSource source;
    Params params;
    params.normal_window = 20;  // this image is coarse
    estimateNormals(cloud, params, source, samples);
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!samples.hasNormal(i)) continue;  // a pixel beyond the tolerance has none
      sum += (samples.normal(i) + Vec3::UnitZ()).norm(), count += 1.0;
    }
    EXPECT_GE(count, 295.0);
    return sum / count;
  };
  // The noise is a share of the depth, so the angle of a fixed window would be the same at both.
  EXPECT_LT(2.0 * errorAt(0.7), errorAt(2.0));
}

TEST(WindowNormals, OfACoarseImageLookAtAsMuchOfTheScene) {
  // A focal length of 140 px is 0.27 of the usual one: 7 px at 1 m become 2.
  Cloud cloud = cameraCloud(Vec3(0.3, 0, 1).normalized(), 1.0);
  addNoise(0.001, 38, cloud);
  Samples samples;
  drawSamples(cloud, 300, 1, samples);
  NormalSource source;
  estimateNormals(cloud, Params(), source, samples);
  EXPECT_NEAR(shareOfUsualWindows(*source.rays), 140.0 / 525.0, 1e-3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto expected = windowNormal(cloud, samples.index[i], samples.point(i), 2, *source.pitch);
    if (expected) {
      EXPECT_LT((samples.normal(i) - expected->direction).norm(), 1e-6) << i;
    }
  }
  EXPECT_EQ(shareOfUsualWindows(ImageRays()), 1.0) << "not known";
}

TEST(WindowNormals, ReachTheCornersOfTheImage) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (const std::uint32_t pixel : {0u, 159u, 119u * 160u, 119u * 160u + 159u}) {
    const std::optional<WindowNormal> found = windowNormal(cloud, pixel, 5);
    ASSERT_TRUE(found) << pixel;
    EXPECT_LT((found->direction + Vec3::UnitZ()).norm(), 1e-4);
  }
}

/// Exact points of a tube that stands upright 1 m away, with nothing behind it.
Cloud cloudOfTube(const Cylinder& tube) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 ray = cloud.point(i) / cloud.z[i];
    const double across = ray.x() * ray.x() + 1.0, half = tube.point.z();
    const double root = half * half - across * (half * half - tube.radius * tube.radius);
    const double z = root > 0.0 ? (half - std::sqrt(root)) / across : std::numeric_limits<double>::quiet_NaN();
    cloud.x[i] = static_cast<float>(ray.x() * z), cloud.y[i] = static_cast<float>(ray.y() * z);
    cloud.z[i] = static_cast<float>(z);
  }
  return cloud;
}

TEST(WindowNormals, BesideALimbAreThoseOfTheMiddleOfTheirPixels) {
  const Cylinder tube = {Vec3(0, 0, 1.0), Vec3::UnitY(), 0.06};
  const Cloud cloud = cloudOfTube(tube);
  const auto off = [&tube](const WindowNormal& found, const Vec3& place) {
    return std::acos(std::min(found.direction.dot(normalAt(tube, place)), 1.0)) / kDegree;
  };
  int beside = 0;
  for (std::uint32_t column = 0; column < 160; ++column) {
    const std::uint32_t pixel = 60 * 160 + column;
    const std::optional<WindowNormal> found = windowNormal(cloud, pixel, 5);
    if (!found) continue;
    const Vec3 point = cloud.point(pixel);
    EXPECT_NEAR(found->direction.dot(found->place - found->point), 0.0, 1e-6);
    EXPECT_LT(off(*found, found->place), 6.0) << column;
    beside += off(*found, point) > 9.0 ? 1 : 0;
  }
  EXPECT_EQ(beside, 2) << "one at either limb, where the normal at the point itself is another one";
}

TEST(NeighborNormals, OfUnorganizedCloudsFollowTheSphere) {
  // Of all sides: no camera sees that from one place.
  Random random(32);
  const Sphere sphere = {Vec3(0.1, 0.0, 1.0), 0.3};
  std::vector<test::SurfacePoint> points;
  for (int i = 0; i < 8000; ++i) points.push_back(test::pointOn(sphere, test::randomDirection(random)));
  Cloud cloud = test::cloudOf(points);
  for (std::vector<float>* values : {&cloud.nx, &cloud.ny, &cloud.nz}) values->clear();
  Samples samples;
  drawSamples(cloud, 200, 1, samples);
  NormalSource source;
  estimateNormals(cloud, Params(), source, samples);
  std::vector<double> errors;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_TRUE(samples.hasNormal(i));
    EXPECT_LT(samples.normal(i).dot(samples.point(i)), 0.0);  // towards the sensor
    errors.push_back(test::lineAngle(normalAt(sphere, samples.point(i)), samples.normal(i)));
  }
  std::nth_element(errors.begin(), errors.begin() + 100, errors.end());
  // 41 neighbours of a sphere of 8000 points span 8 deg either way; their plane is off by a fraction of that.
  EXPECT_LT(errors[100], 2.0 * kDegree);
}

TEST(NeighborNormals, ThatAreMeasuredAnewPointTowardsTheSensorAgain) {
  // So thick that six neighbours tell nothing of its direction, and all sides are the wrong one half of the time.
  Random random(33);
  std::vector<Vec3> points;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-0.5, 0.5), y = random.uniform(-0.5, 0.5);
    points.emplace_back(x, y, 1.0 + 0.01 * random.gaussian());
  }
  const Cloud cloud = test::listOf(points);
  Samples samples;
  drawSamples(cloud, 200, 1, samples);
  NormalSource source;
  for (const int neighbors : {6, 300}) {
    source.neighbor_count = neighbors;
    estimateNormals(cloud, Params(), source, samples);
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_TRUE(samples.hasNormal(i));
    EXPECT_LT(samples.normal(i).dot(samples.point(i)), 0.0);
  }
}

TEST(WindowNormals, AreFoundInAnImageThatLostItsOrder) {
  const Vec3 normal = Vec3(0.3, -0.2, 1.0).normalized();
  const Cloud image = cameraCloud(normal, 1.0);
  List<std::uint32_t> order(image.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  Random random(35);
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(image.size()), 1, false);
  for (std::size_t i = 0; i < order.size(); ++i) {
    cloud.setPoint(i, image.x[order[i]], image.y[order[i]], image.z[order[i]], {});
  }
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(cloud));
  EXPECT_TRUE(isDepthImage(projected.image()));
  Samples samples;
  drawSamples(projected.image(), 200, 1, samples);
  NormalSource source;
  estimateNormals(projected.image(), Params(), source, samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_TRUE(samples.hasNormal(i)) << i;
    EXPECT_LT((samples.normal(i) + normal).norm(), 1e-3) << i;
    EXPECT_GT(samples.normal_sigma[i], 0.0f) << i;
  }
}

TEST(NeighborNormals, OfPointsOnALineOrInOnePlaceAreMissing) {
  Cloud line;
  line.reset(20, 1, false);
  for (std::size_t i = 0; i < 20; ++i) line.setPoint(i, 0.1f * static_cast<float>(i), 0.0f, 1.0f, {});
  List<std::uint32_t> all(20);
  for (std::uint32_t i = 0; i < 20; ++i) all[i] = i;
  EXPECT_FALSE(planeNormal(line, all));
  for (std::size_t i = 0; i < 20; ++i) line.x[i] = 1.0f;
  EXPECT_FALSE(planeNormal(line, all));
}

/// Of a tilted plane 1 m away, with a little noise: six rows of 200 points, 1 mm apart, so far from each other (m).
Cloud rowsOfPlane(float apart, float noise = 0.0003f) {
  Random random(7);
  Cloud cloud;
  cloud.reset(200 * 6, 1, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float x = 0.001f * static_cast<float>(i % 200) - 0.1f;
    const float y = apart * (static_cast<float>(i / 200) - 2.5f);
    const float depth = 1.0f / (1.0f - 0.4f * x - 0.3f * y) + noise * static_cast<float>(random.gaussian());
    cloud.setPoint(i, x * depth, y * depth, depth, {});
  }
  return cloud;
}

TEST(NeighborNormals, OfRowsThatAreFarApartAreNotThoseOfTheScan) {
  const auto normalsOf = [](const Cloud& cloud, bool from_origin) {
    Samples samples;
    drawSamples(cloud, 300, 1, samples);
    NormalSource source;
    source.from_origin = from_origin;
    estimateNormals(cloud, Params(), source, samples);
    return samples;
  };
  const Vec3 truth = Vec3(0.4, 0.3, -1.0).normalized();
  // 164 neighbours are of a row and the next one, or of one alone.
  for (const float noise : {0.0f, 0.0003f}) {  // without any, one row is a line
    const Samples reached = normalsOf(rowsOfPlane(0.06f, noise), true);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      ASSERT_TRUE(reached.hasNormal(i)) << noise;
      EXPECT_LT(test::lineAngle(reached.normal(i), truth), 2.0 * kDegree) << noise;
    }
  }
  const Samples alone = normalsOf(rowsOfPlane(0.3f), true);
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_FALSE(alone.hasNormal(i));
  const Samples of_no_sensor = normalsOf(rowsOfPlane(0.3f), false);
  for (std::size_t i = 0; i < of_no_sensor.size(); ++i) EXPECT_TRUE(of_no_sensor.hasNormal(i));
}

TEST(DepthCamera, SeesAnImageWhoseEveryPointLiesInFront) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  EXPECT_TRUE(isDepthImage(cloud));
  cloud.setPoint(5000, 0.5f, 0.5f, -1.0f, {});
  EXPECT_FALSE(isDepthImage(cloud));
}

TEST(CloudNormals, AreKeptOrTurnedTowardsTheSensor) {
  Cloud cloud = test::cloudOf({{Vec3(0, 0, 1), Vec3(0, 0, 1)}, {Vec3(0, 1, 1), Vec3(0, 0, -1)}});
  Samples samples = test::samplesOf({{Vec3(0, 0, 1), Vec3::UnitX()}, {Vec3(0, 1, 1), Vec3::UnitX()}});
  Params params;
  NormalSource source;
  params.orient_normals = false;
  estimateNormals(cloud, params, source, samples);
  EXPECT_FLOAT_EQ(samples.nz[0], 1.0f);
  params.orient_normals = true;
  estimateNormals(cloud, params, source, samples);
  EXPECT_FLOAT_EQ(samples.nz[0], -1.0f);
  EXPECT_FLOAT_EQ(samples.nz[1], -1.0f);
}

TEST(CloudNormals, ThatAreMeasuredAnewAreTurnedAsTheyWouldBe) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  cloud.height = 1, cloud.width = static_cast<std::uint32_t>(cloud.size());
  // Away from the sensor, but so aslant that on the left they look towards it.
  for (std::vector<float>* values : {&cloud.nx, &cloud.ny, &cloud.nz}) values->resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.setNormal(i, 1.0f, 0.0f, 0.1f);
  Samples samples;
  drawSamples(cloud, 50, 1, samples);
  for (const bool turned : {false, true}) {
    Params params;
    params.orient_normals = turned;
    NormalSource source;
    source.neighbor_count = 20;
    estimateNormals(cloud, params, source, samples);
    for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_NEAR(samples.nz[i], turned ? -1.0f : 1.0f, 1e-3f);
  }
}

/// Of a whole ball, seen through.
std::vector<test::SurfacePoint> wholeBall(const Vec3& center) {
  Random random(5);
  std::vector<test::SurfacePoint> points;
  for (int i = 0; i < 4000; ++i) points.push_back(test::pointOn(Sphere{center, 0.2}, test::randomDirection(random)));
  return points;
}

/// The side of a ball that a sensor at the origin sees.
std::vector<test::SurfacePoint> frontOfBall(double sign_of_normals) {
  Random random(5);
  std::vector<test::SurfacePoint> points = patchOf(Sphere{Vec3::UnitZ(), 0.2}, 2000, random);
  for (test::SurfacePoint& on : points) on.normal *= sign_of_normals;
  return points;
}

bool detectorSaysTheyFaceAway(const std::vector<test::SurfacePoint>& points, bool orient_normals = false) {
  Params params;
  params.orient_normals = orient_normals;
  return Detector(params).detect(test::cloudOf(points)).normals_face_away;
}

TEST(CloudNormals, ThatFaceAwayFromTheSensorAreTold) {
  EXPECT_TRUE(detectorSaysTheyFaceAway(frontOfBall(-1.0)));
  EXPECT_FALSE(detectorSaysTheyFaceAway(frontOfBall(1.0)));
  EXPECT_FALSE(detectorSaysTheyFaceAway(frontOfBall(-1.0), true)) << "they are turned";
  EXPECT_FALSE(detectorSaysTheyFaceAway(wholeBall(Vec3::UnitZ()))) << "only those of its far side";
  EXPECT_FALSE(detectorSaysTheyFaceAway(wholeBall(Vec3::Zero()))) << "the origin is in it, not a sensor";
}

TEST(CloudNormals, OfNoSamplesNeedNoNeighbours) {
  const Cloud cloud = test::cloudOf(frontOfBall(1.0));
  Samples none;
  NormalSource source;
  estimateNormals(cloud, Params(), source, none);
  EXPECT_FALSE(source.neighbors);
}

TEST(CloudNormals, ThatAreAllMissingAreEstimated) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (std::vector<float>* values : {&cloud.nx, &cloud.ny, &cloud.nz}) {
    values->assign(cloud.size(), std::numeric_limits<float>::quiet_NaN());
  }
  Samples samples;
  drawSamples(cloud, 50, 1, samples);
  NormalSource source;
  estimateNormals(cloud, Params(), source, samples);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_NEAR(samples.nz[i], -1.0f, 1e-4f);
}

/// Of a pixel's window of 11 x 11 pixels, steadied so far.
std::optional<WindowNormal> steadied(const Cloud& cloud, std::uint32_t pixel, double steadying) {
  return windowNormal(cloud, pixel, cloud.point(pixel), 5, {}, 1.0, steadying);
}

TEST(SteadyPoints, HaveUpToAThirdOfThePixelsNoise) {
  // The point goes to the mean of 3 x 3 pixels, of which it is one.
  const Vec3 normal = Vec3(0.4, -0.2, 1.0).normalized();
  Cloud cloud = cameraCloud(normal, 1.0);
  addNoise(0.0005, 41, cloud);
  for (const double steadying : {0.0, 0.5, 1.0}) {
    double own = 0.0, steady = 0.0;
    int count = 0;
    for (std::uint32_t pixel = 0; pixel < cloud.size(); pixel += 61) {
      const auto found = steadied(cloud, pixel, steadying);
      if (!found) continue;
      ++count;
      EXPECT_LT(found->point.cross(cloud.point(pixel)).norm(), 1e-6) << "on the pixel's ray";
      const auto square = [&normal](const Vec3& point) { return std::pow(normal.dot(point) - 1.0, 2); };
      own += square(cloud.point(pixel)), steady += square(found->point);
    }
    EXPECT_GT(count, 300);
    const double left = 1.0 - steadying;
    EXPECT_NEAR(std::sqrt(steady / own), std::sqrt(left * left + (1.0 - left * left) / 9.0), 0.05) << steadying;
  }
}

TEST(SteadyPoints, StayOnATubeAndOnTheirSideOfAStep) {
  const Cylinder tube = {Vec3(0, 0, 1.0), Vec3::UnitY(), 0.06};
  const Cloud round = cloudOfTube(tube);
  // Two walls that face the camera, with more between them than one surface has.
  Cloud step = cameraCloud(Vec3::UnitZ(), 1.0);
  for (std::size_t i = 0; i < step.size(); ++i) {
    const float factor = i % 160 < 80 ? 1.0f : 1.08f;
    for (std::vector<float>* values : {&step.x, &step.y, &step.z}) (*values)[i] *= factor;
  }
  int on_tube = 0;
  for (std::uint32_t column = 40; column < 120; ++column) {
    const std::uint32_t pixel = 60 * 160 + column;
    if (const auto found = steadied(round, pixel, 1.0)) {
      ++on_tube;
      EXPECT_NEAR(distance(Shape(tube), found->point), 0.0, 0.001) << column << ": of 7 mm a pixel";
    }
    const auto beside = steadied(step, pixel, 1.0);
    ASSERT_TRUE(beside) << column;
    EXPECT_NEAR(beside->point.z(), step.z[pixel], 1e-4) << column;
  }
  EXPECT_GT(on_tube, 12);
}

TEST(SteadyPoints, AreThoseOfTheSamples) {
  Cloud cloud = cameraCloud(Vec3(0.3, 0, 1).normalized(), 1.0);
  addNoise(0.0005, 42, cloud);
  Samples drawn;
  drawSamples(cloud, 300, 1, drawn);
  for (const double steadying : {0.0, 0.6}) {
    Samples samples = drawn;
    NormalSource source;
    source.steadying = steadying;
    estimateNormals(cloud, Params(), source, samples);
    int moved = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::uint32_t pixel = samples.index[i];
      const Vec3 own = cloud.point(pixel);
      const auto expected = windowNormal(cloud, pixel, own, 2, *source.pitch, 1.0, steadying);
      EXPECT_LT((samples.point(i) - (expected ? expected->point : own)).norm(), 1e-6);
      moved += (samples.point(i) - own).norm() > 1e-5 ? 1 : 0;
    }
    if (steadying == 0.0) {
      EXPECT_EQ(moved, 0);
    } else {
      EXPECT_GT(moved, 250);
    }
  }
}

}  // namespace
}  // namespace primitect::normals_test
