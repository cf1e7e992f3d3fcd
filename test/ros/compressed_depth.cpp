// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Packed depths come out as they went in, and what is none of them is told.
#include "ros/compressed_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "test/support/png_files.h"

namespace primitect::ros_layer::compressed_depth_test {
namespace {

/// Two rows: 0 . 1 . 1000 / 65535 . 7 . 300.
const cv::Mat kStored = (cv::Mat_<std::uint16_t>(2, 3) << 0, 1, 1000, 65535, 7, 300);

sensor_msgs::CompressedImage packed(const cv::Mat& stored, const std::string& format, float a = 0.0f, float b = 0.0f) {
  sensor_msgs::CompressedImage packed;
  packed.header.frame_id = "camera";
  packed.format = format;
  const std::array<float, 3> parameters = {0.0f, a, b};
  packed.data.resize(sizeof(parameters));
  std::memcpy(packed.data.data(), parameters.data(), sizeof(parameters));
  const std::vector<std::uint8_t> png = test::encodedPng(stored);
  packed.data.insert(packed.data.end(), png.begin(), png.end());
  return packed;
}

template <class T>
std::vector<T> valuesOf(const sensor_msgs::Image& image) {
  std::vector<T> values(image.data.size() / sizeof(T));
  std::memcpy(values.data(), image.data.data(), image.data.size());
  return values;
}

std::string refusalOf(const sensor_msgs::CompressedImage& packed) {
  try {
    unpackedDepth(packed);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(CompressedDepth, OfMillimetresIsWhatItWas) {
  for (const char* format : {"16UC1; compressedDepth png", "16UC1; compressedDepth"}) {
    const auto image = unpackedDepth(packed(kStored, format));
    EXPECT_EQ(image->header.frame_id, "camera");
    EXPECT_EQ(image->encoding, "16UC1");
    EXPECT_EQ(image->width, 3u);
    EXPECT_EQ(image->height, 2u);
    EXPECT_EQ(image->step, 6u);
    EXPECT_EQ(valuesOf<std::uint16_t>(*image), (std::vector<std::uint16_t>{0, 1, 1000, 65535, 7, 300}));
  }
  const auto mono = unpackedDepth(packed(kStored, "mono16; compressedDepth png"));
  EXPECT_EQ(mono->encoding, "mono16");
  EXPECT_EQ(valuesOf<std::uint16_t>(*mono), (std::vector<std::uint16_t>{0, 1, 1000, 65535, 7, 300}));
}

TEST(CompressedDepth, OfMetresIsWhatSixteenBitsOfInverseDepthTell) {
  // The transport's own choice: depth_quantization 100, depth_max 10 m.
  constexpr float kA = 100.0f * 101.0f, kB = 1.0f - kA / 10.0f;
  const std::array<float, 5> depths = {0.4f, 0.75f, 1.0f, 2.5f, 9.0f};
  cv::Mat stored(1, 6, CV_16UC1);
  stored.at<std::uint16_t>(0) = 0;
  for (int k = 0; k < 5; ++k) {
    stored.at<std::uint16_t>(k + 1) =
        static_cast<std::uint16_t>(std::lround(kA / depths[static_cast<std::size_t>(k)] + kB));
  }
  const auto image = unpackedDepth(packed(stored, "32FC1; compressedDepth png", kA, kB));
  EXPECT_EQ(image->encoding, "32FC1");
  EXPECT_EQ(image->step, 24u);
  const std::vector<float> values = valuesOf<float>(*image);
  ASSERT_EQ(values.size(), 6u);
  EXPECT_TRUE(std::isnan(values[0]));
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(values[k + 1], depths[k], 0.51f * depths[k] * depths[k] / kA)
        << depths[k];  // half a step of the inverse
  }
}

TEST(CompressedDepth, IsNoColourImageNorRvl) {
  EXPECT_NE(refusalOf(packed(kStored, "bgr8; jpeg compressed bgr8")).find("'bgr8; jpeg compressed bgr8'"),
            std::string::npos);
  EXPECT_NE(refusalOf(packed(kStored, "8UC1; compressedDepth png")).find("expected is '16UC1;"), std::string::npos);
  EXPECT_NE(refusalOf(packed(kStored, "16UC1; compressedDepth rvl")).find("not RVL"), std::string::npos);
  EXPECT_NE(refusalOf(packed(kStored, "16UC1; png compressed ")).find("expected is '16UC1;"), std::string::npos);
  EXPECT_NE(refusalOf(packed(kStored, "")).find("format is ''"), std::string::npos);
}

TEST(CompressedDepth, OfMetresNeedsParameters) {
  const std::string format = "32FC1; compressedDepth png";
  for (const float a : {0.0f, -1.0f, std::nanf(""), INFINITY}) {
    EXPECT_NE(refusalOf(packed(kStored, format, a, -10.0f)).find("no parameters"), std::string::npos) << a;
  }
  EXPECT_NE(refusalOf(packed(kStored, format, 1.0f, std::nanf(""))).find("no parameters"), std::string::npos);
  const std::vector<float> values = valuesOf<float>(*unpackedDepth(packed(kStored, format, 100.0f, 7.0f)));
  ASSERT_EQ(values.size(), 6u);
  EXPECT_TRUE(std::isnan(values[1]) && std::isnan(values[4]));  // of 1 and 7
  EXPECT_FLOAT_EQ(values[5], 100.0f / 293.0f);
}

TEST(CompressedDepth, ThatIsBrokenIsTold) {
  const std::string format = "16UC1; compressedDepth png";
  const sensor_msgs::CompressedImage whole = packed(kStored, format);
  sensor_msgs::CompressedImage broken = whole;
  broken.data.resize(11);
  EXPECT_NE(refusalOf(broken).find("no data"), std::string::npos);
  for (const std::size_t size : {12u, 19u}) {
    broken.data.assign(whole.data.begin(), whole.data.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_NE(refusalOf(broken).find("no PNG"), std::string::npos) << size;
  }
  broken = whole;
  broken.data.resize(whole.data.size() - 20);
  EXPECT_NE(refusalOf(broken).find("broken or truncated PNG"), std::string::npos);
  broken = whole;
  broken.data[12] = 0;
  EXPECT_NE(refusalOf(broken).find("no PNG"), std::string::npos);
  broken = whole;
  const std::vector<std::uint8_t> huge = test::claiming(test::encodedPng(kStored), 65536, 257);
  std::copy(huge.begin(), huge.end(), broken.data.begin() + 12);
  EXPECT_NE(refusalOf(broken).find("at most 16777216"), std::string::npos) << refusalOf(broken);
  EXPECT_NE(refusalOf(packed(cv::Mat(2, 3, CV_8UC1, cv::Scalar(1)), format)).find("not one of 16 bits"),
            std::string::npos);
}

}  // namespace
}  // namespace primitect::ros_layer::compressed_depth_test
