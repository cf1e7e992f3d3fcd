// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// latency_observer: which frames cameras sent and when which primitives came back, as JSON. It listens to camera_info,
// which is small and has the stamp of the cloud, so that watching costs nothing that counts.
#include <primitect/PrimitiveArray.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <deque>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> cameras = {"/camera"}, detectors = {"/detector"};
  double seconds = 5.0;
  double patience = 60.0;  ///< s, until then
  std::size_t after = 20;  ///< frames that each camera must have sent, and one answer of each detector
  double drain = 1.0;      ///< s, for the answers to the last frames
  std::string out;
};

/// One camera and its detector.
struct Pair {
  std::vector<double> sent;  ///< stamps
  struct Answer {
    double stamp, received, processing_time;
    std::size_t primitives;
    std::uint32_t samples;
  };
  std::vector<Answer> answers;
  ros::Subscriber info, primitives;
};

/// Nanoseconds would be lost in a double since 1970: stamps count from here.
double secondsSince(const ros::Time& origin, const ros::Time& time) { return (time - origin).toSec(); }

void subscribe(const Options& options, const ros::Time& origin, ros::NodeHandle& node, std::deque<Pair>& pairs) {
  constexpr std::uint32_t kQueue = 1000;
  const ros::TransportHints fast = ros::TransportHints().tcpNoDelay();
  for (std::size_t k = 0; k < options.cameras.size(); ++k) {
    pairs.emplace_back();
    Pair* const pair = &pairs.back();
    pair->info = node.subscribe<sensor_msgs::CameraInfo>(
        options.cameras[k] + "/depth/camera_info", kQueue,
        [=](const sensor_msgs::CameraInfoConstPtr& info) {
          pair->sent.push_back(secondsSince(origin, info->header.stamp));
        },
        ros::VoidConstPtr(), fast);
    pair->primitives = node.subscribe<primitect::PrimitiveArray>(
        options.detectors[k] + "/primitives", kQueue,
        [=](const primitect::PrimitiveArrayConstPtr& message) {
          pair->answers.push_back({secondsSince(origin, message->header.stamp), secondsSince(origin, ros::Time::now()),
                                   message->processing_time, message->primitives.size(), message->samples});
        },
        ros::VoidConstPtr(), fast);
  }
}

/// Callbacks as they come, until the time is over or the condition holds.
template <class Condition>
void spinFor(double seconds, const Condition& enough) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (ros::ok() && ros::WallTime::now() < end && !enough()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
}

Json toJson(const std::deque<Pair>& pairs, const ros::Time& origin, double begin, double end) {
  Json list = Json::array();
  for (const Pair& pair : pairs) {
    Json answers = Json::array();
    for (const Pair::Answer& a : pair.answers) {
      answers.push_back({a.stamp, a.received, a.processing_time, a.primitives, a.samples});
    }
    list.push_back({{"sent", pair.sent}, {"answers", answers}});
  }
  return {{"origin", origin.toSec()},
          {"begin", begin},
          {"end", end},
          {"answer_columns", {"stamp", "received", "processing_time", "primitives", "samples"}},
          {"pairs", list}};
}

int observe(const Options& options) {
  ros::NodeHandle node;
  const ros::Time origin = ros::Time::now();
  std::deque<Pair> pairs;
  subscribe(options, origin, node, pairs);
  const auto warm = [&] {
    for (const Pair& pair : pairs) {
      if (pair.answers.empty() || pair.sent.size() < options.after) return false;
    }
    return true;
  };
  spinFor(options.patience, warm);
  if (!warm()) {
    std::fprintf(stderr, "latency_observer: too few camera_info or no primitives within %g s\n", options.patience);
    return 1;
  }
  // What reads the processes' times waits for these lines.
  const double begin = secondsSince(origin, ros::Time::now());
  std::printf("begin\n");
  std::fflush(stdout);
  spinFor(options.seconds, [] { return false; });
  const double end = secondsSince(origin, ros::Time::now());
  std::printf("end\n");
  std::fflush(stdout);
  spinFor(options.drain, [] { return false; });
  std::ofstream file(options.out);
  file << toJson(pairs, origin, begin, end) << "\n" << std::flush;
  return file ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "latency_observer", ros::init_options::AnonymousName);
  CLI::App app{"Stamps of the frames that cameras sent, and when the primitives of each came back; JSON."};
  Options options;
  app.add_option("--camera", options.cameras, "namespace of each camera");
  app.add_option("--detector", options.detectors, "name of the detector of each camera");
  app.add_option("--after", options.after, "frames of each camera before it begins")->capture_default_str();
  app.add_option("--seconds", options.seconds, "how long from then on")->capture_default_str();
  app.add_option("--patience", options.patience, "s, until then")->capture_default_str();
  app.add_option("--out", options.out, "JSON file")->required();
  CLI11_PARSE(app, argc, argv);
  if (options.cameras.size() != options.detectors.size()) {
    std::fprintf(stderr, "latency_observer: as many --camera as --detector\n");
    return 2;
  }
  return observe(options);
}
