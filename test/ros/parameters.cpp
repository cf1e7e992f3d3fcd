// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parameters from the server: strict, and the same table as the core's.
#include "ros/parameters.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace primitect::parameters_test {
namespace {

using namespace ros_layer;
using Text = std::string;

/// What loadParams() says about these values; "accepted" if nothing.
std::string complaint(const std::map<std::string, ParamValue>& values) {
  try {
    loadParams(values);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

void expectRefused(const std::map<std::string, ParamValue>& values, const std::vector<std::string>& said) {
  const std::string text = complaint(values);
  for (const std::string& part : said) EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
}

TEST(Parameters, StartFromThePresetAndPutExplicitValuesOnTop) {
  const LoadedParams loaded = loadParams({{"clustering", Text("average")}, {"preset", Text("drost")}});
  EXPECT_FALSE(loaded.params.spread_votes);  // of the preset
  EXPECT_EQ(loaded.params.clustering, "average");
  EXPECT_EQ(differenceText(loaded), "clustering: 'average'");
}

TEST(Parameters, TakeAnIntWhereARealIsExpected) { EXPECT_EQ(loadParams({{"max_depth", 3}}).params.max_depth, 3.0); }

TEST(Parameters, AreRefusedWithNameValueAndRange) {
  expectRefused({{"max_dept", 3.0}}, {"max_dept"});
  expectRefused({{"max_depth", 1000.0}}, {"max_depth", "1000", "100"});
  expectRefused({{"max_depth", Text("far")}}, {"max_depth", "far", "100"});
  expectRefused({{"samples", 100.5}}, {"samples", "100.5", "65536"});
  expectRefused({{"detect_planes", 1}}, {"detect_planes", "1", "true or false"});
  expectRefused({{"clustering", Text("best")}}, {"clustering", "best", "nms"});
  expectRefused({{"preset", Text("fast")}}, {"preset", "fast", "paper"});
  expectRefused({{"preset", 3}}, {"preset", "3", "paper"});
  expectRefused({{"min_depth", 3.0}}, {"min_depth", "max_depth"});
  expectRefused({{"inner/name", 3.0}}, {"inner/name"});
}

TEST(Parameters, AreRefusedForAllThatIsWrongAtOnce) {
  expectRefused({{"max_dept", 3.0}, {"preset", Text("best")}, {"samples", 100.5}, {"rounds", 1}},
                {"'best'", "; and: ", "max_dept", "samples", "100.5"});
}

TEST(Parameters, LeaveNamesOfTheNodeAlone) {
  EXPECT_EQ(complaint({{"num_worker_threads", 4}, {"diagnostic_period", 1.0}}), "accepted");
}

TEST(Parameters, AreLiveWithTheDefaultsAndRangesOfTheTable) {
  const Params params;
  DetectorConfig config = DetectorConfig::__getDefault__();
  const Params live = fromConfig(config, params);
  for (const ParamInfo& info : paramTable()) EXPECT_EQ(getParam(live, info.name), info.default_value) << info.name;
  EXPECT_EQ(DetectorConfig::__getMax__().max_depth, paramInfo("max_depth").max);
  EXPECT_EQ(DetectorConfig::__getMin__().samples, paramInfo("samples").min);
  EXPECT_EQ(config.__getParamDescriptions__().size() + 2, paramTable().size());  // all but the frames
}

TEST(Parameters, RefuseLiveValuesThatContradictEachOther) {
  DetectorConfig config = DetectorConfig::__getDefault__();
  config.min_depth = 5.0;
  EXPECT_THROW(fromConfig(config, Params()), std::invalid_argument);
}

TEST(Parameters, SurviveTheWayToTheConfigAndBack) {
  Params params = presetParams("drost");
  params.max_depth = 3.5;
  params.seed = 9;
  params.target_frame = "base";
  DetectorConfig config = DetectorConfig::__getDefault__();
  copyToConfig(params, config);
  const Params back = fromConfig(config, params);
  for (const ParamInfo& info : paramTable()) EXPECT_EQ(getParam(back, info.name), getParam(params, info.name));
}

}  // namespace
}  // namespace primitect::parameters_test
