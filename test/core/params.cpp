// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The parameter table: defaults, checks and their messages, presets, YAML text.
#include "primitect/params.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

namespace primitect::params_test {
namespace {

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ParamTable, HasEveryNameOnceAndEveryDefaultInRange) {
  std::set<std::string> names;
  Params params;
  for (const ParamInfo& info : paramTable()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.meaning.empty()) << info.name;
    EXPECT_EQ(getParam(params, info.name), info.default_value) << info.name;
    EXPECT_NO_THROW(setParam(params, info.name, info.default_value)) << info.name;
  }
  EXPECT_NO_THROW(checkParams(params));
}

TEST(ParamTable, NamesParameterValueAndRangeWhenItRefuses) {
  Params params;
  EXPECT_EQ(refusal([&] { setParam(params, "max_depth", -1.0); }),
            "parameter 'max_depth' is -1.0, allowed: a number from 0 to 100 m");
  EXPECT_EQ(refusal([&] { setParam(params, "samples", std::string("many")); }),
            "parameter 'samples' is 'many', allowed: a whole number from 16 to 65536 points");
  EXPECT_EQ(refusal([&] { setParam(params, "clustering", std::string("best")); }),
            "parameter 'clustering' is 'best', allowed: average or nms");
  EXPECT_EQ(params.max_depth, Params().max_depth);
}

TEST(ParamTable, SaysWhichParameterMayBeMeantByAnUnknownOne) {
  Params params;
  const auto said = [&](const char* name) { return refusal([&] { setParam(params, name, 1.0); }); };
  EXPECT_EQ(said("max_dept"), "unknown parameter 'max_dept'; did you mean 'max_depth'?");
  EXPECT_EQ(said("maxdepth"), "unknown parameter 'maxdepth'; did you mean 'max_depth'?");
  EXPECT_EQ(said("min_radus"), "unknown parameter 'min_radus'; did you mean 'min_radius'?");
  EXPECT_EQ(said("max_dpeth"), "unknown parameter 'max_dpeth'; did you mean 'max_depth'?");
  EXPECT_EQ(said("max_dpteh"), "unknown parameter 'max_dpteh'") << "two swaps";
  EXPECT_EQ(said("closer_smaples"), "unknown parameter 'closer_smaples'; did you mean 'closer_samples'?");
  EXPECT_EQ(said("min_half_angle"), "unknown parameter 'min_half_angle'; did you mean 'min_half_angle_deg'?");
  EXPECT_EQ(said("presett"), "unknown parameter 'presett'; did you mean 'preset'?") << "in files it stands among them";
  EXPECT_EQ(said("preset"), "unknown parameter 'preset'");
  EXPECT_EQ(said("mx_dept"), "unknown parameter 'mx_dept'") << "two of seven letters";
  EXPECT_EQ(said("detect_torus"), "unknown parameter 'detect_torus'");
  EXPECT_EQ(said("depth"), "unknown parameter 'depth'");
  EXPECT_EQ(said("min"), "unknown parameter 'min'");
  EXPECT_EQ(said(""), "unknown parameter ''");
}

TEST(ParamTable, TakesWholeNumbersForRealsButNotTheOtherWayRound) {
  Params params;
  setParam(params, "max_depth", 3);
  EXPECT_EQ(params.max_depth, 3.0);
  EXPECT_NE(refusal([&] { setParam(params, "samples", 100.0); }), "");
  EXPECT_NE(refusal([&] { setParam(params, "detect_planes", 1); }), "");
}

TEST(ParamTable, RefusesNanAndEveryValueBeyondItsRange) {
  for (const ParamInfo& info : paramTable()) {
    Params params;
    if (std::holds_alternative<double>(info.default_value)) {
      EXPECT_NE(refusal([&] { setParam(params, info.name, std::nan("")); }), "") << info.name;
      EXPECT_NE(refusal([&] { setParam(params, info.name, info.max * 1.01 + 1e-6); }), "") << info.name;
      EXPECT_NO_THROW(setParam(params, info.name, info.max)) << info.name;
    }
    if (std::holds_alternative<int>(info.default_value)) {
      EXPECT_NE(refusal([&] { setParam(params, info.name, static_cast<int>(info.min) - 1); }), "") << info.name;
      EXPECT_NO_THROW(setParam(params, info.name, static_cast<int>(info.min))) << info.name;
    }
  }
}

TEST(ParamText, IsReadStrictly) {
  Params params;
  setParamFromText(params, "samples", "512");
  setParamFromText(params, "max_depth", "1.5e0");
  setParamFromText(params, "detect_cones", "false");
  setParamFromText(params, "clustering", "nms");
  EXPECT_EQ(params.samples, 512);
  EXPECT_EQ(params.max_depth, 1.5);
  EXPECT_FALSE(params.detect_cones);
  EXPECT_EQ(params.clustering, "nms");
  for (const char* text : {"", "12x", "1.5", "nan", "99999999999"}) {
    EXPECT_NE(refusal([&] { setParamFromText(params, "samples", text); }), "") << text;
  }
  EXPECT_NE(refusal([&] { setParamFromText(params, "detect_cones", "maybe"); }), "");
}

TEST(CheckParams, RefusesBoundsThatContradictEachOther) {
  Params params;
  params.min_depth = 2.5;
  EXPECT_NE(refusal([&] { checkParams(params); }).find("min_depth"), std::string::npos);
  params.max_depth = 0.0;  // off
  EXPECT_EQ(refusal([&] { checkParams(params); }), "");
  params.min_half_angle_deg = 80.0;
  EXPECT_NE(refusal([&] { checkParams(params); }).find("min_half_angle_deg"), std::string::npos);
}

TEST(Presets, PaperIsTheSectionChoiceOfParameters) {
  const Params paper = presetParams("paper");
  EXPECT_EQ(paper.samples, 2048);
  EXPECT_EQ(paper.references, 2048);
  EXPECT_EQ(paper.angle_bin_deg, 10.0);
  EXPECT_EQ(paper.radius_bin, 0.005);
  EXPECT_EQ(paper.radius_bins, 40);
  EXPECT_EQ(paper.pair_distance, 0.2);
  EXPECT_EQ(paper.min_votes, 8.0);
  EXPECT_EQ(paper.cluster_distance, 0.01);
  EXPECT_EQ(paper.cluster_angle_deg, 20.0);
  EXPECT_EQ(paper.convexity, "convex");
  EXPECT_TRUE(paper.spread_votes && paper.average_bins && paper.clustering == "average");
}

TEST(Presets, PaperDependsOnNoDefault) {
  const std::vector<std::string> own = presetSettings("paper");
  const std::set<std::string> names(own.begin(), own.end());
  for (const ParamInfo& info : paramTable()) {
    if (info.group == "input" || info.group == "node") continue;
    EXPECT_EQ(names.count(info.name), 1u) << info.name;
  }
}

TEST(Presets, DrostIsThePaperWithoutWhatThePaperAdds) {
  Params drost = presetParams("drost");
  EXPECT_FALSE(drost.spread_votes || drost.average_bins || drost.clustering == "average");
  drost.spread_votes = drost.average_bins = true;
  drost.clustering = "average";
  for (const ParamInfo& info : paramTable()) {
    EXPECT_EQ(getParam(drost, info.name), getParam(presetParams("paper"), info.name)) << info.name;
  }
}

TEST(Presets, UnknownOnesAreRefusedWithTheKnownOnes) {
  EXPECT_EQ(refusal([] { presetParams("papr"); }), "parameter 'preset' is 'papr', allowed: default or drost or paper");
}

TEST(ParamYaml, ListsEveryParameterWithItsValue) {
  const std::string yaml = paramsAsYaml("default");
  for (const ParamInfo& info : paramTable()) {
    EXPECT_NE(yaml.find("# " + info.name + ": " + valueText(info.default_value) + "  # "), std::string::npos)
        << info.name;
  }
}

}  // namespace
}  // namespace primitect::params_test
