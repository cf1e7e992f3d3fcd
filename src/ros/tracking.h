// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tracks of the primitives of a message.
#pragma once

#include <primitect/PrimitiveArray.h>

#include <string>
#include <vector>

#include "primitect/tracker.h"

namespace primitect::ros_layer {

/// Of one message after the other; keeps its memory.
class PrimitiveTracker {
 public:
  /// Fills track_id and age, by the stamp of the message and in its frame, and turns cylinders and planes as they were
  /// before in their track. Also for empty messages: time goes on. Tracks end where the frame is another one.
  /// patience (s): see Tracker.
  void update(double patience, PrimitiveArray& message);

  void startAnew() { tracker_.startAnew(); }

 private:
  void forgetAnotherFrame(const PrimitiveArray& message);
  void turn(const std::vector<Track>& tracks, PrimitiveArray& message);

  Tracker tracker_;
  std::vector<Sighting> sightings_;
  std::string frame_;            ///< of the last message with primitives
  std::vector<Extent> extents_;  ///< of its primitives, and of more in messages before: their memory serves
};

}  // namespace primitect::ros_layer
