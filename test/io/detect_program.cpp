// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The program `detect` as a user runs it: results, messages, exit codes.
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "detect_fixture.h"
#include "test/support/png_files.h"
#include "tools/output_target.h"

namespace detect_program_test {
namespace {

using primitect::test::ballImage;
using primitect::test::ballPly;
using primitect::test::DetectProgram;
using Json = nlohmann::json;

constexpr int kPlyPoints = 2000 + 45 * 45;

/// True when a sphere of that radius (m, within 5 %) is among the primitives.
bool hasSphere(const Json& json, double radius) {
  return std::any_of(json["primitives"].begin(), json["primitives"].end(), [&](const Json& primitive) {
    return primitive["type"] == "sphere" && std::abs(primitive["radius"].get<double>() / radius - 1.0) < 0.05;
  });
}

TEST_F(DetectProgram, FindsTheBallAndWritesNothingButJson) {
  const Json json = runJson(ball);
  EXPECT_EQ(err, "");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["points_in"], kPlyPoints);
  ASSERT_EQ(json["primitives"].size(), 2u) << json.dump(1);
  EXPECT_TRUE(hasSphere(json, 0.1)) << json.dump(1);
  EXPECT_TRUE(json["primitives"][0]["type"] == "plane" || json["primitives"][1]["type"] == "plane");
  for (const char* stage : {"read", "sample", "normals", "vote", "segment", "look closer", "measure", "total"}) {
    EXPECT_TRUE(json["timing_ms"].contains(stage)) << stage;
  }
}

TEST_F(DetectProgram, PrintsATableWithoutJson) {
  EXPECT_EQ(run(ball), 0);
  EXPECT_NE(out.find("sphere"), std::string::npos);
  EXPECT_NE(out.find("r 1"), std::string::npos) << out;  // 0.1 m
  EXPECT_NE(out.find("total"), std::string::npos);
}

TEST_F(DetectProgram, PrintsHowSureItIsAndWhatItRefused) {
  EXPECT_EQ(run(ball), 0);
  const std::string row = out.substr(out.find("sphere"), out.find('\n', out.find("sphere")) - out.find("sphere"));
  EXPECT_NE(row.find(" mm "), std::string::npos) << row;  // its radius' standard deviation
  EXPECT_NE(row.find(" %"), std::string::npos) << row;
  EXPECT_EQ(run(ball + " --min_confidence 1"), 0);
  EXPECT_NE(out.find("nothing found: no shape"), std::string::npos) << out;
  EXPECT_NE(out.find(" unlikely (see min_confidence); --unlikely looks for more\n"), std::string::npos) << out;
}

Json::const_iterator sphereIn(const Json& list) {
  return std::find_if(list.begin(), list.end(), [](const Json& item) { return item["type"] == "sphere"; });
}

TEST_F(DetectProgram, ShowsWhatHadTooFewSamplesOrVotes) {
  const Json usual = runJson(ball + " --unlikely");
  EXPECT_EQ(usual["few_inliers"].size(), 0u) << "what is reported is not told twice";
  EXPECT_FALSE(runJson(ball).contains("few_inliers")) << "nobody asked";
  const auto found = sphereIn(usual["primitives"]);
  ASSERT_NE(found, usual["primitives"].end());
  for (const char* lost : {" --unlikely --min_inliers 100000", " --unlikely --min_votes 100000"}) {
    const Json none = runJson(ball + lost);
    EXPECT_EQ(sphereIn(none["primitives"]), none["primitives"].end()) << lost;
    const auto missing = sphereIn(none["few_inliers"]);
    ASSERT_NE(missing, none["few_inliers"].end()) << none.dump(1);
    EXPECT_NEAR((*missing)["radius"].get<double>(), 0.1, 0.005);
  }
  // In the frame of the file, as all else.
  const Json moved = runJson(ball + " --unlikely --min_inliers 100000 --sensor \"0 0 -0.2 0 0 0 1\"");
  const auto seen = sphereIn(moved["few_inliers"]);
  ASSERT_NE(seen, moved["few_inliers"].end()) << moved.dump(1);
  EXPECT_NEAR((*seen)["center"][2].get<double>(), (*found)["center"][2].get<double>(), 0.005);
  EXPECT_EQ(run(ball + " --unlikely --min_inliers 100000"), 0);
  EXPECT_NE(out.find("would come out with min_inliers 12 and min_votes 0, where nothing above is:\n"),
            std::string::npos)
      << out;
  EXPECT_FALSE(usual.contains("late"));
  EXPECT_EQ(run(ball + " --unlikely --min_inliers 8"), 0);
  EXPECT_NE(out.find("would come out with min_inliers 8 and"), std::string::npos) << out;
}

/// And blames nothing else for it.
TEST_F(DetectProgram, ShowsWhatThereWasNoTimeFor) {
  const Json hurried = runJson(ball + " --unlikely --max_latency 0.0001 --min_inliers 100 --repeat 5");
  const bool reported = sphereIn(hurried["primitives"]) != hurried["primitives"].end();
  const bool late = sphereIn(hurried["late"]) != hurried["late"].end();
  EXPECT_NE(reported, late) << hurried.dump(1);
  EXPECT_EQ(sphereIn(hurried["few_inliers"]), hurried["few_inliers"].end());
  EXPECT_EQ(run(ball + " --max_latency 0.0001 --repeat 5"), 0);
  EXPECT_NE(out.find(" of 5 runs took longer than max_latency (0.1 ms)\n"), std::string::npos) << out;
  EXPECT_EQ(run(ball + " --unlikely --max_latency 1"), 0);
  EXPECT_EQ(out.find("took longer"), std::string::npos) << out;
  EXPECT_NE(out.find("would come out without max_latency, where nothing above is: none\n"), std::string::npos) << out;
}

TEST_F(DetectProgram, ShowsWhatWasTooUnlikelyOnPointsOfNothingElse) {
  const Json usual = runJson(ball + " --unlikely");
  EXPECT_EQ(usual["primitives"].size(), 2u);
  EXPECT_EQ(usual["unlikely"].size(), 0u) << "what is reported is not told twice";
  EXPECT_FALSE(runJson(ball).contains("unlikely")) << "nobody asked";
  const Json none = runJson(ball + " --unlikely --min_confidence 1");
  EXPECT_EQ(none["primitives"].size(), 0u);
  const auto unlikely = sphereIn(none["unlikely"]), found = sphereIn(usual["primitives"]);
  ASSERT_NE(unlikely, none["unlikely"].end()) << none.dump(1);
  EXPECT_NEAR((*unlikely)["radius"].get<double>(), 0.1, 0.005);
  EXPECT_LT((*unlikely)["confidence"].get<double>(), 1.0);
  // In the frame of the file, as all else.
  const Json moved = runJson(ball + " --unlikely --min_confidence 1 --sensor \"0 0 -0.2 0 0 0 1\"");
  const auto seen = sphereIn(moved["unlikely"]);
  ASSERT_NE(seen, moved["unlikely"].end()) << moved.dump(1);
  EXPECT_NEAR((*seen)["center"][2].get<double>(), (*found)["center"][2].get<double>(), 0.005);
  EXPECT_EQ(run(ball + " --unlikely --min_confidence 1"), 0);
  EXPECT_NE(out.find("refused as too unlikely (min_confidence), where nothing above is:"), std::string::npos) << out;
  EXPECT_EQ(out.find("--unlikely"), std::string::npos) << "it was asked for";
}

/// Where they are not reported together with it, the planes on which an axis ends are named in the list that it is in.
TEST_F(DetectProgram, NamesFacesInTheListOfWhatWasTooUnlikely) {
  ASSERT_EQ(run("--example " + path("table.pcd")), 0) << err;
  int named = 0;
  for (const char* limit : {" --min_confidence 1", " --min_confidence 0.9999", " --min_inliers 500"}) {
    const Json json = runJson(path("table.pcd") + " --unlikely" + limit);
    for (const char* list : {"unlikely", "few_inliers"}) {
      for (const Json& item : json[list]) {
        for (const char* end : {"face_at_minus_z", "face_at_plus_z"}) {
          const Json face = item["extent"].value(end, Json());
          if (face.is_null()) continue;
          ASSERT_LT(face.get<std::size_t>(), json[list].size()) << limit;
          EXPECT_EQ(json[list][face.get<std::size_t>()]["type"], "plane") << limit;
          ++named;
        }
      }
    }
  }
  EXPECT_GT(named, 4);
  // The table alone is reported, and the cylinder on it names no more than its own top.
  const Json few = runJson(path("table.pcd") + " --unlikely --min_inliers 500");
  ASSERT_EQ(few["primitives"].size(), 1u);
  const auto can = std::find_if(few["few_inliers"].begin(), few["few_inliers"].end(),
                                [](const Json& item) { return item["type"] == "cylinder"; });
  ASSERT_NE(can, few["few_inliers"].end());
  EXPECT_TRUE((*can)["extent"]["face_at_minus_z"].is_null()) << can->dump(1);
  EXPECT_TRUE((*can)["extent"]["face_at_plus_z"].is_number()) << can->dump(1);
}

TEST_F(DetectProgram, PrintsWhereAPlaneFaces) {
  EXPECT_EQ(run(ball), 0);
  EXPECT_NE(out.find("  normal or axis x y z  "), std::string::npos) << out;
  const auto rowOf = [&](const char* kind) {
    return out.substr(out.find(kind), out.find('\n', out.find(kind)) - out.find(kind));
  };
  EXPECT_NE(rowOf("plane").find("   0.000  0.000 -1.000  "), std::string::npos) << out;
  EXPECT_NE(rowOf("sphere").find("                     -  "), std::string::npos) << out;
}

TEST_F(DetectProgram, SaysWhyNothingWasFound) {
  const std::string none =
      write("none.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
            "float z\nend_header\nnan nan nan\n");
  EXPECT_EQ(run(none), 0);
  EXPECT_NE(out.find("nothing found: none of the 1 points is measured"), std::string::npos) << out;
  EXPECT_EQ(runJson(none)["status"], "empty_input");
  EXPECT_EQ(run(none + " --labels " + path("none-labels.ply")), 0) << err;
  EXPECT_NE(read(path("none-labels.ply")).find("element vertex 0\n"), std::string::npos);
}

TEST_F(DetectProgram, TellsTooFewPointsFromAllInOnePlace) {
  std::string header =
      "ply\nformat ascii 1.0\nelement vertex 20\nproperty float x\nproperty float y\nproperty float z\n";
  header += "end_header\n";
  std::string same, missing = "nan nan nan\n";
  for (int i = 0; i < 19; ++i) same += "0.5 0.5 1\n", missing += i < 9 ? "nan nan nan\n" : "0.1 0.2 1\n";
  EXPECT_EQ(run(write("same.ply", header + same + "0.5 0.5 1\n")), 0);
  EXPECT_NE(out.find("nothing found: all points are in one place"), std::string::npos) << out;
  EXPECT_EQ(run(write("few.ply", header + missing)), 0);
  EXPECT_NE(out.find("only 10 of 20 are measured"), std::string::npos) << out;
  EXPECT_NE(out.find("at least 16 are needed"), std::string::npos) << out;
}

TEST_F(DetectProgram, SaysThatAllKindsAreOff) {
  EXPECT_EQ(run(ball + " --detect_planes false --detect_spheres false --detect_cylinders false --detect_cones false"),
            0);
  EXPECT_NE(out.find("nothing found: all kinds are off (detect_planes, "), std::string::npos) << out;
}

TEST_F(DetectProgram, NamesTheDepthRangeThatCutAllPointsAway) {
  EXPECT_EQ(run(ball + " --min_depth 0.25 --max_depth 0.5"), 0);  // the nearest is at 0.9 m, the wall at 1.3 m
  for (const char* part : {"nothing found: all 4025", "0.9", "1.3 m", "min_depth 0.25 m", "max_depth 0.5 m"}) {
    EXPECT_NE(out.find(part), std::string::npos) << out << part;
  }
  EXPECT_EQ(run(ball + " --min_depth 2.5 --max_depth 0"), 0);
  EXPECT_NE(out.find("min_depth 2.5 m"), std::string::npos) << out;
  EXPECT_EQ(out.find("max_depth"), std::string::npos) << out;  // is off
  EXPECT_EQ(run(ball + " --max_depth 0.9005"), 0);             // leaves the tip of the ball
  EXPECT_NE(out.find("too few points"), std::string::npos) << out;
  EXPECT_NE(out.find("max_depth 0.9005 m"), std::string::npos) << out;
}

TEST_F(DetectProgram, DoesNotBlameTheDepthRangeForWhatItDidNotCut) {
  EXPECT_EQ(run(ball + " --min_inliers 100000"), 0);
  EXPECT_NE(out.find("nothing found: no shape"), std::string::npos) << out;
  EXPECT_EQ(out.find("_depth"), std::string::npos) << out;
}

TEST_F(DetectProgram, NamesBadFilesAndGoesOnWithTheOthers) {
  EXPECT_EQ(run(path("nothing.pcd") + " " + broken + " " + ball + " --json " + path("all.json")), 1);
  EXPECT_EQ(errorLines(), 2) << err;
  EXPECT_NE(err.find(path("nothing.pcd") + ": no such file"), std::string::npos) << err;
  EXPECT_NE(err.find(broken + ": is not a PCD"), std::string::npos) << err;
  const Json json = Json::parse(read(path("all.json")));
  ASSERT_EQ(json.size(), 3u);
  EXPECT_TRUE(json[0].contains("error"));
  EXPECT_TRUE(hasSphere(json[2], 0.1));
}

TEST_F(DetectProgram, SaysWhichOptionMayBeMeantByAnUnknownOne) {
  EXPECT_EQ(run(ball + " --min_radus 0.1"), 2);
  EXPECT_NE(err.find("--min_radus; did you mean '--min_radius'? (see --help)"), std::string::npos) << err;
  EXPECT_EQ(run(ball + " --pictur=a.png"), 2);
  EXPECT_NE(err.find("; did you mean '--picture'?"), std::string::npos) << err;
  EXPECT_EQ(run(ball + " -max_depth 1"), 2);
  EXPECT_NE(err.find("; did you mean '--max_depth'?"), std::string::npos) << err;
  for (const char* as_node : {" max_depth:=1", " _max_depth:=1"}) {
    EXPECT_EQ(run(ball + as_node), 2);
    EXPECT_NE(err.find("here it is '--max_depth 1' (see --help)"), std::string::npos) << err;
  }
  EXPECT_EQ(run(ball + " input:=/camera/points"), 2);
  EXPECT_NE(err.find("here it is '--NAME VALUE' (see --help)"), std::string::npos) << err;
  EXPECT_EQ(run(ball + " max_depth=1"), 2);
  EXPECT_NE(err.find("'max_depth=1' is no file; it is '--max_depth 1' (see --help)"), std::string::npos) << err;
  EXPECT_EQ(run(ball + " --min_radus 1 --max_dpeth 1"), 2);
  EXPECT_NE(err.find("'--min_radius'?; did you mean '--max_depth'? (see"), std::string::npos) << err;
  EXPECT_EQ(run(ball + " --json " + path("x:=y.json")), 0) << "a name of a file all the same";
  EXPECT_EQ(run(ball + " --nothing-like-it"), 2);
  EXPECT_EQ(err.find("did you mean"), std::string::npos) << err;
}

TEST_F(DetectProgram, SaysWhatWasNotLookedForAndWhatWasCutAway) {
  EXPECT_EQ(run(ball + " --detect_spheres false --detect_cones false --convexity concave"), 0);
  EXPECT_NE(out.find("note: not looked for: spheres, cones, outsides of curved shapes (detect_spheres, detect_cones, "
                     "convexity)\n"),
            std::string::npos)
      << out;
  EXPECT_EQ(run(ball), 0);
  EXPECT_EQ(out.find("not looked for"), std::string::npos) << out;
  EXPECT_EQ(out.find("max_depth"), std::string::npos) << "nothing is cut away: " << out;
  EXPECT_EQ(run(ball + " --unlikely --min_depth 0.95 --max_depth 1.2"), 0);
  EXPECT_NE(out.find(" nearer than min_depth 0.95 m, 2025 beyond max_depth 1.2 m), "), std::string::npos) << out;
}

TEST_F(DetectProgram, LeavesStepsOut) {
  const auto foundBy = [&](const std::string& arguments) { return runJson(arguments)["primitives"]; };
  const Json usual = foundBy(ball), no_fit = foundBy("--without last_fit " + ball);
  const Json no_noise = foundBy("--without noise " + ball);
  const Json neither = foundBy("--without last_fit --without noise " + ball);
  EXPECT_NE((*sphereIn(usual))["radius"], (*sphereIn(no_fit))["radius"]);
  EXPECT_NE(usual, no_noise);
  EXPECT_NE(neither, no_fit);
  EXPECT_NE(neither, no_noise);
  EXPECT_EQ(run(ball + " --without last_fit --without upright"), 0);
  EXPECT_NE(out.find("note: without last_fit, upright\n"), std::string::npos) << out;
  EXPECT_EQ(runJson(ball + " --without last_fit --without upright")["without"], Json({"last_fit", "upright"}));
  EXPECT_FALSE(runJson(ball).contains("without"));
  EXPECT_EQ(run(ball + " --without last_fit --preset paper"), 0);
  EXPECT_NE(out.find("without last_fit, which does nothing where verify is off\n"), std::string::npos) << out;
  EXPECT_EQ(run("--print-params --without last_fit"), 2);
  EXPECT_EQ(run(ball + " --without lastfit"), 2);
  EXPECT_NE(err.find("unknown step 'lastfit'; did you mean 'last_fit'?"), std::string::npos) << err;
}

TEST_F(DetectProgram, WritesNoJsonForASingleBadFile) {
  EXPECT_EQ(run(broken + " --json -"), 1);
  EXPECT_EQ(out, "");
  EXPECT_EQ(errorLines(), 1);
}

TEST_F(DetectProgram, RefusesBadParametersNamingValueAndRange) {
  expectUsageError(ball + " --max_depth 1000", {"max_depth", "1000", "100"});
  expectUsageError(ball + " --max_depth -1", {"max_depth", "-1", "100"});
  expectUsageError(ball + " --samples few", {"samples", "few", "65536"});
  expectUsageError(ball + " --clustering best", {"clustering", "best", "average"});
  expectUsageError(ball + " --preset best", {"preset", "best", "paper"});
  expectUsageError(ball + " --min_depth 3 --max_depth 2", {"min_depth", "max_depth"});
  expectUsageError(ball + " --params " + write("p.yaml", "samples: 3\n"), {"p.yaml", "samples", "3", "16"});
  expectUsageError(ball + " --params " + path("nothing.yaml"), {"nothing.yaml"});
}

TEST_F(DetectProgram, RefusesWrongUsage) {
  expectUsageError("", {"FILE"});
  expectUsageError(ball + " --max_dpth 3", {"max_dpth"});
  expectUsageError(ball + " --target_frame base", {"target_frame"});
  expectUsageError(ball + " --repeat 0", {"--repeat", "0"});
  expectUsageError(ball + " --repeat 1.5", {"--repeat", "1.5"});
  expectUsageError(ball + " --depth-scale 0", {"--depth-scale", "0"});
  expectUsageError(ball + " --intrinsics 1,2,3", {"1,2,3", "fx,fy,cx,cy"});
  expectUsageError(path("depth.png"), {"depth.png", "--intrinsics"});
  expectUsageError(ball + " --json", {"--json"});
  expectUsageError(ball + " --labels -", {"--labels"});
  expectUsageError(ball + " --intrinsics 500,500,320,240", {"--intrinsics", "depth image"});
}

TEST_F(DetectProgram, RefusesOutputsThatCollide) {
  std::filesystem::create_directories(path("other"));
  const std::string twin = write("other/ball.ply", ballPly(1.0));
  expectUsageError(ball + " " + twin + " --json " + path("out/"), {"--json", "ball.json", twin});
  expectUsageError(ball + " " + broken + " --labels " + path("labels.ply"), {"--labels", "directory"});
  expectUsageError(ball + " --labels " + ball, {"--labels", "overwrite"});
  EXPECT_EQ(read(ball), ballPly(1.0));
}

TEST_F(DetectProgram, RefusesTwoOutputsInOneFile) {
  const std::string file = path("result"), detour = path("no/../result");
  expectUsageError(ball + " --json " + file + " --labels " + file, {"--json", "--labels", "result"});
  expectUsageError(ball + " --json " + file + " --picture " + detour, {"--json", "--picture", "result"});
  EXPECT_EQ(read(file), "");
}

TEST_F(DetectProgram, RefusesOutputsThatAreNamedAsOtherFormats) {
  expectUsageError(ball + " --labels " + path("labels.pcd"), {"--labels", "labels.pcd", "ply"});
  for (const char* name : {"picture.jpg", "picture.JPG", "picture.bmp", "picture.unknown"}) {
    expectUsageError(ball + " --picture " + path(name), {"--picture", name, "png"});
  }
  expectUsageError(ball + " --json " + path("result.yaml"), {"--json", "result.yaml", "json"});
  EXPECT_EQ(run(ball + " --json " + path("result.txt")), 0) << err;
}

TEST_F(DetectProgram, ReportsOutputsThatCannotBeWritten) {
  // Before anything is worked out.
  expectUsageError(ball + " --json " + path("no/such/folder.json"), {"--json", "folder.json", "no directory"});
  expectUsageError(ball + " --picture " + path("no/such/folder.png"), {"--picture", "folder.png", "no directory"});
  expectUsageError(broken + " --labels " + ball + "/labels.ply", {"--labels", "labels.ply", "no directory"});
}

TEST_F(DetectProgram, EndsWithOneWhereAFolderCannotBeWritten) {
  EXPECT_EQ(run(ball + " --json " + ball + "/sub/"), 1);
  EXPECT_NE(err.find("--json: cannot make directory " + ball + "/sub/"), std::string::npos) << err;
  EXPECT_EQ(errorLines(), 1) << err;
  // As a user whom access rights bind.
  std::filesystem::create_directories(path("closed"));
  std::filesystem::permissions(path("closed"), std::filesystem::perms(0555));
  const primitect::tools::OutputTarget target("--json", path("closed/x.json"), ".json", {ball}, true);
  const uid_t user = ::getuid();
  if (user == 0) {
    ASSERT_EQ(::setreuid(65534, 0), 0);
  }
  EXPECT_THROW(primitect::tools::refuseUnwritable({&target}, 1), std::runtime_error);
  if (user == 0) {
    ASSERT_EQ(::setreuid(0, 0), 0);
  }
}

TEST_F(DetectProgram, EndsWithOneWhereStandardOutputCannotBeWritten) {
  for (const std::string& arguments :
       {ball, ball + " --json -", std::string("--print-params"), std::string("--kernels"), std::string("--help")}) {
    const std::string command =
        std::string(PRIMITECT_TOOLS_DIR) + "/detect " + arguments + " 2>" + path("said") + " >/dev/full </dev/null";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << arguments;
    EXPECT_EQ(read(path("said")), "detect: standard output cannot be written\n") << arguments;
  }
}

TEST_F(DetectProgram, FillsADirectoryForSeveralFiles) {
  const std::string second = write("second.ply", ballPly(1.5));
  const std::string to = path("out/");
  EXPECT_EQ(run(ball + " " + second + " --json " + to + " --labels " + to + " --picture " + to), 0) << err;
  for (const char* stem : {"ball", "second"}) {
    EXPECT_TRUE(hasSphere(Json::parse(read(to + stem + ".json")), 0.1));
    EXPECT_NE(read(to + stem + ".ply").find("property uint label"), std::string::npos);
    EXPECT_FALSE(primitect::test::readPicture(to + stem + ".png").empty());
  }
}

TEST_F(DetectProgram, FillsADirectoryAlsoForFilesThatCannotBeRead) {
  const std::string to = path("some/");
  EXPECT_EQ(run(write("broken.ply", "no points") + " " + ball + " --json " + to), 1);
  EXPECT_NE(Json::parse(read(to + "broken.json"))["error"], "");
  EXPECT_TRUE(hasSphere(Json::parse(read(to + "ball.json")), 0.1));
  EXPECT_EQ(run(path("missing.pcd") + " --json " + to), 1);
  EXPECT_NE(Json::parse(read(to + "missing.json"))["error"], "") << "of a single one, too";
}

TEST_F(DetectProgram, CutsDepthImagesButNotUnorganizedFiles) {
  primitect::test::writePng(path("image.png"), ballImage());
  const std::string lens = " --intrinsics 262.5,262.5,159.5,119.5";
  const Json cut = runJson(path("image.png") + lens);
  EXPECT_EQ(cut["points_in"], 320 * 240);
  EXPECT_LT(cut["points_used"], 320 * 240 * 2 / 3);
  EXPECT_TRUE(hasSphere(cut, 0.1)) << cut.dump(1);
  EXPECT_EQ(runJson(path("image.png") + lens + " --max_depth 0")["points_used"], 320 * 240);
  const std::string far = write("far.ply", ballPly(5.0));
  EXPECT_EQ(runJson(far)["points_used"], kPlyPoints);
  EXPECT_EQ(runJson(far + " --max_depth 2")["status"], "empty_input");
}

TEST_F(DetectProgram, ScalesDepthImages) {
  primitect::test::writePng(path("image.png"), ballImage());
  const Json json = runJson(path("image.png") + " --intrinsics 262.5,262.5,159.5,119.5 --depth-scale 0.0005");
  EXPECT_EQ(run(path("image.png") + " --intrinsics 262.5,262.5,159.5,119.5 --depth-scale 0.1"), 0);
  EXPECT_NE(out.find("cut away by the depth range"), std::string::npos) << out;
  EXPECT_NE(out.find("is --depth-scale that of the image?"), std::string::npos) << out;
  EXPECT_EQ(json["points_used"], 320 * 240);  // the far wall is now at 1.5 m
}

TEST_F(DetectProgram, KeepsTheNormalsThatAFileBrings) {
  // Turned towards the sensor, inward normals are the outward ones; kept, they are not.
  const std::string inward = write("inward.ply", ballPly(1.0, -1.0));
  const Json outward = runJson(ball)["primitives"];
  EXPECT_EQ(runJson(inward + " --orient_normals true")["primitives"], outward);
  const Json kept = runJson(inward)["primitives"];
  ASSERT_FALSE(kept.empty());
  EXPECT_NE(kept, outward);
}

TEST_F(DetectProgram, LetsOptionsWinOverTheYamlFileAndThatOverThePreset) {
  const std::string yaml = write("p.yaml", "preset: drost\nsamples: 300\nreferences: 200\n");
  EXPECT_EQ(runJson(ball + " --params " + yaml)["samples"], 300);
  EXPECT_EQ(runJson(ball + " --params " + yaml + " --samples 400")["samples"], 400);
  EXPECT_EQ(run("--params " + yaml + " --print-params"), 0);
  EXPECT_NE(out.find("preset: drost"), std::string::npos);
  EXPECT_NE(out.find("\nsamples: 300\n"), std::string::npos);
  EXPECT_EQ(run("--params " + yaml + " --preset paper --samples 400 --print-params"), 0);
  EXPECT_NE(out.find("preset: paper"), std::string::npos);
  EXPECT_NE(out.find("\nsamples: 400\n"), std::string::npos);
  EXPECT_NE(out.find("\nreferences: 200\n"), std::string::npos);
}

TEST_F(DetectProgram, PrintsParametersThatItTakesBack) {
  EXPECT_EQ(run("--preset paper --max_depth 3.5 --detect_cones false --clustering nms --print-params"), 0);
  const std::string yaml = write("printed.yaml", out);
  EXPECT_EQ(run(ball + " --params " + yaml + " --json -"), 0) << err;
}

TEST_F(DetectProgram, UsesTheKernelThatTheEnvironmentNames) {
  setenv("PRIMITECT_KERNELS", "portable", 1);
  EXPECT_EQ(run("--kernels"), 0);
  EXPECT_NE(out.find("available: scalar portable"), std::string::npos) << out;
  EXPECT_NE(out.find("in use: portable, loops: baseline\n"), std::string::npos) << out;
  EXPECT_EQ(run(ball), 0) << err;
  setenv("PRIMITECT_KERNELS", "sse9", 1);
  expectUsageError(ball, {"PRIMITECT_KERNELS", "'sse9'", "scalar or portable"});
  expectUsageError("--kernels", {"'sse9'"});
  unsetenv("PRIMITECT_KERNELS");
}

TEST_F(DetectProgram, ExplainsItself) {
  EXPECT_EQ(run("--help"), 0);
  EXPECT_EQ(err, "");
  for (const char* word : {"FILE", "--json", "--labels", "--picture", "--intrinsics", "--sensor", "--repeat",
                           "--max_depth", "--samples", "--kernels"}) {
    EXPECT_NE(out.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(out.find("target_frame"), std::string::npos);
  EXPECT_EQ(run("--version"), 0);
  EXPECT_NE(out.find("detect (primitect) "), std::string::npos);
}

}  // namespace
}  // namespace detect_program_test
