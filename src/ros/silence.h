// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Why no cloud comes.
#pragma once

#include <cstdint>
#include <string>

namespace primitect::ros_layer {

/// In words for the log, as far as this node's connections and the master tell: a topic that nobody publishes or of
/// another type, a publisher that has fallen silent, or one that itself waits for a topic that nobody publishes, as the
/// nodelet that makes clouds of depth images does; of a manager's nodelets the master does not know which subscribes.
/// publishers: of the topic, connected to this node; came_before: there were clouds. Does not wait for a master.
std::string whySilent(const std::string& topic, std::uint32_t publishers, bool came_before);

}  // namespace primitect::ros_layer
