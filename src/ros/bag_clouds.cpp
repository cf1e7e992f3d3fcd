// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Topics are chosen by their types; a depth image takes the last camera_info before it, or else the first one.
#include "bag_clouds.h"

#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <map>
#include <stdexcept>

#include "depth_clouds.h"

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
  throw std::runtime_error(path + ": cannot be read as a bag: " + error.what());
}

std::string listText(const Types& types) {
  std::string text;
  for (const auto& [topic, type] : types) text += (text.empty() ? "" : ", ") + topic + " (" + type + ")";
  return text.empty() ? "nothing" : text;
}

/// The only topic of that type; empty: there is none, or more than one.
std::string onlyOne(const Types& types, const std::string& wanted) {
  std::string found;
  for (const auto& [topic, type] : types) {
    if (type != wanted) continue;
    if (!found.empty()) return "";
    found = topic;
  }
  return found;
}

/// "/camera/depth/image_raw" -> "/camera/depth/camera_info", as image_transport has it.
std::string cameraInfoBeside(const std::string& image) { return image.substr(0, image.rfind('/') + 1) + "camera_info"; }

template <class Message>
boost::shared_ptr<Message const> messageOf(const rosbag::MessageInstance& recorded) {
  return recorded.instantiate<Message>();
}

}  // namespace

BagClouds::BagClouds(const BagJob& job) {
  for (const std::string& path : job.bags) bags_.push_back(opened(path));
  chooseTopic(job);
  rosbag::View all;
  for (const auto& bag : bags_) all.addQuery(*bag);
  begin_ = all.getBeginTime() + ros::Duration(job.start);
  if (job.duration > 0.0) end_ = begin_ + ros::Duration(job.duration);
  rosbag::View wanted;
  add({topic_}, wanted);
  if (wanted.size() > 0) return;
  throw std::runtime_error("no cloud on " + topic_ + " in the time that is asked for; the recording lasts " +
                           valueText((all.getEndTime() - all.getBeginTime()).toSec()) + " s");
}

void BagClouds::chooseTopic(const BagJob& job) {
  rosbag::View all;
  for (const auto& bag : bags_) all.addQuery(*bag);
  Types types;
  for (const rosbag::ConnectionInfo* info : all.getConnections()) types[info->topic] = info->datatype;
  const std::string cloud = typeName<sensor_msgs::PointCloud2>(), image = typeName<sensor_msgs::Image>();
  topic_ = job.topic;
  if (topic_.empty()) topic_ = onlyOne(types, cloud);
  if (topic_.empty()) topic_ = onlyOne(types, image);
  if (topic_.empty())
    throw std::runtime_error("which topic? --topic takes a cloud or depth image; there is: " + listText(types));
  const std::string type = types.count(topic_) > 0 ? types[topic_] : "";
  if (type == cloud) return;
  if (type.empty()) throw std::runtime_error("there is no topic " + topic_ + ", but: " + listText(types));
  if (type != image) throw std::runtime_error(topic_ + " is a " + type + ", expected is a " + cloud + " or " + image);
  camera_info_ = job.camera_info.empty() ? cameraInfoBeside(topic_) : job.camera_info;
  if (types.count(camera_info_) > 0 && types[camera_info_] == typeName<sensor_msgs::CameraInfo>()) return;
  throw std::runtime_error("the depth image " + topic_ + " needs a camera_info, and " + camera_info_ +
                           " is none; there is: " + listText(types));
}

void BagClouds::add(const std::vector<std::string>& topics, rosbag::View& view) const {
  for (const auto& bag : bags_) view.addQuery(*bag, rosbag::TopicQuery(topics), begin_, end_);
}

void BagClouds::forEach(const std::function<void(const RecordedCloud&)>& use) const try {
  sensor_msgs::CameraInfoConstPtr camera;
  if (ofDepthImages()) {
    rosbag::View cameras;
    for (const auto& bag : bags_) cameras.addQuery(*bag, rosbag::TopicQuery(camera_info_));
    if (cameras.size() > 0) camera = messageOf<sensor_msgs::CameraInfo>(*cameras.begin());
  }
  rosbag::View view;
  add(ofDepthImages() ? std::vector<std::string>{topic_, camera_info_} : std::vector<std::string>{topic_}, view);
  for (const rosbag::MessageInstance& recorded : view) {
    if (recorded.getTopic() != topic_) {
      camera = messageOf<sensor_msgs::CameraInfo>(recorded);
      continue;
    }
    RecordedCloud cloud;
    cloud.recorded = recorded.getTime();
    try {
      if (ofDepthImages()) {
        const auto image = messageOf<sensor_msgs::Image>(recorded);
        cloud.header = image->header;
        cloud.cloud = cloudOf(image, *camera);
      } else {
        cloud.cloud = messageOf<sensor_msgs::PointCloud2>(recorded);
        cloud.header = cloud.cloud->header;
      }
    } catch (const std::exception& error) {
      cloud.problem = error.what();
    }
    use(cloud);
  }
} catch (const rosbag::BagException& error) {
  throw std::runtime_error(std::string("the recording cannot be read on: ") + error.what());
}

}  // namespace primitect::ros_layer
