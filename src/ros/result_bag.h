// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A bag of what was found, to be played beside the recording.
#pragma once

#include <primitect/PrimitiveArray.h>
#include <rosbag/bag.h>
#include <visualization_msgs/MarkerArray.h>

#include <memory>
#include <string>

namespace primitect::ros_layer {

class ResultBag {
 public:
  /// Under another name (FILE.part) until finish(). Throws std::runtime_error naming file and cause.
  explicit ResultBag(const std::string& path);
  /// Without finish() nothing is left.
  ~ResultBag();
  ResultBag(const ResultBag&) = delete;
  ResultBag& operator=(const ResultBag&) = delete;

  /// On /detector/primitives and /detector/markers. Throws as the constructor.
  void write(const ros::Time& recorded, const PrimitiveArray& primitives,
             const visualization_msgs::MarkerArray& markers);

  /// Gives the bag its name. Throws as the constructor.
  void finish();

 private:
  /// The destructor of a bag that cannot be closed closes it again, and what that throws ends the program: such a bag
  /// is left as it is.
  struct Deleter {
    void operator()(rosbag::Bag* bag) const;
  };

  void discard();

  std::string path_, unfinished_;
  std::unique_ptr<rosbag::Bag, Deleter> bag_{new rosbag::Bag};
};

}  // namespace primitect::ros_layer
