// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Questions about units, frames and intrinsics, and what to expect of noise.
#include "tools/notes.h"

#include "core/wanted_kinds.h"
#include "io/depths_text.h"
#include "io/share_beyond.h"
#include "primitect/noisy_image.h"
#include "tools/format.h"

namespace primitect::tools {
namespace {

/// Of an image in millimetres the range of depths leaves nothing whose size would tell.
std::string unitsText(const Detections& found, const Cloud& seen) {
  const bool nothing_left = found.points_used == 0 && io::mayBeInMillimetres(seen);
  if (found.scene_diameter <= io::kMillimetres && !nothing_left) return "";
  return "  note: lengths are taken for metres; are they millimetres?\n";
}

std::uint32_t countBehind(const io::SensorPose& sensor, Cloud points) {
  points.move(sensor.pointsFromSensor().inverse(), DepthRange());
  return points.behind_count;
}

/// As PCL means it, or where that puts more points behind the sensor, as those write it whose x looks ahead.
io::SensorPose sensorAt(const io::SensorPose& viewpoint, const Cloud& points) {
  const Eigen::Quaterniond body_from_optical(0.5, -0.5, 0.5, -0.5);  // REP 103: x ahead, z up
  const io::SensorPose turned = {viewpoint.position, viewpoint.orientation * body_from_optical};
  return countBehind(viewpoint, points) <= countBehind(turned, points) ? viewpoint : turned;
}

std::string sensorAdvice(const io::PointFile& file) {
  if (!file.viewpoint) return "If not, --sensor says where the camera was";
  return "If not, the VIEWPOINT of the file may say where the camera was: try --sensor \"" +
         io::sensorPoseText(sensorAt(*file.viewpoint, file.cloud)) + "\"";
}

std::string foundSensorText(const DetectInput& input) {
  if (!input.found_by) return "";
  const std::string what =
      *input.found_by == CameraClue::image   ? "an image that was moved to another frame; its rows and columns tell"
      : *input.found_by == CameraClue::order ? "a list that was moved to another frame; their order tells"
                                             : "a list that was moved to another frame; the shadows of things on a "
                                               "plane tell, to some centimetres,";
  return "  note: the points are " + what + " where the camera was: --sensor \"" + io::sensorPoseText(*input.sensor) +
         (*input.found_by == CameraClue::shadows ? "\" is used (docs/files.md, Points in another frame)\n"
                                                 : "\" is used\n");
}

/// Clouds of robots and maps have their table or floor through the origin.
std::string otherFrameText(const Detections& found, const DetectInput& input) {
  const Cloud& seen = input.seen();
  std::string what = "the points were not seen from the sensor";
  if (seen.liesBehind()) {
    what = format("%.0f %% of the points lie behind the sensor (z <= 0)", 100.0 * seen.behind_count / seen.valid_count);
  } else if (found.seen_from_origin) {
    return "";
  }
  if (input.sensor && !input.found_by) {
    return "  note: " + what +
           "; is --sensor the pose of the camera's optical frame (z ahead, x right, y down) in the frame of the "
           "file?\n";
  }
  if (input.found_by) return "  note: " + what + "; are some of them those of another camera?\n";
  return "  note: " + what +
         ", which is taken to be at the origin and to look along z; is the cloud in the frame of the camera? " +
         sensorAdvice(input.file) + "\n";
}

std::string beyondText(const DetectInput& input) {
  const double share = io::shareBeyond(input.cloud);
  if (share < io::kMuchBeyond || input.cloud.valid_count == 0) return "";
  return format(
      "  note: %.0f %% of what was measured lies beyond max_depth (%.4g m) and is left out; --max_depth says "
      "how far to look\n",
      100.0 * share, input.range.max);
}

/// Of points in no order that may have been seen from the origin nothing tells where the sensor was; images, and lists
/// in their order, do. Normals of a file stay as they are.
std::string assumedOriginText(const Detections& found, const DetectInput& input) {
  const bool assumed = found.seen_from_origin && !input.sensor && !input.seen().liesBehind();
  if (!assumed || input.cloud.valid_count == 0 || input.cloud.organized() || input.cloud.hasNormals() ||
      input.sensor_at_origin)
    return "";
  return "  note: a list of points without normals is taken for seen from its origin along z; --sensor says where else "
         "the camera was\n";
}

std::string normalsText(const Detections& found) {
  if (!found.normals_face_away) return "";
  return "  note: most normals of the file face away from the sensor: --sensor says where the camera was; if it was "
         "at the origin, they are inward, and what is seen from outside passes for hollow and is missed: "
         "--orient_normals true turns them\n";
}

std::string noiseText(const Detections& found) {
  if (found.image_noise < kNoisyImage) return "";
  return format(
      "  note: points stray %.1f times as far as those of structured light: small things are missed, "
      "positions less exact; nearer, or with the camera's own filters, more is found (docs/tuning.md, The noise)\n",
      found.image_noise);
}

/// From half of the noise of structured light at 1 m on.
std::string wavesText(const Detections& found) {
  constexpr double kLeast = 0.001;
  if (found.depth_waves < kLeast) return "";
  return format(
      "  note: the camera bends what it sees, by %.2f %% of the depth in waves over the image: standard deviations "
      "include it (docs/tuning.md, A camera that bends)\n",
      100.0 * found.depth_waves);
}

/// Written in another order, as that of the camera's matrix, or those of an image of another size, they put the middle
/// of the image far aside.
std::string intrinsicsText(const io::PointFile& read) {
  if (!read.intrinsics) return "";
  const double right = read.intrinsics->cx / read.cloud.width, down = read.intrinsics->cy / read.cloud.height;
  const auto central = [](double share) { return 0.3 <= share && share <= 0.7; };
  if (central(right) && central(down)) return "";
  return format(
      "  note: the principal point (%g, %g) is far from the middle of the image; is the order fx,fy,cx,cy, "
      "for %u x %u pixels?\n",
      read.intrinsics->cx, read.intrinsics->cy, read.cloud.width, read.cloud.height);
}

/// What was switched off is not found, however well it is seen.
std::string notLookedForText(const Params& params) {
  std::string what, by;
  const auto add = [&](const std::string& shapes, const std::string& parameter) {
    what += (what.empty() ? "" : ", ") + shapes;
    by += (by.empty() ? "" : ", ") + parameter;
  };
  for (const Kind kind : {Kind::plane, Kind::sphere, Kind::cylinder, Kind::cone}) {
    const std::string kinds = std::string(kindName(kind)) + "s";
    if (!isWanted(kind, params)) add(kinds, "detect_" + kinds);
  }
  if (params.convexity == "concave") add("outsides of curved shapes", "convexity");
  return what.empty() ? "" : "  note: not looked for: " + what + " (" + by + ")\n";
}

std::string leftOutText(const Params& params) {
  std::string names;
  for (const std::string& name : namesOf(params.left_out)) names += (names.empty() ? "" : ", ") + name;
  if (names.empty()) return "";
  return "  note: without " + names + (params.verify ? "" : ", which does nothing where verify is off") + "\n";
}

}  // namespace

std::string ignoredFramesText(const DetectOptions& options) {
  const Params params = options.params.asSaid();
  std::string text;
  const auto add = [&](const std::string& name, const std::string& frame, const std::string& advice) {
    if (!frame.empty()) text += "detect: note: " + name + " '" + frame + "' is for the ROS node only; " + advice + "\n";
  };
  if (!options.sensor) add("sensor_frame", params.sensor_frame, "here --sensor says where the camera was");
  add("target_frame", params.target_frame, "here results are in the frame of the file");
  return text;
}

std::string notesText(const Detections& found, const DetectInput& input) {
  return unitsText(found, input.seen()) + intrinsicsText(input.file) + foundSensorText(input) +
         otherFrameText(found, input) + assumedOriginText(found, input) + normalsText(found) + beyondText(input) +
         noiseText(found) + wavesText(found) + notLookedForText(input.params) + leftOutText(input.params);
}

}  // namespace primitect::tools
