// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth images as compressed_depth_image_transport packs them.
#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

namespace primitect::ros_layer {

/// The image that was packed, with its header: 16UC1 or mono16 (mm) as it was, 32FC1 (m) as far as its 16 bits of
/// inverse depth tell, NaN where nothing was measured. Throws std::runtime_error saying what is wrong and what was
/// expected: another format (as of colour images), RVL instead of PNG, broken data, more than 2^24 pixels.
sensor_msgs::ImagePtr unpackedDepth(const sensor_msgs::CompressedImage& packed);

}  // namespace primitect::ros_layer
