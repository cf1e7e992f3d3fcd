// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The program `detect` as a user runs it: results, messages, exit codes.
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "temporary_folder.h"

namespace {

using Json = nlohmann::json;

/// The part of a ball of 0.1 m radius that a camera sees, in front of a wall of 1 x 1 m, with normals.
std::string ballPly(double depth, double normal_sign = 1.0) {
  std::ostringstream ply;
  constexpr int kBall = 2000, kRow = 45;
  ply << "ply\nformat ascii 1.0\nelement vertex " << kBall + kRow * kRow << "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) ply << "property float " << name << "\n";
  ply << "end_header\n";
  for (int i = 0; i < kBall; ++i) {
    const double z = -0.2 - 0.8 * (i + 0.5) / kBall, flat = std::sqrt(1.0 - z * z),
                 turn = 2.399963 * i;  // golden angle
    const double x = flat * std::cos(turn), y = flat * std::sin(turn);
    ply << 0.1 * x << " " << 0.1 * y << " " << depth + 0.1 * z << " " << normal_sign * x << " " << normal_sign * y
        << " " << normal_sign * z << "\n";
  }
  for (int i = 0; i < kRow * kRow; ++i) {
    ply << (i % kRow) / 44.0 - 0.5 << " " << (i / kRow) / 44.0 - 0.5 << " " << depth + 0.3 << " 0 0 " << -normal_sign
        << "\n";
  }
  return ply.str();
}

constexpr int kPlyPoints = 2000 + 45 * 45;

/// A ball of 0.1 m radius, 1.2 m in front of a camera, a wall at 1.7 m, and in the upper half of the image one at 3 m.
cv::Mat ballImage() {
  cv::Mat image(240, 320, CV_16UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double a = (u - 159.5) / 262.5, b = (v - 119.5) / 262.5, ray = a * a + b * b + 1.0;
      const double root = 1.2 * 1.2 - ray * (1.2 * 1.2 - 0.1 * 0.1);
      const double wall = v < 120 ? 3.0 : 1.7;
      const double z = root > 0.0 ? (1.2 - std::sqrt(root)) / ray : wall;
      image.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(std::lround(1000.0 * z));
    }
  }
  return image;
}

/// True when a sphere of that radius (m, within 5 %) is among the primitives.
bool hasSphere(const Json& json, double radius) {
  return std::any_of(json["primitives"].begin(), json["primitives"].end(), [&](const Json& primitive) {
    return primitive["type"] == "sphere" && std::abs(primitive["radius"].get<double>() / radius - 1.0) < 0.05;
  });
}

class DetectProgram : public primitect::test::TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    ball = write("ball.ply", ballPly(1.0));
    broken = write("broken.pcd", "no cloud");
  }

  int run(const std::string& arguments) {
    const std::string command = std::string(PRIMITECT_TOOLS_DIR) + "/detect " + arguments + " >" + path("stdout") +
                                " 2>" + path("stderr") + " </dev/null";
    const int status = std::system(command.c_str());
    out = read(path("stdout"));
    err = read(path("stderr"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  }

  Json runJson(const std::string& arguments) {
    EXPECT_EQ(run(arguments + " --json -"), 0) << err;
    return Json::parse(out);
  }

  long errorLines() const { return std::count(err.begin(), err.end(), '\n'); }

  void expectUsageError(const std::string& arguments, const std::vector<std::string>& says) {
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_EQ(errorLines(), 1) << err;
    EXPECT_EQ(out, "") << arguments;
    for (const std::string& part : says) EXPECT_NE(err.find(part), std::string::npos) << err << " / " << part;
  }

  std::string ball, broken, out, err;
};

TEST_F(DetectProgram, FindsTheBallAndWritesNothingButJson) {
  const Json json = runJson(ball);
  EXPECT_EQ(err, "");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["points_in"], kPlyPoints);
  ASSERT_EQ(json["primitives"].size(), 2u) << json.dump(1);
  EXPECT_TRUE(hasSphere(json, 0.1)) << json.dump(1);
  EXPECT_TRUE(json["primitives"][0]["type"] == "plane" || json["primitives"][1]["type"] == "plane");
  for (const char* stage : {"read", "sample", "normals", "vote", "cluster", "segment", "extent", "total"}) {
    EXPECT_TRUE(json["timing_ms"].contains(stage)) << stage;
  }
  double stages = 0.0;
  for (const auto& [stage, time] : json["timing_ms"].items()) {
    if (stage != "read" && stage != "total") stages += time.get<double>();
  }
  EXPECT_LE(stages, json["timing_ms"]["total"].get<double>() + 1e-6);
}

TEST_F(DetectProgram, PrintsATableWithoutJson) {
  EXPECT_EQ(run(ball), 0);
  EXPECT_NE(out.find("sphere"), std::string::npos);
  EXPECT_NE(out.find("r 1"), std::string::npos) << out;  // 0.1 m
  EXPECT_NE(out.find("total"), std::string::npos);
}

TEST_F(DetectProgram, SaysWhyNothingWasFound) {
  const std::string none =
      write("none.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
            "float z\nend_header\nnan nan nan\n");
  EXPECT_EQ(run(none), 0);
  EXPECT_NE(out.find("nothing found"), std::string::npos);
  EXPECT_EQ(runJson(none)["status"], "empty_input");
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
}

TEST_F(DetectProgram, RefusesOutputsThatCollide) {
  std::filesystem::create_directories(path("other"));
  const std::string twin = write("other/ball.ply", ballPly(1.0));
  expectUsageError(ball + " " + twin + " --json " + path("out/"), {"--json", "ball.json", twin});
  expectUsageError(ball + " " + broken + " --labels " + path("labels.ply"), {"--labels", "directory"});
  expectUsageError(ball + " --labels " + ball, {"--labels", "overwrite"});
  EXPECT_EQ(read(ball), ballPly(1.0));
}

TEST_F(DetectProgram, ReportsOutputsThatCannotBeWritten) {
  EXPECT_EQ(run(ball + " --json " + path("no/such/folder.json")), 1);
  EXPECT_NE(err.find("folder.json"), std::string::npos) << err;
  EXPECT_EQ(run(ball + " --picture " + path("no/such/folder.png")), 1);
  EXPECT_NE(err.find("folder.png"), std::string::npos) << err;
}

TEST_F(DetectProgram, FillsADirectoryForSeveralFiles) {
  const std::string second = write("second.ply", ballPly(1.5));
  const std::string to = path("out/");
  EXPECT_EQ(run(ball + " " + second + " --json " + to + " --labels " + to + " --picture " + to), 0) << err;
  for (const char* stem : {"ball", "second"}) {
    EXPECT_TRUE(hasSphere(Json::parse(read(to + stem + ".json")), 0.1));
    EXPECT_NE(read(to + stem + ".ply").find("property uint label"), std::string::npos);
    EXPECT_FALSE(cv::imread(to + stem + ".png").empty());
  }
}

TEST_F(DetectProgram, RepeatsAndPrintsMinimumMedianMaximum) {
  EXPECT_EQ(run(ball + " --repeat 3"), 0);
  EXPECT_NE(out.find("3 runs"), std::string::npos);
  for (const char* word : {"min", "median", "max", "vote", "total"})
    EXPECT_NE(out.find(word), std::string::npos) << word;
  const Json json = runJson(ball + " --repeat 3");
  EXPECT_EQ(json["repeats"], 3);
  EXPECT_LE(json["timing_min_ms"]["total"], json["timing_ms"]["total"]);
  EXPECT_LE(json["timing_ms"]["total"], json["timing_max_ms"]["total"]);
}

TEST_F(DetectProgram, GivesTheSameResultEveryTime) {
  Json first = runJson(ball), second = runJson(ball);
  first.erase("timing_ms");
  second.erase("timing_ms");
  EXPECT_EQ(first, second);
}

TEST_F(DetectProgram, CutsDepthImagesButNotUnorganizedFiles) {
  cv::imwrite(path("image.png"), ballImage());
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
  cv::imwrite(path("image.png"), ballImage());
  const Json json = runJson(path("image.png") + " --intrinsics 262.5,262.5,159.5,119.5 --depth-scale 0.0005");
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

TEST_F(DetectProgram, ExplainsItself) {
  EXPECT_EQ(run("--help"), 0);
  EXPECT_EQ(err, "");
  for (const char* word :
       {"FILE", "--json", "--labels", "--picture", "--intrinsics", "--repeat", "--max_depth", "--samples"}) {
    EXPECT_NE(out.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(out.find("target_frame"), std::string::npos);
  EXPECT_EQ(run("--version"), 0);
  EXPECT_NE(out.find("detect (primitect) "), std::string::npos);
}

}  // namespace
