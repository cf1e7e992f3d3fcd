// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Peers by name; see peers.h.
#include "eval/peers/peers.h"

#include "eval/peers/cgal.h"
#include "eval/peers/pcl_planes.h"
#include "eval/peers/pcl_sac.h"

namespace primitect::eval {

std::optional<Method> makePeer(const std::string& name) {
  if (name == "pcl-sac") return makePclSac();
  if (name == "pcl-planes") return makePclPlanes();
  return makeCgal(name);
}

std::vector<std::string> peerNames() {
  std::vector<std::string> names = {"pcl-sac", "pcl-planes"};
  if (cgalBuilt()) names.insert(names.begin(), {"cgal", "cgal-3sigma", "cgal-2048"});
  return names;
}

}  // namespace primitect::eval
