// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Written aside, renamed in the end.
#include "result_bag.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace primitect::ros_layer {
namespace {

/// What rosbag throws names no file.
template <class Work>
void naming(const std::string& path, const Work& work) try {
  work();
} catch (const std::exception& error) {
  throw std::runtime_error(path + ": cannot be written: " + error.what());
}

}  // namespace

void ResultBag::Deleter::operator()(rosbag::Bag* bag) const {
  try {
    bag->close();
  } catch (const std::exception&) {
    return;
  }
  delete bag;
}

ResultBag::ResultBag(const std::string& path) : path_(path), unfinished_(path + ".part") {
  try {
    naming(path_, [this] { bag_->open(unfinished_, rosbag::bagmode::Write); });
  } catch (const std::exception&) {
    if (bag_->isOpen()) discard();
    throw;
  }
}

ResultBag::~ResultBag() {
  if (!unfinished_.empty()) discard();
}

void ResultBag::discard() {
  bag_.reset();
  std::error_code ignored;
  std::filesystem::remove(unfinished_, ignored);
}

void ResultBag::write(const ros::Time& recorded, const PrimitiveArray& primitives,
                      const visualization_msgs::MarkerArray& markers) {
  naming(path_, [&] {
    bag_->write("/detector/primitives", recorded, primitives);
    bag_->write("/detector/markers", recorded, markers);
  });
}

void ResultBag::finish() {
  naming(path_, [this] {
    bag_->close();
    std::filesystem::rename(unfinished_, path_);
  });
  unfinished_.clear();
}

}  // namespace primitect::ros_layer
