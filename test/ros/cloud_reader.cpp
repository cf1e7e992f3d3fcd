// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Every layout that a PointCloud2 may have, and every lie that it may tell.
#include "ros/cloud_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "cloud_messages.h"
#include "core/thinned_image.h"

namespace primitect::cloud_reader_test {
namespace {

using ros_layer::readCloud;
using ros_layer::Wanted;
using test::makeField;
using test::plainCloud;
using test::put;

const DepthRange kAnyDepth;
constexpr Wanted kEverything = {true, true}, kPositions = {false, true};

void expectGrid(const Cloud& cloud, std::uint32_t width, std::uint32_t height) {
  ASSERT_EQ(cloud.width, width);
  ASSERT_EQ(cloud.height, height);
  ASSERT_EQ(cloud.size(), std::size_t{width} * height);
  EXPECT_EQ(cloud.valid_count, width * height);
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const std::size_t i = row * width + column;
      EXPECT_FLOAT_EQ(cloud.x[i], 0.1f * column);
      EXPECT_FLOAT_EQ(cloud.y[i], 0.1f * row);
      EXPECT_FLOAT_EQ(cloud.z[i], 0.1f * (1 + column + row));
    }
  }
}

/// The reader must refuse the message, say all of this, and leave an empty cloud.
void expectRefused(const sensor_msgs::PointCloud2& message, const std::vector<std::string>& said,
                   bool with_normals = true) {
  Cloud cloud;
  ASSERT_EQ(readCloud(plainCloud(), kAnyDepth, kEverything, cloud), "");
  const std::string error = readCloud(message, kAnyDepth, {with_normals, true}, cloud);
  for (const std::string& text : said)
    EXPECT_NE(error.find(text), std::string::npos) << "'" << text << "' in: " << error;
  EXPECT_NE(error.find("expected"), std::string::npos) << error;
  EXPECT_EQ(cloud.size(), 0u);
  EXPECT_EQ(cloud.valid_count, 0u);
}

TEST(CloudReader, ReadsAnOrganizedCloud) {
  Cloud cloud;
  EXPECT_EQ(readCloud(plainCloud(4, 3), kAnyDepth, kEverything, cloud), "");
  expectGrid(cloud, 4, 3);
  EXPECT_TRUE(cloud.organized());
  EXPECT_FALSE(cloud.hasNormals());
}

TEST(CloudReader, TakesAConstantThatWasFilledInForMissing) {
  const std::uint32_t width = 40, height = 30;
  sensor_msgs::PointCloud2 message = plainCloud(width, height);
  const std::array<float, 3> constant = {0.0f, 0.0f, 0.5f};
  for (std::size_t i = 0; i < width * height; i += 3) {
    std::memcpy(message.data.data() + i * message.point_step, constant.data(), sizeof(constant));
  }
  Cloud cloud;
  EXPECT_EQ(readCloud(message, kAnyDepth, kEverything, cloud), "");
  EXPECT_EQ(cloud.valid_count, width * height * 2 / 3);
}

TEST(CloudReader, ReadsAnUnorganizedCloud) {
  Cloud cloud;
  EXPECT_EQ(readCloud(plainCloud(7, 1), kAnyDepth, kEverything, cloud), "");
  expectGrid(cloud, 7, 1);
  EXPECT_FALSE(cloud.organized());
  EXPECT_EQ(readCloud(plainCloud(1, 7), kAnyDepth, kEverything, cloud), "");
  expectGrid(cloud, 1, 7);
  EXPECT_FALSE(cloud.organized()) << "one column is a list, too";
}

TEST(CloudReader, ReadsAnyFieldOrderWithPaddingInPointsAndRows) {
  Cloud cloud;
  EXPECT_EQ(readCloud(test::gridCloud<float>(4, 3, {17, 1, 9}, 23, 5), kAnyDepth, kEverything, cloud), "");
  expectGrid(cloud, 4, 3);
}

TEST(CloudReader, ReadsDoubles) {
  Cloud cloud;
  EXPECT_EQ(readCloud(test::gridCloud<double>(4, 3, {16, 0, 8}, 27, 3), kAnyDepth, kEverything, cloud), "");
  expectGrid(cloud, 4, 3);
}

TEST(CloudReader, ReadsFloatsAndDoublesMixed) {
  auto message = test::gridCloud<float>(4, 3, {0, 4, 8}, 24, 0);
  message.fields[2] = makeField("z", 16, sensor_msgs::PointField::FLOAT64);
  for (std::uint32_t row = 0; row < 3; ++row) {
    for (std::uint32_t column = 0; column < 4; ++column) put(message, row, column, 16, 0.1 * (1 + column + row));
  }
  Cloud cloud;
  EXPECT_EQ(readCloud(message, kAnyDepth, kEverything, cloud), "");
  expectGrid(cloud, 4, 3);
}

TEST(CloudReader, DoesNotNeedThePaddingAfterTheLastRow) {
  auto message = test::gridCloud<float>(4, 3, {0, 4, 8}, 12, 100);
  message.data.resize(message.data.size() - 100);
  Cloud cloud;
  EXPECT_EQ(readCloud(message, kAnyDepth, kEverything, cloud), "");
  expectGrid(cloud, 4, 3);
}

TEST(CloudReader, TakesZeroNanAndInfinityAsMissing) {
  auto message = plainCloud(4, 1);
  const float infinity = std::numeric_limits<float>::infinity();
  for (std::uint32_t offset : {0, 4, 8}) put(message, 0, 0, offset, 0.0f);
  put(message, 0, 1, 4, std::numeric_limits<float>::quiet_NaN());
  put(message, 0, 2, 8, infinity);
  Cloud cloud;
  EXPECT_EQ(readCloud(message, kAnyDepth, kEverything, cloud), "");
  EXPECT_EQ(cloud.valid_count, 1u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FALSE(cloud.valid(i));
    EXPECT_TRUE(std::isnan(cloud.x[i]) && std::isnan(cloud.y[i]));
  }
  EXPECT_TRUE(cloud.valid(3));
}

TEST(CloudReader, TakesDoublesBeyondFloatsAsMissing) {
  auto message = test::gridCloud<double>(2, 1, {0, 8, 16}, 24, 0);
  put(message, 0, 0, 16, 1e300);
  Cloud cloud;
  EXPECT_EQ(readCloud(message, kAnyDepth, kEverything, cloud), "");
  EXPECT_EQ(cloud.valid_count, 1u);
}

TEST(CloudReader, CutsDepthsOutsideTheRange) {
  Cloud cloud;
  EXPECT_EQ(readCloud(plainCloud(6, 1), DepthRange{0.25f, 0.45f}, kEverything, cloud), "");  // z = 0.1 ... 0.6
  EXPECT_EQ(cloud.size(), 6u);
  EXPECT_EQ(cloud.valid_count, 2u);
  EXPECT_TRUE(cloud.valid(2) && cloud.valid(3));
}

TEST(CloudReader, KeepsTheLengthOfNormalsAtOne) {
  auto message = test::gridCloud<float>(2, 1, {0, 4, 8}, 24, 0);
  for (int i = 0; i < 3; ++i) {
    const char* const names[] = {"normal_x", "normal_y", "normal_z"};
    message.fields.push_back(makeField(names[i], 12 + 4 * i, sensor_msgs::PointField::FLOAT32));
    put(message, 0, 0, 12 + 4 * i, i == 2 ? -2.0f : 0.0f);
    put(message, 0, 1, 12 + 4 * i, 0.0f);
  }
  Cloud cloud;
  EXPECT_EQ(readCloud(message, kAnyDepth, kEverything, cloud), "");
  ASSERT_TRUE(cloud.hasNormals());
  EXPECT_FLOAT_EQ(cloud.nz[0], -1.0f);
  EXPECT_TRUE(std::isnan(cloud.nz[1]));  // without length: missing
  EXPECT_EQ(readCloud(message, kAnyDepth, kPositions, cloud), "");
  EXPECT_FALSE(cloud.hasNormals());
}

TEST(CloudReader, RefusesNormalsThatAreNotComplete) {
  auto message = plainCloud();
  message.fields.push_back(makeField("normal_x", 0, sensor_msgs::PointField::FLOAT32));
  expectRefused(message, {"normal_y", "missing", "expected normal_x, normal_y, normal_z, or none of them"});
  Cloud cloud;
  EXPECT_EQ(readCloud(message, kAnyDepth, kPositions, cloud), "");
}

/// A camera's image of a wall with a step, 25 % of the rows missing, and normals as doubles.
sensor_msgs::PointCloud2 largeImage() {
  auto message = test::gridCloud<float>(1282, 962, {4, 0, 8}, 40, 8);
  const char* const names[] = {"normal_x", "normal_y", "normal_z"};
  for (std::uint32_t k = 0; k < 3; ++k)
    message.fields.push_back(makeField(names[k], 16 + 8 * k, sensor_msgs::PointField::FLOAT64));
  for (std::uint32_t row = 0; row < message.height; ++row) {
    for (std::uint32_t column = 0; column < message.width; ++column) {
      put(message, row, column, 8, row % 4 == 3 ? 0.0f / 0.0f : 1.0f + 0.001f * static_cast<float>(column));
      for (std::uint32_t k = 0; k < 3; ++k) put(message, row, column, 16 + 8 * k, k == 2 ? -2.0 : 0.0);
    }
  }
  return message;
}

TEST(CloudReader, ReadsOfALargeImageWhatTheDetectorWouldTakeOfAllOfIt) {
  const auto message = largeImage();
  const DepthRange range = {0.1f, 2.0f};  // leaves a thousand columns
  Cloud all, part;
  ASSERT_EQ(readCloud(message, range, kEverything, all), "");
  ASSERT_EQ(readCloud(message, range, {true, false}, part), "");
  ASSERT_EQ(all.step, 1u);
  ThinnedImage thinned;
  const Cloud& expected = thinned.of(all);
  ASSERT_EQ(part.step, 2u);
  ASSERT_EQ(expected.step, 2u);
  EXPECT_EQ(part.width, expected.width);
  EXPECT_EQ(part.height, expected.height);
  EXPECT_EQ(part.valid_count, expected.valid_count);
  const auto same = [](const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
  };
  for (const auto values : {&Cloud::x, &Cloud::y, &Cloud::z, &Cloud::nx, &Cloud::ny, &Cloud::nz})
    EXPECT_TRUE(same(part.*values, expected.*values));
}

TEST(CloudReader, ReadsAllOfALargeImageWhereLittleIsWithinTheRange) {
  Cloud cloud;
  ASSERT_EQ(readCloud(largeImage(), {0.1f, 1.2f}, {true, false}, cloud), "");
  EXPECT_EQ(cloud.step, 1u);
  EXPECT_EQ(cloud.width, 1282u);
  EXPECT_EQ(cloud.valid_count, 201u * 722u);
}

TEST(CloudReader, TakesACloudWithoutPointsAsEmpty) {
  for (const auto& message : {sensor_msgs::PointCloud2(), plainCloud(0, 3), plainCloud(3, 0)}) {
    Cloud cloud;
    EXPECT_EQ(readCloud(message, kAnyDepth, kEverything, cloud), "");
    EXPECT_EQ(cloud.size(), 0u);
  }
}

TEST(CloudReader, RefusesAMissingField) {
  auto message = plainCloud();
  message.fields.pop_back();
  expectRefused(message, {"'z'", "missing", "x, y"});
  message.fields.clear();
  expectRefused(message, {"'x'", "missing", "none"});
}

TEST(CloudReader, RefusesAFieldOfAnotherType) {
  auto message = plainCloud();
  message.fields[1].datatype = sensor_msgs::PointField::INT16;
  expectRefused(message, {"'y'", "int16", "float32"});
  message.fields[1].datatype = 77;
  expectRefused(message, {"'y'", "unknown type 77"});
}

TEST(CloudReader, RefusesACountThatIsNotOne) {
  auto message = plainCloud();
  for (std::uint32_t count : {0u, 2u, 4294967295u}) {
    message.fields[0].count = count;
    expectRefused(message, {"'x'", "count " + std::to_string(count)});
  }
}

TEST(CloudReader, RefusesAFieldBeyondThePoint) {
  auto message = plainCloud();
  for (std::uint32_t offset : {9u, 12u, 4294967293u, 4294967295u}) {
    message.fields[2].offset = offset;
    expectRefused(message, {"'z'", "point_step"});
  }
  message = plainCloud();
  message.point_step = 0;
  expectRefused(message, {"point_step"});
}

TEST(CloudReader, RefusesRowsShorterThanTheirPoints) {
  auto message = plainCloud();
  message.row_step = 47;
  expectRefused(message, {"row_step is 47", "48"});
  message.row_step = 0;
  expectRefused(message, {"row_step is 0"});
}

TEST(CloudReader, RefusesDataShorterThanItsPoints) {
  auto message = plainCloud();
  message.data.pop_back();
  expectRefused(message, {"143 bytes", "144"});
  message.data.clear();
  expectRefused(message, {"0 bytes"});
}

TEST(CloudReader, RefusesSizesWhoseProductOverflows) {
  auto message = plainCloud();
  message.width = message.height = 65536;  // 2^32 points: 0 in 32 bits
  expectRefused(message, {"4294967296 points"});
  message.width = message.height = 4294967295u;
  expectRefused(message, {"points"});
  message = plainCloud(4, 3);
  message.point_step = 1073741824u;  // times width: 2^32
  message.row_step = 0;
  expectRefused(message, {"row_step"});
  message.row_step = 4294967295u;
  expectRefused(message, {"row_step"});
  message.width = 3;
  expectRefused(message, {"144 bytes"});
}

TEST(CloudReader, RefusesBigEndianData) {
  auto message = plainCloud();
  message.is_bigendian = true;
  expectRefused(message, {"big-endian", "little-endian"});
}

}  // namespace
}  // namespace primitect::cloud_reader_test
