// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Detections in numbers for programs and in words for people.
#include <gtest/gtest.h>

#include "io/length_text.h"
#include "io/percent_text.h"
#include "io/report.h"
#include "io/shape_text.h"
#include "test/support/json_text.h"

namespace primitect::io::json_report_test {
namespace {

using Json = nlohmann::json;

Detection detectionOf(const Shape& shape) {
  Detection detection;
  detection.shape = shape;
  detection.inlier_count = 42;
  detection.votes = 12.5f;
  detection.rms_error = 0.25f;
  return detection;
}

FileReport fourKinds() {
  FileReport report;
  report.file = "frame.pcd";
  report.detections.points_in = 100;
  report.detections.points_used = 90;
  report.detections.samples = 80;
  report.detections.scene_diameter = 1.5;
  report.detections.image_noise = 1.25;
  report.detections.depth_waves = 0.0025;
  report.detections.seen_from_origin = false;
  report.detections.items = {detectionOf(Plane{{1, 2, 3}, {0, 0, -1}}), detectionOf(Sphere{{1, 2, 3}, 0.5}),
                             detectionOf(Cylinder{{1, 2, 3}, {0, 1, 0}, 0.25}),
                             detectionOf(Cone{{1, 2, 3}, {1, 0, 0}, 0.75})};
  report.timing_ms = {{"read", 1.5}, {"vote", 2.5}, {"total", 3.5}};
  return report;
}

const Json kPoint = {1.0, 2.0, 3.0};

TEST(JsonReport, GivesEachKindItsKeys) {
  const Json primitives = test::parsedJson(reportJson(fourKinds()))["primitives"];
  ASSERT_EQ(primitives.size(), 4u);
  EXPECT_EQ(primitives[0]["type"], "plane");
  EXPECT_EQ(primitives[0]["point"], kPoint);
  EXPECT_EQ(primitives[0]["normal"], Json({0.0, 0.0, -1.0}));
  EXPECT_EQ(primitives[1]["type"], "sphere");
  EXPECT_EQ(primitives[1]["center"], kPoint);
  EXPECT_EQ(primitives[1]["radius"], 0.5);
  EXPECT_EQ(primitives[2]["type"], "cylinder");
  EXPECT_EQ(primitives[2]["point"], kPoint);
  EXPECT_EQ(primitives[2]["axis"], Json({0.0, 1.0, 0.0}));
  EXPECT_EQ(primitives[2]["radius"], 0.25);
  EXPECT_EQ(primitives[3]["type"], "cone");
  EXPECT_EQ(primitives[3]["apex"], kPoint);
  EXPECT_EQ(primitives[3]["axis"], Json({1.0, 0.0, 0.0}));
  EXPECT_EQ(primitives[3]["half_angle"], 0.75);
  for (const Json& primitive : primitives) {
    EXPECT_EQ(primitive["inliers"], 42);
    EXPECT_EQ(primitive["votes"], 12.5);
    EXPECT_EQ(primitive["rms_error"], 0.25);
  }
}

TEST(JsonReport, SaysHowMuchWasReadAndHowLongItTook) {
  const Json json = test::parsedJson(reportJson(fourKinds()));
  EXPECT_EQ(json["file"], "frame.pcd");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["points_in"], 100);
  EXPECT_EQ(json["points_used"], 90);
  EXPECT_EQ(json["samples"], 80);
  EXPECT_EQ(json["scene_diameter"], 1.5);
  EXPECT_EQ(json["image_noise"], 1.25);
  EXPECT_EQ(json["depth_waves"], 0.0025);
  EXPECT_TRUE(Json::parse(reportJson(FileReport()))["depth_waves"].is_null()) << "no plane tells";
  EXPECT_EQ(json["seen_from_origin"], false);
  EXPECT_EQ(json["timing_ms"]["read"], 1.5);
  EXPECT_EQ(json["timing_ms"]["vote"], 2.5);
  EXPECT_EQ(json["timing_ms"]["total"], 3.5);
  EXPECT_FALSE(json.contains("repeats"));
}

TEST(JsonReport, SaysWhereTheSensorWasAndHowThatIsKnown) {
  FileReport report = fourKinds();
  EXPECT_TRUE(test::parsedJson(reportJson(report)).at("sensor").is_null());
  report.sensor = SensorPose{{1, 2, 3}, Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5)};
  const Json given = test::parsedJson(reportJson(report))["sensor"];
  EXPECT_EQ(given["position"], kPoint);
  EXPECT_EQ(given["orientation"], Json({0.5, -0.5, 0.5, 0.5})) << "x y z w";
  EXPECT_EQ(given["from"], "option");
  const auto fromOf = [&report](CameraClue clue) {
    report.found_by = clue;
    return test::parsedJson(reportJson(report))["sensor"]["from"];
  };
  EXPECT_EQ(fromOf(CameraClue::image), "image");
  EXPECT_EQ(fromOf(CameraClue::order), "order");
  EXPECT_EQ(fromOf(CameraClue::shadows), "shadows");
}

TEST(JsonReport, LeavesUnknownFieldsNull) {
  const Json plane = test::parsedJson(reportJson(fourKinds()))["primitives"][0];
  for (const char* key : {"confidence", "coverage", "radius_stddev", "half_angle_stddev", "position_stddev",
                          "axis_stddev", "covariance", "truncated"}) {
    ASSERT_TRUE(plane.contains(key)) << key;
    EXPECT_TRUE(plane[key].is_null()) << key;
  }
}

TEST(JsonReport, FillsKnownFields) {
  FileReport report = fourKinds();
  Detection& plane = report.detections.items[0];
  plane.confidence = 0.5f;
  plane.truncated = kTruncatedByImage | kTruncatedByOcclusion;
  plane.covariance.fill(0.125);
  plane.extent.size = {2.0, 1.0, 0.0};
  plane.extent.hull = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const Json json = test::parsedJson(reportJson(report))["primitives"][0];
  EXPECT_EQ(json["confidence"], 0.5);
  EXPECT_EQ(json["truncated"], Json({"image", "occlusion"}));
  EXPECT_EQ(json["covariance"].size(), 36u);
  EXPECT_EQ(json["extent"]["size"], Json({2.0, 1.0}));
  EXPECT_EQ(json["extent"]["hull"][1], Json({1.0, 0.0, 1.0}));
}

TEST(JsonReport, NamesThePlanesOnWhichAnAxisEnds) {
  FileReport report = fourKinds();
  report.detections.items[3].extent.face_at_plus_z = 0;
  const Json extent = test::parsedJson(reportJson(report))["primitives"][3]["extent"];
  EXPECT_EQ(extent["face_at_plus_z"], 0);
  EXPECT_TRUE(extent["face_at_minus_z"].is_null());
}

TEST(JsonReport, NamesEndsThatWereNotSeen) {
  FileReport report = fourKinds();
  const auto endsOf = [&report](std::size_t k, int ends) {
    report.detections.items[k].extent.unseen_ends = static_cast<std::uint8_t>(ends);
    return test::parsedJson(reportJson(report))["primitives"][k]["extent"].value("unseen_ends", Json("none"));
  };
  for (const std::size_t k : {2, 3}) {  // cylinder and cone
    EXPECT_EQ(endsOf(k, 0), Json::array());
    EXPECT_EQ(endsOf(k, kEndAtMinusZ), Json::array({"minus_z"}));
    EXPECT_EQ(endsOf(k, kEndAtMinusZ | kEndAtPlusZ), Json::array({"minus_z", "plus_z"}));
    EXPECT_EQ(endsOf(k, kEndsUnknown), Json(nullptr));
  }
  for (const std::size_t k : {0, 1}) EXPECT_EQ(endsOf(k, 0), Json("none")) << "has no axis";
}

TEST(JsonReport, TellsTheDepthCutOfACloudThatIsNoImage) {
  FileReport report = fourKinds();
  report.detections.items[0].truncated = kTruncationUnknown;
  report.detections.items[1].truncated = kTruncationUnknown | kTruncatedByDepth;
  const Json json = test::parsedJson(reportJson(report))["primitives"];
  EXPECT_TRUE(json[0]["truncated"].is_null());
  EXPECT_EQ(json[1]["truncated"], Json::array({"depth"}));
}

TEST(JsonReport, SaysWhatIsSeenFromInside) {
  FileReport report = fourKinds();
  report.detections.items[1].concave = true;
  const Json primitives = test::parsedJson(reportJson(report))["primitives"];
  EXPECT_EQ(primitives[0]["concave"], false);
  EXPECT_EQ(primitives[1]["concave"], true);
}

TEST(JsonReport, NamesTheRivalOrNone) {
  FileReport report = fourKinds();
  report.detections.items[3].rival = Kind::cylinder;
  const Json primitives = test::parsedJson(reportJson(report))["primitives"];
  EXPECT_EQ(primitives[3]["rival"], "cylinder");
  EXPECT_TRUE(primitives[2]["rival"].is_null());
}

TEST(JsonReport, CountsWhatWasRefused) {
  FileReport report = fourKinds();
  report.detections.refusals[Refusal::half_angle] = 7;
  const Json refused = test::parsedJson(reportJson(report))["refused"];
  EXPECT_EQ(refused, Json({{"few inliers", 0},
                           {"too large", 0},
                           {"too small", 0},
                           {"half angle", 7},
                           {"edge-on", 0},
                           {"unlikely", 0},
                           {"not seen", 0}}));
}

TEST(JsonReport, SaysWhyNothingCameOut) {
  FileReport empty;
  empty.detections.status = Status::empty_input;
  const Json json = test::parsedJson(reportJson(empty));
  EXPECT_EQ(json["status"], "empty_input");
  EXPECT_TRUE(json["primitives"].is_array());
  EXPECT_TRUE(json["primitives"].empty());
}

TEST(JsonReport, ListsSeveralFilesWithThoseThatFailed) {
  FileReport failed;
  failed.file = "broken\xff.pcd";  // not UTF-8
  failed.error = "broken.pcd: is empty (0 bytes)";
  const Json json = test::parsedJson(reportsJson({fourKinds(), failed}));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["primitives"].size(), 4u);
  EXPECT_EQ(json[1]["error"], failed.error);
  EXPECT_TRUE(json[1]["primitives"].empty());
}

TEST(JsonReport, KeepsTheOrderOfKeysAndEndsWithANewline) {
  const std::string text = reportJson(fourKinds());
  EXPECT_LT(text.find("\"file\""), text.find("\"primitives\""));
  EXPECT_LT(text.find("\"primitives\""), text.find("\"timing_ms\""));
  EXPECT_EQ(text.back(), '\n');
}

TEST(NamesOfShapes, TellKindAndSizeInSuitableUnits) {
  Detection plane = detectionOf(Plane{});
  EXPECT_EQ(nameText(plane), "plane");
  plane.extent.size = {0.42, 0.61, 0.0};
  EXPECT_EQ(nameText(plane), "plane 610 x 420 mm");
  plane.extent.size = {1.31, 0.9, 0.0};
  EXPECT_EQ(nameText(plane), "plane 1.31 x 0.90 m");
  EXPECT_EQ(nameText(detectionOf(Sphere{{}, 0.203})), "sphere r 203 mm");
  EXPECT_EQ(nameText(detectionOf(Cylinder{{}, {0, 0, 1}, 0.0393})), "cylinder r 39 mm");
  EXPECT_EQ(nameText(detectionOf(Cylinder{{}, {0, 0, 1}, 1.714})), "cylinder r 1.71 m");
  EXPECT_EQ(nameText(detectionOf(Cone{{}, {0, 0, 1}, 0.5235987755982988})), "cone half angle 30.0 deg");
  EXPECT_EQ(lengthText(0.0043), "4.3 mm");
  EXPECT_EQ(lengthsText(0.0043, 0.12), "4.3 x 120 mm");
  EXPECT_EQ(lengthsText(0.2, 1.234), "0.20 x 1.23 m");
  EXPECT_EQ(lengthText(0.9994), "999 mm");
  EXPECT_EQ(lengthText(0.9996), "1.00 m");
  EXPECT_EQ(lengthsText(0.9996, 0.3), "1.00 x 0.30 m");
}

TEST(NamesOfShapes, SayWhatIsSeenFromInside) {
  Detection tube = detectionOf(Cylinder{{0, 0, 1}, {0, 1, 0}, 0.0393});
  tube.concave = true;
  EXPECT_EQ(kindText(tube), "concave cylinder");
  EXPECT_EQ(nameText(tube), "concave cylinder r 39 mm");
}

TEST(WordsForPeople, GiveSharesInPercentAndSureOnlyWhereNothingIsMissing) {
  EXPECT_EQ(percentText(0.973f), "97 %");
  EXPECT_EQ(percentText(0.0f), "0 %");
  EXPECT_EQ(percentText(0.9999f), "99 %");
  EXPECT_EQ(percentText(1.0f), "100 %");
  EXPECT_EQ(percentText(kUnknown), "");
}

TEST(WordsForPeople, GiveTheDeviationOfWhatTheKindHas) {
  Detection ball = detectionOf(Sphere{{0, 0, 1}, 0.1});
  EXPECT_EQ(deviationText(ball), "");
  ball.radius_stddev = 0.00025f;
  EXPECT_EQ(deviationText(ball), "0.25 mm");
  Detection cone = detectionOf(Cone{{0, 0, 1}, {0, 0, 1}, 0.5});
  cone.radius_stddev = 0.001f;
  cone.half_angle_stddev = 0.0043633f;
  EXPECT_EQ(deviationText(cone), "0.25 deg");
  Detection plane = detectionOf(Plane{});
  plane.radius_stddev = plane.half_angle_stddev = 0.0f;
  EXPECT_EQ(deviationText(plane), "");
}

TEST(WordsForPeople, SayWhatCutsOffAShape) {
  EXPECT_EQ(truncationText(0), "");
  EXPECT_EQ(truncationText(kTruncatedByImage | kTruncatedByOcclusion), "image, occlusion");
  EXPECT_EQ(truncationText(kTruncationUnknown), "");
  EXPECT_EQ(truncationText(kTruncationUnknown | kTruncatedByDepth), "depth");
}

TEST(WordsForPeople, CountOnlyTheRefusalsThatWere) {
  Refusals refusals;
  Params params;
  EXPECT_EQ(refusalsText(refusals, params), "");
  refusals[Refusal::few_inliers] = 12;
  refusals[Refusal::not_seen] = 3;
  EXPECT_EQ(refusalsText(refusals, params), "12 few inliers (see min_inliers), 3 not seen");
}

TEST(WordsForPeople, NameTheLimitsOfRefusalsThatAreSet) {
  Refusals refusals;
  refusals[Refusal::too_large] = 1, refusals[Refusal::too_small] = 2, refusals[Refusal::half_angle] = 3;
  refusals[Refusal::unlikely] = 4;
  const std::string rest = "3 half angle (see min_half_angle_deg, max_half_angle_deg), 4 unlikely (see min_confidence)";
  Params params;
  EXPECT_EQ(refusalsText(refusals, params), "1 too large, 2 too small, " + rest) << "no bounds on radii by default";
  params.max_radius = 0.05, params.min_radius = 0.02;
  EXPECT_EQ(refusalsText(refusals, params), "1 too large (see max_radius), 2 too small (see min_radius), " + rest);
}

}  // namespace
}  // namespace primitect::io::json_report_test
