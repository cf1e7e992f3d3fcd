// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The marker array of a frame: everything that is there, and an explicit DELETE for what vanished.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "marker_shapes.h"

namespace primitect::ros_layer {

/// Remembers which markers it has shown, so that it can take back those that are gone.
class MarkerWriter {
 public:
  /// The markers of this message, preceded by one DELETEALL after construction or startAnew().
  visualization_msgs::MarkerArray update(const PrimitiveArray& message, const MarkerStyle& style);

  /// Forgets what was shown: the next array begins with DELETEALL.
  void startAnew();

 private:
  using Key = std::pair<std::string, int>;  ///< namespace and id

  std::set<Key> shown_;
  bool clear_all_ = true;
};

}  // namespace primitect::ros_layer
