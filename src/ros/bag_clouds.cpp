// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Topics are chosen by their types; depth images become clouds.
#include "bag_clouds.h"

#include <rosbag/view.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string_view>

#include "compressed_depth.h"
#include "depth_clouds.h"
#include "recorded_messages.h"

namespace primitect::ros_layer {
namespace {

using Types = std::map<std::string, std::string>;  ///< topic -> type

template <class Message>
std::string typeName() {
  return ros::message_traits::datatype<Message>();
}

std::unique_ptr<rosbag::Bag> opened(const std::string& path) try {
  return std::make_unique<rosbag::Bag>(path, rosbag::bagmode::Read);
} catch (const rosbag::BagUnindexedException&) {
  throw std::runtime_error(path + ": it has no index, as it was not closed: rosbag reindex makes one");
} catch (const std::exception& error) {
  throw std::runtime_error(path + ": cannot be read as a bag: " + error.what() +
                           " (of one that is cut off rosbag reindex saves the rest)");
}

std::string listText(const Types& types) {
  std::string text;
  for (const auto& [topic, type] : types) text += (text.empty() ? "" : ", ") + topic + " (" + type + ")";
  return text.empty() ? "nothing" : text;
}

bool isImage(const std::string& type) {
  return type == typeName<sensor_msgs::Image>() || type == typeName<sensor_msgs::CompressedImage>();
}

/// Of "/camera/depth/image_raw/compressedDepth" what is before the last part; else the topic itself.
std::string rawImageOf(const std::string& topic) {
  constexpr std::string_view kEnd = "/compressedDepth";
  const bool packed = topic.size() >= kEnd.size() && topic.compare(topic.size() - kEnd.size(), kEnd.size(), kEnd) == 0;
  return packed ? topic.substr(0, topic.size() - kEnd.size()) : topic;
}

/// Of compressed images those whose name says that they are depths, where the raw one was not recorded, too; of raw
/// ones any: colour images have the same type.
bool mayBeDepth(const Types& types, const std::string& topic) {
  const std::string raw = rawImageOf(topic), image = typeName<sensor_msgs::Image>();
  if (types.at(topic) == image) return true;
  const bool recorded_raw = types.count(raw) > 0 && types.at(raw) == image;
  return types.at(topic) == typeName<sensor_msgs::CompressedImage>() && raw != topic && !recorded_raw;
}

template <class Wanted>
Types those(const Types& types, const Wanted& wanted) {
  Types found;
  for (const auto& [topic, type] : types) {
    if (wanted(topic)) found[topic] = type;
  }
  return found;
}

/// "/camera/depth/image_raw" -> "/camera/depth/camera_info", as image_transport has it; that of a compressed image is
/// the raw one's.
std::string cameraInfoBeside(const std::string& image) {
  const std::string raw = rawImageOf(image);
  return (raw.empty() ? "/" : raw.substr(0, raw.rfind('/') + 1)) + "camera_info";
}

/// Which of the topics it is, with or without a slash in front: programs that are no nodes record names without.
std::string recordedName(const Types& types, const std::string& topic) {
  if (types.count(topic) > 0 || topic.empty()) return topic;
  const std::string other = topic.front() == '/' ? topic.substr(1) : "/" + topic;
  return types.count(other) > 0 ? other : topic;
}

/// Whatever it was packed in. The header is told before anything else is wrong.
sensor_msgs::ImageConstPtr imageOf(const rosbag::MessageInstance& recorded, std::optional<std_msgs::Header>& header) {
  if (!recorded.isType<sensor_msgs::CompressedImage>()) {
    const auto image = messageOf<sensor_msgs::Image>(recorded);
    header = image->header;
    return image;
  }
  const auto packed = messageOf<sensor_msgs::CompressedImage>(recorded);
  header = packed->header;
  return unpackedDepth(*packed);
}

}  // namespace

BagClouds::BagClouds(const BagJob& job) {
  for (const std::string& path : job.bags) {
    if (!std::filesystem::exists(path)) throw std::runtime_error(path + ": no such file");
    if (std::filesystem::is_directory(path)) throw std::runtime_error(path + ": is a folder, expected is a bag");
    bags_.push_back(opened(path));
  }
  rosbag::View all;
  for (const auto& bag : bags_) all.addQuery(*bag);
  chooseTopic(job, all.getConnections());
  if (!camera_info_.empty()) cameras_.emplace(bags_, camera_info_);
  begin_ = all.getBeginTime() + ros::Duration(job.start);
  if (job.duration > 0.0) end_ = begin_ + ros::Duration(job.duration);
  rosbag::View wanted;
  for (const auto& bag : bags_) wanted.addQuery(*bag, rosbag::TopicQuery(topic_), begin_, end_);
  if (wanted.size() > 0) return;
  throw std::runtime_error("no cloud on " + topic_ + " in the time that is asked for; the recording lasts " +
                           valueText((all.getEndTime() - all.getBeginTime()).toSec()) + " s");
}

void BagClouds::chooseTopic(const BagJob& job, const std::vector<const rosbag::ConnectionInfo*>& connections) {
  Types types;
  for (const rosbag::ConnectionInfo* info : connections) types[info->topic] = info->datatype;
  const std::string cloud = typeName<sensor_msgs::PointCloud2>(), image = typeName<sensor_msgs::Image>();
  topic_ = job.topic;
  if (topic_.empty()) {
    Types topics = those(types, [&](const std::string& topic) { return types[topic] == cloud; });
    const Types images = those(types, [&](const std::string& topic) { return mayBeDepth(types, topic); });
    if (topics.empty()) topics = images;
    if (topics.size() != 1) {
      topics.insert(images.begin(), images.end());
      throw std::runtime_error("which topic? --topic takes a cloud or depth image; there is: " +
                               listText(topics.empty() ? types : topics));
    }
    topic_ = topics.begin()->first;
  }
  topic_ = recordedName(types, topic_);
  const std::string type = types.count(topic_) > 0 ? types[topic_] : "";
  if (type.empty()) throw std::runtime_error("there is no topic " + topic_ + ", but: " + listText(types));
  if (type == cloud && !job.camera_info.empty()) {
    throw std::runtime_error("--camera-info is of depth images, and " + topic_ + " is a " + type);
  }
  if (type == cloud) return;
  if (!isImage(type)) {
    throw std::runtime_error(topic_ + " is a " + type + ", expected is a " + cloud + ", " + image + " or " +
                             typeName<sensor_msgs::CompressedImage>());
  }
  camera_info_ = recordedName(types, job.camera_info.empty() ? cameraInfoBeside(topic_) : job.camera_info);
  if (types.count(camera_info_) > 0 && types[camera_info_] == typeName<sensor_msgs::CameraInfo>()) return;
  throw std::runtime_error("the depth image " + topic_ + " needs a camera_info, and " + camera_info_ +
                           " is none; there is: " + listText(types));
}

void BagClouds::read(const rosbag::MessageInstance& recorded, RecordedCloud& cloud) const {
  if (!cameras_) {
    cloud.cloud = messageOf<sensor_msgs::PointCloud2>(recorded);
    cloud.header = cloud.cloud->header;
    return;
  }
  const auto image = imageOf(recorded, cloud.header);
  const RecordedCameras::Camera camera = cameras_->of(image->header.stamp, recorded.getTime());
  cloud.camera_of_other_stamp = !camera.of_stamp;
  cloud.cloud = cloudOf(image, *camera.info);
}

void BagClouds::forEach(const std::function<void(const RecordedCloud&)>& use) const {
  rosbag::View view;
  for (const auto& bag : bags_) view.addQuery(*bag, rosbag::TopicQuery(topic_), begin_, end_);
  for (const rosbag::MessageInstance& recorded : view) {
    RecordedCloud cloud;
    cloud.recorded = recorded.getTime();
    try {
      read(recorded, cloud);
    } catch (const BagDamage& damage) {
      cloud.damaged = true;
      cloud.problem = damage.what();
    } catch (const std::exception& error) {
      cloud.problem = error.what();
    }
    use(cloud);
  }
}

}  // namespace primitect::ros_layer
