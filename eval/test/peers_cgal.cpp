// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// CGAL as a peer: its program beside the tests, and programs that misbehave in its place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "eval/peers/cgal.h"
#include "eval/peers/child_program.h"
#include "eval/test/peers_find.h"
#include "test/io/temporary_folder.h"

namespace primitect::eval::peers_cgal_test {
namespace {

using namespace primitect::test;

class Cgal : public ::testing::Test {
 protected:
  void SetUp() override {
    setenv("PRIMITECT_TOOLS_DIR", PRIMITECT_TOOLS_DIR, 1);
    if (!cgalBuilt()) GTEST_SKIP() << "peer_cgal was not built: libcgal-dev was missing";
  }
};

TEST_F(Cgal, FindsWallAndSphere) { expectFindsSphere("cgal"); }
TEST_F(Cgal, FindsWallAndCylinder) { expectFindsCylinder("cgal"); }
TEST_F(Cgal, FindsWallAndConeWithItsAxisIntoTheBody) { expectFindsCones("cgal"); }

TEST_F(Cgal, FindsTheWallIn2048PointsMaybeInPieces) {
  // These points lie farther apart than the default cluster epsilon.
  const std::vector<Plane> planes = shapesOf<Plane>(answerOf("cgal-2048", wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25})));
  const auto is_the_wall = [](const Plane& plane) {
    return angleDeg(plane.normal, wall().normal) < 2.0 && std::abs(distance(plane, wall().point)) < kRansacError;
  };
  EXPECT_GT(std::count_if(planes.begin(), planes.end(), is_the_wall), 0);
}

TEST_F(Cgal, LooksForTheNamedKindOnly) {
  const Answer answer = answerOf("cgal:spheres", wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25}));
  EXPECT_FALSE(answer.shapes.empty());
  EXPECT_EQ(shapesOf<Sphere>(answer).size(), answer.shapes.size());
}

TEST_F(Cgal, WithTheNoiseKnownFitsCloser) {
  LabelledCloud scene = wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25});
  scene.recipe.sigma = 0.001;
  const std::vector<Sphere> spheres = shapesOf<Sphere>(answerOf("cgal-3sigma", scene));
  const auto error = [](const Sphere& sphere) { return std::abs(sphere.radius - 0.25); };
  ASSERT_FALSE(spheres.empty());
  EXPECT_LT(error(*std::min_element(spheres.begin(), spheres.end(),
                                    [&](const Sphere& a, const Sphere& b) { return error(a) < error(b); })),
            0.003);
}

TEST_F(Cgal, PreparingIsPartOfTheTime) {
  const Answer answer = answerOf("cgal", wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25}));
  EXPECT_GT(answer.prepare_ms, 0.0);
  EXPECT_LT(answer.prepare_ms, answer.total_ms);
  EXPECT_GT(answer.cpu_ms, 0.0);
}

TEST_F(Cgal, SameCloudAndSeedSameShapes) {
  const LabelledCloud scene = wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25});
  const Sphere first = shapesOf<Sphere>(answerOf("cgal", scene)).at(0);
  const Sphere second = shapesOf<Sphere>(makePeer("cgal")->run(scene, 3)).at(0);
  EXPECT_EQ(first.center, second.center);
  EXPECT_EQ(first.radius, second.radius);
}

TEST_F(Cgal, TooFewPointsAreAFailureInItsOwnWords) {
  LabelledCloud scene;
  scene.cloud = cloudOf({{{1.0, 0.0, 1.0}, Vec3::UnitZ()}, {{0.0, 1.0, 1.0}, Vec3::UnitZ()}});
  const Answer answer = makePeer("cgal")->run(scene, 1);
  EXPECT_NE(answer.failure.find("has 2 points with normals, must be at least 10"), std::string::npos) << answer.failure;
}

TEST_F(Cgal, EndsWithOneAndAReasonOnBadInput) {
  const std::string program = std::string(PRIMITECT_TOOLS_DIR) + "/peer_cgal";
  const ProgramResult result = runProgram(program, {"/nowhere/cloud.ply"}, 60.0);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.last_words.find("/nowhere/cloud.ply"), std::string::npos) << result.last_words;
}

/// A shell script takes the place of peer_cgal.
class CgalReplaced : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    setenv("PRIMITECT_TOOLS_DIR", path("").c_str(), 1);
  }
  std::string failureWith(const std::string& script, const std::string& name = "cgal", int repeat = 1) const {
    namespace fs = std::filesystem;
    fs::permissions(write("peer_cgal", "#!/bin/sh\n" + script + "\n"), fs::perms::owner_all);
    LabelledCloud scene = wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25});
    scene.recipe.seed = 42;
    const Answer answer = makePeer(name)->run(scene, repeat);
    EXPECT_TRUE(answer.shapes.empty());
    return answer.failure;
  }
};

TEST_F(CgalReplaced, ByNothingItIsNotListedAndSaysWhatIsMissing) {
  const std::vector<std::string> names = peerNames();
  EXPECT_EQ(std::count(names.begin(), names.end(), "cgal"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "pcl-sac"), 1);
  try {
    makePeer("cgal-2048");
    FAIL() << "must throw";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("libcgal-dev"), std::string::npos) << error.what();
  }
}

TEST_F(CgalReplaced, ItIsToldKindsSamplesSeedAndRepetitions) {
  const std::string say_arguments = "shift; echo \"$*\" >&2; exit 1";
  EXPECT_EQ(failureWith(say_arguments), "--kinds plane,sphere,cylinder,cone --samples 0 --seed 42 --repeat 1");
  EXPECT_EQ(failureWith(say_arguments, "cgal-2048:cones", 3), "--kinds cone --samples 2048 --seed 42 --repeat 3");
  EXPECT_EQ(failureWith(say_arguments, "cgal:planes"), "--kinds plane --samples 0 --seed 42 --repeat 1");
}

TEST_F(CgalReplaced, ItsLastWordsAreTheFailure) {
  EXPECT_EQ(failureWith("echo first >&2; echo 'out of memory' >&2; echo >&2; exit 1"), "out of memory");
}

TEST_F(CgalReplaced, ItsExitCodeIsTheFailureWhenItSaysNothing) {
  EXPECT_EQ(failureWith("exit 3"), "peer_cgal ended with exit code 3");
  EXPECT_NE(failureWith("kill -SEGV $$"), "");
}

TEST_F(CgalReplaced, WhatIsNoAnswerIsAFailure) {
  EXPECT_EQ(failureWith("echo nonsense").rfind("peer_cgal: ", 0), 0u);
  EXPECT_NE(failureWith("echo '{}'").find("primitives"), std::string::npos);
  EXPECT_NE(failureWith("echo '{\"primitives\":[{\"type\":\"torus\"}],\"total_ms\":1,\"prepare_ms\":1}'").find("torus"),
            std::string::npos);
}

TEST(ChildProgram, GetsItsArgumentsAsTheyAre) {
  const ProgramResult result = runProgram("/bin/echo", {"it's", "a \"b\" $HOME `ls`"}, 60.0);
  EXPECT_EQ(result.out, "it's a \"b\" $HOME `ls`\n");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_FALSE(result.timed_out);
}

TEST(ChildProgram, IsEndedWhenItTakesTooLong) {
  const ProgramResult result = runProgram("/bin/sleep", {"1000"}, 0.1);
  EXPECT_TRUE(result.timed_out);
  EXPECT_NE(result.exit_code, 0);
}

}  // namespace
}  // namespace primitect::eval::peers_cgal_test
