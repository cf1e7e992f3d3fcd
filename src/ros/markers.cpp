// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which markers to show and which to delete.
#include "markers.h"

namespace primitect::ros_layer {
namespace {

using visualization_msgs::Marker;

Marker deletion(const std_msgs::Header& header, const std::string& name_space, int id, int action) {
  Marker marker;
  marker.header = header;
  marker.ns = name_space;
  marker.id = id;
  marker.action = action;
  marker.pose.orientation.w = 1.0;
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray MarkerWriter::update(const PrimitiveArray& message, const MarkerStyle& style) {
  visualization_msgs::MarkerArray array;
  if (clear_all_) array.markers.push_back(deletion(message.header, "", 0, Marker::DELETEALL));
  clear_all_ = false;

  std::set<Key> vanished = std::move(shown_);
  shown_.clear();
  for (const Primitive& primitive : message.primitives) {
    for (Marker& marker : primitiveMarkers(message.header, primitive, style)) {
      const Key key(marker.ns, marker.id);
      vanished.erase(key);
      shown_.insert(key);
      array.markers.push_back(std::move(marker));
    }
  }
  for (const Key& key : vanished) {
    array.markers.push_back(deletion(message.header, key.first, key.second, Marker::DELETE));
  }
  return array;
}

void MarkerWriter::startAnew() {
  shown_.clear();
  clear_all_ = true;
}

}  // namespace primitect::ros_layer
