// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Other people's detectors, each run as its users run it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/methods.h"

namespace primitect::eval {

/// The peer with this name, or nothing if there is none:
/// "cgal"                 CGAL Efficient RANSAC on all points, default adaptive parameters; "cgal-2048" on 2048 of them
///                        (any count); with a kind behind it ("cgal:spheres", "cgal-2048:cones") only that kind
/// "cgal-3sigma"          the same on all points, but epsilon, a point's distance to its shape, is three times the
///                        noise that the cloud was made with (depth frames: 10 mm) instead of 1 % of the diagonal
/// "pcl-sac"              PCL SACSegmentationFromNormals in a loop: plane, sphere, cylinder, cone
/// "pcl-planes"           PCL OrganizedMultiPlaneSegmentation, organized clouds only
/// All get the same normals, see peer_cloud.h; converting the cloud to what a library wants is in nobody's time.
/// Throws std::runtime_error when the peer was not built.
std::optional<Method> makePeer(const std::string& name);

/// Names of makePeer() without the kinds, those that were built only.
std::vector<std::string> peerNames();

}  // namespace primitect::eval
