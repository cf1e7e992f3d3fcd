// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Pictures show each shape where its geometry projects to.
#include "io/picture.h"

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "io/kind_color.h"
#include "io/label_colors.h"
#include "io/label_file.h"
#include "io/name_tags.h"
#include "io/outlines.h"
#include "io/picture_caption.h"
#include "temporary_folder.h"

namespace primitect::io::picture_test {
namespace {

constexpr Intrinsics kLens = {500.0, 500.0, 319.5, 239.5};

/// A wall at 2 m as a 640 x 480 camera sees it.
Cloud wall() {
  Cloud cloud;
  cloud.reset(640, 480, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double u = static_cast<double>(i % 640), v = static_cast<double>(i / 640);
    cloud.setPoint(i, static_cast<float>((u - kLens.cx) / kLens.fx * 2.0),
                   static_cast<float>((v - kLens.cy) / kLens.fy * 2.0), 2.0f, {});
  }
  return cloud;
}

Detections only(const Shape& shape, const Extent& extent = {}) {
  Detections detections;
  detections.items.resize(1);
  detections.items[0].shape = shape;
  detections.items[0].extent = extent;
  return detections;
}

/// How near a pixel of the kind's colour is, px.
double distanceToColor(const cv::Mat& picture, const cv::Point& place, Kind kind) {
  const cv::Scalar color = bgr(kind);
  double nearest = std::numeric_limits<double>::max();
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      const cv::Vec3b pixel = picture.at<cv::Vec3b>(row, column);
      const bool same = pixel[0] == color[0] && pixel[1] == color[1] && pixel[2] == color[2];
      if (same) nearest = std::min(nearest, std::hypot(column - place.x, row - place.y));
    }
  }
  return nearest;
}

TEST(Pictures, OutlineASphereWhereItProjects) {
  const Cloud cloud = wall();
  const Sphere sphere{{0.1, -0.05, 1.0}, 0.1};
  Extent extent;
  extent.origin = sphere.center;
  const Detections detections = only(sphere, extent);
  const std::vector<std::uint32_t> labels(cloud.size(), 0);
  const cv::Mat picture = drawPicture({cloud, {}, labels, detections}, kLens, "wall");
  ASSERT_EQ(picture.cols, 1280);
  ASSERT_GE(picture.rows, 960);
  // Rays in the plane y = -0.05 z... are not simple: take the exact rims left and right along the row of the centre,
  // where the angle between ray and centre is asin(r / distance).
  const double to_center = std::atan2(0.1, 1.0), flat = std::hypot(0.1, 1.0);
  const double half = std::asin(std::sqrt(0.1 * 0.1 / (flat * flat)));
  for (const double angle : {to_center - half, to_center + half}) {
    const double u = 2.0 * (kLens.fx * std::tan(angle) + kLens.cx) + 0.5;
    const double v = 2.0 * (kLens.fy * -0.05 + kLens.cy) + 0.5;
    const cv::Point rim(static_cast<int>(std::lround(u)), static_cast<int>(std::lround(v)));
    // The circle projects to an ellipse whose vertical extremes are off this row by far less than the line is wide.
    EXPECT_LE(distanceToColor(picture, rim, Kind::sphere), 3.0);
  }
}

TEST(Pictures, AreScaledByTheLongerSide) {
  const Detections none;
  const auto sizeOf = [&](std::uint32_t width, std::uint32_t height) {
    Cloud cloud;
    cloud.reset(width, height, false);
    const std::vector<std::uint32_t> labels(cloud.size(), 0);
    return drawPicture({cloud, {}, labels, none}, kLens, "").size();
  };
  EXPECT_EQ(sizeOf(640, 480).width, 1280);
  EXPECT_EQ(sizeOf(1600, 1200).width, 1600);
  // With the caption.
  for (const auto& [width, height] : {std::pair(20, 1000), std::pair(2, 300)}) {
    EXPECT_LT(sizeOf(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)).height, 1400);
  }
}

TEST(Pictures, EstimateTheLensOfAnOrganizedCloud) {
  const Cloud cloud = wall();
  const Detections detections = only(Sphere{{0.0, 0.0, 1.0}, 0.1}, {});
  const std::vector<std::uint32_t> labels(cloud.size(), 0);
  const LabelledPoints points{cloud, {}, labels, detections};
  cv::Mat difference;
  cv::absdiff(drawPicture(points, kLens, ""), drawPicture(points, std::nullopt, ""), difference);
  EXPECT_LT(cv::mean(difference)[0], 0.05);
}

TEST(Pictures, TintLabelledPointsAndDarkenUnusedOnes) {
  const Cloud cloud = wall();
  const Detections detections = only(Plane{{0, 0, 2}, {0, 0, -1}}, {});
  std::vector<std::uint32_t> labels(cloud.size(), 0);
  for (std::size_t i = 0; i < 640 * 100; ++i) labels[i] = 1;
  const cv::Mat tinted = drawPicture({cloud, {}, labels, detections}, kLens, "");
  const cv::Vec3b labelled = tinted.at<cv::Vec3b>(20, 20), plain = tinted.at<cv::Vec3b>(900, 20);
  EXPECT_GT(labelled[0], labelled[2] + 40);  // a plane is blue
  EXPECT_EQ(plain[0], plain[2]);
  const cv::Mat dark = drawPicture({cloud, {0.0f, 1.5f}, labels, detections}, kLens, "");
  EXPECT_LT(dark.at<cv::Vec3b>(900, 20)[0], plain[0] / 2);
}

TEST(Pictures, ShowUnorganizedCloudsAsDots) {
  Cloud cloud;
  cloud.reset(10000, 1, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.setPoint(i, 0.01f * static_cast<float>(i % 100), 0.01f * static_cast<float>(i / 100), 0.5f, {});
  }
  const Detections detections = only(Sphere{{0.5, 0.5, 0.5}, 0.2}, {});
  const std::vector<std::uint32_t> labels(cloud.size(), 0);
  const cv::Mat picture = drawPicture({cloud, {}, labels, detections}, std::nullopt, "");
  ASSERT_FALSE(picture.empty());
  EXPECT_GT(cv::countNonZero(picture.reshape(1)), 960 * 960);
  const View view = orthographicView(cloud, 1280, 960);
  const auto rim = view.project({0.7, 0.5, 0.5});
  ASSERT_TRUE(rim);
  const cv::Point place(static_cast<int>(std::lround(rim->x())), static_cast<int>(std::lround(rim->y())));
  EXPECT_LE(distanceToColor(picture, place, Kind::sphere), 3.0);
}

TEST(Pictures, NumberTheShapesAsTheListDoes) {
  const Cloud cloud = wall();
  Detections detections = only(Plane{{0, 0, 2}, {0, 0, -1}}, {});
  detections.items.push_back(only(Sphere{{0.1, -0.05, 1.0}, 0.1}, {}).items[0]);
  std::vector<std::uint32_t> labels(cloud.size(), 1);
  for (std::size_t row = 100; row < 200; ++row) {
    for (std::size_t column = 300; column < 400; ++column) labels[row * 640 + column] = 2;
  }
  const auto tags = tagsOf({cloud, {}, labels, detections}, cameraView(kLens, 640, 480, 1));
  ASSERT_EQ(tags.size(), 2u);
  EXPECT_EQ(tags[0].text.substr(0, 9), "2  sphere");
  EXPECT_EQ(tags[1].text.substr(0, 8), "1  plane");
  EXPECT_LT(cv::norm(tags[0].anchor - cv::Point(350, 150)), 20.0);
  EXPECT_GT(cv::norm(tags[1].anchor - cv::Point(350, 150)), 70.0);
}

TEST(Pictures, AreDrawnOfNothing) {
  const Detections none;
  const std::vector<std::uint32_t> labels;
  const Cloud empty;
  EXPECT_FALSE(drawPicture({empty, {}, labels, none}, std::nullopt, "empty").empty());
  Cloud missing;
  missing.reset(64, 48, false);
  EXPECT_FALSE(drawPicture({missing, {}, labels, none}, std::nullopt, "missing").empty());
}

TEST(Outlines, TouchASphereAlongLinesOfSight) {
  const Sphere sphere{{0.3, -0.2, 1.5}, 0.4};
  const auto lines = outlineOf(only(sphere).items[0], cameraView(kLens, 640, 480, 1));
  ASSERT_EQ(lines.size(), 1u);
  for (const Vec3& corner : lines[0]) {
    EXPECT_NEAR((corner - sphere.center).norm(), sphere.radius, 1e-9);
    EXPECT_NEAR(corner.dot(corner - sphere.center), 0.0, 1e-9);
  }
}

TEST(Outlines, FollowTheSidesOfACylinderAndAConeThatTurnAway) {
  const Vec3 axis = Vec3(0.2, 1.0, 0.3).normalized();
  Extent extent;
  extent.origin = {0.1, 0.05, 1.2};
  extent.size.z() = 0.3;
  extent.radius = 0.12;
  extent.radius_small = 0.05;
  const double half_angle = std::atan((0.12 - 0.05) / 0.3);
  const Vec3 apex = extent.origin - axis * (0.15 + 0.05 / std::tan(half_angle));
  const View view = cameraView(kLens, 640, 480, 1);
  for (const Shape& shape : {Shape(Cylinder{extent.origin, axis, 0.12}), Shape(Cone{apex, axis, half_angle})}) {
    const auto lines = outlineOf(only(shape, extent).items[0], view);
    ASSERT_EQ(lines.size(), 4u);  // two ends, two sides
    for (const Line3& line : lines) {
      for (const Vec3& corner : line) EXPECT_NEAR(distance(shape, corner), 0.0, 1e-9);
    }
    for (const std::size_t side : {2u, 3u}) {
      for (const Vec3& corner : lines[side]) EXPECT_NEAR(normalAt(shape, corner).dot(corner), 0.0, 1e-9);
    }
  }
}

TEST(Outlines, AreCutOffBehindTheViewer) {
  Extent extent;
  extent.hull = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 3}, {-1, 1, 3}};
  const View view = cameraView(kLens, 640, 480, 1);
  const auto lines = projectLines(outlineOf(only(Plane{{0, 1, 1}, {0, -1, 0}}, extent).items[0], view), view);
  ASSERT_EQ(lines.size(), 1u);
  for (const Eigen::Vector2d& pixel : lines[0]) EXPECT_TRUE(pixel.allFinite());
}

TEST(NameTags, DoNotCoverEachOther) {
  const std::vector<cv::Point> anchors(8, cv::Point(5, 5));
  const std::vector<cv::Size> sizes(8, cv::Size(120, 20));
  const cv::Size picture(640, 480);
  const std::vector<cv::Rect> boxes = placeTags(anchors, sizes, {}, picture);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_EQ((boxes[i] & cv::Rect({0, 0}, picture)), boxes[i]);
    for (std::size_t k = 0; k < i; ++k) EXPECT_EQ((boxes[i] & boxes[k]).area(), 0);
  }
}

TEST(NameTags, LeaveThingsAndOtherAnchorsFree) {
  const std::vector<cv::Point> anchors = {{200, 200}, {200, 150}};
  Things things = {cv::Mat(60, 80, CV_8UC1, cv::Scalar(0)), 8};
  things.cells(cv::Rect(20, 20, 10, 10)).setTo(1);  // 160 to 240 px either way
  const std::vector<cv::Rect> boxes = placeTags(anchors, {{120, 20}, {120, 20}}, things, {640, 480});
  for (const cv::Rect& box : boxes) {
    EXPECT_EQ((box & cv::Rect(160, 160, 80, 80)).area(), 0) << box;
    EXPECT_FALSE(box.contains(anchors[1])) << box;
    EXPECT_LT(cv::norm((box.tl() + box.br()) / 2 - anchors[0]), 150.0) << "no farther than it must";
  }
  const cv::Rect alone = placeTags({anchors[0]}, {{120, 20}}, {}, {640, 480}).at(0);
  EXPECT_EQ(alone.br().y, 190) << "above its place, where nothing is in the way";
}

/// Nothing is written as far to the right as the margin on the left is wide.
bool isWithinItsWidth(const cv::Mat& caption) {
  const int margin = static_cast<int>(21 * textScale(caption.cols)) / 2;
  cv::Mat grey;
  cv::cvtColor(caption.colRange(caption.cols - margin, caption.cols), grey, cv::COLOR_BGR2GRAY);
  return cv::countNonZero(grey != 30) == 0;
}

TEST(Captions, HaveAsManyRowsAsTheirWidthAsksFor) {
  const Cloud cloud = wall();
  const std::vector<std::uint32_t> labels(cloud.size(), 0);
  const Detections ball = only(Sphere{});
  const LabelledPoints points = {cloud, {0.0f, 1.5f}, labels, ball};
  const auto rowsOf = [&points](const std::string& title, int width) {
    const cv::Mat caption = drawCaption(points, title, width);
    EXPECT_TRUE(isWithinItsWidth(caption)) << title << ", " << width;
    EXPECT_EQ(caption.cols, width);
    return caption.rows / static_cast<int>(42 * textScale(width));
  };
  EXPECT_EQ(rowsOf("wall", 2560), 3);
  EXPECT_GT(rowsOf("wall", 320), 4);
  EXPECT_EQ(rowsOf(std::string(500, 'w'), 2560), 4) << "the counts have a row of their own";
}

TEST(Pictures, AreWideEnoughForTheirCaption) {
  Cloud strip;
  strip.reset(20, 1000, false);
  const std::vector<std::uint32_t> labels(strip.size(), 0);
  EXPECT_EQ(drawPicture({strip, {}, labels, {}}, kLens, "").cols, 320);
}

class LabelFiles : public test::TemporaryFolder {};

TEST_F(LabelFiles, HoldPointsColorsAndLabels) {
  Cloud cloud;
  cloud.reset(3, 1, false);
  cloud.setPoint(0, 1.0f, 2.0f, 3.0f, {});
  cloud.setPoint(2, 4.0f, 5.0f, 6.0f, {});
  writeLabels(path("labels.ply"), cloud, only(Sphere{}), {1, 0, 0});
  const std::string bytes = read(path("labels.ply"));
  EXPECT_NE(bytes.find("format binary_little_endian"), std::string::npos);
  EXPECT_NE(bytes.find("element vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                       "property uchar green\nproperty uchar blue\nproperty uint label\n"),
            std::string::npos);
  const Rgb red = kindColor(Kind::sphere), grey = kUnlabelledColor;
  const std::string body =
      test::bytesOf<float>({1, 2, 3}) + test::bytesOf<std::uint8_t>({red.red, red.green, red.blue}) +
      test::bytesOf<std::uint32_t>({1}) + test::bytesOf<float>({4, 5, 6}) +
      test::bytesOf<std::uint8_t>({grey.red, grey.green, grey.blue}) + test::bytesOf<std::uint32_t>({0});
  EXPECT_EQ(bytes.substr(bytes.size() - body.size()), body);
}

TEST_F(LabelFiles, TellShapesOfOneKindApart) {
  Detections found;
  for (const Shape& shape : {Shape(Plane{}), Shape(Sphere{}), Shape(Plane{}), Shape(Plane{})}) {
    found.items.emplace_back().shape = shape;
  }
  const std::vector<Rgb> colors = labelColors(found);
  ASSERT_EQ(colors.size(), 5u);
  const auto bytes = [&colors](std::size_t label) {
    return std::tuple(colors[label].red, colors[label].green, colors[label].blue);
  };
  const Rgb blue = kindColor(Kind::plane), red = kindColor(Kind::sphere);
  EXPECT_EQ(bytes(1), std::tuple(blue.red, blue.green, blue.blue));
  EXPECT_EQ(bytes(2), std::tuple(red.red, red.green, red.blue)) << "the first of its kind";
  EXPECT_LT(colors[3].blue, blue.blue);
  EXPECT_GT(colors[4].red, blue.red);
}

/// Files can have so many bytes, as on a disk that is nearly full, while this lives.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(LabelFiles, ThatEndTooSoonAreReported) {
  Cloud cloud;  // an image, with and without missing points, and a list
  for (const auto& [width, height, every] : {std::tuple(60, 50, 1), std::tuple(60, 50, 3), std::tuple(3000, 1, 3)}) {
    cloud.reset(width, height, false);
    for (std::size_t i = 0; i < cloud.size(); i += every) cloud.setPoint(i, static_cast<float>(i), 1.0f, 2.0f, {});
    const std::vector<std::uint32_t> labels(cloud.size(), 1);
    EXPECT_NO_THROW(writeLabels(path("labels.ply"), cloud, Detections{}, labels)) << height << " " << every;
    const auto size = static_cast<rlim_t>(std::filesystem::file_size(path("labels.ply")));
    const SmallFiles all_but_one(size - 1);
    EXPECT_THROW(writeLabels(path("labels.ply"), cloud, Detections{}, labels), std::runtime_error) << height;
  }
}

TEST_F(LabelFiles, ThatCannotBeWrittenAreReported) {
  EXPECT_THROW(writeLabels(path("no/such/folder.ply"), Cloud{}, Detections{}, {}), std::runtime_error);
  EXPECT_THROW(writePicture(path("no/such/folder.png"), cv::Mat(2, 2, CV_8UC3)), std::runtime_error);
  EXPECT_THROW(writePicture("/dev/full", cv::Mat::zeros(2, 2, CV_8UC3)), std::runtime_error);
  EXPECT_TRUE(std::filesystem::exists("/dev/full")) << "what cannot be written stays";
}

}  // namespace
}  // namespace primitect::io::picture_test
