// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A frame a tick; nothing is rendered while nobody subscribes.
#include "synthetic_camera_nodelet.h"

#include <atomic>
#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>
#include <stdexcept>

#include "messages.h"
#include "parameters.h"
#include "synthetic/poses.h"
#include "synthetic/scene_text.h"
#include "synthetic/sensors.h"
#include "synthetic/tabletop.h"
#include "synthetic_messages.h"

namespace primitect::ros_layer {
namespace {

using Text = std::string;

const std::vector<ParamInfo>& settingsTable() {
  static const std::vector<ParamInfo> kTable = {
      {"rate", "", 30.0, 0.1, 200.0, {}, "Hz", "frames a second"},
      {"speed", "", 1.0, 0.0, 10.0, {}, "", "how fast the camera moves; 0 = it stands still"},
      {"seed", "", 1, 0, 2147483647, {}, "", "which tabletop, and its noise"},
      {"objects", "", Text(), 0, 0, {}, "", "what is on the table; empty: that of the seed"},
      {"eye", "", Text(), 0, 0, {}, "", "X Y Z, where the camera stands (m); empty: it swings around the table"},
      {"look_at", "", Text(), 0, 0, {}, "", "X Y Z, what it looks at from there (m); empty: the middle of the table"},
      {"roll", "", 0.0, -180.0, 180.0, {}, "deg", "by which it is turned about its view there; 180: upside down"},
      {"sensor", "", synthetic::sensorNames().front(), 0, 0, synthetic::sensorNames(), "", "what kind of depth camera"},
      {"noise_scale", "", 1.0, 0.0, 10.0, {}, "", "times the sensor's depth noise; 0 = exact depths"},
      {"width", "", 640, 16, 2048, {}, "px", "of the image; the field of view stays the same"},
      {"height", "", 480, 16, 2048, {}, "px", "of the image"},
      {"replay", "", 0, 0, 1000, {}, "frames", "so many are rendered once, then repeated, clouds only; 0 = each anew"},
      {"frame_id", "", Text("camera_depth_optical_frame"), 0, 0, {}, "", "of the camera"},
      {"world_frame", "", Text("world"), 0, 0, {}, "", "in which the camera moves"},
      {"depth_encoding", "", Text("32FC1"), 0, 0, {"32FC1", "16UC1"}, "", "of the depth image: m or mm"},
  };
  return kTable;
}

}  // namespace

SyntheticCameraNodelet::~SyntheticCameraNodelet() {
  timer_.stop();
  for (ros::Publisher* publisher : {&points_, &image_, &info_, &truth_}) publisher->shutdown();
}

void SyntheticCameraNodelet::onInit() {
  try {
    start();
    started_ = true;
  } catch (const std::exception& error) {
    NODELET_FATAL_STREAM(getName() << " does not start: " << error.what());
  }
}

void SyntheticCameraNodelet::start() {
  settings_ = loadSettings();
  world_ = settings_.objects.empty() ? synthetic::tabletop(settings_.seed) : synthetic::tableWith(settings_.objects);
  broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>();
  ros::NodeHandle& handle = getNodeHandle();
  points_ = handle.advertise<sensor_msgs::PointCloud2>("depth/points", 2);
  image_ = handle.advertise<sensor_msgs::Image>("depth/image_raw", 2);
  info_ = handle.advertise<sensor_msgs::CameraInfo>("depth/camera_info", 2);
  truth_ = getPrivateNodeHandle().advertise<PrimitiveArray>("truth", 2);
  timer_ = handle.createTimer(ros::Duration(1.0 / settings_.rate), [this](const ros::TimerEvent&) { onTimer(); });
}

SyntheticCameraNodelet::Settings SyntheticCameraNodelet::loadSettings() const {
  const auto values = loadTable(settingsTable(), privateParameters(getPrivateNodeHandle()));
  Settings settings;
  settings.rate = std::get<double>(values.at("rate"));
  settings.speed = std::get<double>(values.at("speed"));
  settings.replay = static_cast<std::size_t>(std::get<int>(values.at("replay")));
  settings.seed = static_cast<std::uint64_t>(std::get<int>(values.at("seed")));
  settings.objects = std::get<Text>(values.at("objects"));
  const Text& eye = std::get<Text>(values.at("eye"));
  const Text& look_at = std::get<Text>(values.at("look_at"));
  const double roll = std::get<double>(values.at("roll")) * synthetic::kDegree;
  if (eye.empty() && (roll != 0.0 || !look_at.empty())) {
    throw std::invalid_argument("roll and look_at are of a camera that stands still; set eye, too");
  }
  if (!eye.empty()) settings.pose = synthetic::poseOf(eye, look_at.empty() ? "0 0 0.75" : look_at, roll);
  settings.frame_id = std::get<Text>(values.at("frame_id"));
  settings.world_frame = std::get<Text>(values.at("world_frame"));
  settings.depth_encoding = std::get<Text>(values.at("depth_encoding"));
  settings.camera =
      synthetic::PinholeCamera().scaledTo(std::get<int>(values.at("width")), std::get<int>(values.at("height")));
  settings.frame.noise = synthetic::noiseOf(std::get<Text>(values.at("sensor")));
  settings.frame.noise.scale = std::get<double>(values.at("noise_scale"));
  if (settings.frame.noise.scale == 0.0) {
    settings.frame.noise.disparity_step = settings.frame.noise.waves = 0.0;
    settings.frame.noise.footprint = 1;
  }
  // As many pixels as needed at the default resolution, in proportion.
  const double shrink = static_cast<double>(settings.camera.pixelCount()) / synthetic::PinholeCamera().pixelCount();
  settings.frame.truth.min_pixels = static_cast<std::uint32_t>(settings.frame.truth.min_pixels * shrink);
  return settings;
}

double SyntheticCameraNodelet::secondsOfFrame() const {
  constexpr double kBetweenViews = 1.0;
  if (settings_.replay > 0)
    return settings_.speed * kBetweenViews * static_cast<double>(frame_index_ % settings_.replay);
  return settings_.speed * static_cast<double>(frame_index_) / settings_.rate;
}

void SyntheticCameraNodelet::onTimer() try {
  const Eigen::Isometry3d world_from_camera = settings_.pose.value_or(synthetic::cameraPose(secondsOfFrame()));
  std_msgs::Header header;
  header.stamp = ros::Time::now();
  header.frame_id = settings_.frame_id;
  broadcaster_->sendTransform(cameraTransform(header, settings_.world_frame, world_from_camera));
  settings_.replay > 0 ? replayFrame(header, world_from_camera) : publishFrame(header, world_from_camera);
  ++frame_index_;
} catch (const std::exception& error) {
  NODELET_ERROR_STREAM(getName() << " could not make a frame: " << error.what());
}

void SyntheticCameraNodelet::publishFrame(const std_msgs::Header& header, const Eigen::Isometry3d& world_from_camera) {
  if (info_.getNumSubscribers() > 0) info_.publish(cameraInfo(header, settings_.camera));
  if (points_.getNumSubscribers() + image_.getNumSubscribers() + truth_.getNumSubscribers() == 0) return;
  const synthetic::Frame frame = synthetic::renderFrame(world_, settings_.camera, world_from_camera, settings_.frame,
                                                        settings_.seed, frame_index_);
  if (truth_.getNumSubscribers() > 0) truth_.publish(toMessage(frame.truth, header));
  if (image_.getNumSubscribers() > 0) {
    image_.publish(depthImage(header, frame.depth, settings_.camera, settings_.depth_encoding));
  }
  if (points_.getNumSubscribers() > 0) points_.publish(depthCloud(header, frame.depth, settings_.camera));
}

void SyntheticCameraNodelet::replayFrame(std_msgs::Header header, const Eigen::Isometry3d& world_from_camera) {
  if (points_.getNumSubscribers() == 0) return;
  replayed_.resize(settings_.replay);
  sensor_msgs::PointCloud2Ptr& cloud = replayed_[frame_index_ % settings_.replay];
  if (!cloud) {
    const synthetic::Frame frame = synthetic::renderFrame(world_, settings_.camera, world_from_camera, settings_.frame,
                                                          settings_.seed, frame_index_);
    cloud = depthCloud(header, frame.depth, settings_.camera);
  }
  // A subscriber in this process may still be reading the one that was sent before.
  if (cloud.use_count() > 1) cloud = boost::make_shared<sensor_msgs::PointCloud2>(*cloud);
  std::atomic_thread_fence(std::memory_order_acquire);  // the last reader's reads come before the new stamp
  // Latencies are measured from here: nothing but publishing comes after.
  header.stamp = ros::Time::now();
  cloud->header = header;
  points_.publish(cloud);
  if (info_.getNumSubscribers() > 0) info_.publish(cameraInfo(header, settings_.camera));
}

}  // namespace primitect::ros_layer

PLUGINLIB_EXPORT_CLASS(primitect::ros_layer::SyntheticCameraNodelet, nodelet::Nodelet)
