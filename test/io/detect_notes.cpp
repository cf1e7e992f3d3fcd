// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the program `detect` asks where a file cannot be what it is taken for, and tells of its noise.
#include <cmath>

#include "core/random.h"
#include "detect_fixture.h"
#include "test/support/png_files.h"

namespace detect_notes_test {
namespace {

using primitect::test::ballImage;
using primitect::test::ballPly;

class DetectNotes : public primitect::test::DetectProgram {};

/// A line of an ASCII PLY.
std::string pointLine(double x, double y, double z) {
  return std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
}

TEST_F(DetectNotes, AskWhereUnitsOrFrameCannotBeRight) {
  std::string header =
      "ply\nformat ascii 1.0\nelement vertex 400\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  std::string metres, millimetres, around_origin;
  for (int i = 0; i < 400; ++i) {
    const int column = i % 20, row = i / 20;
    metres += pointLine(0.05 * column, 0.05 * row, 1.0);
    millimetres += pointLine(50.0 * column, 50.0 * row, 1000.0);
    around_origin += pointLine(0.05 * column, 0.05 * row, i % 8 == 0 ? -0.002 : 0.002);
  }
  EXPECT_EQ(run(write("metres.ply", header + metres)), 0);
  EXPECT_EQ(out.find("note: lengths"), std::string::npos) << out;
  EXPECT_EQ(run(write("millimetres.ply", header + millimetres)), 0);
  const std::string units = "note: lengths are taken for metres; are they millimetres?";
  EXPECT_NE(out.find(units), std::string::npos) << out;
  // Of an image nothing is left within the range of depths.
  const std::string pcd = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 20\nHEIGHT 20\n";
  EXPECT_EQ(run(write("millimetres.pcd", pcd + "POINTS 400\nDATA ascii\n" + millimetres)), 0);
  EXPECT_NE(out.find("nothing found"), std::string::npos) << out;
  EXPECT_NE(out.find(units), std::string::npos) << out;
  EXPECT_EQ(run(write("far.pcd", pcd + "POINTS 400\nDATA ascii\n" + metres) + " --min_depth 1.5"), 0);
  EXPECT_NE(out.find("nothing found"), std::string::npos) << out;
  EXPECT_EQ(out.find(units), std::string::npos) << out;
  EXPECT_EQ(run(write("table.ply", header + around_origin)), 0);
  EXPECT_NE(out.find("note: 12 % of the points lie behind the sensor (z <= 0)"), std::string::npos) << out;
  std::string hidden = metres;
  for (int i = 0; i < 400; i += 2) hidden += pointLine(0.075 * (i % 20), 0.075 * (i / 20), 1.5);
  header.replace(header.find("400"), 3, "600");
  EXPECT_EQ(run(write("through.ply", header + hidden)), 0);
  EXPECT_NE(out.find("note: the points were not seen from the sensor"), std::string::npos) << out;
}

TEST_F(DetectNotes, SayWhatIsAssumedOfAListOfPoints) {
  const std::string note = "note: a list of points without normals is taken for seen from its origin along z";
  std::string wall;
  for (int i = 0; i < 400; ++i) wall += pointLine(0.05 * (i % 20), 0.05 * (i / 20), 1.0);
  const std::string head = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  EXPECT_EQ(run(write("list.pcd", head + "WIDTH 400\nHEIGHT 1\nPOINTS 400\nDATA ascii\n" + wall)), 0);
  EXPECT_NE(out.find(note), std::string::npos) << out;
  EXPECT_EQ(run(path("list.pcd") + " --sensor \"0 0 0 0 0 0 1\""), 0);
  EXPECT_EQ(out.find(note), std::string::npos) << out;
  EXPECT_EQ(run(write("image.pcd", head + "WIDTH 20\nHEIGHT 20\nPOINTS 400\nDATA ascii\n" + wall)), 0);
  EXPECT_EQ(out.find("note: "), std::string::npos) << out;
}

TEST_F(DetectNotes, SayHowMuchLiesBeyondTheDepthsThatCount) {
  std::string two_walls;
  for (int i = 0; i < 400; ++i) {
    const double depth = i % 20 < 7 ? 1.0 : 3.0;
    two_walls += pointLine(0.05 * (i % 20) * depth, 0.05 * (i / 20) * depth, depth);
  }
  const std::string head = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 20\nHEIGHT 20\n";
  EXPECT_EQ(run(write("walls.pcd", head + "POINTS 400\nDATA ascii\n" + two_walls)), 0);
  EXPECT_NE(out.find("note: 65 % of what was measured lies beyond max_depth (2 m)"), std::string::npos) << out;
  EXPECT_EQ(run(path("walls.pcd") + " --max_depth 4"), 0);
  EXPECT_EQ(out.find("beyond max_depth"), std::string::npos) << out;
}

TEST_F(DetectNotes, AskWhereTheOrderOfIntrinsicsCannotBeRight) {
  primitect::test::writePng(path("image.png"), ballImage());
  EXPECT_EQ(run(path("image.png") + " --intrinsics 262.5,262.5,159.5,119.5"), 0);
  EXPECT_EQ(out.find("note: "), std::string::npos) << out;
  EXPECT_EQ(run(path("image.png") + " --intrinsics 262.5,159.5,262.5,119.5"), 0);  // as in a camera's matrix
  EXPECT_NE(out.find("note: the principal point (262.5, 119.5) is far from the middle"), std::string::npos) << out;
  EXPECT_EQ(run(path("image.png") + " --intrinsics 131.25,131.25,85,119.5"), 0);  // of an image of half the width
  EXPECT_NE(out.find("for 320 x 240 pixels?"), std::string::npos) << out;
}

/// A wall at 1 m whose depths are off by about this share, in waves of 100 pixels and more.
cv::Mat bentWall(double share) {
  cv::Mat image(480, 640, CV_16UC1);
  primitect::Random random(5);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double wave = std::sin(0.063 * u) + std::sin(0.042 * (u + v)) + std::sin(0.027 * (v - 0.6 * u));
      const double z = 1000.0 * (1.0 + share * wave + 0.002 * random.gaussian());
      image.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(std::lround(z));
    }
  }
  return image;
}

TEST_F(DetectNotes, TellThatTheCameraBendsWhatItSees) {
  const std::string note = "note: the camera bends what it sees, by 0.";
  primitect::test::writePng(path("bent.png"), bentWall(0.003));
  primitect::test::writePng(path("straight.png"), bentWall(0.0));
  EXPECT_EQ(run(path("bent.png") + " --intrinsics 525,525,319.5,239.5"), 0);
  EXPECT_NE(out.find(note), std::string::npos) << out;
  EXPECT_EQ(run(path("bent.png") + " --intrinsics 525,525,319.5,239.5 --without depth_waves"), 0);
  EXPECT_EQ(out.find("bends"), std::string::npos) << out;
  EXPECT_EQ(run(path("straight.png") + " --intrinsics 525,525,319.5,239.5"), 0);
  EXPECT_EQ(out.find("bends"), std::string::npos) << out;
}

TEST_F(DetectNotes, TellNormalsThatFaceAwayFromTheSensor) {
  const std::string note = "note: most normals of the file face away from the sensor";
  const std::string inward = write("inward.ply", ballPly(1.0, -1.0));
  EXPECT_EQ(run(inward), 0);
  EXPECT_NE(out.find(note), std::string::npos) << out;
  for (const std::string& turned : {ball, inward + " --orient_normals true", inward + " --use_cloud_normals false"}) {
    EXPECT_EQ(run(turned), 0);
    EXPECT_EQ(out.find(note), std::string::npos) << out;
  }
}

/// The image with noise, in standard deviations of structured light at 1.2 m.
cv::Mat noisyImage(double deviations) {
  cv::Mat image = ballImage();
  primitect::Random random(3);
  for (std::size_t i = 0; i < image.total(); ++i) {
    auto& millimetres = image.at<std::uint16_t>(static_cast<int>(i));
    const double z = 0.001 * millimetres;
    const double sigma = deviations * (0.0012 + 0.0019 * (z - 0.4) * (z - 0.4));
    millimetres = static_cast<std::uint16_t>(std::lround(1000.0 * (z + sigma * random.gaussian())));
  }
  return image;
}

TEST_F(DetectNotes, TellHowNoisyTheCameraIs) {
  const std::string note = "note: points stray ", options = " --intrinsics 262.5,262.5,159.5,119.5";
  primitect::test::writePng(path("usual.png"), noisyImage(1.0));
  EXPECT_EQ(run(path("usual.png") + options), 0);
  EXPECT_EQ(out.find(note), std::string::npos) << out;
  primitect::test::writePng(path("noisy.png"), noisyImage(3.0));
  EXPECT_EQ(run(path("noisy.png") + options), 0);
  ASSERT_NE(out.find(note), std::string::npos) << out;
  EXPECT_NEAR(std::stod(out.substr(out.find(note) + note.size())), 3.0, 0.5) << out;
}

}  // namespace
}  // namespace detect_notes_test
