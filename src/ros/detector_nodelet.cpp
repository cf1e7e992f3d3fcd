// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Starts, subscribes while someone listens, processes, publishes what is listened to.
#include "detector_nodelet.h"

#include <ros/master.h>

#include <iomanip>
#include <pluginlib/class_list_macros.hpp>

#include "messages.h"
#include "primitect/kernel_choice.h"

namespace primitect::ros_layer {
namespace {

using Lock = boost::recursive_mutex::scoped_lock;

/// Clouds of one sensor may arrive a little out of order; a bag that starts again jumps farther.
constexpr double kTimeJumpSeconds = 0.1;

}  // namespace

DetectorNodelet::~DetectorNodelet() { stop(); }

void DetectorNodelet::onInit() {
  try {
    const Lock lock(mutex_);
    start();
    started_ = true;
  } catch (const std::exception& error) {
    NODELET_FATAL_STREAM(getName() << " does not start: " << error.what());
    stop();
  }
}

void DetectorNodelet::start() {
  ros::NodeHandle& private_handle = getPrivateNodeHandle();
  const LoadedParams loaded = loadParams(privateParameters(private_handle));
  NODELET_INFO_STREAM(getName() << ": preset '" << loaded.preset
                                << "', parameters that differ from it: " << differenceText(loaded));
  NODELET_INFO_STREAM(getName() << ": voting kernel '" << kernelInUse() << "', loops '" << loopsInUse() << "'");
  pipeline_ = std::make_unique<FramePipeline>(loaded.params);
  diagnostics_ = std::make_unique<DetectorDiagnostics>(getNodeHandle(), private_handle, getName());
  if (!loaded.params.sensor_frame.empty() || !loaded.params.target_frame.empty()) {
    transforms_ = std::make_unique<tf2_ros::Buffer>();
    late_transforms_ = std::make_unique<LateTransforms>(*transforms_, loaded.params.transform_patience);
    transform_listener_ = std::make_unique<tf2_ros::TransformListener>(*transforms_, getNodeHandle());
  }
  writeParams(private_handle, loaded.params);
  reconfigure_ = std::make_unique<dynamic_reconfigure::Server<DetectorConfig>>(mutex_, private_handle);
  reconfigure_->setCallback([this](DetectorConfig& config, std::uint32_t level) { onReconfigure(config, level); });
  advertise();
  diagnostics_timer_ = getNodeHandle().createWallTimer(ros::WallDuration(1.0),
                                                       [this](const ros::WallTimerEvent&) { onDiagnosticsTimer(); });
}

void DetectorNodelet::advertise() {
  ros::NodeHandle& private_handle = getPrivateNodeHandle();
  const ros::SubscriberStatusCallback changed = [this](const ros::SingleSubscriberPublisher&) { onConnectionChange(); };
  constexpr std::uint32_t kQueue = 5;
  primitives_ = private_handle.advertise<PrimitiveArray>("primitives", kQueue, changed, changed);
  markers_ = private_handle.advertise<visualization_msgs::MarkerArray>("markers", kQueue, changed, changed);
  labels_ = private_handle.advertise<sensor_msgs::PointCloud2>("labels", 1, changed, changed);
  normals_ = private_handle.advertise<sensor_msgs::PointCloud2>("normals", 1, changed, changed);
}

/// Without the lock: shutting down waits for a running callback, and that may be waiting for the lock.
/// The outputs first: while they live, somebody who connects makes onConnectionChange() subscribe the input again.
void DetectorNodelet::stop() {
  for (ros::Publisher* publisher : {&primitives_, &markers_, &labels_, &normals_}) publisher->shutdown();
  input_.shutdown();
  diagnostics_timer_.stop();
  reconfigure_.reset();
}

void DetectorNodelet::onConnectionChange() try {
  const Lock lock(mutex_);
  const bool wanted = primitives_.getNumSubscribers() + markers_.getNumSubscribers() + labels_.getNumSubscribers() +
                          normals_.getNumSubscribers() >
                      0;
  if (!wanted) {
    input_.shutdown();
  } else if (!input_) {
    input_ = getPrivateNodeHandle().subscribe("input", 1, &DetectorNodelet::onCloud, this,
                                              ros::TransportHints().tcpNoDelay());
  }
} catch (const std::exception& error) {
  NODELET_ERROR_STREAM(getName() << " could not change its subscription: " << error.what());
}

void DetectorNodelet::onCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  const Lock lock(mutex_);
  try {
    processCloud(*cloud);
  } catch (const std::exception& error) {
    diagnostics_->frameFailed(error.what());
    if (failure_warning_.ready()) NODELET_ERROR_STREAM(getName() << " failed on a cloud: " << error.what());
  }
}

void DetectorNodelet::processCloud(const sensor_msgs::PointCloud2& cloud) {
  startAnewIfTimeWentBack(cloud.header.stamp);
  diagnostics_->frameReceived();
  pipeline_->times().begin();
  PrimitiveArray& message = detect(cloud);
  std::string problem = pipeline_->problem();
  if (!problem.empty() && input_warning_.ready()) {
    NODELET_WARN_STREAM(getName() << " refuses a cloud on " << input_.getTopic() << ": " << problem);
  }
  const std::string no_transform = toTargetFrame(cloud.header.frame_id, message);
  if (problem.empty()) problem = no_transform;
  track(message);
  pipeline_->times().stageDone("message");
  message.processing_time = static_cast<float>(pipeline_->times().end());
  FrameView view = {pipeline_->seenFromOrigin(), pipeline_->normalsFaceAway(), pipeline_->imageNoise(), std::nullopt};
  if (pipeline_->foundCamera()) view.found_camera = pipeline_->foundCamera()->translation();
  diagnostics_->frameDone(message, pipeline_->refusals(), view, problem);
  publish(message);
  pipeline_->published();
  warnIfHopeless();
  warnIfNotSeenFromOrigin();
  tellFoundCamera();
}

PrimitiveArray& DetectorNodelet::detect(const sensor_msgs::PointCloud2& cloud) {
  const std::string sensor = frameName(pipeline_->params().sensor_frame);
  const std::string& source = cloud.header.frame_id;
  sensor_header_ = cloud.header;
  with_labels_ = labels_.getNumSubscribers() > 0;
  if (sensor.empty()) return pipeline_->process(cloud, with_labels_);
  if (sensor == frameName(source)) return pipeline_->process(cloud, with_labels_, std::nullopt, CameraPlace::said);
  sensor_header_.frame_id = sensor;
  Eigen::Isometry3d sensor_from_cloud;
  try {
    sensor_from_cloud = late_transforms_->lookup(sensor, source, cloud.header.stamp);
  } catch (const std::exception& error) {  // tf2 has its own, ros::Duration another
    const std::string from_to = "from '" + source + "' to sensor_frame '" + sensor + "'";
    return pipeline_->withoutTransform(cloud.header, "no transform " + from_to + ": " + error.what());
  }
  PrimitiveArray& message = pipeline_->process(cloud, with_labels_, sensor_from_cloud);
  message.header.frame_id = sensor;
  return message;
}

void DetectorNodelet::track(PrimitiveArray& message) {
  if (!pipeline_->params().track) return tracker_.startAnew();
  tracker_.update(pipeline_->params().track_patience, message);
}

void DetectorNodelet::warnIfNotSeenFromOrigin() {
  if (pipeline_->seenFromOrigin() != false || told_not_from_origin_) return;
  told_not_from_origin_ = true;
  const std::string& sensor = pipeline_->params().sensor_frame;
  const std::string advice = sensor.empty() ? "set sensor_frame to the camera's optical frame, or shapes are missed"
                                            : "is sensor_frame the camera's optical frame, and the transform right?";
  NODELET_WARN_STREAM(getName() << ": clouds on " << input_.getTopic() << " are not seen from the origin of frame '"
                                << sensor_header_.frame_id << "' along z: " << advice);
}

void DetectorNodelet::tellFoundCamera() {
  if (!pipeline_->foundCamera() || told_found_camera_) return;
  told_found_camera_ = true;
  const Eigen::Vector3d position = pipeline_->foundCamera()->translation();
  NODELET_INFO_STREAM(getName() << ": clouds on " << input_.getTopic() << " are images that were moved to frame '"
                                << sensor_header_.frame_id << "': searched from where their rows and columns tell that "
                                << "the camera was, at (" << std::fixed << std::setprecision(3) << position.transpose()
                                << ") m; sensor_frame would say it");
}

void DetectorNodelet::warnIfHopeless() {
  const LatencyGovernor* governor = pipeline_->governor();
  if (!governor || !governor->hopeless() || told_hopeless_) return;
  told_hopeless_ = true;
  NODELET_WARN_STREAM(getName() << ": even with the fewest samples frames take longer than max_latency, "
                                << governor->bound() << " s");
}

namespace {

/// Of what is published there, as the master knows it; empty when nothing is.
std::string typeOf(const std::string& topic) {
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  for (const ros::master::TopicInfo& info : topics) {
    if (info.name == topic) return info.datatype;
  }
  return "";
}

std::string whySilent(const std::string& topic, std::uint32_t publishers) {
  if (publishers > 0) {
    return "of its " + std::to_string(publishers) + (publishers == 1 ? " publisher" : " publishers") +
           " none sent any; one that makes it of a depth image needs camera_info, too";
  }
  const std::string type = typeOf(topic), wanted = ros::message_traits::datatype<sensor_msgs::PointCloud2>();
  if (type.empty() || type == wanted)
    return "nobody publishes it (launch files take input:=TOPIC, or depth:=TOPIC of a depth image)";
  const bool image = type == "sensor_msgs/Image";
  return "it is a " + type + ", not a " + wanted + (image ? " (depth_image.launch takes depth:=TOPIC)" : "");
}

}  // namespace

void DetectorNodelet::warnIfSilent() {
  const bool silent = diagnostics_->silent();
  if (silent && !told_silent_) {
    NODELET_WARN_STREAM(getName() << ": no cloud on " << input_.getTopic() << " for "
                                  << DetectorDiagnostics::kSilenceSeconds << " s; "
                                  << whySilent(input_.getTopic(), input_.getNumPublishers()));
  }
  told_silent_ = silent;
}

void DetectorNodelet::publish(const PrimitiveArray& message) {
  if (primitives_.getNumSubscribers() > 0) primitives_.publish(message);
  if (markers_.getNumSubscribers() > 0) {
    marker_style_.alpha = pipeline_->params().marker_alpha;
    marker_style_.lifetime = pipeline_->params().marker_lifetime;
    markers_.publish(marker_writer_.update(message, marker_style_));
  }
  if (!pipeline_->hasCloud()) return;
  if (with_labels_ && labels_.getNumSubscribers() > 0) labels_.publish(pipeline_->labels(sensor_header_));
  if (normals_.getNumSubscribers() > 0) normals_.publish(pipeline_->normals(sensor_header_));
}

void DetectorNodelet::startAnewIfTimeWentBack(const ros::Time& stamp) {
  // Not (last_stamp_ - stamp): a ros::Duration has 32 bits and throws beyond 68 years.
  const double backwards = last_stamp_.toSec() - stamp.toSec();
  last_stamp_ = stamp;
  if (backwards <= kTimeJumpSeconds) return;
  NODELET_INFO_STREAM(getName() << ": time went back by " << backwards << " s, starting anew");
  tracker_.startAnew();
  marker_writer_.startAnew();
  diagnostics_->startAnew();
  pipeline_->startAnew();
}

std::string DetectorNodelet::toTargetFrame(const std::string& cloud_frame, PrimitiveArray& message) {
  const std::string& wanted = pipeline_->params().target_frame;
  const std::string& target = wanted.empty() ? cloud_frame : wanted;
  const std::string& source = message.header.frame_id;
  Eigen::Isometry3d target_from_source = Eigen::Isometry3d::Identity();
  std::string problem;
  const bool something_to_move = message.status == PrimitiveArray::OK;
  if (something_to_move && frameName(target) != frameName(source)) {
    try {
      target_from_source = late_transforms_->lookup(target, source, message.header.stamp);
    } catch (const std::exception& error) {  // tf2 has its own, ros::Duration another
      const std::string name = wanted.empty() ? "the cloud's frame '" : "target_frame '";
      problem = "no transform from '" + source + "' to " + name + target + "': " + error.what();
      message.primitives.clear();
      message.status = PrimitiveArray::NO_TRANSFORM;
      if (transform_warning_.ready()) NODELET_WARN_STREAM(getName() << ": " << problem);
    }
    transformPrimitives(target_from_source, message);
  }
  message.header.frame_id = message.status == PrimitiveArray::OK ? target : cloud_frame;
  const Eigen::Isometry3d target_from_sensor =
      target_from_source * pipeline_->foundCamera().value_or(Eigen::Isometry3d::Identity());
  marker_style_.viewpoint = target_from_sensor.translation();
  marker_style_.up = target_from_sensor.linear() * -Vec3::UnitY();
  return problem;
}

void DetectorNodelet::onReconfigure(DetectorConfig& config, std::uint32_t level) {
  const Lock lock(mutex_);
  try {
    pipeline_->setParams(fromConfig(config, pipeline_->params()));
    if (late_transforms_) late_transforms_->setPatience(pipeline_->params().transform_patience);
    told_hopeless_ = told_not_from_origin_ = told_found_camera_ = false;
    if (level != ~std::uint32_t{0}) NODELET_INFO_STREAM(getName() << ": parameters changed");
  } catch (const std::exception& error) {
    NODELET_WARN_STREAM(getName() << " keeps its parameters: " << error.what());
    copyToConfig(pipeline_->params(), config);
  }
}

void DetectorNodelet::onDiagnosticsTimer() try {
  const Lock lock(mutex_);
  diagnostics_->publish(static_cast<bool>(input_), pipeline_->times(), pipeline_->governor());
  warnIfSilent();
} catch (const std::exception& error) {
  NODELET_ERROR_STREAM(getName() << " could not publish diagnostics: " << error.what());
}

}  // namespace primitect::ros_layer

PLUGINLIB_EXPORT_CLASS(primitect::ros_layer::DetectorNodelet, nodelet::Nodelet)
