// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables that are told in words.
#include "synthetic/scene_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "synthetic/camera.h"
#include "synthetic/poses.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic::scene_text_test {
namespace {

std::size_t bodiesIn(const World& world) { return world.bodies().size(); }

/// The only thing on the table.
Body thingOf(const std::string& text) {
  const World world = tableWith(text);
  EXPECT_EQ(world.bodies().size(), bodiesIn(emptyRoom()) + 1) << text;
  return world.bodies().back();
}

/// Lowest point of its box, and the middle, in the world (m).
struct Stand {
  double lowest;
  Vec3 middle;
};

Stand standOf(const Body& body) {
  Stand stand = {1e9, body.world_from_body * Vec3(0.5 * (body.corner_min + body.corner_max))};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1 ? body.corner_max : body.corner_min).x(),
                 (corner & 2 ? body.corner_max : body.corner_min).y(),
                 (corner & 4 ? body.corner_max : body.corner_min).z());
    stand.lowest = std::min(stand.lowest, (body.world_from_body * p).z());
  }
  return stand;
}

constexpr double kRounding = 1e-9;

TEST(SceneText, StandsThingsOnTheTableWhereItSays) {
  for (const char* text : {"ball 0.05 at 0.1 -0.2", "can 0.03 0.12 at 0.1 -0.2", "cone 20 0.1 at 0.1 -0.2",
                           "box 0.1 0.2 0.05 at 0.1 -0.2", "can 0.03 0.12 lying turn 30 at 0.1 -0.2"}) {
    const Stand stand = standOf(thingOf(text));
    EXPECT_NEAR(stand.lowest, kTableHeight, kRounding) << text;
    EXPECT_LT((stand.middle.head<2>() - Eigen::Vector2d(0.1, -0.2)).norm(), kRounding) << text;
  }
  EXPECT_NEAR(standOf(thingOf("can 0.03 0.12 at 0 0 0.25")).lowest, kTableHeight + 0.25, kRounding);
  EXPECT_NEAR(standOf(thingOf("can 0.03 0.12 at 0 1 -0.75")).lowest, 0.0, kRounding) << "on the floor";
}

TEST(SceneText, MakesThemAsLargeAsItSays) {
  const Body can = thingOf("can 0.03 0.12");
  EXPECT_EQ(std::get<Rod>(can.solid).radius, 0.03);
  EXPECT_EQ(std::get<Rod>(can.solid).half_length, 0.06);
  const Frustum cone = std::get<Frustum>(thingOf("cone 20 0.1").solid);
  EXPECT_NEAR(cone.half_angle, 20.0 * kDegree, kRounding);
  EXPECT_EQ(cone.end - cone.begin, 0.1);
  EXPECT_EQ(std::get<Ball>(thingOf("ball 0.05").solid).radius, 0.05);
  const Box box = std::get<Box>(thingOf("box 0.1 0.2 0.05").solid);
  EXPECT_EQ(Vec3(box.half_x, box.half_y, box.half_z), Vec3(0.05, 0.1, 0.025));
}

TEST(SceneText, TurnsThemAndLaysThemDown) {
  const auto axisOf = [](const std::string& text) { return Vec3(thingOf(text).world_from_body.linear().col(2)); };
  EXPECT_LT((axisOf("can 0.03 0.12") - Vec3::UnitZ()).norm(), kRounding);
  EXPECT_LT((axisOf("can 0.03 0.12 lying") - Vec3::UnitX()).norm(), kRounding);
  EXPECT_LT((axisOf("can 0.03 0.12 lying turn 90") - Vec3::UnitY()).norm(), kRounding);
  EXPECT_LT((axisOf("cone 20 0.1") + Vec3::UnitZ()).norm(), kRounding) << "its tip up";
  // A side of a lying one is on the table.
  const Vec3 axis = axisOf("cone 20 0.1 lying");
  EXPECT_LT((axis - Vec3(std::cos(20.0 * kDegree), 0.0, std::sin(20.0 * kDegree))).norm(), kRounding);
  const Body cone = thingOf("cone 20 0.1 lying");
  EXPECT_NEAR((cone.world_from_body * Vec3(0.1 * std::tan(20.0 * kDegree), 0.0, 0.1)).z(), kTableHeight, kRounding);
  EXPECT_NEAR((cone.world_from_body * Vec3::Zero()).z(), kTableHeight, kRounding);
}

TEST(SceneText, TakesAnyNumberOfThings) {
  const std::size_t room = bodiesIn(emptyRoom());
  EXPECT_EQ(bodiesIn(tableWith("none")), room);
  EXPECT_EQ(bodiesIn(tableWith("ball 0.05; can 0.03 0.1 at 0.2 0;\n box .1 .1 .1 at 0 .3;")), room + 3);
}

/// Why it is refused.
std::string refusalOf(const std::string& text) {
  try {
    tableWith(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SceneText, SaysWhatItDoesNotUnderstand) {
  const std::pair<const char*, const char*> cases[] = {
      {"bowl 0.05", "'bowl' is no kind of thing"},
      {"ball 0.05; can 0.03", "' can 0.03': it has 1 instead of 2 sizes; expected"},
      {"ball 5cm", "'5cm' and what follows is not understood"},
      {"ball 0.05 at 0.1", "'at' and what follows"},
      {"ball 0.05 at 0 0 0 0", "'at' and what follows"},
      {"ball 0.05 turn nan", "'turn' and what follows"},
      {"ball 0.05 turn 10 turn 20", "'turn' is said twice"},
      {"ball 0.05 at 0 0 at 0 0.1", "'at' is said twice"},
      {"can 0.05 0.1 lying lying", "'lying' is said twice"},
      {"ball 0.05 at 0.7 0", "'ball 0.05 at 0.7 0': X and Y are beside the table"},
      {"ball 0.05 at -0.7 0", "beside the table"},
      {"ball 0.05 at 0 0.8", "beside the table"},
      {"ball 0.05 at 0 -0.8", "beside the table"},
      {"ball 0.05 lying", "only a can or a cone"},
      {"ball -0.05", "'ball -0.05': sizes must be above 0 m"},
      {"can 33 120", "sizes must be above 0 m, and at most 2 m"},
      {"cone 95 0.1", "cone"},
  };
  for (const auto& [text, why] : cases) {
    EXPECT_NE(refusalOf(text).find(why), std::string::npos) << text << ": " << refusalOf(text);
  }
}

TEST(SceneText, PutsTheCameraWhereItSays) {
  const Eigen::Isometry3d pose = poseOf("-1 0.5 1.2", "0 0 0.75", 0.0);
  EXPECT_EQ(Vec3(pose.translation()), Vec3(-1.0, 0.5, 1.2));
  const PinholeCamera camera;
  const Eigen::Vector2d middle = camera.project(pose.inverse() * Vec3(0.0, 0.0, 0.75));
  EXPECT_LT((middle - Eigen::Vector2d(camera.cx, camera.cy)).norm(), 1e-6);
  EXPECT_LT((pose.inverse() * Vec3(0.0, 0.0, 0.85)).y(), 0.0) << "up in the image";
  EXPECT_GT((poseOf("-1 0.5 1.2", "0 0 0.75", kPi).inverse() * Vec3(0.0, 0.0, 0.85)).y(), 0.0) << "upside down";
  const Eigen::Isometry3d down = poseOf("0 0 1.5", "0 0 0.75", 0.0);
  EXPECT_LT((down.inverse() * Vec3(0.3, 0.0, 0.75) - Vec3(0.0, -0.3, 0.75)).norm(), kRounding) << "the wall is above";
  EXPECT_NEAR(down.linear().determinant(), 1.0, kRounding);
  for (const char* text : {"", "1 2", "1 2 3 4", "1 2 x", "1 2 inf"}) {
    EXPECT_THROW(poseOf(text, "0 0 0", 0.0), std::invalid_argument) << text;
    EXPECT_THROW(poseOf("1 1 1", text, 0.0), std::invalid_argument) << text;
  }
  EXPECT_THROW(poseOf("1 1 1", "1 1 1", 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace primitect::synthetic::scene_text_test
