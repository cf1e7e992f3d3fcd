// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Subscribes while someone listens, unpacks, publishes; see unpack_depth_nodelet.h.
#include "unpack_depth_nodelet.h"

#include <exception>
#include <pluginlib/class_list_macros.hpp>

#include "compressed_depth.h"

namespace primitect::ros_layer {
namespace {

using Lock = boost::recursive_mutex::scoped_lock;

}  // namespace

/// The output first: while it lives, somebody who connects makes onConnectionChange() subscribe the input again.
UnpackDepthNodelet::~UnpackDepthNodelet() {
  image_.shutdown();
  packed_.shutdown();
}

void UnpackDepthNodelet::onInit() {
  const Lock lock(mutex_);
  const ros::SubscriberStatusCallback changed = [this](const ros::SingleSubscriberPublisher&) { onConnectionChange(); };
  image_ = getPrivateNodeHandle().advertise<sensor_msgs::Image>("image", 1, changed, changed);
}

void UnpackDepthNodelet::onConnectionChange() try {
  const Lock lock(mutex_);
  if (image_.getNumSubscribers() == 0) {
    packed_.shutdown();
  } else if (!packed_) {
    packed_ = getPrivateNodeHandle().subscribe("packed", 1, &UnpackDepthNodelet::onPacked, this,
                                               ros::TransportHints().tcpNoDelay());
  }
} catch (const std::exception& error) {
  NODELET_ERROR_STREAM(getName() << " could not change its subscription: " << error.what());
}

void UnpackDepthNodelet::onPacked(const sensor_msgs::CompressedImageConstPtr& packed) {
  const Lock lock(mutex_);
  try {
    image_.publish(unpackedDepth(*packed));
  } catch (const std::exception& error) {
    if (!warning_.ready()) return;
    NODELET_WARN_STREAM(getName() << " refuses an image on " << packed_.getTopic() << ": " << error.what());
  }
}

}  // namespace primitect::ros_layer

PLUGINLIB_EXPORT_CLASS(primitect::ros_layer::UnpackDepthNodelet, nodelet::Nodelet)
