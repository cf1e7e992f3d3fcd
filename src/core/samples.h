// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points that vote, with their normals: structure of arrays, neighbours in space near each other in memory.
#pragma once

#include <array>
#include <cstdint>

#include "core/frame_memory.h"
#include "core/sample_blocks.h"
#include "kernels/kernels.h"
#include "kernels/loops.h"
#include "primitect/primitives.h"

namespace primitect {

struct Samples {
  List<float> x, y, z, nx, ny, nz;
  /// m, where on a curved surface the normal holds: amid the pixels that it was fitted to, else the point. Fits begin
  /// with normals at their points all the same.
  List<float> px, py, pz;
  List<float> normal_sigma;  ///< rad, noise of the normal about each axis as far as it is known, else 0
  List<float> sigma;         ///< m, noise of the distance to a surface; see NoiseModel
  /// What applyNoise() makes of the noise for the loops; see kernels/loops.h.
  List<float> inverse_tolerance, normal_loss, farthest_turn;
  float gain_reach = 0.0f;
  List<std::uint32_t> index;  ///< of the point in the cloud
  SampleBlocks blocks;        ///< made by applyNoise()
  /// How many are of the first of several draws: later ones leave large planes out. 0: there is only one.
  std::size_t first_draw = 0;

  std::size_t size() const { return x.size(); }
  void clear() {
    for (List<float>* values : fields()) values->clear();
    index.clear();
    blocks.clear();
    first_draw = 0;
  }
  void append(const Samples& more) {
    if (index.empty()) first_draw = more.size();
    const auto add = [](auto& values, const auto& other) { values.insert(values.end(), other.begin(), other.end()); };
    add(x, more.x), add(y, more.y), add(z, more.z);
    add(nx, more.nx), add(ny, more.ny), add(nz, more.nz);
    add(px, more.px), add(py, more.py), add(pz, more.pz);
    add(normal_sigma, more.normal_sigma), add(sigma, more.sigma);
    add(inverse_tolerance, more.inverse_tolerance), add(normal_loss, more.normal_loss);
    add(farthest_turn, more.farthest_turn);
    gain_reach = more.gain_reach;
    blocks.append(more.blocks, index.size());
    add(index, more.index);
  }
  /// Those of these indices, without what applyNoise() makes of them.
  Samples part(const List<std::uint32_t>& indices) const {
    Samples result;
    result.resize(indices.size());
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const std::uint32_t i = indices[k];
      result.x[k] = x[i], result.y[k] = y[i], result.z[k] = z[i];
      result.nx[k] = nx[i], result.ny[k] = ny[i], result.nz[k] = nz[i];
      result.px[k] = px[i], result.py[k] = py[i], result.pz[k] = pz[i];
      result.normal_sigma[k] = normal_sigma[i];
      result.index[k] = index[i];
    }
    return result;
  }
  void resize(std::size_t count) {
    for (List<float>* values : fields()) values->resize(count);
    index.resize(count);
  }
  Vec3 point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vec3 normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
  Vec3 placeOfNormal(std::size_t i) const { return {px[i], py[i], pz[i]}; }
  bool hasNormal(std::size_t i) const { return nx[i] == nx[i]; }
  kernels::Samples view() const { return {x.data(), y.data(), z.data(), nx.data(), ny.data(), nz.data(), x.size()}; }
  /// held: the best gain that other shapes have at each sample.
  kernels::JudgedSamples judged(const List<float>& held) const {
    kernels::JudgedSamples all = judged();
    all.held = held.data();
    return all;
  }
  kernels::JudgedSamples judged() const {
    return {x.data(),
            y.data(),
            z.data(),
            nx.data(),
            ny.data(),
            nz.data(),
            px.data(),
            py.data(),
            pz.data(),
            inverse_tolerance.data(),
            normal_loss.data(),
            farthest_turn.data(),
            nullptr,
            gain_reach};
  }

 private:
  std::array<List<float>*, 14> fields() {
    return {&x,           &y,
            &z,           &nx,
            &ny,          &nz,
            &px,          &py,
            &pz,          &normal_sigma,
            &sigma,       &inverse_tolerance,
            &normal_loss, &farthest_turn};
  }
};

}  // namespace primitect
