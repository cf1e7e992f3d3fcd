// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scores to JSON; see score_json.h.
#include "eval/score_json.h"

#include <nlohmann/json.hpp>

#include "eval/data_sets.h"
#include "eval/peers/peers.h"

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

}  // namespace

std::string scoreLine(const LabelledCloud& input, const std::string& method, const Answer& answer,
                      const CaseScore& score) {
  const Recipe& recipe = input.recipe;
  Json json = {{"set", recipe.set},
               {"seed", recipe.seed},
               {"sigma", recipe.sigma},
               {"noise_scale", recipe.noise_scale},
               {"outliers", recipe.outliers},
               {"keep", recipe.keep},
               {"uneven", recipe.uneven},
               {"shuffle", recipe.shuffle},
               {"unit", input.unit},
               {"points", score.points},
               {"method", method},
               {"failure", answer.failure},
               {"total_ms", answer.total_ms},
               {"vote_ms", answer.vote_ms},
               {"prepare_ms", answer.prepare_ms}};
  json["all"] = countsJson(score.all);
  json["errors"] = Json::object();
  for (std::size_t k = 0; k < kKindCount; ++k) {
    const char* kind = kindName(static_cast<Kind>(k));
    json[kind] = countsJson(score.of_kind[k]);
    json["errors"][kind] = errorsJson(score.errors[k]);
  }
  json["p_coverage"] = score.p_coverage;
  json["s_coverage"] = score.s_coverage.empty() ? Json(nullptr) : Json(score.s_coverage);
  return json.dump();
}

std::string aboutJson() {
#ifdef NDEBUG
  const char* build = "optimized, without assertions";
#else
  const char* build = "with assertions: not for measuring time";
#endif
  return Json{{"compiler", std::string("GCC-compatible ") + __VERSION__},
              {"build", build},
              {"curve_step", kCurveStep},
              {"sets", dataSetNames()},
              {"peers", peerNames()}}
      .dump();
}

}  // namespace primitect::eval
