// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Asks the master; see silence.h.
#include "silence.h"

#include <ros/master.h>
#include <ros/this_node.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace primitect::ros_layer {
namespace {

/// ros::master::getTopics() would wait until there is a master.
bool askMaster(const std::string& method, XmlRpc::XmlRpcValue arguments, XmlRpc::XmlRpcValue& answer) {
  constexpr bool kWait = false;
  XmlRpc::XmlRpcValue response;
  arguments[0] = ros::this_node::getName();
  return ros::master::execute(method, arguments, response, answer, kWait);
}

/// Of what is published there; empty when nothing is. Nothing where there is no master.
std::optional<std::string> typeOf(const std::string& topic) {
  XmlRpc::XmlRpcValue arguments, topics;
  arguments[1] = "";  // below any namespace
  if (!askMaster("getPublishedTopics", arguments, topics)) return std::nullopt;
  for (int k = 0; k < topics.size(); ++k) {
    if (std::string(topics[k][0]) == topic) return std::string(topics[k][1]);
  }
  return "";
}

/// The nodes that publish, or subscribe to, each topic.
using NodesOf = std::map<std::string, std::set<std::string>>;

NodesOf nodesOf(XmlRpc::XmlRpcValue& topics) {
  NodesOf result;
  for (int k = 0; k < topics.size(); ++k) {
    std::set<std::string>& nodes = result[std::string(topics[k][0])];
    for (int n = 0; n < topics[k][1].size(); ++n) nodes.insert(std::string(topics[k][1][n]));
  }
  return result;
}

/// Clouds are made of these. Other topics, as those of the same manager's other nodelets, say nothing.
bool isOfImages(const std::string& type) {
  return type == "sensor_msgs/Image" || type == "sensor_msgs/CompressedImage" || type == "sensor_msgs/CameraInfo";
}

/// Topics of images that somebody publishes or subscribes to.
std::set<std::string> imageTopics() {
  XmlRpc::XmlRpcValue topics;
  std::set<std::string> result;
  if (!askMaster("getTopicTypes", {}, topics)) return result;
  for (int k = 0; k < topics.size(); ++k) {
    if (isOfImages(std::string(topics[k][1]))) result.insert(std::string(topics[k][0]));
  }
  return result;
}

/// What the publishers of the topic wait for in vain: images, and what belongs to them, that they subscribe to and
/// nobody publishes. In the order of their names.
std::vector<std::string> missingInputsOf(const std::string& topic, const NodesOf& publishers,
                                         const NodesOf& subscribers) {
  std::vector<std::string> missing;
  const auto makers = publishers.find(topic);
  if (makers == publishers.end()) return missing;
  const auto isMaker = [&](const std::string& node) { return makers->second.count(node) > 0; };
  const std::set<std::string> images = imageTopics();
  for (const auto& [name, nodes] : subscribers) {
    const bool wanted = images.count(name) > 0 && std::any_of(nodes.begin(), nodes.end(), isMaker);
    if (wanted && publishers.count(name) == 0) missing.push_back(name);
  }
  return missing;
}

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (std::size_t k = 0; k < names.size(); ++k) {
    result += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  }
  return result;
}

std::string whyNoneSent(const std::string& topic) {
  const std::string unknown = "; one that makes it of a depth image needs an image, not a cloud, and camera_info";
  XmlRpc::XmlRpcValue state;
  if (!askMaster("getSystemState", {}, state)) return unknown;
  const NodesOf publishers = nodesOf(state[0]), subscribers = nodesOf(state[1]);
  const std::vector<std::string> missing = missingInputsOf(topic, publishers, subscribers);
  if (missing.empty()) return unknown;
  for (const std::string& name : missing) {
    const std::string packed = name + "/compressedDepth";
    if (publishers.count(packed) > 0) return ": " + name + " is published compressed only (depth:=" + packed + ")";
  }
  return ": it waits for " + joined(missing) + ", which nobody publishes";
}

}  // namespace

std::string whySilent(const std::string& topic, std::uint32_t publishers, bool came_before) {
  if (came_before) return publishers > 0 ? "its publisher sends no more" : "its publisher is gone";
  if (publishers > 0) {
    return "of its " + std::to_string(publishers) + (publishers == 1 ? " publisher" : " publishers") +
           " none sent any" + whyNoneSent(topic);
  }
  const std::optional<std::string> known = typeOf(topic);
  if (!known) return "and the ROS master does not answer";
  const std::string &type = *known, wanted = ros::message_traits::datatype<sensor_msgs::PointCloud2>();
  if (type.empty() || type == wanted)
    return "nobody publishes it (launch files take input:=TOPIC, or depth:=TOPIC of a depth image)";
  const bool image = type == "sensor_msgs/Image";
  return "it is a " + type + ", not a " + wanted + (image ? " (depth_image.launch takes depth:=TOPIC)" : "");
}

}  // namespace primitect::ros_layer
