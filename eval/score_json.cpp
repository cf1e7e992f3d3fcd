// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scores to JSON; see score_json.h.
#include "eval/score_json.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "eval/data_sets.h"
#include "eval/extent_errors.h"
#include "eval/label_score.h"
#include "eval/nees.h"
#include "eval/peers/peers.h"
#include "primitect/steps.h"

namespace primitect::eval {
namespace {

using Json = nlohmann::ordered_json;

Json countsJson(const Counts& counts) {
  return {{"truths", counts.truths},         {"found", counts.found},
          {"correct", counts.correct},       {"typed_correct", counts.typed_correct},
          {"missed", counts.missed},         {"noise", counts.noise},
          {"over", counts.over_segmented},   {"under", counts.under_segmented},
          {"type_right", counts.type_right}, {"dod", counts.dod},
          {"typed_dod", counts.typed_dod}};
}

Json errorsJson(const ParameterErrors& errors) {
  Json json = Json::object();
  const auto add = [&json](const char* name, const std::vector<double>& values) {
    if (!values.empty()) json[name] = values;
  };
  add("position", errors.position);
  add("radius", errors.radius);
  add("axis_deg", errors.axis_deg);
  add("apex", errors.apex);
  add("half_angle_deg", errors.half_angle_deg);
  return json;
}

const char* verdictName(Verdict verdict) {
  if (verdict == Verdict::no_matter) return "no matter";
  return verdict == Verdict::right ? "right" : "wrong";
}

Json neesJson(Kind kind, const NormalisedErrors& errors) {
  Json json = Json::object();
  const auto add = [&json](const char* name, const std::optional<NormalisedError>& error) {
    if (error) json[name] = {error->value, error->degrees};
  };
  add("origin", errors.origin);
  add("axis", errors.axis);
  add("pose", errors.pose);
  add("radius", errors.radius);
  add("half_angle", errors.half_angle);
  add("total", errors.total(kind));
  return json;
}

constexpr std::array<const char*, 10> kEvidenceNames = {"inliers",         "gain", "against", "runs_on",   "runs_into",
                                                        "border_residual", "turn", "lead",    "own_noise", "stands"};

std::array<float, kEvidenceNames.size()> evidenceNumbers(const Evidence& e) {
  return {e.inliers,         e.gain, e.against, e.runs_on,   e.runs_into,
          e.border_residual, e.turn, e.lead,    e.own_noise, e.stands};
}

/// Whether its errors tell something about its covariance: not when the truth is rougher than these, nor when it is
/// another true shape that the detection is nearest to. Two planes a centimetre apart are the same for the scores.
bool isJudged(const LabelledCloud& input, int true_shape, const Detection& detection) {
  const Kind kind = kindOf(detection.shape);
  const auto errorOf = [&](const Shape& truth) { return normalisedErrors(truth, detection).total(kind); };
  const auto error = errorOf(input.truth[true_shape].shape);
  const auto isNearer = [&](const TrueShape& other) {
    const auto other_error = kindOf(other.shape) == kind ? errorOf(other.shape) : std::nullopt;
    return other_error && other_error->value < error->value;
  };
  return input.truth[true_shape].exact && error && std::none_of(input.truth.begin(), input.truth.end(), isNearer);
}

/// With what the detection says of its ends: truncated, unseen_ends; on_faces: bits of End.
Json extentJson(const TrueShape& truth, const Detection& found) {
  const ExtentErrors errors = extentErrors(truth.shape, *truth.seen, found);
  Json json = Json::object();
  if (errors.beyond_ends) json["beyond_ends"] = *errors.beyond_ends;
  if (errors.outline_overlap) json["outline_overlap"] = *errors.outline_overlap;
  if (json.empty()) return json;
  json["truncated"] = found.truncated;
  json["unseen_ends"] = found.extent.unseen_ends;
  json["on_faces"] = (found.extent.face_at_minus_z == kNoFace ? 0 : int{kEndAtMinusZ}) |
                     (found.extent.face_at_plus_z == kNoFace ? 0 : int{kEndAtPlusZ});
  return json;
}

/// Confidence, evidence, normalised errors and labels only where the method tells them.
Json detectionsJson(const LabelledCloud& input, const Answer& answer, const CaseScore& score) {
  std::vector<std::optional<LabelScore>> labels(answer.shapes.size());
  if (!answer.labels.empty()) labels = scoreLabels(input, answer.labels, score);
  Json json = Json::array();
  for (std::size_t d = 0; d < answer.shapes.size(); ++d) {
    const Kind kind = kindOf(answer.shapes[d]);
    Json entry = {{"kind", kindName(kind)}, {"verdict", verdictName(score.verdicts[d])}};
    if (score.lies_on[d]) entry["on"] = kindName(*score.lies_on[d]);
    if (labels[d]) {
      entry["labels"] = {
          {"labelled", labels[d]->labelled}, {"on_shape", labels[d]->on_shape}, {"both", labels[d]->both}};
    }
    if (d < answer.detections.size()) {
      const Detection& detection = answer.detections[d];
      if (detection.confidence >= 0.0f) {
        entry["confidence"] = detection.confidence;
        entry["evidence"] = evidenceNumbers(detection.evidence);
      }
      if (score.verdicts[d] == Verdict::right && isJudged(input, score.true_shape[d], detection)) {
        const Json nees = neesJson(kind, normalisedErrors(input.truth[score.true_shape[d]].shape, detection));
        if (!nees.empty()) entry["nees"] = nees;
      }
      if (score.verdicts[d] == Verdict::right && input.truth[score.true_shape[d]].seen) {
        const Json extent = extentJson(input.truth[score.true_shape[d]], detection);
        if (!extent.empty()) entry["extent"] = extent;
      }
    }
    json.push_back(entry);
  }
  return json;
}

}  // namespace

std::string scoreLine(const LabelledCloud& input, const Method& method, const Answer& answer, const CaseScore& score) {
  const Recipe& recipe = input.recipe;
  Json json = {{"set", recipe.set},
               {"seed", recipe.seed},
               {"sigma", recipe.sigma},
               {"noise_scale", recipe.noise_scale},
               {"noise_grain", recipe.noise_grain},
               {"sensor", recipe.sensor},
               {"blots", recipe.blots},
               {"width", recipe.width},
               {"outliers", recipe.outliers},
               {"keep", recipe.keep},
               {"uneven", recipe.uneven},
               {"voxel", recipe.voxel},
               {"listed", recipe.listed},
               {"shuffle", recipe.shuffle},
               {"robot_frame", recipe.robot_frame},
               {"unit", input.unit},
               {"points", score.points},
               {"method", method.name},
               {"algorithm_seed", method.algorithm_seed},
               {"failure", answer.failure},
               {"total_ms", answer.total_ms},
               {"vote_ms", answer.vote_ms},
               {"prepare_ms", answer.prepare_ms}};
  json["all"] = countsJson(score.all);
  json["false_curved"] = score.false_curved;
  json["errors"] = Json::object();
  for (std::size_t k = 0; k < kKindCount; ++k) {
    const char* kind = kindName(static_cast<Kind>(k));
    json[kind] = countsJson(score.of_kind[k]);
    json["errors"][kind] = errorsJson(score.errors[k]);
  }
  json["p_coverage"] = score.p_coverage;
  json["s_coverage"] = score.s_coverage.empty() ? Json(nullptr) : Json(score.s_coverage);
  json["detections"] = detectionsJson(input, answer, score);
  return json.dump();
}

std::string aboutJson() {
#ifdef NDEBUG
  const char* build = "optimized, without assertions";
#else
  const char* build = "with assertions: not for measuring time";
#endif
  Json steps = Json::array();
  for (const StepInfo& step : stepTable()) {
    steps.push_back({{"name", step.name}, {"stage", step.stage}, {"meaning", step.meaning}});
  }
  return Json{{"compiler", std::string("GCC-compatible ") + __VERSION__},
              {"build", build},
              {"curve_step", kCurveStep},
              {"sets", dataSetNames()},
              {"evidence", kEvidenceNames},
              {"peers", peerNames()},
              {"steps", steps}}
      .dump();
}

}  // namespace primitect::eval
