// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the border of a shape tells, and how sure evidence makes us.
#include "core/evidence.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "test/support/hypotheses.h"

namespace primitect::evidence_test {
namespace {

using test::kKinds;
using test::kNoise;
using test::patchOf;
using test::SurfacePoint;

constexpr std::uint32_t kSelf = 0, kOther = 1;

/// Samples on surfaces, each owned by one shape or nobody, and what speaks for the shape kSelf.
class Scene {
 public:
  void add(const std::vector<SurfacePoint>& points, std::uint32_t owner) {
    points_.insert(points_.end(), points.begin(), points.end());
    owner_.resize(points_.size(), owner);
  }

  Evidence evidenceOf(const Shape& shape) const {
    const Samples samples = test::samplesWith(test::kNoiseModel, points_);
    SampleGraph graph;
    graph.build(samples);
    return gatherEvidence(samples, graph, owner_, kSelf, test::hypothesisOf(shape, samples));
  }

 private:
  std::vector<SurfacePoint> points_;
  List<std::uint32_t> owner_;
};

/// A patch of a large ball, cut in two: the cap within 30 deg of the view, and what goes on around it.
struct CutBall {
  Sphere sphere{Vec3(0, 0, 1.2), 0.2};
  std::vector<SurfacePoint> cap, around;

  CutBall() {
    Random random(5);
    for (const SurfacePoint& p : patchOf(sphere, 1500, random)) (-p.normal.z() > 0.87 ? cap : around).push_back(p);
  }
};

/// Evidence that is neither good nor bad.
Evidence usualEvidence(Kind kind) {
  Evidence evidence;
  evidence.inliers = 60.0f;
  evidence.gain = 0.75f;
  evidence.against = 0.2f;
  evidence.runs_on = 0.2f;
  evidence.runs_into = 0.1f;
  evidence.border_residual = 0.8f;
  if (kind != Kind::plane) evidence.turn = 0.2f, evidence.lead = 0.1f;
  return evidence;
}

TEST(Evidence, ABallInFrontOfAWallRunsOnNowhere) {
  Random random(3);
  const Sphere ball = {Vec3(0, 0, 1), 0.08};
  Scene scene;
  scene.add(patchOf(ball, 300, random), kSelf);
  // So near that neighbours are found across the outline.
  scene.add(patchOf(Plane{Vec3(0, 0, 1.05), Vec3(0, 0, -1)}, 1000, 0.15, random), kNobody);
  const Evidence evidence = scene.evidenceOf(ball);
  EXPECT_EQ(evidence.inliers, 300.0f);
  EXPECT_LT(evidence.runs_on, 0.05f);
  EXPECT_EQ(evidence.runs_into, 0.0f);
}

TEST(Evidence, ACapRunsOnIntoTheSurfaceThatItWasCutFrom) {
  const CutBall ball;
  Scene scene;
  scene.add(ball.cap, kSelf);
  scene.add(ball.around, kNobody);
  const Evidence evidence = scene.evidenceOf(ball.sphere);
  // That of a disk is 1; samples are not in rows, so that its border is more or less than one sample wide.
  EXPECT_NEAR(evidence.runs_on, 1.0f, 0.4f);
  EXPECT_EQ(evidence.runs_into, 0.0f);
  // The samples lie on the shape, as exactly as single precision tells: 1e-7 m of 1 mm.
  EXPECT_NEAR(evidence.border_residual, 0.0f, 1e-3f);
}

TEST(Evidence, ACapRunsIntoTheOtherShapeThatOwnsTheRest) {
  const CutBall ball;
  Scene scene;
  scene.add(ball.cap, kSelf);
  scene.add(ball.around, kOther);
  const Evidence evidence = scene.evidenceOf(ball.sphere);
  EXPECT_NEAR(evidence.runs_into, 1.0f, 0.4f);
  EXPECT_EQ(evidence.runs_on, 0.0f);
}

TEST(Evidence, OnlyWhatNobodyExplainsSpeaksAgainstAShape) {
  Random random(4);
  const Plane plane = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  // Four standard deviations off: near, but no inliers.
  std::vector<SurfacePoint> beside = patchOf(plane, 100, 0.1, random);
  for (SurfacePoint& p : beside) p.point.z() += 4.0 * kNoise;
  const auto againstWhenOwnedBy = [&](std::uint32_t owner) {
    Random same(6);
    Scene scene;
    scene.add(patchOf(plane, 200, 0.1, same), kSelf);
    scene.add(beside, owner);
    return scene.evidenceOf(plane).against;
  };
  // 100 times (4/3)^2 - 1 over 200 inliers.
  EXPECT_NEAR(againstWhenOwnedBy(kNobody), 0.389f, 0.01f);
  EXPECT_EQ(againstWhenOwnedBy(kOther), 0.0f);
}

TEST(Evidence, TurnTellsAPlaneFromHalfASphere) {
  Random random(7);
  const Plane plane = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  const Sphere ball = {Vec3(0, 0, 1), 0.08};
  Scene flat, round;
  flat.add(patchOf(plane, 200, 0.1, random), kSelf);
  round.add(patchOf(ball, 2000, random), kSelf);
  EXPECT_NEAR(flat.evidenceOf(plane).turn, 0.0f, 1e-5f);
  // The patch ends where 0.1 of the normal looks at the sensor: the mean of that share is 0.55.
  EXPECT_NEAR(round.evidenceOf(ball).turn, 0.45f, 0.03f);
}

TEST(Evidence, OfAShapeWithoutSamplesIsNothing) {
  EXPECT_EQ(Scene().evidenceOf(Sphere{Vec3(0, 0, 1), 0.1}).inliers, 0.0f);
}

TEST(Confidence, FallsWithWhatSpeaksAgainstAShape) {
  for (const Kind kind : kKinds) {
    Evidence more = usualEvidence(kind);
    more.against *= 2.0f;
    EXPECT_LT(confidenceOf(kind, more), confidenceOf(kind, usualEvidence(kind))) << kindName(kind);
  }
}

TEST(Confidence, RisesWithTheInliers) {
  for (const Kind kind : kKinds) {
    Evidence more = usualEvidence(kind);
    more.inliers *= 2.0f;
    EXPECT_GT(confidenceOf(kind, more), confidenceOf(kind, usualEvidence(kind))) << kindName(kind);
  }
}

// Where the noise is the cloud's own, soft clutter is as near to planes as their own points, but less evenly: the
// median right and the median wrong plane of simulated tables in a robot's frame, and a small one among others.
TEST(Confidence, OfAPlaneAsksForAnEvenFitWhereTheNoiseIsTheCloudsOwn) {
  Evidence right, wrong;
  right.inliers = 186.0f, right.gain = 0.79f, right.against = 0.06f, right.own_noise = 1.0f;
  wrong.inliers = 69.0f, wrong.gain = 0.69f, wrong.against = 0.14f, wrong.runs_into = 0.47f, wrong.own_noise = 1.0f;
  EXPECT_GT(confidenceOf(Kind::plane, right), 0.95);
  EXPECT_LT(confidenceOf(Kind::plane, wrong), 0.4);
  Evidence of_camera = wrong;
  of_camera.own_noise = 0.0f;
  EXPECT_GT(confidenceOf(Kind::plane, of_camera), 0.4) << "there clutter lies off planes";
  wrong.gain = 0.85f;
  EXPECT_GT(confidenceOf(Kind::plane, wrong), 0.7);
}

/// Log of the odds.
double logOdds(Kind kind, const Evidence& evidence) {
  const double confidence = confidenceOf(kind, evidence);
  return std::log(confidence / (1.0 - confidence));
}

TEST(Confidence, KnowsTheKindsByOtherSignsWhereTheNoiseIsTheCloudsOwn) {
  const auto forTurn = [](Kind kind, float own_noise) {
    Evidence little = usualEvidence(kind);
    little.own_noise = own_noise;
    Evidence much = little;
    much.turn *= 2.0f;
    return logOdds(kind, much) - logOdds(kind, little);
  };
  EXPECT_GT(forTurn(Kind::sphere, 1.0f), 1.5 * forTurn(Kind::sphere, 0.0f));
  EXPECT_LT(forTurn(Kind::cone, 1.0f), 0.7 * forTurn(Kind::cone, 0.0f));
  EXPECT_LT(forTurn(Kind::cylinder, 1.0f), 0.7 * forTurn(Kind::cylinder, 0.0f));
}

TEST(Confidence, OfATubeThatTurnsLittleIsHigherWhereTheNoiseIsTheCloudsOwn) {
  Evidence little = usualEvidence(Kind::cylinder);  // as one of the paper's, a seventh of which is seen
  little.inliers = 180.0f, little.against = 0.05f, little.turn = 0.06f, little.lead = 0.6f, little.runs_into = 0.67f;
  EXPECT_LT(confidenceOf(Kind::cylinder, little), 0.6);
  little.own_noise = 1.0f;
  EXPECT_GT(confidenceOf(Kind::cylinder, little), 0.7);
}

TEST(Confidence, RisesOfTubesAndConesThatStand) {
  for (const Kind kind : kKinds) {
    Evidence standing = usualEvidence(kind);
    standing.stands = 1.0f;
    const double before = confidenceOf(kind, usualEvidence(kind)), after = confidenceOf(kind, standing);
    if (kind == Kind::cylinder || kind == Kind::cone) {
      EXPECT_GT(after, before) << kindName(kind);
    } else {
      EXPECT_EQ(after, before) << kindName(kind);
    }
  }
}

// A wall seen by structured light, bent towards the border of the image: half of its samples are beside the plane.
TEST(Confidence, IsHighOfAWallThatTheCameraBends) {
  Evidence wall;
  wall.inliers = 465.0f, wall.gain = 0.55f, wall.against = 0.42f, wall.runs_on = 4.2f;
  EXPECT_GT(confidenceOf(Kind::plane, wall), 0.7);
  wall.inliers = 40.0f;
  EXPECT_LT(confidenceOf(Kind::plane, wall), 0.2);
}

TEST(Confidence, IsLowOfABallThatTheSurfaceLeavesAtItsBorder) {
  // A head: as good as a ball in everything else.
  Evidence head = usualEvidence(Kind::sphere);
  head.inliers = 900.0f, head.runs_on = 1.6f, head.border_residual = 1.4f, head.turn = 0.16f;
  EXPECT_LT(confidenceOf(Kind::sphere, head), 0.2);
  Evidence ball = head;
  ball.border_residual = 1.1f;
  EXPECT_GT(confidenceOf(Kind::sphere, ball), 0.9) << "no more than noise and waves";
  ball = head;
  ball.runs_on = 0.3f;
  EXPECT_GT(confidenceOf(Kind::sphere, ball), 0.9) << "of a few samples it is chance";
  ball = head;
  ball.turn = 0.25f;
  EXPECT_GT(confidenceOf(Kind::sphere, ball), 0.9) << "it fits as far as a ball is seen";
  for (const Kind kind : {Kind::plane, Kind::cylinder, Kind::cone}) {
    Evidence other = usualEvidence(kind);
    const double usual = confidenceOf(kind, other);
    other.runs_on = 1.6f, other.border_residual = 1.4f;
    EXPECT_EQ(confidenceOf(kind, other), usual) << kindName(kind);
  }
}

TEST(Confidence, LosesLessOfALargePlaneOrBallToWhatSpeaksAgainstIt) {
  // How much (log-odds) is lost to what speaks against so many inliers.
  const auto lostWith = [](Kind kind, float inliers) {
    const auto logOdds = [&](float against) {
      Evidence evidence = usualEvidence(kind);
      evidence.inliers = inliers;
      evidence.against = against;
      const double confidence = confidenceOf(kind, evidence);
      return std::log(confidence / (1.0 - confidence));
    };
    return logOdds(0.0f) - logOdds(0.2f);
  };
  for (const Kind kind : {Kind::plane, Kind::sphere}) {
    EXPECT_NEAR(lostWith(kind, 40.0f), lostWith(kind, 150.0f), 1e-6) << kindName(kind);
    EXPECT_NEAR(lostWith(kind, 600.0f), 0.5 * lostWith(kind, 150.0f), 1e-6) << kindName(kind);
  }
  for (const Kind kind : {Kind::cylinder, Kind::cone}) {
    EXPECT_NEAR(lostWith(kind, 600.0f), lostWith(kind, 150.0f), 1e-6) << kindName(kind);
  }
}

TEST(Confidence, RisesWithTheLeadOverOtherKinds) {
  for (const Kind kind : {Kind::cylinder, Kind::cone}) {
    Evidence more = usualEvidence(kind);
    more.lead *= 3.0f;
    EXPECT_GT(confidenceOf(kind, more), confidenceOf(kind, usualEvidence(kind))) << kindName(kind);
  }
}

TEST(Confidence, RisesWithTheTurnOfTheNormals) {
  for (const Kind kind : {Kind::sphere, Kind::cylinder, Kind::cone}) {
    const Evidence usual = usualEvidence(kind);
    Evidence more = usual;
    more.turn *= 1.5f;
    // Of a cylinder its lead tells as much.
    EXPECT_GE(confidenceOf(kind, more), confidenceOf(kind, usual)) << kindName(kind);
    if (kind == Kind::cylinder) continue;
    EXPECT_GT(confidenceOf(kind, more), confidenceOf(kind, usual)) << kindName(kind);
  }
}

TEST(Confidence, IsAProbabilityForAbsurdEvidence) {
  const float huge = std::numeric_limits<float>::max(), nan = std::numeric_limits<float>::quiet_NaN();
  for (float Evidence::*number :
       {&Evidence::inliers, &Evidence::gain, &Evidence::against, &Evidence::runs_on, &Evidence::runs_into,
        &Evidence::border_residual, &Evidence::turn, &Evidence::lead, &Evidence::stands}) {
    for (const float value : {-huge, -1.0f, 0.0f, huge, std::numeric_limits<float>::infinity(), nan}) {
      for (const Kind kind : kKinds) {
        Evidence evidence = usualEvidence(kind);
        evidence.*number = value;
        const double confidence = confidenceOf(kind, evidence);
        EXPECT_TRUE(0.0 <= confidence && confidence <= 1.0) << kindName(kind) << " " << value << ": " << confidence;
      }
    }
  }
}

}  // namespace
}  // namespace primitect::evidence_test
