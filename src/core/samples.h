// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points that vote, with their normals: structure of arrays, neighbours in space near each other in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/kernels.h"
#include "primitect/primitives.h"

namespace primitect {

struct Samples {
  std::vector<float> x, y, z, nx, ny, nz;
  std::vector<float> normal_sigma;   ///< rad, noise of the normal about each axis as far as it is known, else 0
  std::vector<float> sigma;          ///< m, noise of the distance to a surface; see NoiseModel
  std::vector<float> normal_limit;   ///< rad, a normal this far from a surface's is hardly noise; see NoiseModel
  std::vector<std::uint32_t> index;  ///< of the point in the cloud

  std::size_t size() const { return x.size(); }
  void clear() {
    for (std::vector<float>* values : {&x, &y, &z, &nx, &ny, &nz, &normal_sigma, &sigma, &normal_limit})
      values->clear();
    index.clear();
  }
  void append(const Samples& more) {
    const auto add = [](auto& values, const auto& other) { values.insert(values.end(), other.begin(), other.end()); };
    add(x, more.x), add(y, more.y), add(z, more.z);
    add(nx, more.nx), add(ny, more.ny), add(nz, more.nz);
    add(normal_sigma, more.normal_sigma), add(sigma, more.sigma), add(normal_limit, more.normal_limit);
    add(index, more.index);
  }
  void resize(std::size_t count) {
    for (std::vector<float>* values : {&x, &y, &z, &nx, &ny, &nz, &normal_sigma, &sigma, &normal_limit})
      values->resize(count);
    index.resize(count);
  }
  Vec3 point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vec3 normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
  bool hasNormal(std::size_t i) const { return nx[i] == nx[i]; }
  kernels::Samples view() const { return {x.data(), y.data(), z.data(), nx.data(), ny.data(), nz.data(), x.size()}; }
};

}  // namespace primitect
