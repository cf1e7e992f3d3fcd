// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Starts, subscribes while someone listens, processes, publishes what is listened to.
#include "detector_nodelet.h"

#include <tf2/exceptions.h>

#include <boost/make_shared.hpp>
#include <iomanip>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <utility>

#include "messages.h"
#include "primitect/kernel_choice.h"
#include "primitect/moved_image.h"
#include "silence.h"

namespace primitect::ros_layer {
namespace {

using Lock = boost::recursive_mutex::scoped_lock;

const char* clueText(CameraClue clue) {
  switch (clue) {
    case CameraClue::image:
      return "their rows and columns tell";
    case CameraClue::order:
      return "their order tells";
    case CameraClue::shadows:
      return "the shadows of things on a plane tell, to some centimetres,";
  }
  return "";
}

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
  diagnostics_ = std::make_unique<DetectorDiagnostics>(getNodeHandle(), private_handle, getName());
  if (!loaded.params.sensor_frame.empty() || !loaded.params.target_frame.empty()) {
    transforms_ = std::make_unique<TransformInbox>(getNodeHandle(), loaded.params.transform_patience);
    transform_timer_ = getNodeHandle().createWallTimer(ros::WallDuration(TransformInbox::kTakeSeconds),
                                                       [this](const ros::WallTimerEvent&) { transforms_->take(); });
  }
  sequence_ = std::make_unique<CloudSequence>(
      loaded.params, [this](const std::string& target, const std::string& source, const ros::Time& stamp) {
        return lookup(target, source, stamp);
      });
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
  transform_timer_.stop();
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
  warnIfIncomplete(cloud.header);
  startAnewIfTimeWentBack(cloud.header.stamp);
  diagnostics_->frameReceived(cloud.header.stamp);
  with_labels_ = labels_.getNumSubscribers() > 0;
  const PrimitiveArray& message = sequence_->process(cloud, with_labels_);
  tellProblems(message.status);
  const std::string& refused = sequence_->problem();
  const FramePipeline& done = pipeline();
  FrameView view = {done.seenFromOrigin(), done.normalsFaceAway(), done.imageNoise(), done.depthWaves(), std::nullopt};
  view.found_camera = done.foundCamera();
  diagnostics_->frameDone(message, done.refusals(), view, refused.empty() ? sequence_->frameProblem() : refused);
  if (primitives_.getNumSubscribers() > 0) primitives_.publish(message);
  pipeline().published();
  publishPictures(message);
  pipeline().times().recordAfter("publish");
  warnIfHopeless();
  warnIfNotSeenFromOrigin();
  warnIfOriginIsAssumed();
  tellFoundCamera();
}

void DetectorNodelet::tellProblems(std::uint8_t status) {
  const std::string& refused = sequence_->problem();
  const std::string& lost = sequence_->frameProblem();
  const bool no_transform = status == PrimitiveArray::NO_TRANSFORM;
  if (!refused.empty() && input_warning_.ready()) {
    NODELET_WARN_STREAM(getName() << " refuses a cloud on " << input_.getTopic() << ": " << refused);
    told_no_transform_ |= no_transform;
  }
  if (!lost.empty() && transform_warning_.ready()) {
    NODELET_WARN_STREAM(getName() << ": " << lost);
    told_no_transform_ |= no_transform;
  }
  if (told_no_transform_ && status == PrimitiveArray::OK) {
    told_no_transform_ = false;
    NODELET_INFO_STREAM(getName() << ": the transform that was missing is there");
  }
}

Eigen::Isometry3d DetectorNodelet::lookup(const std::string& target, const std::string& source,
                                          const ros::Time& stamp) try {
  return transforms_->lookup(target, source, stamp);
} catch (const tf2::ExtrapolationException& error) {
  throw std::runtime_error(error.what() +
                           (" (a cloud waits transform_patience, " + valueText(pipeline().params().transform_patience) +
                            " s, for transforms that come later than it)"));
} catch (const tf2::TransformException& error) {
  throw std::runtime_error(std::string(error.what()) +
                           " (rosrun tf2_tools view_frames.py draws the frames that there are)");
}

void DetectorNodelet::warnIfOriginIsAssumed() {
  if (told_assumed_origin_ || !sequence_->originIsAssumed()) return;
  told_assumed_origin_ = true;
  NODELET_WARN_STREAM(getName() << ": clouds on " << input_.getTopic()
                                << " are lists without rows and columns in frame '"
                                << sequence_->sensorHeader().frame_id
                                << "', and are taken for seen from its origin along its z axis; if the camera was "
                                << "elsewhere, set sensor_frame to its optical frame");
}

void DetectorNodelet::warnIfNotSeenFromOrigin() {
  if (pipeline().seenFromOrigin() != false || told_not_from_origin_) return;
  told_not_from_origin_ = true;
  const std::string& sensor = pipeline().params().sensor_frame;
  const std::string advice = sensor.empty() ? "set sensor_frame to the camera's optical frame, or shapes are missed"
                                            : "is sensor_frame the camera's optical frame, and the transform right?";
  NODELET_WARN_STREAM(getName() << ": clouds on " << input_.getTopic() << " are not seen from the origin of frame '"
                                << sequence_->sensorHeader().frame_id << "' along z: " << advice);
}

void DetectorNodelet::tellFoundCamera() {
  if (!pipeline().foundCamera() || told_found_camera_) return;
  told_found_camera_ = true;
  const Eigen::Isometry3d& camera = *pipeline().foundCamera();
  const std::string& frame = sequence_->sensorHeader().frame_id;
  constexpr double kTurned = 0.3;  // rad: more than from one optical frame of a camera to another of its own
  const CameraClue clue = pipeline().cameraClue();
  const bool of_list = clue != CameraClue::image;
  if (frame.find("optical") != std::string::npos && turnOf(camera, of_list) > kTurned) {
    NODELET_WARN_STREAM(getName() << ": clouds on " << input_.getTopic() << " are said to be in '" << frame
                                  << "', but their axes are not those of an optical frame (z ahead, x right, y down): "
                                  << "what tf makes of them, as in target_frame, is turned");
  }
  const Eigen::Vector3d position = camera.translation();
  const Eigen::Quaterniond orientation(camera.linear());
  NODELET_INFO_STREAM(getName() << ": clouds on " << input_.getTopic() << " are "
                                << (of_list ? "lists of the points of images" : "images")
                                << " that were moved to frame '" << frame << "': searched from where " << clueText(clue)
                                << " that the camera was, at (" << std::fixed << std::setprecision(3)
                                << position.transpose() << ") m, x y z w (" << orientation.coeffs().transpose()
                                << "); sensor_frame would say it");
}

void DetectorNodelet::warnIfIncomplete(const std_msgs::Header& header) {
  if (told_incomplete_ || !(header.frame_id.empty() || header.stamp.isZero())) return;
  told_incomplete_ = true;
  NODELET_WARN_STREAM(getName() << ": clouds on " << input_.getTopic() << " have no "
                                << (header.frame_id.empty()
                                        ? "frame_id: neither RViz nor tf can tell where they are"
                                        : "stamp: neither tf nor tracks can tell when they are from"));
}

void DetectorNodelet::warnIfHopeless() {
  const LatencyGovernor* governor = pipeline().governor();
  if (!governor || !governor->hopeless() || told_hopeless_) return;
  told_hopeless_ = true;
  NODELET_WARN_STREAM(getName() << ": even with the fewest samples frames take longer than max_latency, "
                                << governor->bound() << " s");
}

void DetectorNodelet::warnIfSilent() {
  if (!diagnostics_->silent()) {
    silence_.clear();
    return;
  }
  if (!silence_check_.ready()) return;  // the master is asked
  const std::string why = whySilent(input_.getTopic(), input_.getNumPublishers(), diagnostics_->anyFrame());
  if (why == silence_) return;
  silence_ = why;
  NODELET_WARN_STREAM(getName() << ": no cloud on " << input_.getTopic() << " for "
                                << DetectorDiagnostics::kSilenceSeconds << " s; " << why);
}

/// What is there to be looked at. After the time that max_latency bounds: fewer samples would not make it quicker.
void DetectorNodelet::publishPictures(const PrimitiveArray& message) {
  if (markers_.getNumSubscribers() > 0) {
    markers_.publish(marker_writer_.update(message, sequence_->markerStyle()));
  }
  if (!pipeline().hasCloud()) return;
  // Nodelets of the same manager get these clouds as they are, without a copy.
  const auto shared = [](sensor_msgs::PointCloud2 made) {
    return boost::make_shared<sensor_msgs::PointCloud2>(std::move(made));
  };
  const std_msgs::Header& header = sequence_->sensorHeader();
  if (with_labels_ && labels_.getNumSubscribers() > 0) labels_.publish(shared(pipeline().labels(header)));
  if (normals_.getNumSubscribers() > 0) normals_.publish(shared(pipeline().normals(header)));
}

void DetectorNodelet::startAnewIfTimeWentBack(const ros::Time& stamp) {
  const std::optional<double> backwards = sequence_->begin(stamp);
  if (!backwards) return;
  marker_writer_.startAnew();
  if (!diagnostics_->timeWentBack(stamp)) {
    NODELET_INFO_STREAM(getName() << ": time went back by " << *backwards << " s, starting anew");
  } else if (jump_warning_.ready()) {
    NODELET_WARN_STREAM(getName() << ": stamps on " << input_.getTopic() << " go back again and again (now by "
                                  << *backwards
                                  << " s), and tracks begin anew each time: do two sources publish there?");
  }
}

void DetectorNodelet::onReconfigure(DetectorConfig& config, std::uint32_t level) {
  const Lock lock(mutex_);
  try {
    const Params before = pipeline().params();
    pipeline().setParams(fromConfig(config, before));
    if (transforms_) transforms_->setPatience(pipeline().params().transform_patience);
    told_hopeless_ = told_not_from_origin_ = told_assumed_origin_ = told_found_camera_ = false;
    if (level != ~std::uint32_t{0}) {
      NODELET_INFO_STREAM(getName() << ": parameters changed: " << differenceText(pipeline().params(), before));
    }
  } catch (const std::exception& error) {
    NODELET_WARN_STREAM(getName() << " keeps its parameters: " << error.what());
    copyToConfig(pipeline().params(), config);
  }
}

void DetectorNodelet::onDiagnosticsTimer() try {
  const Lock lock(mutex_);
  diagnostics_->publish(static_cast<bool>(input_), pipeline().times(), pipeline().governor());
  warnIfSilent();
} catch (const std::exception& error) {
  NODELET_ERROR_STREAM(getName() << " could not publish diagnostics: " << error.what());
}

}  // namespace primitect::ros_layer

PLUGINLIB_EXPORT_CLASS(primitect::ros_layer::DetectorNodelet, nodelet::Nodelet)
