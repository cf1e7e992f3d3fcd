// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How the answer of a peer comes about: timed runs, or the reason why there is none.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <exception>
#include <limits>
#include <string>

#include "eval/methods.h"

namespace primitect::eval {

inline Answer failureOf(const std::string& reason) {
  Answer answer;
  answer.failure = reason;
  return answer;
}

/// Processor time of this process, ms.
inline double cpuMsSince(std::clock_t start) {
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Runs find(), which returns shapes, `repeat` times; the shortest time counts. What it throws becomes the failure.
template <class Find>
Answer timedAnswer(int repeat, const Find& find) {
  Answer answer;
  answer.total_ms = answer.cpu_ms = std::numeric_limits<double>::infinity();
  try {
    for (int run = 0; run < repeat; ++run) {
      const std::clock_t cpu_start = std::clock();
      const auto start = std::chrono::steady_clock::now();
      answer.shapes = find();
      const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
      answer.total_ms = std::min(answer.total_ms, spent.count());
      answer.cpu_ms = std::min(answer.cpu_ms, cpuMsSince(cpu_start));
    }
  } catch (const std::exception& error) {
    return failureOf(error.what());
  }
  return answer;
}

}  // namespace primitect::eval
