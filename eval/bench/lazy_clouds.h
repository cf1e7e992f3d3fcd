// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Clouds that are made when they are first asked for, and shared by all cases that work on them.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "primitect/cloud.h"

namespace primitect::bench {

class LazyClouds {
 public:
  explicit LazyClouds(std::function<std::vector<Cloud>()> make) : make_(std::move(make)) {}

  const std::vector<Cloud>& get() {
    if (clouds_.empty()) clouds_ = make_();
    return clouds_;
  }

 private:
  std::function<std::vector<Cloud>()> make_;
  std::vector<Cloud> clouds_;
};

using SharedClouds = std::shared_ptr<LazyClouds>;

inline SharedClouds lazily(std::function<std::vector<Cloud>()> make) {
  return std::make_shared<LazyClouds>(std::move(make));
}

}  // namespace primitect::bench
