// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Point files written by PCL and libpng, or by hand, come back as the points that went in.
#include "io/point_files.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <cmath>

#include "temporary_folder.h"
#include "test/support/png_files.h"

namespace primitect::io::point_files_test {
namespace {

using test::bytesOf;
class PointFiles : public test::TemporaryFolder {};

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

pcl::PointCloud<pcl::PointNormal> gridWithNormals() {
  pcl::PointCloud<pcl::PointNormal> points(4, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float number = static_cast<float>(i);
    points[i].getVector3fMap() = Eigen::Vector3f(0.1f * number, -0.2f * number, 1.0f + number);
    points[i].getNormalVector3fMap() = Eigen::Vector3f(number, 1.0f, -2.0f).normalized();
  }
  points[5].x = points[5].y = points[5].z = kNaN;
  points.is_dense = false;
  return points;
}

void expectGrid(const Cloud& cloud, bool normals) {
  const pcl::PointCloud<pcl::PointNormal> truth = gridWithNormals();
  ASSERT_EQ(cloud.width, 4u);
  ASSERT_EQ(cloud.height, 3u);
  EXPECT_EQ(cloud.valid_count, 11u);
  ASSERT_EQ(cloud.hasNormals(), normals);
  EXPECT_FALSE(cloud.valid(5));
  for (const std::size_t i : {0u, 4u, 11u}) {
    EXPECT_FLOAT_EQ(cloud.x[i], truth[i].x);
    EXPECT_FLOAT_EQ(cloud.y[i], truth[i].y);
    EXPECT_FLOAT_EQ(cloud.z[i], truth[i].z);
    if (!normals) continue;
    EXPECT_NEAR(cloud.nx[i], truth[i].normal_x, 1e-6);
    EXPECT_NEAR(cloud.nz[i], truth[i].normal_z, 1e-6);
  }
}

pcl::PointCloud<pcl::PointXYZ> withoutNormals(const pcl::PointCloud<pcl::PointNormal>& points) {
  pcl::PointCloud<pcl::PointXYZ> plain;
  pcl::copyPointCloud(points, plain);
  return plain;
}

TEST_F(PointFiles, KeepRowsAndNormalsOfOrganizedPcdsOfAllEncodings) {
  pcl::PCDWriter writer;
  writer.writeASCII(path("ascii.pcd"), gridWithNormals());
  writer.writeBinary(path("binary.pcd"), gridWithNormals());
  writer.writeBinaryCompressed(path("compressed.pcd"), gridWithNormals());
  for (const char* name : {"ascii.pcd", "binary.pcd", "compressed.pcd"}) {
    SCOPED_TRACE(name);
    expectGrid(readPointFile(path(name)).cloud, true);
  }
}

TEST_F(PointFiles, KeepRowsOfPcdsWithoutNormals) {
  pcl::PCDWriter().writeBinary(path("plain.pcd"), withoutNormals(gridWithNormals()));
  expectGrid(readPointFile(path("plain.pcd")).cloud, false);
}

TEST_F(PointFiles, TakeAConstantThatWasFilledInForMissing) {
  pcl::PointCloud<pcl::PointXYZ> points;
  for (int i = 0; i < 600; ++i) {
    points.push_back(i % 3 == 0 ? pcl::PointXYZ(0.0f, 0.0f, 0.5f)
                                : pcl::PointXYZ(0.01f * static_cast<float>(i), 0.0f, 1.0f));
  }
  pcl::PCDWriter().writeBinary(path("filled_in.pcd"), points);
  EXPECT_EQ(readPointFile(path("filled_in.pcd")).cloud.valid_count, 400u);
}

TEST_F(PointFiles, KeepRowsAndNormalsOfRangeGrids) {
  pcl::PCLPointCloud2 with, without;
  pcl::toPCLPointCloud2(gridWithNormals(), with);
  pcl::toPCLPointCloud2(withoutNormals(gridWithNormals()), without);
  const Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  const Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();
  pcl::PLYWriter writer;
  for (const bool normals : {false, true}) {
    SCOPED_TRACE(normals);
    writer.writeBinary(path("binary.ply"), normals ? with : without, origin, rotation, false);
    writer.writeASCII(path("ascii.ply"), normals ? with : without, origin, rotation, 8, false);
    expectGrid(readPointFile(path("binary.ply")).cloud, normals);
    expectGrid(readPointFile(path("ascii.ply")).cloud, normals);
  }
}

TEST_F(PointFiles, ReadUnorganizedPliesWithNormals) {
  pcl::PointCloud<pcl::PointNormal> points;
  points.push_back(gridWithNormals()[1]);
  points.push_back(gridWithNormals()[2]);
  pcl::PLYWriter().write(path("two.ply"), points, true, false);
  const Cloud cloud = readPointFile(path("two.ply")).cloud;
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_FALSE(cloud.organized());
  ASSERT_TRUE(cloud.hasNormals());
  EXPECT_FLOAT_EQ(cloud.z[1], 3.0f);
  EXPECT_NEAR(cloud.nx[1], points[1].normal_x, 1e-6);
}

TEST_F(PointFiles, ReadFloat64InAnyFieldOrder) {
  const std::string pcd =
      write("wide.pcd",
            "VERSION 0.7\nFIELDS z intensity x y\nSIZE 8 2 4 8\nTYPE F U F F\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\n"
            "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA binary\n" +
                bytesOf<double>({3.0}) + bytesOf<std::uint16_t>({7}) + bytesOf<float>({1.0f}) + bytesOf<double>({2.0}));
  const std::string ply = write(
      "wide.ply",
      "ply\r\nformat binary_little_endian 1.0\r\ncomment by hand\r\nelement vertex 1\r\nproperty uchar red\r\nproperty "
      "uchar green\r\nproperty uchar blue\r\nproperty double z\r\nproperty float x\r\nproperty double y\r\nelement "
      "face "
      "1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n\x01\x02\x03" +
          bytesOf<double>({3.0}) + bytesOf<float>({1.0f}) + bytesOf<double>({2.0}) + "\x01" + bytesOf<int>({0}));
  for (const std::string& file : {pcd, ply}) {
    SCOPED_TRACE(file);
    const Cloud cloud = readPointFile(file).cloud;
    ASSERT_EQ(cloud.valid_count, 1u);
    EXPECT_EQ(cloud.x[0], 1.0f);
    EXPECT_EQ(cloud.y[0], 2.0f);
    EXPECT_EQ(cloud.z[0], 3.0f);
  }
}

TEST_F(PointFiles, TakeZeroNanAndInfinityForMissing) {
  const std::string file =
      write("missing.ply",
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
            "float z\nend_header\n0 0 0\nnan 1 1\n1 1 inf\n0 0 1\n");
  const Cloud cloud = readPointFile(file).cloud;
  ASSERT_EQ(cloud.size(), 4u);
  EXPECT_EQ(cloud.valid_count, 1u);
  EXPECT_TRUE(cloud.valid(3));
}

TEST_F(PointFiles, ReadFilesWithoutPointsAsEmptyClouds) {
  const std::string ply = write("none.ply",
                                "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty "
                                "float z\nend_header\n");
  EXPECT_EQ(readPointFile(ply).cloud.size(), 0u);
}

TEST_F(PointFiles, ProjectDepthImagesThroughTheirIntrinsics) {
  cv::Mat image(3, 4, CV_16UC1, cv::Scalar(0));
  image.at<std::uint16_t>(2, 3) = 1500;
  test::writePng(path("depth.png"), image);
  DepthImageOptions options;
  options.intrinsics = Intrinsics{500.0, 400.0, 1.0, 0.5};
  const PointFile file = readPointFile(path("depth.png"), options);
  ASSERT_EQ(file.cloud.width, 4u);
  ASSERT_EQ(file.cloud.height, 3u);
  EXPECT_EQ(file.cloud.valid_count, 1u);
  // (3 - 1) * 1.5 / 500 and (2 - 0.5) * 1.5 / 400
  EXPECT_NEAR(file.cloud.x[11], 0.006, 1e-7);
  EXPECT_NEAR(file.cloud.y[11], 0.005625, 1e-7);
  EXPECT_NEAR(file.cloud.z[11], 1.5, 1e-6);
  options.depth_scale = 0.0002;
  EXPECT_NEAR(readPointFile(path("depth.png"), options).cloud.z[11], 0.3, 1e-6);
}

TEST_F(PointFiles, AreCutAtDepthOnlyOnRequest) {
  pcl::PCDWriter().writeBinary(path("grid.pcd"), gridWithNormals());
  const Cloud whole = readPointFile(path("grid.pcd")).cloud;
  Cloud cut;
  cutAtDepth(whole, {2.0f, 5.0f}, cut);
  EXPECT_EQ(cut.valid_count, 4u);  // z = 2, 3, 4, 5 of 1 ... 12
  EXPECT_EQ(cut.width, 4u);
  EXPECT_FALSE(cut.valid(0));
  EXPECT_TRUE(cut.valid(1));
  EXPECT_FLOAT_EQ(cut.nx[1], whole.nx[1]);
}

TEST(IntrinsicsOfACloud, AreFoundFromItsPoints) {
  Cloud cloud;
  cloud.reset(40, 30, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float z = 1.0f + 0.01f * static_cast<float>(i % 7);
    cloud.setPoint(i, (static_cast<float>(i % 40) - 18.5f) / 50.0f * z,
                   (static_cast<float>(i / 40) - 14.0f) / 60.0f * z, z, {});
  }
  const auto lens = estimateIntrinsics(cloud);
  ASSERT_TRUE(lens);
  EXPECT_NEAR(lens->fx, 50.0, 1e-3);
  EXPECT_NEAR(lens->fy, 60.0, 1e-3);
  EXPECT_NEAR(lens->cx, 18.5, 1e-3);
  EXPECT_NEAR(lens->cy, 14.0, 1e-3);
}

TEST(IntrinsicsOfACloud, AreNotMadeUpForAnOrthographicGrid) {
  Cloud cloud;
  cloud.reset(100, 100, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float slope = 0.3f + 0.02f * static_cast<float>((i * 7919) % 100);
    cloud.setPoint(i, 0.01f * static_cast<float>(i % 100), 0.01f * static_cast<float>(i / 100), slope, {});
  }
  EXPECT_FALSE(estimateIntrinsics(cloud));
}

TEST(IntrinsicsFromText, AreFourNumbers) {
  const Intrinsics lens = parseIntrinsics("525,526.5,319.5,239.5");
  EXPECT_EQ(lens.fy, 526.5);
  EXPECT_EQ(lens.cy, 239.5);
  for (const char* bad :
       {"", "525", "525,525,320", "525,525,320,240,1", "0,525,1,1", "525,-1,1,1", "a,b,c,d", "1;2;3;4"}) {
    EXPECT_THROW(parseIntrinsics(bad), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace primitect::io::point_files_test
