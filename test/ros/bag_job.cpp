// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Recordings are searched as topics are: clouds and depth images, transforms, tracks; and what is wrong is said.
#include "ros/bag_job.h"

#include <gtest/gtest.h>
#include <primitect/PrimitiveArray.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CompressedImage.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/cloud_reader.h"
#include "ros/depth_clouds.h"
#include "ros/frame_pipeline.h"
#include "ros/messages.h"
#include "ros/synthetic_messages.h"
#include "ros/tracking.h"
#include "synthetic/frame.h"
#include "synthetic/poses.h"
#include "synthetic/tabletop.h"
#include "test/io/temporary_folder.h"
#include "test/support/png_files.h"

namespace primitect::bag_job_test {
namespace {

using namespace ros_layer;

const synthetic::PinholeCamera kCamera = synthetic::PinholeCamera().scaledTo(320, 240);

std_msgs::Header headerAt(int k) {
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(1000, 100000000u * static_cast<std::uint32_t>(k));
  return header;
}

/// Somewhat later than it was taken.
ros::Time recordedAt(int k) { return headerAt(k).stamp + ros::Duration(0.03); }

std::vector<float> depthAt(int k) {
  static const synthetic::World world = synthetic::tabletop(2);
  return synthetic::renderFrame(world, kCamera, synthetic::cameraPose(0.1 * k), {}, 2, static_cast<std::uint64_t>(k))
      .depth;
}

std::vector<Detections> foundIn(const BagJob& job) {
  std::vector<Detections> found;
  detectInBags(job, [&found](const io::FrameReport& frame) { found.push_back(frame.detections); });
  return found;
}

std::vector<std::string> problemsOf(const BagJob& job) {
  std::vector<std::string> problems;
  detectInBags(job, [&problems](const io::FrameReport& frame) { problems.push_back(frame.problem); });
  return problems;
}

/// What keeps a job from running.
std::string refusalOf(const BagJob& job) {
  try {
    detectInBags(job, [](const io::FrameReport&) {});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

void expectSame(const Detections& a, const Detections& b) {
  ASSERT_EQ(a.items.size(), b.items.size());
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    EXPECT_EQ(kindOf(a.items[i].shape), kindOf(b.items[i].shape));
    EXPECT_EQ(a.items[i].extent.origin, b.items[i].extent.origin);
    EXPECT_EQ(a.items[i].confidence, b.items[i].confidence);
    EXPECT_EQ(a.items[i].covariance, b.items[i].covariance);
  }
}

class BagJobs : public test::TemporaryFolder {
 protected:
  /// A bag of clouds, `frames` of them from that one on.
  std::string cloudBag(const std::string& name, int first, int frames) const {
    rosbag::Bag bag(path(name), rosbag::bagmode::Write);
    for (int k = first; k < first + frames; ++k) {
      bag.write("/camera/points", recordedAt(k), depthCloud(headerAt(k), depthAt(k), kCamera));
    }
    bag.close();
    return path(name);
  }

  /// A bag of depth images of that encoding, with a camera_info before each.
  std::string depthBag(const std::string& encoding,
                       const std::string& camera_info = "/camera/depth/camera_info") const {
    rosbag::Bag bag(path("depth.bag"), rosbag::bagmode::Write);
    for (int k = 0; k < 2; ++k) {
      bag.write(camera_info, headerAt(k).stamp, cameraInfo(headerAt(k), kCamera));
      bag.write("/camera/depth/image_raw", headerAt(k).stamp, depthImage(headerAt(k), depthAt(k), kCamera, encoding));
    }
    bag.close();
    return path("depth.bag");
  }

  static BagJob jobOf(const std::vector<std::string>& bags) {
    BagJob job;
    job.bags = bags;
    return job;
  }
};

TEST_F(BagJobs, FindInEachCloudWhatThePipelineFinds) {
  const std::vector<Detections> found = foundIn(jobOf({cloudBag("clouds.bag", 0, 3)}));
  ASSERT_EQ(found.size(), 3u);
  FramePipeline pipeline{Params()};
  PrimitiveTracker tracker;
  for (int k = 0; k < 3; ++k) {
    PrimitiveArray& message = pipeline.process(*depthCloud(headerAt(k), depthAt(k), kCamera));
    tracker.update(Params().track_patience, message);
    const Detections alone = fromMessage(message);
    EXPECT_GT(alone.items.size(), 3u);
    expectSame(found[static_cast<std::size_t>(k)], alone);
  }
}

TEST_F(BagJobs, TellStampFrameAndTimeOfEachCloud) {
  std::vector<std::uint32_t> nanoseconds;
  std::vector<double> recorded;
  const BagOutcome outcome = detectInBags(jobOf({cloudBag("clouds.bag", 1, 2)}), [&](const io::FrameReport& frame) {
    EXPECT_EQ(frame.frame_id, "camera");
    EXPECT_EQ(frame.secs, 1000u);
    EXPECT_GT(frame.processing_ms, 0.0);
    nanoseconds.push_back(frame.nsecs);
    recorded.push_back(frame.recorded);
  });
  EXPECT_EQ(outcome.topic, "/camera/points");
  EXPECT_EQ(outcome.unusable_transforms, 0u);
  EXPECT_EQ(nanoseconds, (std::vector<std::uint32_t>{100000000u, 200000000u}));
  EXPECT_EQ(recorded[0], 0.0);
  EXPECT_NEAR(recorded[1], 0.1, 1e-6);
}

TEST_F(BagJobs, SearchTheCloudsOfDepthImages) {
  const std::vector<Detections> of_depth = foundIn(jobOf({depthBag("16UC1")}));
  ASSERT_EQ(of_depth.size(), 2u);
  FramePipeline pipeline{Params()};
  const auto image = depthImage(headerAt(0), depthAt(0), kCamera, "16UC1");
  const auto cloud = cloudOf(image, *cameraInfo(headerAt(0), kCamera));
  EXPECT_EQ(cloud->header.frame_id, "camera");
  expectSame(of_depth[0], fromMessage(pipeline.process(*cloud)));
  EXPECT_GT(of_depth[0].items.size(), 3u);
}

/// As compressed_depth_image_transport makes it of an image of 16UC1.
sensor_msgs::CompressedImage packed(const sensor_msgs::Image& depth) {
  sensor_msgs::CompressedImage packed;
  packed.header = depth.header;
  packed.format = "16UC1; compressedDepth png";
  const cv::Mat stored(static_cast<int>(depth.height), static_cast<int>(depth.width), CV_16UC1,
                       const_cast<std::uint8_t*>(depth.data.data()), depth.step);
  const std::vector<std::uint8_t> png = test::encodedPng(stored);
  packed.data.assign(12, 0);
  packed.data.insert(packed.data.end(), png.begin(), png.end());
  return packed;
}

TEST_F(BagJobs, SearchCompressedDepthImagesAsRawOnes) {
  const Detections raw = foundIn(jobOf({depthBag("16UC1")})).at(0);
  {
    rosbag::Bag bag(path("packed.bag"), rosbag::bagmode::Write);
    bag.write("/camera/depth/camera_info", headerAt(0).stamp, cameraInfo(headerAt(0), kCamera));
    bag.write("/camera/depth/image_raw/compressedDepth", headerAt(0).stamp,
              packed(*depthImage(headerAt(0), depthAt(0), kCamera, "16UC1")));
    sensor_msgs::CompressedImage colour;
    colour.format = "rgb8; jpeg compressed bgr8";
    bag.write("/camera/rgb/image_raw/compressed", headerAt(0).stamp, colour);
  }
  BagJob job = jobOf({path("packed.bag")});
  expectSame(foundIn(job).at(0), raw);
  {
    rosbag::Bag bag(path("packed.bag"), rosbag::bagmode::Append);
    bag.write("/camera/depth/image_raw", headerAt(1).stamp, depthImage(headerAt(1), depthAt(1), kCamera, "16UC1"));
  }
  std::vector<std::uint32_t> stamps;
  const BagOutcome outcome =
      detectInBags(job, [&stamps](const io::FrameReport& frame) { stamps.push_back(frame.nsecs); });
  EXPECT_EQ(outcome.topic, "/camera/depth/image_raw");  // recorded both ways: one image
  EXPECT_EQ(stamps, std::vector<std::uint32_t>{100000000u});
  job.topic = "/camera/rgb/image_raw/compressed";
  job.camera_info = "/camera/depth/camera_info";
  EXPECT_NE(problemsOf(job).at(0).find("'rgb8; jpeg compressed bgr8', expected is"), std::string::npos);
}

TEST_F(BagJobs, GiveThePixelsOfADepthImageTheirPlaces) {
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->width = 3, image->height = 2, image->encoding = "16UC1", image->step = 8;  // two bytes of padding
  image->data = {0xe8, 3, 0, 0, 0xd0, 7, 9, 9, 0, 0, 0xe8, 3, 0, 0, 9, 9};          // 1000 . 2000 / . 1000 . mm
  sensor_msgs::CameraInfo camera;
  camera.P = {100, 0, 1, 0, 0, 50, 0, 0, 0, 0, 1, 0};
  const auto cloud = cloudOf(image, camera);
  Cloud points;
  ASSERT_EQ(readCloud(*cloud, DepthRange(), {false, true}, points), "");
  EXPECT_EQ(points.valid_count, 3u);
  const auto expectAt = [&points](std::size_t i, float x, float y, float z) {
    EXPECT_FLOAT_EQ(points.x[i], x);
    EXPECT_FLOAT_EQ(points.y[i], y);
    EXPECT_FLOAT_EQ(points.z[i], z);
  };
  expectAt(0, -0.01f, 0.0f, 1.0f);
  expectAt(2, 0.02f, 0.0f, 2.0f);
  expectAt(4, 0.0f, 0.02f, 1.0f);
}

std::string refusalOf(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& camera) {
  try {
    cloudOf(boost::make_shared<sensor_msgs::Image>(image), camera);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

sensor_msgs::CameraInfo cameraWith(double focal_length) {
  sensor_msgs::CameraInfo camera;
  camera.P = {focal_length, 0, 1, 0, 0, focal_length, 0, 0, 0, 0, 1, 0};
  return camera;
}

std::string refusalOf(const sensor_msgs::Image& image, double focal_length = 100.0) {
  return refusalOf(image, cameraWith(focal_length));
}

TEST_F(BagJobs, TakeNoImageOrCameraThatCannotBeRight) {
  sensor_msgs::Image image;
  image.width = 2, image.height = 1, image.encoding = "mono16", image.step = 4;
  image.data = {1, 0, 2, 0};
  EXPECT_EQ(refusalOf(image), "");
  for (const double focal_length : {0.0, -1.0, std::nan("")}) {
    EXPECT_NE(refusalOf(image, focal_length).find("no focal length"), std::string::npos) << focal_length;
  }
  sensor_msgs::Image other = image;
  other.is_bigendian = 1;
  EXPECT_NE(refusalOf(other).find("big-endian"), std::string::npos);
  other = image;
  other.step = 5, other.data.resize(5);
  EXPECT_NE(refusalOf(other).find("rows of 5 bytes"), std::string::npos);
  other = image;
  other.height = 2;
  EXPECT_NE(refusalOf(other).find("has 4 bytes"), std::string::npos);
  other = image;
  other.width = 1u << 25, other.step = 1u << 26;
  EXPECT_NE(refusalOf(other).find("at most 16777216"), std::string::npos);
}

/// Of an image of 4 x 2 pixels.
std::string refusalOf(const sensor_msgs::CameraInfo& camera) {
  sensor_msgs::Image image;
  image.width = 4, image.height = 2, image.encoding = "16UC1", image.step = 8;
  image.data.resize(16);
  return refusalOf(image, camera);
}

TEST_F(BagJobs, TakeNoCameraOfAnotherSizeThanTheImages) {
  sensor_msgs::CameraInfo camera = cameraWith(100.0);
  EXPECT_EQ(refusalOf(camera), "") << "it does not tell its size";
  camera.width = 4, camera.height = 2;
  EXPECT_EQ(refusalOf(camera), "");
  camera.width = 8, camera.height = 4;
  EXPECT_EQ(refusalOf(camera), "the image has 4 x 2 pixels, and its camera_info is of 8 x 4");
  camera.binning_x = camera.binning_y = 2;
  EXPECT_EQ(refusalOf(camera), "");
  camera.width = 7, camera.height = 3;
  EXPECT_EQ(refusalOf(camera), "") << "rounded up";
  camera.width = 640, camera.height = 480;
  camera.roi.width = 8, camera.roi.height = 4;
  EXPECT_EQ(refusalOf(camera), "");
  camera.binning_x = camera.binning_y = 1;
  EXPECT_NE(refusalOf(camera).find("camera_info is of 8 x 4"), std::string::npos);
}

TEST_F(BagJobs, TakeSeveralBagsForOneRecordingWhoseTracksGoOn) {
  const std::string later = cloudBag("1.bag", 2, 2), earlier = cloudBag("0.bag", 0, 2);
  const std::vector<Detections> found = foundIn(jobOf({later, earlier}));
  ASSERT_EQ(found.size(), 4u);
  std::size_t went_on = 0;
  for (const Detection& item : found[3].items) went_on += item.age == 3 ? 1 : 0;
  EXPECT_GT(went_on, 3u);  // the table and most things on it, from the first frame on
}

TEST_F(BagJobs, BeginAndEndWhereTheyAreToldTo) {
  BagJob job = jobOf({cloudBag("clouds.bag", 0, 4)});
  job.start = 0.05;
  EXPECT_EQ(foundIn(job).size(), 3u);
  job.duration = 0.1;
  EXPECT_EQ(foundIn(job).size(), 1u);
  job.start = 5.0;
  EXPECT_NE(refusalOf(job).find("no cloud"), std::string::npos);
}

TEST_F(BagJobs, KnowTheTransformsOfTheRecordingFromItsBeginning) {
  tf2_msgs::TFMessage transforms;
  transforms.transforms.resize(1);
  geometry_msgs::TransformStamped& camera_in_base = transforms.transforms[0];
  camera_in_base.header.frame_id = "base";
  camera_in_base.child_frame_id = "camera";
  camera_in_base.transform.translation.x = 2.0;
  camera_in_base.transform.rotation.w = 1.0;
  const std::string clouds = cloudBag("clouds.bag", 0, 1);
  {
    rosbag::Bag late(path("late.bag"), rosbag::bagmode::Write);
    late.write("/tf_static", ros::Time(1005), transforms);
  }
  BagJob job = jobOf({clouds, path("late.bag")});
  const Detections in_camera = foundIn(job)[0];
  job.params.target_frame = "base";
  std::string frame_id;
  Detections in_base;
  detectInBags(job, [&](const io::FrameReport& frame) { frame_id = frame.frame_id, in_base = frame.detections; });
  EXPECT_EQ(frame_id, "base");
  ASSERT_EQ(in_base.items.size(), in_camera.items.size());
  for (std::size_t i = 0; i < in_base.items.size(); ++i) {
    const Vec3 moved = in_camera.items[i].extent.origin + Vec3(2.0, 0.0, 0.0);
    EXPECT_LT((in_base.items[i].extent.origin - moved).norm(), 1e-9);
  }
  job.params.target_frame = "map";
  EXPECT_NE(problemsOf(job)[0].find("to target_frame 'map'"), std::string::npos);
}

TEST_F(BagJobs, ShowAllPointsOfALargeImage) {
  const synthetic::PinholeCamera large = synthetic::PinholeCamera().scaledTo(1280, 960);
  const auto frame = synthetic::renderFrame(synthetic::tabletop(2), large, synthetic::cameraPose(0.1), {}, 2, 0);
  {
    rosbag::Bag bag(path("large.bag"), rosbag::bagmode::Write);
    bag.write("/camera/points", recordedAt(0), depthCloud(headerAt(0), frame.depth, large));
  }
  int shown = 0;
  detectInBags(
      jobOf({path("large.bag")}), [](const io::FrameReport&) {},
      [&shown](const io::FrameReport&, const io::LabelledPoints& points) {
        ++shown;
        EXPECT_EQ(points.cloud.size(), 1280u * 960u);
        EXPECT_EQ(points.labels.size(), points.cloud.size());
      });
  EXPECT_EQ(shown, 1);
}

/// The camera's frame, which moves along x by 1 m a second.
tf2_msgs::TFMessage cameraInBase(const ros::Time& stamp) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms[0].header.frame_id = "base";
  message.transforms[0].header.stamp = stamp;
  message.transforms[0].child_frame_id = "camera";
  message.transforms[0].transform.translation.x = (stamp - headerAt(0).stamp).toSec();
  message.transforms[0].transform.rotation.w = 1.0;
  return message;
}

TEST_F(BagJobs, ShowPointsAsTheSensorSawThemWhereverPrimitivesAreWanted) {
  const std::string clouds = cloudBag("clouds.bag", 0, 1);
  {
    rosbag::Bag bag(path("tf.bag"), rosbag::bagmode::Write);
    bag.write("/tf_static", headerAt(0).stamp, cameraInBase(headerAt(0).stamp + ros::Duration(5.0)));
  }
  BagJob job = jobOf({clouds, path("tf.bag")});
  job.params.target_frame = "base";
  job.params.max_depth = 1.0;
  const std::vector<float> depth = depthAt(0);
  int shown = 0;
  detectInBags(
      job, [&shown](const io::FrameReport&) { EXPECT_EQ(shown, 0); },
      [&](const io::FrameReport& frame, const io::LabelledPoints& points) {
        ++shown;
        ASSERT_EQ(points.cloud.size(), depth.size());
        ASSERT_EQ(points.labels.size(), depth.size());
        EXPECT_EQ(points.used.max, 1.0f);
        ASSERT_GT(points.detections.items.size(), 1u);
        ASSERT_EQ(points.detections.items.size(), frame.detections.items.size());
        std::size_t labelled = 0, farther = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
          if (!(depth[i] > 0.0f)) continue;
          EXPECT_EQ(points.cloud.z[i], depth[i]);  // not cut at max_depth
          farther += depth[i] > 1.0f ? 1 : 0;
          if (points.labels[i] == 0) continue;
          ++labelled;
          EXPECT_LE(depth[i], 1.0f);
          EXPECT_LT(std::abs(distance(points.detections.items.at(points.labels[i] - 1).shape, points.cloud.point(i))),
                    0.02);
        }
        EXPECT_GT(labelled, 1000u);
        EXPECT_GT(farther, 1000u);
        EXPECT_NEAR(frame.detections.items[0].extent.origin.x() - points.detections.items[0].extent.origin.x(), 5.0,
                    1e-6);
      });
  EXPECT_EQ(shown, 1);
}

TEST_F(BagJobs, FollowTransformsThatMoveWhateverTheirOrder) {
  const std::string clouds = cloudBag("clouds.bag", 0, 3);
  {
    rosbag::Bag moving(path("tf.bag"), rosbag::bagmode::Write);
    for (const int k : {3, 0, 1}) moving.write("/tf", recordedAt(5), cameraInBase(headerAt(k).stamp));
    tf2_msgs::TFMessage broken = cameraInBase(headerAt(0).stamp);
    broken.transforms[0].header.stamp = ros::Time(4294967295u, 0);  // tf2 would reach beyond 32 bits of seconds
    moving.write("/tf", recordedAt(5), broken);
  }
  BagJob job = jobOf({clouds, path("tf.bag")});
  const std::vector<Detections> in_camera = foundIn(job);
  job.params.target_frame = "base";
  std::vector<Detections> in_base;
  const BagOutcome outcome =
      detectInBags(job, [&](const io::FrameReport& frame) { in_base.push_back(frame.detections); });
  EXPECT_EQ(outcome.unusable_transforms, 1u);
  ASSERT_EQ(in_base.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(in_base[k].items.size(), in_camera[k].items.size());
    const double moved = in_base[k].items.at(0).extent.origin.x() - in_camera[k].items.at(0).extent.origin.x();
    EXPECT_NEAR(moved, 0.1 * static_cast<double>(k), 1e-9);
  }
  job.params.target_frame = "";
  job.params.sensor_frame = "base";  // only to be looked up
  std::vector<Detections> from_base;
  detectInBags(job, [&](const io::FrameReport& frame) { from_base.push_back(frame.detections); });
  ASSERT_EQ(from_base.size(), 3u);
  for (const Detections& found : from_base) EXPECT_EQ(found.status, Status::ok);
}

TEST_F(BagJobs, SayThatThereAreNoTransforms) {
  BagJob job = jobOf({cloudBag("clouds.bag", 0, 1)});
  job.params.target_frame = "base";
  EXPECT_NE(problemsOf(job)[0].find("holds no transforms"), std::string::npos);
}

TEST_F(BagJobs, BeginTracksAndMarkersAnewWhereStampsGoBack) {
  BagJob job;
  {
    rosbag::Bag bag(path("looped.bag"), rosbag::bagmode::Write);
    int recorded = 0;
    for (const int k : {4, 5, 0, 1}) {
      bag.write("/camera/points", recordedAt(10 + recorded++), depthCloud(headerAt(k), depthAt(k), kCamera));
    }
  }
  job = jobOf({path("looped.bag")});
  job.output = path("found.bag");
  std::vector<std::uint32_t> oldest;  // in each frame
  for (const Detections& found : foundIn(job)) {
    oldest.push_back(0);
    for (const Detection& item : found.items) oldest.back() = std::max(oldest.back(), item.age);
  }
  EXPECT_EQ(oldest, (std::vector<std::uint32_t>{0, 1, 0, 1}));
  std::vector<bool> cleared;
  rosbag::Bag written(job.output);
  for (const rosbag::MessageInstance& message : rosbag::View(written, rosbag::TopicQuery("/detector/markers"))) {
    const auto shown = message.instantiate<visualization_msgs::MarkerArray>();
    cleared.push_back(shown->markers.at(0).action == visualization_msgs::Marker::DELETEALL);
  }
  EXPECT_EQ(cleared, (std::vector<bool>{true, false, true, false}));
}

TEST_F(BagJobs, TakeTheLastCameraBeforeAnImageAlsoFromBeforeTheirTime) {
  {
    rosbag::Bag bag(path("cameras.bag"), rosbag::bagmode::Write);
    sensor_msgs::CameraInfo wrong = *cameraInfo(headerAt(0), kCamera), right = wrong;
    wrong.P[0] = wrong.P[5] = 10.0 * right.P[0];
    bag.write("/camera/depth/camera_info", recordedAt(0), wrong);
    bag.write("/camera/depth/camera_info", recordedAt(1), right);
    bag.write("/camera/depth/image_raw", recordedAt(2), depthImage(headerAt(2), depthAt(2), kCamera, "16UC1"));
    bag.write("/camera/depth/camera_info", recordedAt(3), wrong);
  }
  BagJob job = jobOf({path("cameras.bag")});
  FramePipeline pipeline{Params()};
  const auto image = depthImage(headerAt(2), depthAt(2), kCamera, "16UC1");
  const Detections right = fromMessage(pipeline.process(*cloudOf(image, *cameraInfo(headerAt(2), kCamera))));
  expectSame(foundIn(job).at(0), right);
  EXPECT_EQ(detectInBags(job, [](const io::FrameReport&) {}).unpaired_images, 1u) << "none has its stamp";
  job.start = 0.15;  // after both cameras
  expectSame(foundIn(job).at(0), right);
}

TEST_F(BagJobs, TakeTheCameraWithTheStampOfAnImageAlsoFromAfterIt) {
  {
    rosbag::Bag bag(path("cameras.bag"), rosbag::bagmode::Write);
    sensor_msgs::CameraInfo right = *cameraInfo(headerAt(1), kCamera), wrong = *cameraInfo(headerAt(0), kCamera);
    wrong.P[0] = wrong.P[5] = 10.0 * right.P[0];
    bag.write("/camera/depth/camera_info", recordedAt(0), wrong);
    bag.write("/camera/depth/image_raw", recordedAt(1), depthImage(headerAt(1), depthAt(1), kCamera, "16UC1"));
    bag.write("/camera/depth/camera_info", recordedAt(2), right);
  }
  FramePipeline pipeline{Params()};
  const auto image = depthImage(headerAt(1), depthAt(1), kCamera, "16UC1");
  const BagJob job = jobOf({path("cameras.bag")});
  expectSame(foundIn(job).at(0), fromMessage(pipeline.process(*cloudOf(image, *cameraInfo(headerAt(1), kCamera)))));
  EXPECT_EQ(detectInBags(job, [](const io::FrameReport&) {}).unpaired_images, 0u);
}

TEST_F(BagJobs, FindTopicsThatWereRecordedWithoutASlash) {
  {
    rosbag::Bag bag(path("names.bag"), rosbag::bagmode::Write);
    bag.write("camera_info", headerAt(0).stamp, cameraInfo(headerAt(0), kCamera));
    bag.write("image", headerAt(0).stamp, depthImage(headerAt(0), depthAt(0), kCamera, "16UC1"));
  }
  BagJob job = jobOf({path("names.bag")});
  EXPECT_GT(foundIn(job).at(0).items.size(), 3u);
  job.topic = "/image";
  job.camera_info = "/camera_info";
  EXPECT_GT(foundIn(job).at(0).items.size(), 3u);
}

TEST_F(BagJobs, TellStampAndFrameOfAnImageThatCannotBeUnpacked) {
  {
    rosbag::Bag bag(path("rvl.bag"), rosbag::bagmode::Write);
    sensor_msgs::CompressedImage image = packed(*depthImage(headerAt(1), depthAt(1), kCamera, "16UC1"));
    image.format = "16UC1; compressedDepth rvl";
    bag.write("/camera/depth/camera_info", headerAt(1).stamp, cameraInfo(headerAt(1), kCamera));
    bag.write("/camera/depth/image_raw/compressedDepth", headerAt(1).stamp, image);
  }
  detectInBags(jobOf({path("rvl.bag")}), [](const io::FrameReport& frame) {
    EXPECT_NE(frame.problem.find("not RVL"), std::string::npos) << frame.problem;
    EXPECT_EQ(frame.frame_id, "camera");
    EXPECT_EQ(frame.nsecs, 100000000u);
    EXPECT_FALSE(frame.damaged);
  });
}

TEST_F(BagJobs, SayThatTheBagIsDamagedWhereAMessageRunsBeyondItsEnd) {
  std::string bytes = read(depthBag("16UC1"));
  const std::size_t length = bytes.rfind(test::bytesOf<std::uint32_t>({5}) + "16UC1");  // of the last one's encoding
  ASSERT_NE(length, std::string::npos);
  bytes[length + 2] = '\x7f';
  write("depth.bag", bytes);
  std::vector<bool> damaged;
  std::string problem;
  detectInBags(jobOf({path("depth.bag")}), [&](const io::FrameReport& frame) {
    damaged.push_back(frame.damaged);
    problem = frame.problem;
  });
  EXPECT_EQ(damaged, (std::vector<bool>{false, true}));
  EXPECT_NE(problem.find("the bag is damaged there: "), std::string::npos) << problem;
}

TEST_F(BagJobs, LeaveABagOfPrimitivesAndMarkers) {
  BagJob job = jobOf({cloudBag("clouds.bag", 0, 2)});
  job.output = path("found.bag");
  const std::vector<Detections> found = foundIn(job);
  rosbag::Bag written(job.output);
  std::size_t primitives = 0, markers = 0;
  for (const rosbag::MessageInstance& message : rosbag::View(written)) {
    if (const auto array = message.instantiate<PrimitiveArray>()) {
      ASSERT_LT(primitives, found.size());
      EXPECT_EQ(message.getTopic(), "/detector/primitives");
      EXPECT_EQ(message.getTime(), recordedAt(static_cast<int>(primitives)));
      EXPECT_EQ(array->header.stamp, headerAt(static_cast<int>(primitives)).stamp);
      expectSame(fromMessage(*array), found[primitives++]);
    } else if (const auto shown = message.instantiate<visualization_msgs::MarkerArray>()) {
      EXPECT_EQ(message.getTopic(), "/detector/markers");
      EXPECT_GT(shown->markers.size(), found[markers++].items.size());  // names, too
    }
  }
  EXPECT_EQ(primitives, 2u);
  EXPECT_EQ(markers, 2u);
}

TEST_F(BagJobs, LeaveNoBagWhereTheyDoNotEnd) {
  BagJob job = jobOf({cloudBag("clouds.bag", 0, 2)});
  job.output = path("found.bag");
  EXPECT_THROW(detectInBags(job, [](const io::FrameReport&) { throw std::runtime_error("full"); }), std::runtime_error);
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(path("")).parent_path()))
    left.push_back(entry.path().filename());
  EXPECT_EQ(left, std::vector<std::string>{"clouds.bag"});
}

TEST_F(BagJobs, SayWhichTopicsThereAreWhereNoneIsTheOne) {
  const std::string bag = path("two.bag");
  {
    rosbag::Bag two(bag, rosbag::bagmode::Write);
    for (const char* topic : {"/left/points", "/right/points"}) {
      two.write(topic, headerAt(0).stamp, depthCloud(headerAt(0), depthAt(0), kCamera));
    }
  }
  const std::string which = refusalOf(jobOf({bag}));
  EXPECT_NE(which.find("/left/points (sensor_msgs/PointCloud2), /right/points"), std::string::npos) << which;
  {
    rosbag::Bag two(bag, rosbag::bagmode::Append);
    two.write("/rgb/image_raw", headerAt(0).stamp, depthImage(headerAt(0), depthAt(0), kCamera, "16UC1"));
  }
  EXPECT_NE(refusalOf(jobOf({bag})).find("which topic?"), std::string::npos);
  BagJob job = jobOf({bag});
  job.topic = "/right/points";
  job.camera_info = "/rgb/camera_info";
  EXPECT_NE(refusalOf(job).find("is of depth images"), std::string::npos);
  job.camera_info = "";
  job.topic = "right/points";
  EXPECT_EQ(foundIn(job).size(), 1u);
  job.topic = "/middle/points";
  EXPECT_NE(refusalOf(job).find("no topic /middle/points"), std::string::npos);
}

TEST_F(BagJobs, AskForTheCameraOfADepthImage) {
  BagJob job = jobOf({depthBag("32FC1", "/elsewhere/camera_info")});
  const std::string refusal = refusalOf(job);
  EXPECT_NE(refusal.find("/camera/depth/camera_info is none"), std::string::npos) << refusal;
  job.camera_info = "/elsewhere/camera_info";
  EXPECT_GT(foundIn(job).at(0).items.size(), 3u);
  {
    rosbag::Bag bag(path("root.bag"), rosbag::bagmode::Write);
    bag.write("/camera_info", headerAt(0).stamp, cameraInfo(headerAt(0), kCamera));
    bag.write("/compressedDepth", headerAt(0).stamp, packed(*depthImage(headerAt(0), depthAt(0), kCamera, "16UC1")));
  }
  EXPECT_GT(foundIn(jobOf({path("root.bag")})).at(0).items.size(), 3u);
}

TEST_F(BagJobs, GoOnAfterAnImageThatIsNoneOfDepths) {
  const std::string bag = path("colour.bag");
  {
    rosbag::Bag colour(bag, rosbag::bagmode::Write);
    colour.write("/camera/depth/camera_info", headerAt(0).stamp, cameraInfo(headerAt(0), kCamera));
    sensor_msgs::ImagePtr image = depthImage(headerAt(0), depthAt(0), kCamera, "16UC1");
    image->encoding = "rgb8";
    colour.write("/camera/depth/image_raw", headerAt(0).stamp, image);
    image = depthImage(headerAt(1), depthAt(1), kCamera, "16UC1");
    image->data.resize(image->data.size() / 2);
    colour.write("/camera/depth/image_raw", headerAt(1).stamp, image);
    image = depthImage(headerAt(2), depthAt(2), kCamera, "16UC1");
    colour.write("/camera/depth/image_raw", headerAt(2).stamp, image);
  }
  const std::vector<std::string> problems = problemsOf(jobOf({bag}));
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_NE(problems[0].find("'rgb8', expected is one of depths"), std::string::npos) << problems[0];
  EXPECT_NE(problems[1].find("320 x 240 pixels"), std::string::npos) << problems[1];
  EXPECT_EQ(problems[2], "");
  EXPECT_EQ(foundIn(jobOf({bag}))[0].status, Status::rejected_input);
}

TEST_F(BagJobs, RefuseWhatIsNoBag) {
  const std::string refusal = refusalOf(jobOf({write("no.bag", "no bag")}));
  EXPECT_EQ(refusal.find(path("no.bag")), 0u) << refusal;
  EXPECT_EQ(refusalOf(jobOf({path("none.bag")})), path("none.bag") + ": no such file");
  EXPECT_EQ(refusalOf(jobOf({path("")})), path("") + ": is a folder, expected is a bag");
}

}  // namespace
}  // namespace primitect::bag_job_test
