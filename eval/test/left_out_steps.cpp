// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Each step of steps.def can be left out by its name, and some cloud comes out another way then.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "eval/data_sets.h"
#include "eval/methods.h"
#include "primitect/detector.h"
#include "primitect/steps.h"

namespace left_out_steps_test {
namespace {

using namespace primitect;
using namespace primitect::eval;

/// What steps change of a cloud's detections, in one list.
std::vector<double> numbersOf(const Answer& answer) {
  std::vector<double> numbers;
  for (const Detection& detection : answer.detections) {
    const Vec3& origin = detection.extent.origin;
    numbers.insert(numbers.end(), {origin.x(), origin.y(), origin.z(), detection.confidence, detection.position_stddev,
                                   static_cast<double>(detection.inlier_count)});
  }
  return numbers;
}

Recipe recipeOf(const std::string& set, std::uint64_t seed) {
  Recipe recipe;
  recipe.set = set;
  recipe.seed = seed;
  return recipe;
}

Recipe stereo(std::uint64_t seed) {
  Recipe recipe = recipeOf("tabletop", seed);
  recipe.sensor = "stereo";
  return recipe;
}

Recipe bent(std::uint64_t seed) {
  Recipe recipe = recipeOf("tabletop", seed);
  recipe.sensor = "bent_structured_light";
  return recipe;
}

Recipe noisy(std::uint64_t seed) {
  Recipe recipe = recipeOf("tabletop", seed);
  recipe.noise_scale = 2.0;
  return recipe;
}

/// Each of these has something for a step that is seldom needed.
std::vector<Recipe> variedClouds() {
  return {recipeOf("household", 308),
          recipeOf("tabletop", 323),
          stereo(300),
          stereo(303),
          noisy(303),
          bent(245),
          recipeOf("household", 304),
          recipeOf("household", 337),
          recipeOf("objects", 315),
          recipeOf("clutter", 303),
          recipeOf("clutter", 306),
          recipeOf("paper-mixed", 301)};
}

TEST(LeftOutSteps, ChangeWhatComesOut) {
  // Of what is larger than the image, waves of a wall, parts of bent tables and small cups test_frames has scenes.
  const std::set<std::string> elsewhere = {"facets", "uneven_planes", "bent_parts", "undetermined_cones"};
  std::set<std::string> unseen;
  for (const StepInfo& step : stepTable()) {
    if (elsewhere.count(step.name) == 0) unseen.insert(step.name);
  }
  const Method whole = makeMethod("default");
  for (const Recipe& recipe : variedClouds()) {
    const LabelledCloud cloud = makeLabelledCloud(recipe);
    const std::vector<double> with_all = numbersOf(whole.run(cloud, 1));
    ASSERT_FALSE(with_all.empty()) << recipe.set << " " << recipe.seed;
    for (const std::string& name : std::set<std::string>(unseen)) {
      if (numbersOf(makeMethod("x=preset:default,without:" + name).run(cloud, 1)) != with_all) unseen.erase(name);
    }
  }
  for (const std::string& name : unseen) ADD_FAILURE() << name << ": nothing comes out another way without it";
}

TEST(LeftOutSteps, AreOfStagesOfAFrame) {
  std::set<std::string> stages;
  Detector detector{Params()};
  detector.onStageDone([&stages](const char* stage) { stages.insert(stage); });
  detector.detect(makeLabelledCloud(recipeOf("tabletop", 323)).cloud);
  for (const StepInfo& step : stepTable()) EXPECT_EQ(stages.count(step.stage), 1u) << step.name;
}

TEST(LeftOutSteps, AreKnownByTheirNames) {
  EXPECT_EQ(stepOf("upright"), Step::upright);
  EXPECT_THROW(makeMethod("x=preset:default,without:facet"), std::invalid_argument);
}

}  // namespace
}  // namespace left_out_steps_test
