// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The nodelet, the plain node, the core called directly and the offline tool give the same for the same cloud.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl_conversions/pcl_conversions.h>
#include <primitect/PrimitiveArray.h>
#include <ros/ros.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "primitect/detector.h"
#include "ros/geometry_messages.h"
#include "ros/messages.h"
#include "ros/synthetic_messages.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"

namespace primitect {
namespace {

constexpr int kFrames = 3;
constexpr double kPatienceSeconds = 120.0;  // a loaded machine is slow

/// The bytes of a message without what may differ: the publisher's counter and the time it took.
std::vector<std::uint8_t> comparableBytes(PrimitiveArray message) {
  message.header.seq = 0;
  message.processing_time = 0.0f;
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

/// A file that goes with the test.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "_" + name)) {}
  ~TemporaryFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// What the offline tool says about these points in an organized file.
nlohmann::json fromTheTool(const sensor_msgs::PointCloud2& message) {
  const TemporaryFile cloud_file("same_result.pcd"), report_file("same_result.json");
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromROSMsg(message, cloud);
  pcl::io::savePCDFileBinary(cloud_file.path(), cloud);
  const std::string command = std::string("'") + PRIMITECT_TOOLS_DIR + "/detect' --json - '" + cloud_file.path() +
                              "' > '" + report_file.path() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream stream(report_file.path());
  const nlohmann::json report = nlohmann::json::parse(stream);
  return report.is_array() ? report.at(0) : report;
}

Vec3 vectorOf(const nlohmann::json& json) { return Vec3(json.at(0), json.at(1), json.at(2)); }

/// A number of the message is the float nearest to the double of the report.
void expectFloat(const nlohmann::json& reported, float number) { EXPECT_EQ(reported.get<float>(), number); }

void expectSame(const nlohmann::json& reported, const Primitive& primitive) {
  const nlohmann::json& extent = reported.at("extent");
  const ros_layer::Body body(primitive);
  EXPECT_EQ(reported.at("type"), kindName(static_cast<Kind>(primitive.type)));
  EXPECT_EQ(reported.at("inliers"), primitive.inlier_count);
  expectFloat(reported.at("votes"), primitive.votes);
  expectFloat(reported.at("rms_error"), primitive.rms_error);
  EXPECT_EQ(vectorOf(extent.at("origin")), body.origin);
  if (primitive.type != Primitive::SPHERE) {  // by way of a quaternion
    EXPECT_LT((vectorOf(extent.at("z_axis")) - body.axis).norm(), 1e-9);
  }
  if (primitive.type == Primitive::PLANE) {
    for (std::size_t i = 0; i < 2; ++i) expectFloat(extent.at("size").at(i), primitive.size[i]);
    EXPECT_EQ(extent.at("hull").size(), primitive.hull.size());
  }
  if (primitive.type == Primitive::SPHERE || primitive.type == Primitive::CYLINDER) {
    expectFloat(reported.at("radius"), primitive.radius);
  }
  if (primitive.type == Primitive::CONE) {
    EXPECT_EQ(vectorOf(reported.at("apex")), ros_layer::toVec3(primitive.apex));
    expectFloat(reported.at("half_angle"), primitive.half_angle);
    expectFloat(extent.at("radius_large"), primitive.radius);
  }
  if (extent.contains("length")) {
    expectFloat(extent.at("length"), primitive.size[2]);
    nlohmann::json ends = nlohmann::json::array();
    if (primitive.unseen_ends & Primitive::END_AT_MINUS_Z) ends.push_back("minus_z");
    if (primitive.unseen_ends & Primitive::END_AT_PLUS_Z) ends.push_back("plus_z");
    EXPECT_EQ(extent.at("unseen_ends"), primitive.unseen_ends == Primitive::ENDS_UNKNOWN ? nlohmann::json() : ends);
    const auto face = [](int id) { return id == Primitive::NO_FACE ? nlohmann::json() : nlohmann::json(id); };
    EXPECT_EQ(extent.at("face_at_minus_z"), face(primitive.face_at_minus_z));
    EXPECT_EQ(extent.at("face_at_plus_z"), face(primitive.face_at_plus_z));
  }
}

class SameResult : public testing::Test {
 protected:
  SameResult() {
    for (const std::string name : {"nodelet", "node"}) {
      subscribers_.push_back(handle_.subscribe<PrimitiveArray>(
          "/" + name + "/primitives", 10,
          [this, name](const PrimitiveArrayConstPtr& message) { answers_[name].push_back(*message); }));
    }
    publisher_ = handle_.advertise<sensor_msgs::PointCloud2>("/cloud", 1);
  }

  bool waitFor(const std::function<bool()>& condition) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatienceSeconds);
    while (!condition() && ros::WallTime::now() < end && ros::ok()) {
      ros::spinOnce();
      ros::WallDuration(0.01).sleep();
    }
    return condition();
  }

  bool connected() {
    return waitFor([&] {
      return publisher_.getNumSubscribers() == 2 && subscribers_[0].getNumPublishers() == 1 &&
             subscribers_[1].getNumPublishers() == 1;
    });
  }

  std::vector<float> renderDepth(int frame) const {
    return synthetic::renderFrame(world_, camera_, synthetic::cameraPose(2.0 * frame), {}, 1,
                                  static_cast<std::uint64_t>(frame))
        .depth;
  }

  /// The core on what the camera's own driver would have measured.
  PrimitiveArray fromTheCore(const std::vector<float>& depth, const std_msgs::Header& header) {
    const Params& params = detector_.params();
    Cloud cloud;
    synthetic::cloudFromDepth(depth, camera_, {float(params.min_depth), float(params.max_depth)}, cloud);
    return ros_layer::toMessage(detector_.detect(cloud), header);
  }

  ros::NodeHandle handle_;
  ros::Publisher publisher_;
  std::vector<ros::Subscriber> subscribers_;
  std::map<std::string, std::vector<PrimitiveArray>> answers_;
  synthetic::PinholeCamera camera_;
  synthetic::World world_ = synthetic::tabletop(1);
  Detector detector_{Params()};
};

TEST_F(SameResult, OfNodeletNodeAndCore) {
  ASSERT_TRUE(connected());
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    const std::vector<float> depth = renderDepth(static_cast<int>(frame));
    std_msgs::Header header;
    header.frame_id = "camera";
    header.stamp = ros::Time(100 + static_cast<std::uint32_t>(frame), 7);
    publisher_.publish(ros_layer::depthCloud(header, depth, camera_));
    const auto answered = [&] { return answers_["nodelet"].size() > frame && answers_["node"].size() > frame; };
    ASSERT_TRUE(waitFor(answered)) << "frame " << frame;
    const PrimitiveArray expected = fromTheCore(depth, header);
    EXPECT_FALSE(expected.primitives.empty());
    EXPECT_EQ(comparableBytes(answers_["nodelet"][frame]), comparableBytes(expected));
    EXPECT_EQ(comparableBytes(answers_["node"][frame]), comparableBytes(expected));
    EXPECT_GT(answers_["node"][frame].processing_time, 0.0f);
  }
}

TEST_F(SameResult, OfNodeletAndOfflineTool) {
  ASSERT_TRUE(connected());
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(200, 7);
  const sensor_msgs::PointCloud2Ptr cloud = ros_layer::depthCloud(header, renderDepth(1), camera_);
  publisher_.publish(cloud);
  ASSERT_TRUE(waitFor([&] { return !answers_["nodelet"].empty(); }));
  const PrimitiveArray& answer = answers_["nodelet"].back();
  const nlohmann::json report = fromTheTool(*cloud);
  EXPECT_EQ(report.at("status"), statusName(static_cast<Status>(answer.status)));
  EXPECT_EQ(report.at("points_in"), answer.points_in);
  EXPECT_EQ(report.at("points_used"), answer.points_used);
  EXPECT_EQ(report.at("samples"), answer.samples);
  ASSERT_EQ(report.at("primitives").size(), answer.primitives.size());
  std::set<int> kinds;
  for (std::size_t i = 0; i < answer.primitives.size(); ++i) {
    SCOPED_TRACE("primitive " + std::to_string(i));
    expectSame(report.at("primitives").at(i), answer.primitives[i]);
    kinds.insert(answer.primitives[i].type);
  }
  EXPECT_GE(kinds.size(), 3u);  // or the comparison says little
}

}  // namespace
}  // namespace primitect

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "same_result");
  return RUN_ALL_TESTS();
}
