// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The program `detect` with points in another frame than the camera's.

#include <sstream>
#include <string>
#include <vector>

#include "detect_fixture.h"
#include "io/point_files.h"
#include "io/sensor_pose.h"
#include "io/shape_json.h"
#include "primitect/transforms.h"
#include "synthetic/clutter.h"
#include "test/support/png_files.h"
#include "test/support/point_lists.h"
#include "test/support/rendered_cloud.h"

namespace detect_sensor_test {
namespace {

using primitect::Vec3;
using primitect::test::ballImage;
using primitect::test::DetectProgram;
using Json = nlohmann::ordered_json;

/// Of a camera on a robot, 0.6 rad down; z of the robot is up.
const Eigen::Isometry3d kRobotFromCamera = Eigen::Translation3d(0.1, -0.2, 1.3) *
                                           Eigen::AngleAxisd(-M_PI / 2, Vec3::UnitZ()) *
                                           Eigen::AngleAxisd(-M_PI / 2 - 0.6, Vec3::UnitX());

std::string poseText() {
  return primitect::io::sensorPoseText({kRobotFromCamera.translation(), Eigen::Quaterniond(kRobotFromCamera.linear())});
}

constexpr const char* kNoViewpoint = "0 0 0 1 0 0 0";

/// The points of the image in another frame, as a PCD; flat: of a wall, which tells no camera from another; as_list:
/// without columns and rows.
std::string ballPcd(const Eigen::Isometry3d& frame_from_camera, const std::string& viewpoint = kNoViewpoint,
                    bool flat = false, bool as_list = false) {
  const cv::Mat image = ballImage();
  std::ostringstream pcd;
  pcd.precision(9);
  pcd << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH "
      << (as_list ? static_cast<int>(image.total()) : image.cols) << "\nHEIGHT " << (as_list ? 1 : image.rows)
      << "\nVIEWPOINT " << viewpoint << "\nPOINTS " << image.total() << "\nDATA ascii\n";
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double z = flat ? 1.0 : 0.001 * image.at<std::uint16_t>(v, u);
      const Vec3 point = frame_from_camera * Vec3((u - 159.5) / 262.5 * z, (v - 119.5) / 262.5 * z, z);
      pcd << point.x() << " " << point.y() << " " << point.z() << "\n";
    }
  }
  return pcd.str();
}

class DetectSensor : public DetectProgram {
 protected:
  void SetUp() override {
    DetectProgram::SetUp();
    std::filesystem::create_directories(path("camera"));
    std::filesystem::create_directories(path("robot"));
    in_camera = write("camera/ball.pcd", ballPcd(Eigen::Isometry3d::Identity()));
    in_robot = write("robot/ball.pcd", ballPcd(kRobotFromCamera));
    sensor = " --sensor \"" + poseText() + "\"";
  }

  Json runOrdered(const std::string& arguments) {
    EXPECT_EQ(run(arguments + " --json -"), 0) << err;
    return Json::parse(out);
  }

  std::string in_camera, in_robot, sensor;
};

Vec3 vectorOf(const Json& json) { return Vec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>()); }

TEST_F(DetectSensor, FindsTheSameInTheFrameOfTheFile) {
  const Json seen = runOrdered(in_camera), moved = runOrdered(in_robot + sensor);
  EXPECT_EQ(moved["points_used"], seen["points_used"]) << "depths are cut along the axis of the camera";
  EXPECT_EQ(moved["seen_from_origin"], true);
  ASSERT_EQ(moved["primitives"].size(), 2u) << moved.dump(1);
  ASSERT_EQ(seen["primitives"].size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json &before = seen["primitives"][i], &after = moved["primitives"][i];
    ASSERT_EQ(after["type"], before["type"]);
    const primitect::Shape shape = primitect::io::shapeFromJson(after);
    const primitect::Shape expected = transformed(kRobotFromCamera, primitect::io::shapeFromJson(before));
    const Vec3 origin = vectorOf(after["extent"]["origin"]), near_by = origin + Vec3(0.3, -0.2, 0.1);
    EXPECT_LT((origin - kRobotFromCamera * vectorOf(before["extent"]["origin"])).norm(), 1e-4);
    EXPECT_NEAR(distance(shape, near_by), distance(expected, near_by), 1e-4);
    EXPECT_LT((normalAt(shape, near_by) - normalAt(expected, near_by)).norm(), 1e-3);
  }
}

TEST_F(DetectSensor, WithoutItAWallIsNotSeenFromTheOrigin) {
  const std::string wall_in_robot = write("wall.pcd", ballPcd(kRobotFromCamera, kNoViewpoint, true));
  EXPECT_EQ(run(wall_in_robot), 0);
  EXPECT_NE(out.find("note: "), std::string::npos) << out;
  EXPECT_NE(out.find("--sensor says where the camera was"), std::string::npos) << out;
  EXPECT_EQ(run(wall_in_robot + sensor), 0);
  EXPECT_EQ(out.find("note: "), std::string::npos) << out;
  EXPECT_EQ(run(in_robot + sensor), 0);
  EXPECT_EQ(out.find("note: "), std::string::npos) << out;
  EXPECT_EQ(run(in_camera + sensor), 0);
  EXPECT_NE(out.find("is --sensor the pose of the camera's optical frame"), std::string::npos) << out;
}

/// To what a camera that was found may be off.
void expectSamePlaces(const Json& found, const Json& told) {
  ASSERT_EQ(found["primitives"].size(), told["primitives"].size());
  for (std::size_t k = 0; k < told["primitives"].size(); ++k) {
    const Json& primitive = found["primitives"][k];
    EXPECT_EQ(primitive["type"], told["primitives"][k]["type"]);
    const Vec3 origin = vectorOf(primitive["extent"]["origin"]);
    EXPECT_LT((origin - vectorOf(told["primitives"][k]["extent"]["origin"])).norm(), 0.005);
  }
}

TEST_F(DetectSensor, WithoutItAnImageTellsWhereItsCameraWas) {
  EXPECT_EQ(run(in_robot), 0);
  const std::size_t begin = out.find("rows and columns tell where the camera was: ");
  ASSERT_NE(begin, std::string::npos) << out;
  const std::size_t option = out.find("--sensor", begin);
  const std::string used = out.substr(option, out.find(" is used", option) - option);
  const Json found = runOrdered(in_robot), again = runOrdered(in_robot + " " + used);
  EXPECT_EQ(found["seen_from_origin"], true);
  EXPECT_EQ(found["sensor"]["from"], "image");
  EXPECT_LT((vectorOf(found["sensor"]["position"]) - kRobotFromCamera.translation()).norm(), 0.005);
  EXPECT_EQ(again["sensor"]["from"], "option");
  EXPECT_TRUE(runOrdered(in_camera)["sensor"].is_null());
  EXPECT_GE(found["primitives"].size(), 2u);
  ASSERT_EQ(found["primitives"].size(), again["primitives"].size()) << used;
  const Json told = runOrdered(in_robot + sensor);
  expectSamePlaces(found, told);
}

TEST_F(DetectSensor, WithoutItTheOrderOfAListTellsIt) {
  const std::string list = write("list.pcd", ballPcd(kRobotFromCamera, kNoViewpoint, false, true));
  EXPECT_EQ(run(list), 0);
  EXPECT_NE(out.find("note: the points are a list that was moved to another frame; their order tells where the camera "
                     "was: --sensor"),
            std::string::npos)
      << out;
  const Json found = runOrdered(list), told = runOrdered(list + sensor);
  EXPECT_EQ(found["sensor"]["from"], "order");
  EXPECT_GE(told["primitives"].size(), 2u);
  EXPECT_LT((vectorOf(found["sensor"]["position"]) - kRobotFromCamera.translation()).norm(), 0.005);
  expectSamePlaces(found, told);
  // In the frame of its camera nothing has to be said.
  EXPECT_EQ(run(write("list.pcd", ballPcd(Eigen::Isometry3d::Identity(), kNoViewpoint, false, true))), 0);
  EXPECT_EQ(out.find("note: "), std::string::npos) << out;
}

/// A cluttered table as a voxel grid leaves it, in the frame of the robot; also with normals, all of them upwards.
std::string tableInVoxels(bool with_normals = false) {
  namespace test = primitect::test;
  const auto image =
      test::renderedCloud(primitect::synthetic::clutteredTable(2), {}, 2, primitect::synthetic::clutterPose(2));
  std::vector<Vec3> moved;
  for (const Vec3& point : test::pointsOf(image)) moved.push_back(kRobotFromCamera * point);
  const std::vector<Vec3> means = test::averaged(moved, 0.005);
  std::ostringstream pcd;
  pcd << "VERSION 0.7\nFIELDS x y z" << (with_normals ? " normal_x normal_y normal_z" : "") << "\nSIZE 4 4 4"
      << (with_normals ? " 4 4 4" : "") << "\nTYPE F F F" << (with_normals ? " F F F" : "") << "\nCOUNT 1 1 1"
      << (with_normals ? " 1 1 1" : "") << "\nWIDTH " << means.size() << "\nHEIGHT 1\nVIEWPOINT " << kNoViewpoint
      << "\nPOINTS " << means.size() << "\nDATA ascii\n";
  for (const Vec3& mean : means)
    pcd << mean.x() << " " << mean.y() << " " << mean.z() << (with_normals ? " 0 0 1" : "") << "\n";
  return pcd.str();
}

TEST_F(DetectSensor, WithoutItShadowsTellItOfAListInNoOrder) {
  const std::string list = write("voxels.pcd", tableInVoxels());
  EXPECT_EQ(run(list), 0);
  EXPECT_NE(out.find("note: the points are a list that was moved to another frame; the shadows of things on a plane "
                     "tell, to some centimetres, where the camera was: --sensor"),
            std::string::npos)
      << out;
  const Json found = runOrdered(list);
  EXPECT_EQ(found["sensor"]["from"], "shadows");
  EXPECT_EQ(found["seen_from_origin"], true);
  EXPECT_LT((vectorOf(found["sensor"]["position"]) - kRobotFromCamera.translation()).norm(), 0.25);
  EXPECT_GE(found["primitives"].size(), 5u);
}

TEST_F(DetectSensor, WithoutItShadowsAreLookedAtWhereNormalsAreNotUsed) {
  const std::string list = write("normals.pcd", tableInVoxels(true));
  EXPECT_TRUE(runOrdered(list)["sensor"].is_null());
  EXPECT_EQ(runOrdered(list + " --use_cloud_normals false")["sensor"]["from"], "shadows");
}

/// In the order of a PCD.
std::string viewpointText(const Eigen::Quaterniond& orientation) {
  std::ostringstream text;
  text << kRobotFromCamera.translation().transpose() << " " << orientation.w() << " " << orientation.vec().transpose();
  return text.str();
}

/// The option that a note advises after these words.
std::string adviceAfter(const std::string& words, const std::string& out) {
  const std::size_t begin = out.find(words + ": try --sensor \"");
  if (begin == std::string::npos) return "";
  const std::size_t option = out.find("--sensor", begin);
  return out.substr(option, out.find('\n', begin) - option);
}

TEST_F(DetectSensor, TakesWhatTheNoteAdvisesWhereAViewpointIsToldInEitherConvention) {
  const Eigen::Quaterniond optical(kRobotFromCamera.linear());
  Eigen::Matrix3d ahead_left_up;
  ahead_left_up << kRobotFromCamera.linear().col(2), -kRobotFromCamera.linear().col(0),
      -kRobotFromCamera.linear().col(1);
  for (const Eigen::Quaterniond& orientation : {optical, Eigen::Quaterniond(ahead_left_up)}) {
    const std::string file = write("viewpoint.pcd", ballPcd(kRobotFromCamera, viewpointText(orientation), true));
    EXPECT_EQ(run(file), 0);
    const std::string advice = adviceAfter("VIEWPOINT of the file may say where the camera was", out);
    ASSERT_FALSE(advice.empty()) << out;
    const Json found = runOrdered(file + " " + advice);
    EXPECT_EQ(found["seen_from_origin"], true) << advice;
    const Json expected = runOrdered(file + sensor);
    ASSERT_EQ(found["primitives"].size(), expected["primitives"].size()) << advice;
    EXPECT_EQ(found["points_used"], expected["points_used"]) << advice;
  }
}

TEST_F(DetectSensor, DoesNotUseAViewpointUnasked) {
  const std::string viewpoint = viewpointText(Eigen::Quaterniond(kRobotFromCamera.linear()));
  const std::string file = write("viewpoint.pcd", ballPcd(Eigen::Isometry3d::Identity(), viewpoint));
  EXPECT_EQ(runOrdered(file)["primitives"], runOrdered(in_camera)["primitives"]);
  EXPECT_EQ(run(file), 0);
  EXPECT_EQ(out.find("note: "), std::string::npos) << out;
}

TEST_F(DetectSensor, AdvisesNoViewpointThatIsNone) {
  for (const char* none : {kNoViewpoint, "0 0 0 2 0 0 0", "0 0 0 0 0 0 0", "1 2 nan 1 0 0 0"}) {
    EXPECT_EQ(run(write("none.pcd", ballPcd(kRobotFromCamera, none, true))), 0) << err;
    EXPECT_NE(out.find("--sensor says where"), std::string::npos) << out;
    EXPECT_EQ(out.find("VIEWPOINT"), std::string::npos) << out;
  }
}

TEST_F(DetectSensor, TurnsNormalsThatTheFileBrings) {
  const Json expected = runOrdered(ball);
  std::istringstream lines(primitect::test::ballPly(1.0));
  std::ostringstream ply;
  ply.precision(9);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Vec3 p, n;
    if (words >> p.x() >> p.y() >> p.z() >> n.x() >> n.y() >> n.z()) {
      p = kRobotFromCamera * p, n = kRobotFromCamera.linear() * n;
      ply << p.transpose() << " " << n.transpose() << "\n";
    } else {
      ply << line << "\n";
    }
  }
  const Json found = runOrdered(write("turned.ply", ply.str()) + sensor);
  ASSERT_EQ(found["primitives"].size(), expected["primitives"].size()) << found.dump(1);
  for (std::size_t i = 0; i < found["primitives"].size(); ++i) {
    EXPECT_EQ(found["primitives"][i]["type"], expected["primitives"][i]["type"]);
    EXPECT_EQ(found["primitives"][i]["concave"], false);
  }
}

TEST_F(DetectSensor, WritesLabelsOfThePointsAsTheyAreInTheFile) {
  const std::string labels = path("labels.ply");
  EXPECT_EQ(run(in_robot + sensor + " --labels " + labels), 0) << err;
  const primitect::Cloud points = primitect::io::readPointFile(in_robot).cloud;
  const primitect::Cloud labelled = primitect::io::readPointFile(labels).cloud;
  ASSERT_EQ(labelled.width, points.width);
  EXPECT_EQ(labelled.x, points.x);
  EXPECT_EQ(labelled.z, points.z);
}

TEST_F(DetectSensor, DrawsWhatTheCameraSaw) {
  EXPECT_EQ(run(in_camera + " --picture " + path("camera.png")), 0) << err;
  EXPECT_EQ(run(in_robot + sensor + " --picture " + path("robot.png")), 0) << err;
  const cv::Mat expected = primitect::test::readPicture(path("camera.png")),
                picture = primitect::test::readPicture(path("robot.png"));
  ASSERT_EQ(picture.size(), expected.size());
  // Rounding of moved points may shift an edge.
  EXPECT_LT(cv::norm(picture, expected, cv::NORM_L1) / static_cast<double>(picture.total()), 1.0);
}

TEST_F(DetectSensor, SaysThatFramesOfTheNodeAreNotUsed) {
  const std::string yaml = write("node.yaml", "sensor_frame: camera\ntarget_frame: map\nmarker_alpha: 0.5\n");
  const std::string params = " --params " + yaml;
  EXPECT_EQ(runOrdered(ball + params)["primitives"], runOrdered(ball)["primitives"]);
  EXPECT_EQ(run(ball + params), 0);
  EXPECT_EQ(errorLines(), 2) << err;
  EXPECT_NE(err.find("note: sensor_frame 'camera' is for the ROS node only; here --sensor"), std::string::npos) << err;
  EXPECT_NE(err.find("note: target_frame 'map' is for the ROS node only"), std::string::npos) << err;
  EXPECT_EQ(run(in_robot + sensor + params), 0);
  EXPECT_EQ(errorLines(), 1) << "--sensor was given: " << err;
  const std::string empty = write("empty.yaml", "sensor_frame: ''\ntarget_frame: ''\nmarker_alpha: 0.5\n");
  EXPECT_EQ(run(ball + " --params " + empty), 0);
  EXPECT_EQ(err, "");
}

TEST_F(DetectSensor, RefusesWhatIsNoPose) {
  for (const char* text : {"0 0 1.3", "0 0 1.3 0 0 0 0", "0 0 1.3 nan 0 0 1", "0 0 1.3 0 0 0 1 1", "", "forward"}) {
    expectUsageError(in_robot + " --sensor '" + text + "'", {"sensor", "X Y Z QX QY QZ QW"});
  }
  expectUsageError(in_robot + " --sensor 0 0 1.3 0 0 0 1", {"sensor", "'0'", "X Y Z QX QY QZ QW"});
  primitect::test::writePng(path("image.png"), ballImage());
  expectUsageError(path("image.png") + " --intrinsics 262.5,262.5,159.5,119.5 " + sensor, {"--sensor", "depth image"});
}

}  // namespace
}  // namespace detect_sensor_test
