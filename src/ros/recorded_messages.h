// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Messages as they come out of a bag, or why they do not.
#pragma once

#include <rosbag/message_instance.h>

#include <exception>
#include <stdexcept>
#include <string>

namespace primitect::ros_layer {

/// What is recorded there is no message of its type any more.
struct BagDamage : std::runtime_error {
  explicit BagDamage(const std::exception& error)
      : std::runtime_error(std::string("the bag is damaged there: ") + error.what()) {}
};

/// Throws BagDamage, and std::runtime_error where its fields are others than those of this version.
template <class Message>
boost::shared_ptr<Message const> messageOf(const rosbag::MessageInstance& recorded) {
  boost::shared_ptr<Message const> message;
  try {
    message = recorded.instantiate<Message>();
  } catch (const std::exception& error) {  // of the bag's, of a message whose lengths run beyond it, of no memory
    throw BagDamage(error);
  }
  if (!message) throw std::runtime_error("its " + recorded.getDataType() + " has other fields than that of this ROS");
  return message;
}

}  // namespace primitect::ros_layer
