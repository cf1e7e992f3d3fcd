// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Hypotheses over the rounds of a frame: proposed, selected, split, refused.
#include "core/verification.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "test/support/candidates.h"
#include "test/support/noisy_points.h"
#include "test/support/scenes.h"

namespace primitect::verification_test {
namespace {

using test::kDegree;
using test::kNoise;
using test::measured;
using test::patchOf;
using test::SurfacePoint;
using test::together;

constexpr double kTurn = 0.06;  // rad, of normals
constexpr double kDiameter = 1.0;

const Plane kWall = {Vec3(0, 0, 1.3), Vec3(0, 0, -1)};
const Sphere kBall = {Vec3(-0.2, 0, 1), 0.08};
const Cylinder kCan = {Vec3(0.2, 0, 1), Vec3(0, -1, 0), 0.06};

/// Samples of a round and what they vote for, strongest first.
void addRound(Verification& verification, const Samples& samples, List<Candidate> candidates) {
  for (Candidate& candidate : candidates) {
    candidate.sample += static_cast<std::uint32_t>(verification.samples().size());
  }
  verification.addSamples(samples);
  verification.propose(candidates);
  verification.select();
}

/// A frame, fed by rounds of points and what they vote for.
class Frame {
 public:
  explicit Frame(const Params& params = Params(), double diameter = kDiameter)
      : params_(params), diameter_(diameter), verification_(params) {
    verification_.begin({diameter, false});
  }
  void round(const std::vector<SurfacePoint>& points) {
    List<Candidate> candidates = test::candidatesOf(points, diameter_, params_);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.votes > b.votes; });
    if (verification_.samples().size() == 0) verification_.measureNoise(test::samplesOf(points), candidates);
    addRound(verification_, test::samplesOf(points), candidates);
  }
  void conclude(const std::vector<SurfacePoint>& points = {}, const Verification::AskImage& ask_image = nullptr) {
    verification_.addSamples(test::samplesOf(points));
    verification_.conclude(ask_image);
  }

  const Verification& verification() const { return verification_; }
  const List<Segment>& segments() const { return verification_.segments(); }
  std::vector<const Segment*> of(Kind kind) const {
    std::vector<const Segment*> found;
    for (const Segment& segment : segments()) {
      if (kindOf(segment.candidate.shape) == kind) found.push_back(&segment);
    }
    return found;
  }
  const Segment* only(Kind kind) const { return of(kind).size() == 1 ? of(kind)[0] : nullptr; }

 private:
  Params params_;
  double diameter_;
  Verification verification_;
};

std::vector<SurfacePoint> noisy(const std::vector<SurfacePoint>& points, Random& random) {
  return measured(points, kNoise, kTurn, random);
}

/// A rectangle facing the sensor, half as wide as long.
std::vector<SurfacePoint> plate(const Vec3& middle, double half_width, double half_height, int count, Random& random) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(
        {middle + Vec3{random.uniform(-half_width, half_width), random.uniform(-half_height, half_height), 0},
         Vec3(0, 0, -1)});
  }
  return points;
}

std::vector<SurfacePoint> wallBallAndCan(int of_ball, Random& random) {
  return noisy(together({patchOf(kWall, 600, 0.4, random), patchOf(kBall, of_ball, random),
                         patchOf(kCan, 300, -0.1, 0.1, random)}),
               random);
}

void expectEverySampleOnce(const Frame& frame) {
  std::vector<int> owners(frame.verification().samples().size(), 0);
  for (const Segment& segment : frame.segments()) {
    for (const std::uint32_t i : segment.inliers) ++owners.at(i);
  }
  for (const int count : owners) EXPECT_LE(count, 1);
}

TEST(Verification, FindsEachShapeOnceAndExplainsEachSampleOnce) {
  Random random(91);
  Frame frame;
  frame.round(wallBallAndCan(300, random));
  ASSERT_EQ(frame.segments().size(), 3u);
  EXPECT_TRUE(frame.only(Kind::plane) && frame.only(Kind::sphere) && frame.only(Kind::cylinder));
  expectEverySampleOnce(frame);
  EXPECT_NEAR(frame.verification().noise().distance, kNoise, 0.3 * kNoise);
}

/// Its upper half is rounder than the lower one: each alone is a ball.
TEST(Verification, FindsOneBallWhereAThingIsNearlyOne) {
  const Sphere wide = {Vec3(0, 0, 1), 0.12}, narrow = {Vec3(0, 0.025, 0.992), 0.1};
  Random random(95);
  std::vector<SurfacePoint> bowl;
  for (const Sphere& half : {wide, narrow}) {
    for (const SurfacePoint& point : patchOf(half, 900, random)) {
      const bool above = point.point.y() < 0.0;
      if (above == (half.radius == wide.radius)) bowl.push_back(point);
    }
  }
  Frame frame;
  frame.round(noisy(together({patchOf(kWall, 600, 0.4, random), bowl}), random));
  EXPECT_EQ(frame.of(Kind::sphere).size(), 2u) << "nothing is refused before the end";
  frame.conclude();
  ASSERT_EQ(frame.of(Kind::sphere).size(), 1u);
  expectEverySampleOnce(frame);
}

TEST(Verification, FindsInTheSecondRoundWhatWasTooSmallInTheFirst) {
  Random random(92);
  Frame frame;
  frame.round(wallBallAndCan(12, random));  // fewer than min_inliers
  EXPECT_FALSE(frame.only(Kind::sphere));
  ASSERT_TRUE(frame.only(Kind::plane) && frame.only(Kind::cylinder));
  const std::size_t of_can = frame.only(Kind::cylinder)->inliers.size();
  frame.round(noisy(together({patchOf(kBall, 60, random), patchOf(kCan, 30, -0.1, 0.1, random)}), random));
  const Segment* ball = frame.only(Kind::sphere);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(std::get<Sphere>(ball->candidate.shape).radius, kBall.radius, 2.0 * kNoise);
  // The samples of both rounds count for what either found.
  EXPECT_EQ(frame.verification().samples().size(), 912u + 90u);
  EXPECT_GT(ball->inliers.size(), 65u);
  ASSERT_TRUE(frame.only(Kind::cylinder));
  EXPECT_GT(frame.only(Kind::cylinder)->inliers.size(), of_can + 25u);
  expectEverySampleOnce(frame);
}

TEST(Verification, ForgetsTheLastFrame) {
  Random random(93);
  const std::vector<SurfacePoint> points = wallBallAndCan(300, random);
  Verification used{Params()}, fresh{Params()};
  for (Verification* verification : {&used, &used, &fresh}) {
    verification->begin({kDiameter, false});
    EXPECT_TRUE(verification->segments().empty());
    EXPECT_EQ(verification->samples().size(), 0u);
    const List<Candidate> candidates = test::candidatesOf(points, kDiameter, Params());
    verification->measureNoise(test::samplesOf(points), candidates);
    addRound(*verification, test::samplesOf(points), candidates);
  }
  ASSERT_EQ(used.segments().size(), fresh.segments().size());
  for (std::size_t k = 0; k < fresh.segments().size(); ++k) {
    EXPECT_EQ(used.segments()[k].inliers, fresh.segments()[k].inliers);
  }
}

TEST(Verification, MeasuresTheNoiseOfAThinTubeThatItDoesNotTakeForAnEdgeBeforeItKnows) {
  // Of 20 mm, 100 deg of it: thinner than 6.5 times the noise that is expected before it is measured, 5 mm.
  constexpr double kTurn = 0.05;
  const Cylinder tube = {Vec3(0, 0, 1), Vec3::UnitX(), 0.02};
  Random random(99);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 300; ++i) {
    points.push_back(test::pointOn(tube, {random.uniform(-0.2, 0.2), random.uniform(0.0, 100.0 * test::kDegree)}));
  }
  points = test::measured(points, test::kNoise, kTurn, random);
  FrameScale scale;
  scale.fitted_normals = true;
  Verification verification{Params()};
  for (int time = 0; time < 2; ++time) {  // the second time it knew
    verification.begin(scale);
    for (int k = 0; k < 2; ++k) {
      verification.measureNoise(test::samplesOf(points), {test::candidate(tube, points[0], 9.0)});
      ASSERT_TRUE(verification.noiseMeasured());
      EXPECT_NEAR(verification.noise().distance, test::kNoise, 0.2 * test::kNoise);
    }
  }
}

TEST(Verification, ToleratesLessOfSamplesThanOfPoints) {
  Random random(90);
  FrameScale scale;
  scale.depth_camera = true;
  scale.image_noise = 4.0, scale.sample_noise = 2.0;
  Verification verification{Params()};
  verification.begin(scale);
  verification.addSamples(test::samplesOf(plate(Vec3(0, 0, 1.0), 0.1, 0.1, 50, random)));
  EXPECT_DOUBLE_EQ(verification.noise().scale, toleratedScale(4.0));
  EXPECT_DOUBLE_EQ(verification.fullNoise().scale, fullScale(4.0));
  EXPECT_NEAR(verification.samples().sigma.front(), toleratedScale(2.0) * axialNoise(1.0), 1e-5);
}

TEST(Verification, SplitsPartsThatLieInNearlyTheSamePlane) {
  // 8 mm between them, 40 cm apart: at the noise that is expected before it is measured, 5 mm, they are one.
  Random random(94);
  Frame frame;
  frame.round(noisy(
      together({plate(Vec3(-0.3, 0, 1.0), 0.1, 0.2, 400, random), plate(Vec3(0.3, 0, 1.008), 0.1, 0.2, 400, random)}),
      random));
  frame.conclude();
  ASSERT_EQ(frame.of(Kind::plane).size(), 2u);
  ASSERT_EQ(frame.segments().size(), 2u);
  for (const Segment* segment : frame.of(Kind::plane)) {
    const Plane& plane = std::get<Plane>(segment->candidate.shape);
    EXPECT_LT(test::lineAngle(plane.normal, Vec3::UnitZ()), 1.0 * kDegree);
    const bool left = segment->inliers[0] < 400;
    EXPECT_NEAR(distance(plane, left ? Vec3(-0.3, 0, 1.0) : Vec3(0.3, 0, 1.008)), 0.0, kNoise);
    EXPECT_GT(segment->inliers.size(), 340u);  // most of 400
  }
}

TEST(Verification, RefusesTubesThatAreNotSeenWhileOthersMayHaveTheirSamples) {
  Random random(101);
  const Cylinder can = {Vec3(0, 0, 1.0), Vec3::UnitX(), 0.05};
  const std::vector<SurfacePoint> points =
      noisy(together({plate(Vec3(-0.4, 0, 1.0), 0.1, 0.2, 300, random), patchOf(can, 300, -0.1, 0.1, random)}), random);
  for (const bool is_seen : {true, false}) {
    Frame frame;
    frame.round(points);
    int asked = 0;
    frame.conclude({}, [&](const Segment& tube) {
      ++asked;
      EXPECT_EQ(kindOf(tube.candidate.shape), Kind::cylinder);
      return is_seen ? Verification::ImageSays::nothing : Verification::ImageSays::not_seen;
    });
    EXPECT_GE(asked, 1);
    EXPECT_EQ(frame.of(Kind::cylinder).size(), is_seen ? 1u : 0u);
    EXPECT_EQ(frame.verification().refusals()[Refusal::not_seen] > 0, !is_seen);
    EXPECT_GE(frame.of(Kind::plane).size(), 1u);
  }
}

/// The side that is seen of what curves along the x axis so much of how it curves around it.
std::vector<SurfacePoint> bulgingTube(double radius, double bulge, double half_length, int count, Random& random) {
  std::vector<SurfacePoint> points;
  const double along = radius / bulge;  // radius of the arcs along the axis
  for (int k = 0; k < count; ++k) {
    const double at = random.uniform(-half_length, half_length) / along, turn = random.uniform(-1.2, 1.2);
    const Vec3 out(0.0, std::sin(turn), -std::cos(turn)), normal = std::cos(at) * out + std::sin(at) * Vec3::UnitX();
    points.push_back({Vec3(0, 0, 1) + (radius - along) * out + along * normal, normal});
  }
  return points;
}

TEST(Verification, TakesABallForATubeThatBulgesWhereOneFits) {
  struct Case {
    double bulge;
    bool is_asked;
    Kind kind;
  };
  for (const Case& one : {Case{0.4, false, Kind::cylinder}, {0.4, true, Kind::sphere}, {0.01, true, Kind::cylinder}}) {
    Random random(1);
    const std::vector<SurfacePoint> points = noisy(
        together({plate(Vec3(-0.4, 0, 1.0), 0.1, 0.2, 300, random), bulgingTube(0.06, one.bulge, 0.05, 300, random)}),
        random);
    Frame frame;
    frame.round(points);
    frame.conclude({}, [&](const Segment& segment) {
      const bool ball = kindOf(segment.candidate.shape) == Kind::sphere;
      return one.is_asked && !ball ? Verification::ImageSays::bulges : Verification::ImageSays::nothing;
    });
    for (const Kind kind : {Kind::sphere, Kind::cylinder, Kind::cone}) {
      EXPECT_EQ(frame.of(kind).size(), kind == one.kind ? 1u : 0u) << one.bulge << ' ' << kindName(kind);
    }
    EXPECT_EQ(frame.verification().refusals()[Refusal::unlikely] > 0, one.kind == Kind::sphere);
    EXPECT_EQ(frame.verification().refusals()[Refusal::not_seen], 0u);
  }
}

TEST(Verification, KeepsPartsOfOnePlaneTogether) {
  Random random(96);
  Frame frame;
  frame.round(noisy(
      together({plate(Vec3(-0.3, 0, 1.0), 0.1, 0.2, 400, random), plate(Vec3(0.3, 0, 1.0), 0.1, 0.2, 400, random)}),
      random));
  frame.conclude();
  ASSERT_EQ(frame.segments().size(), 1u);
  EXPECT_GT(frame.segments()[0].inliers.size(), 770u);
}

/// Two tops of 10 cm, 2 cm apart, that lean away from each other by so much (rad): the left one's points first.
std::vector<SurfacePoint> leaningTops(double lean, int count_each, Random& random) {
  std::vector<SurfacePoint> points;
  for (const double side : {-1.0, 1.0}) {
    const Vec3 normal = Vec3(side * std::sin(lean), 0, -std::cos(lean));
    for (int i = 0; i < count_each; ++i) {
      const double along = side * random.uniform(0.01, 0.11), across = random.uniform(-0.05, 0.05);
      points.push_back({Vec3(along, across, 1.0 + std::tan(lean) * std::abs(along)), normal});
    }
  }
  return points;
}

TEST(Verification, FitsThePartsOfAPlaneApartOnceSamplesTellThatThereIsAGap) {
  // The plane through both tops is at most 1.5 mm off, half of the tolerance; that of either is 6 mm off the other's
  // far end.
  constexpr double kLean = 0.03;
  Random random(95);
  // 30 samples of either: every gap among them is as wide as that between the tops.
  const std::vector<SurfacePoint> few = noisy(leaningTops(kLean, 30, random), random);
  const std::vector<SurfacePoint> many = noisy(leaningTops(kLean, 400, random), random);
  const Plane both = {Vec3(0, 0, 1.0 + 0.06 * kLean), Vec3(0, 0, -1)};
  Verification verification{Params()};
  verification.begin({kDiameter, false});
  verification.measureNoise(test::samplesOf(many),
                            {test::candidate({Plane{many[0].point, many[0].normal}}, many[0], 9)});
  addRound(verification, test::samplesOf(few), {test::candidate(both, few[0], 9.0)});
  ASSERT_EQ(verification.segments().size(), 1u);
  EXPECT_GT(verification.segments()[0].inliers.size(), 50u);
  verification.addSamples(test::samplesOf(many));
  verification.conclude();
  ASSERT_EQ(verification.segments().size(), 2u);
  for (const Segment& segment : verification.segments()) {
    const Plane& plane = std::get<Plane>(segment.candidate.shape);
    EXPECT_NEAR(std::abs(plane.normal.x()), std::sin(kLean), 0.2 * kLean);
    EXPECT_GT(segment.inliers.size(), 380u);  // most of 430, but those near the other's edge
  }
}

TEST(Verification, KeepsTopsOfNearlyOneHeightApartInDepthFrames) {
  // A plane through both is tilted by a 27th: nowhere farther off than 2 mm, where 6 mm make an inlier.
  constexpr double kStep = 0.006;
  Random random(97);
  std::vector<SurfacePoint> tops = noisy(together({plate(Vec3(-0.08, 0, 1.0), 0.05, 0.05, 150, random),
                                                   plate(Vec3(0.08, 0, 1.0 + kStep), 0.05, 0.05, 150, random)}),
                                         random);
  // What is a tenth of all that is seen may be what things stand on, and stays whole.
  tops = together({tops, noisy(plate(Vec3(0, 0, 1.3), 0.4, 0.4, 3000, random), random)});
  Verification verification{Params()};
  verification.begin({kDiameter, true});
  const Plane both = {Vec3(0, 0, 1.0 + 0.5 * kStep), Vec3(kStep / 0.16, 0, -1).normalized()};
  addRound(verification, test::samplesOf(tops), {test::candidate(both, tops[0], 9.0)});
  ASSERT_EQ(verification.segments().size(), 1u);
  verification.conclude();
  ASSERT_EQ(verification.segments().size(), 2u);
  for (const Segment& segment : verification.segments()) {
    EXPECT_GE(segment.inliers.size(), 148u);
    const bool left = segment.inliers[0] < 150;
    EXPECT_NEAR(distance(segment.candidate.shape, Vec3(left ? -0.08 : 0.08, 0, left ? 1.0 : 1.0 + kStep)), 0.0, kNoise);
  }
}

TEST(Verification, KeepsSurfacesThroughEachOtherApart) {
  // In squares of 15 cm, every other one nearer by 3.3 deviations: a plane for both stays with one of them.
  constexpr double kSquare = 0.15, kApart = 0.009;
  Random random(98);
  std::vector<SurfacePoint> points = noisy(patchOf(kWall, 1500, 0.4, random), random);
  Verification verification{Params()};
  verification.begin({kDiameter, true});
  verification.measureNoise(test::samplesOf(points), {test::candidate(kWall, points[0], 9.0)});
  List<Candidate> candidates(2);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    Vec3& point = points[i].point;
    const bool nearer = std::sin(M_PI / kSquare * point.x()) * std::sin(M_PI / kSquare * point.y()) > 0.0;
    const double before = nearer ? kApart : 0.0;
    point.z() -= before;
    Candidate& candidate = candidates[nearer ? 1 : 0];
    candidate = test::candidate(Plane{kWall.point - before * Vec3::UnitZ(), kWall.normal}, points[i], 9.0);
    candidate.sample = i;
  }
  addRound(verification, test::samplesOf(points), candidates);
  verification.conclude();
  ASSERT_EQ(verification.segments().size(), 2u);
  for (const Segment& segment : verification.segments()) {
    EXPECT_GT(segment.inliers.size(), 700u);
    const double off = std::abs(distance(segment.candidate.shape, kWall.point));
    EXPECT_LT(std::min(off, std::abs(off - kApart)), 0.5 * kNoise) << "as where one plane took the place of both";
  }
}

TEST(Verification, AsksEachPlaneOfEachFrameWhetherItIsWhole) {
  // Two pairs of tops, one of them level in both frames, the other in the first alone: at the same places, with the
  // same indices.
  constexpr double kStep = 0.006;
  Verification verification{Params()};
  for (const double step : {0.0, kStep}) {
    Random random(102);
    std::vector<SurfacePoint> points = together({plate(Vec3(-0.08, 0, 1.0), 0.05, 0.05, 150, random),
                                                 plate(Vec3(0.08, 0, 1.0 + step), 0.05, 0.05, 150, random)});
    points = together({points, plate(Vec3(-0.08, 0.3, 1.2), 0.05, 0.05, 160, random),
                       plate(Vec3(0.08, 0.3, 1.2), 0.05, 0.05, 160, random)});
    points = together({points, plate(Vec3(0, 0, 1.35), 0.4, 0.4, 3200, random)});
    const Plane both = {Vec3(0, 0, 1.0 + 0.5 * step), Vec3(step / 0.16, 0, -1).normalized()};
    const Plane level = {Vec3(0, 0.3, 1.2), Vec3(0, 0, -1)};
    List<Candidate> candidates = {test::candidate(level, points[300], 9.0), test::candidate(both, points[0], 9.0)};
    candidates[0].sample = 300;
    verification.begin({kDiameter, true});
    addRound(verification, test::samplesOf(points), candidates);
    ASSERT_EQ(verification.segments().size(), 2u);
    verification.conclude();
    ASSERT_EQ(verification.segments().size(), step > 0.0 ? 3u : 2u);
    EXPECT_EQ(verification.segments()[0].inliers.size(), 320u);  // the largest first
    EXPECT_EQ(verification.segments()[1].inliers.size(), step > 0.0 ? 150u : 300u);
  }
}

TEST(Verification, LeavesNothingForAConeOverTwoFacesOfABox) {
  Random random(97);
  const test::TwoFaces box;
  const std::vector<SurfacePoint> points = noisy(box.points(random), random);
  List<Candidate> candidates;
  const auto propose = [&](const Shape& shape, std::uint32_t sample, double votes) {
    candidates.push_back(test::candidate(shape, points[sample], votes));
    candidates.back().sample = sample;
  };
  propose(box.cone, 1, 100.0);
  // One sample in ten strays so far from its plane that it proposes nothing.
  for (const std::uint32_t k : {0u, 2u, 3u}) {
    propose(box.front, k, 90.0 - k);
    propose(box.top, 300 + k, 80.0 - k);
  }
  Verification verification{Params()};
  verification.begin({0.5, false});
  verification.measureNoise(test::samplesOf(points), candidates);
  addRound(verification, test::samplesOf(points), candidates);
  verification.conclude();
  ASSERT_EQ(verification.segments().size(), 2u);
  for (const Segment& segment : verification.segments()) {
    EXPECT_EQ(kindOf(segment.candidate.shape), Kind::plane);
  }
}

TEST(Verification, FindsBothSidesOfTheWallOfACup) {
  // Seen from above and in front: the outer wall, convex, and behind the rim the inner one, 4 mm smaller.
  const Vec3 axis = Vec3(0, -1, -0.6).normalized();
  const Cylinder outside = {Vec3(0, 0, 0.8), axis, 0.06}, inside = {Vec3(0, 0, 0.8), axis, 0.056};
  Random random(98);
  const std::vector<SurfacePoint> points = noisy(
      together({patchOf(outside, 500, -0.08, 0.08, random), test::wallOf(inside, 300, 0.0, 0.08, random)}), random);
  for (const char* convexity : {"both", "convex", "concave"}) {
    Params params;
    params.convexity = convexity;
    Frame frame(params, 0.3);
    frame.round(points);
    frame.conclude();
    std::size_t convex = 0, concave = 0;
    for (const Segment* segment : frame.of(Kind::cylinder)) {
      ++(segment->candidate.concave ? concave : convex);
      const double radius = std::get<Cylinder>(segment->candidate.shape).radius;
      EXPECT_NEAR(radius, segment->candidate.concave ? inside.radius : outside.radius, kNoise) << convexity;
    }
    EXPECT_EQ(convex, std::string(convexity) == "concave" ? 0u : 1u) << convexity;
    EXPECT_EQ(concave, std::string(convexity) == "convex" ? 0u : 1u) << convexity;
  }
}

TEST(Conclusion, RefusesAndCountsWhatIsUnlikely) {
  Random random(99);
  const std::vector<SurfacePoint> points = wallBallAndCan(300, random);
  Params params;
  params.min_confidence = 0.0;
  Frame all(params);
  all.round(points);
  all.conclude();
  ASSERT_EQ(all.segments().size(), 3u);
  EXPECT_EQ(all.verification().refusals()[Refusal::unlikely], 0u);
  std::vector<double> confidences;
  for (const Segment& segment : all.segments()) confidences.push_back(segment.confidence);
  std::sort(confidences.begin(), confidences.end());
  ASSERT_LT(confidences[0], confidences[1]);
  // A bound just above the least likely of them.
  params.min_confidence = 0.5 * (confidences[0] + confidences[1]);
  Frame bounded(params);
  bounded.round(points);
  EXPECT_EQ(bounded.segments().size(), 3u);  // not before the end
  bounded.conclude();
  EXPECT_EQ(bounded.segments().size(), 2u);
  EXPECT_GE(bounded.verification().refusals()[Refusal::unlikely], 1u);
  for (const Segment& segment : bounded.segments()) EXPECT_GE(segment.confidence, params.min_confidence);
}

TEST(Conclusion, TellsWhetherTheNoiseIsTheCloudsOwn) {
  Random random(101);
  const std::vector<SurfacePoint> points = noisy(patchOf(kWall, 600, 0.4, random), random);
  for (const bool depth_camera : {false, true}) {
    Verification verification{Params()};
    verification.begin({kDiameter, depth_camera});
    addRound(verification, test::samplesOf(points), {test::candidate(kWall, points[0], 9.0)});
    verification.conclude();
    ASSERT_EQ(verification.segments().size(), 1u);
    EXPECT_EQ(verification.segments()[0].evidence.own_noise, depth_camera ? 0.0f : 1.0f);
  }
}

TEST(Conclusion, TellsWhetherACanStands) {
  const Plane floor = {Vec3(0.2, 0.1, 1), Vec3(0, -1, 0)};
  for (const bool on_floor : {false, true}) {
    Random random(102);
    std::vector<SurfacePoint> points = patchOf(kCan, 300, -0.1, 0.1, random);
    for (const SurfacePoint& point : patchOf(on_floor ? floor : kWall, 600, 0.3, random)) points.push_back(point);
    Frame frame;
    frame.round(noisy(points, random));
    frame.conclude();
    const Segment *can = frame.only(Kind::cylinder), *plane = frame.only(Kind::plane);
    ASSERT_TRUE(can && plane) << on_floor;
    EXPECT_EQ(can->evidence.stands, on_floor ? 1.0f : 0.0f);
    EXPECT_EQ(plane->evidence.stands, 0.0f);
  }
}

TEST(Conclusion, SettlesTheShapesWithMoreSamples) {
  Random random(100);
  Frame frame;
  frame.round(wallBallAndCan(60, random));
  ASSERT_TRUE(frame.only(Kind::sphere));
  frame.conclude(noisy(patchOf(kBall, 1000, random), random));
  const Segment* ball = frame.only(Kind::sphere);
  ASSERT_TRUE(ball);
  EXPECT_GT(ball->inliers.size(), 1000u);
  // sigma / sqrt(1060), times about 3 as half of it is seen at most; three of these.
  EXPECT_NEAR(std::get<Sphere>(ball->candidate.shape).radius, kBall.radius, 3.0 * 3.0 * kNoise / std::sqrt(1060.0));
}

TEST(Conclusion, KeepsALargePlaneThatTheCloserLookOnlySeesTheOutskirtsOf) {
  Random random(57);
  // Too far off, on either side, and so aslant that no plane holds them.
  std::vector<SurfacePoint> outskirts = patchOf(kWall, 1500, 0.4, random);
  for (SurfacePoint& p : outskirts) {
    const double way = random.uniform(0.0, 2.0 * M_PI), aslant = 0.23;
    p.point.z() += (random.uniform() < 0.5 ? -4.5 : 4.5) * kNoise;
    p.normal = Vec3(std::sin(aslant) * std::cos(way), std::sin(aslant) * std::sin(way), -std::cos(aslant));
  }
  Frame frame;
  frame.round(noisy(patchOf(kWall, 600, 0.4, random), random));
  frame.conclude(measured(outskirts, kNoise, 0.0, random));
  const auto planes = frame.of(Kind::plane);
  const auto wall = std::find_if(planes.begin(), planes.end(), [](const Segment* plane) {
    return std::abs(distance(plane->candidate.shape, kWall.point)) < 0.5 * kNoise;
  });
  ASSERT_NE(wall, planes.end());
  EXPECT_LT((*wall)->evidence.against, 0.1f);
  EXPECT_GT((*wall)->confidence, 0.9);
}

TEST(Verification, CallsPlanesLargeByTheFirstDrawAlone) {
  Random random(59);
  const Vec3 lid = {0.3, 0.3, 1.1};
  Frame frame;
  frame.round(noisy(together({patchOf(kWall, 600, 0.4, random), plate(lid, 0.1, 0.05, 50, random)}), random));
  // Of all samples, the wall has less than 8 % and the lid most.
  frame.conclude(noisy(plate(lid, 0.1, 0.05, 6000, random), random));
  const auto planes = frame.of(Kind::plane);
  ASSERT_EQ(planes.size(), 2u);
  for (const Segment* plane : planes) {
    const bool is_wall = std::abs(distance(plane->candidate.shape, kWall.point)) < kNoise;
    EXPECT_EQ(plane->inliers.size() < 1000, is_wall);
    EXPECT_EQ(frame.verification().isLargePlane(*plane), is_wall);
  }
}

TEST(Confidence, OfRightShapesIsHigherThanOfAnyOnASaddle) {
  Random random(101);
  Params params;
  params.min_confidence = 0.0;
  Frame right(params);
  right.round(wallBallAndCan(300, random));
  right.conclude();
  double least = 1.0;
  for (const Segment& segment : right.segments()) least = std::min(least, segment.confidence);
  EXPECT_GT(least, 0.9);
  // A saddle is nothing that is known: planes, cylinders and cones touch parts of it.
  std::vector<SurfacePoint> saddle;
  for (int i = 0; i < 600; ++i) {
    const double u = random.uniform(-0.15, 0.15), v = random.uniform(-0.15, 0.15);
    saddle.push_back({Vec3(u, v, 1.0 + 4.0 * u * u - 2.5 * v * v), Vec3(8.0 * u, -5.0 * v, -1.0).normalized()});
  }
  Frame wrong(params, 0.5);
  wrong.round(noisy(saddle, random));
  wrong.conclude();
  ASSERT_FALSE(wrong.segments().empty());
  for (const Segment& segment : wrong.segments()) {
    EXPECT_LT(segment.confidence, least) << kindName(kindOf(segment.candidate.shape));
  }
}

TEST(Unexplained, AreSamplesOfNobodyWhereManyAreTogether) {
  Random random(98);
  Frame frame;
  std::vector<SurfacePoint> points = noisy(patchOf(kWall, 1200, 0.4, random), random);
  frame.round(points);
  ASSERT_TRUE(frame.only(Kind::plane));
  // A ball in front of the wall, and a few stray points, which no round has voted for.
  Verification verification = frame.verification();
  std::vector<SurfacePoint> more = noisy(patchOf(kBall, 200, random), random);
  for (const double x : {-0.4, 0.0, 0.4}) more.push_back({Vec3(x, 0.3, 0.6), Vec3(0, 0, -1)});
  verification.addSamples(test::samplesOf(more));
  const List<std::uint32_t> rest = verification.unexplained();
  EXPECT_GT(rest.size(), 190u);
  for (const std::uint32_t i : rest) EXPECT_NEAR(distance(kBall, verification.samples().point(i)), 0.0, 0.02) << i;
  // What they vote for, by indices into all rounds, becomes a ball.
  const std::size_t on_ball = rest[rest.size() / 2];
  Candidate candidate = test::candidate(kBall, more[0], 50.0);
  candidate.point = verification.samples().point(on_ball);
  candidate.normal = verification.samples().normal(on_ball);
  candidate.sample = static_cast<std::uint32_t>(on_ball);
  verification.propose({candidate});
  verification.conclude();
  const auto spheres = std::count_if(verification.segments().begin(), verification.segments().end(),
                                     [](const Segment& s) { return kindOf(s.candidate.shape) == Kind::sphere; });
  EXPECT_EQ(spheres, 1);
}

}  // namespace
}  // namespace primitect::verification_test
