// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Detections to JSON; the keys keep their order.
#include "io/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/shape_json.h"

namespace primitect::io {
namespace {

using Json = nlohmann::ordered_json;

Json knownOrNull(float value) { return value == kUnknown ? Json(nullptr) : Json(value); }

Json unseenEndsJson(std::uint8_t ends) {
  if (ends & kEndsUnknown) return nullptr;
  Json json = Json::array();
  if (ends & kEndAtMinusZ) json.push_back("minus_z");
  if (ends & kEndAtPlusZ) json.push_back("plus_z");
  return json;
}

Json faceJson(std::int32_t face) { return face == kNoFace ? Json(nullptr) : Json(face); }

/// The keys that mean something for the kind.
Json extentJson(const Detection& detection) {
  const Extent& extent = detection.extent;
  const Kind kind = kindOf(detection.shape);
  Json json;
  json["origin"] = vectorJson(extent.origin);
  if (kind == Kind::sphere) return json;
  json["x_axis"] = vectorJson(extent.rotation.col(0));
  json["z_axis"] = vectorJson(extent.rotation.col(2));
  if (kind == Kind::plane) {
    json["size"] = Json::array({extent.size.x(), extent.size.y()});
    json["hull"] = Json::array();
    for (const Vec3& corner : extent.hull) json["hull"].push_back(vectorJson(corner));
    return json;
  }
  json["length"] = extent.size.z();
  json["unseen_ends"] = unseenEndsJson(extent.unseen_ends);
  json["face_at_minus_z"] = faceJson(extent.face_at_minus_z);
  json["face_at_plus_z"] = faceJson(extent.face_at_plus_z);
  if (kind == Kind::cone) {
    json["radius_large"] = extent.radius;
    json["radius_small"] = extent.radius_small;
  }
  return json;
}

Json truncatedJson(std::uint8_t truncated) {
  if (truncated == kTruncationUnknown) return nullptr;  // else only depth is told
  Json json = Json::array();
  if (truncated & kTruncatedByImage) json.push_back("image");
  if (truncated & kTruncatedByDepth) json.push_back("depth");
  if (truncated & kTruncatedByOcclusion) json.push_back("occlusion");
  return json;
}

Json primitiveJson(const Detection& detection) {
  Json json = shapeJson(detection.shape);
  json["inliers"] = detection.inlier_count;
  json["votes"] = detection.votes;
  json["rms_error"] = knownOrNull(detection.rms_error);
  json["confidence"] = knownOrNull(detection.confidence);
  json["rival"] = detection.rival ? Json(kindName(*detection.rival)) : Json(nullptr);
  json["coverage"] = knownOrNull(detection.coverage);
  json["radius_stddev"] = knownOrNull(detection.radius_stddev);
  json["half_angle_stddev"] = knownOrNull(detection.half_angle_stddev);
  json["position_stddev"] = knownOrNull(detection.position_stddev);
  json["axis_stddev"] = knownOrNull(detection.axis_stddev);
  json["covariance"] = detection.covariance[0] == -1.0 ? Json(nullptr) : Json(detection.covariance);
  json["concave"] = detection.concave;
  json["truncated"] = truncatedJson(detection.truncated);
  json["extent"] = extentJson(detection);
  if (detection.track_id == 0) return json;
  json["track_id"] = detection.track_id;
  json["age"] = detection.age;
  return json;
}

Json refusalsJson(const Refusals& refusals) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kRefusalCount; ++i) {
    json[refusalName(static_cast<Refusal>(i))] = refusals.counts[i];
  }
  return json;
}

Json poseJson(const SensorPose& pose) {
  const Eigen::Quaterniond& turn = pose.orientation;
  Json json;
  json["position"] = vectorJson(pose.position);
  json["orientation"] = Json::array({turn.x(), turn.y(), turn.z(), turn.w()});
  return json;
}

const char* clueName(CameraClue clue) {
  return clue == CameraClue::image ? "image" : clue == CameraClue::order ? "order" : "shadows";
}

Json sensorJson(const FileReport& report) {
  if (!report.sensor) return nullptr;
  Json json = poseJson(*report.sensor);
  json["from"] = report.found_by ? clueName(*report.found_by) : "option";
  return json;
}

Json timingJson(const Timing& timing) {
  Json json = Json::object();
  for (const auto& [stage, milliseconds] : timing) json[stage] = milliseconds;
  return json;
}

Json primitivesJson(const Detections& found) {
  Json json = Json::array();
  for (const Detection& detection : found.items) json.push_back(primitiveJson(detection));
  return json;
}

/// null: no plane tells.
Json wavesJson(const Detections& found) { return found.depth_waves < 0.0 ? Json(nullptr) : Json(found.depth_waves); }

Json fileJson(const FileReport& report) {
  Json json;
  json["file"] = report.file;
  if (!report.error.empty()) {
    json["error"] = report.error;
    json["primitives"] = Json::array();
    return json;
  }
  const Detections& found = report.detections;
  json["status"] = statusName(found.status);
  json["points_in"] = found.points_in;
  json["points_used"] = found.points_used;
  json["samples"] = found.samples;
  if (report.effort) json["effort"] = *report.effort;
  json["scene_diameter"] = found.scene_diameter;
  json["image_noise"] = found.image_noise;
  json["depth_waves"] = wavesJson(found);
  json["seen_from_origin"] = found.seen_from_origin;
  json["sensor"] = sensorJson(report);
  json["refused"] = refusalsJson(found.refusals);
  json["primitives"] = primitivesJson(found);
  const std::vector<std::string> without = namesOf(report.left_out);
  if (!without.empty()) json["without"] = without;
  if (report.late) json["late"] = primitivesJson(*report.late);
  if (report.unlikely) json["unlikely"] = primitivesJson(*report.unlikely);
  if (report.few_inliers) json["few_inliers"] = primitivesJson(*report.few_inliers);
  json["timing_ms"] = timingJson(report.timing_ms);
  if (report.repeats > 1) {
    json["repeats"] = report.repeats;
    json["timing_min_ms"] = timingJson(report.min_ms);
    json["timing_max_ms"] = timingJson(report.max_ms);
  }
  return json;
}

Json frameObject(const FrameReport& report) {
  const Detections& found = report.detections;
  Json json;
  json["stamp"] = {{"secs", report.secs}, {"nsecs", report.nsecs}};
  json["frame_id"] = report.frame_id;
  json["status"] = statusName(found.status);
  json["problem"] = report.problem.empty() ? Json(nullptr) : Json(report.problem);
  json["points_in"] = found.points_in;
  json["points_used"] = found.points_used;
  json["samples"] = found.samples;
  json["depth_waves"] = wavesJson(found);
  json["seen_from_origin"] = found.seen_from_origin;
  json["sensor"] = report.found_sensor ? poseJson(*report.found_sensor) : Json(nullptr);
  json["processing_ms"] = report.processing_ms;
  json["refused"] = refusalsJson(found.refusals);
  json["primitives"] = primitivesJson(found);
  return json;
}

/// In one line. Names need not be UTF-8: bytes that are not become a replacement character instead of an exception.
std::string dumpLine(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

bool allNumbers(const Json& list) {
  return std::all_of(list.begin(), list.end(), [](const Json& item) { return item.is_number(); });
}

/// One line a key, vectors on one line: a person can read it, too.
std::string dump(const Json& json, const std::string& indent = "") {
  const bool open_up = (json.is_object() || (json.is_array() && !allNumbers(json))) && !json.empty();
  if (!open_up) return dumpLine(json);
  const std::string deeper = indent + "  ";
  std::string text = json.is_object() ? "{" : "[";
  for (auto item = json.begin(); item != json.end(); ++item) {
    text += (item == json.begin() ? "\n" : ",\n") + deeper;
    if (json.is_object()) text += Json(item.key()).dump() + ": ";
    text += dump(*item, deeper);
  }
  return text + "\n" + indent + (json.is_object() ? "}" : "]");
}

}  // namespace

std::string reportJson(const FileReport& report) { return dump(fileJson(report)) + "\n"; }

std::string reportsJson(const std::vector<FileReport>& reports) {
  Json json = Json::array();
  for (const FileReport& report : reports) json.push_back(fileJson(report));
  return dump(json) + "\n";
}

std::string frameJson(const FrameReport& report) { return dumpLine(frameObject(report)) + "\n"; }

}  // namespace primitect::io
