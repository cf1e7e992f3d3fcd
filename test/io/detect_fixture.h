// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs the program `detect` on a ball in front of a wall, as a point file or a depth image.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <sstream>

#include "temporary_folder.h"
#include "test/support/json_text.h"

namespace primitect::test {

/// The part of a ball of 0.1 m radius that a camera sees, in front of a wall of 1 x 1 m, with normals.
inline std::string ballPly(double depth, double normal_sign = 1.0) {
  std::ostringstream ply;
  constexpr int kBall = 2000, kRow = 45;
  ply << "ply\nformat ascii 1.0\nelement vertex " << kBall + kRow * kRow << "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) ply << "property float " << name << "\n";
  ply << "end_header\n";
  for (int i = 0; i < kBall; ++i) {
    const double z = -0.2 - 0.8 * (i + 0.5) / kBall, flat = std::sqrt(1.0 - z * z),
                 turn = 2.399963 * i;  // golden angle
    const double x = flat * std::cos(turn), y = flat * std::sin(turn);
    ply << 0.1 * x << " " << 0.1 * y << " " << depth + 0.1 * z << " " << normal_sign * x << " " << normal_sign * y
        << " " << normal_sign * z << "\n";
  }
  for (int i = 0; i < kRow * kRow; ++i) {
    ply << (i % kRow) / 44.0 - 0.5 << " " << (i / kRow) / 44.0 - 0.5 << " " << depth + 0.3 << " 0 0 " << -normal_sign
        << "\n";
  }
  return ply.str();
}

/// A ball of 0.1 m radius, 1.2 m in front of a camera, a wall at 1.7 m, and in the upper half of the image one at 3 m.
inline cv::Mat ballImage() {
  cv::Mat image(240, 320, CV_16UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double a = (u - 159.5) / 262.5, b = (v - 119.5) / 262.5, ray = a * a + b * b + 1.0;
      const double root = 1.2 * 1.2 - ray * (1.2 * 1.2 - 0.1 * 0.1);
      const double wall = v < 120 ? 3.0 : 1.7;
      const double z = root > 0.0 ? (1.2 - std::sqrt(root)) / ray : wall;
      image.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(std::lround(1000.0 * z));
    }
  }
  return image;
}

class DetectProgram : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    ball = write("ball.ply", ballPly(1.0));
    broken = write("broken.pcd", "no cloud");
  }

  int run(const std::string& arguments) {
    const std::string command = std::string(PRIMITECT_TOOLS_DIR) + "/detect " + arguments + " >" + path("stdout") +
                                " 2>" + path("stderr") + " </dev/null";
    const int status = std::system(command.c_str());
    out = read(path("stdout"));
    err = read(path("stderr"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  }

  nlohmann::json runJson(const std::string& arguments) {
    EXPECT_EQ(run(arguments + " --json -"), 0) << err;
    return parsedJson(out);
  }

  long errorLines() const { return std::count(err.begin(), err.end(), '\n'); }

  void expectUsageError(const std::string& arguments, const std::vector<std::string>& says) {
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_EQ(errorLines(), 1) << err;
    EXPECT_EQ(out, "") << arguments;
    for (const std::string& part : says) EXPECT_NE(err.find(part), std::string::npos) << err << " / " << part;
  }

  std::string ball, broken, out, err;
};

}  // namespace primitect::test
