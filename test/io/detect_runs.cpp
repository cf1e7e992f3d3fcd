// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The program `detect` run again and again: the same results, and times that add up.

#include "detect_fixture.h"
#include "test/support/png_files.h"
#include "tools/stage_timing.h"

namespace detect_runs_test {
namespace {

using primitect::io::Timing;
using primitect::test::ballImage;
using primitect::test::ballPly;
using primitect::test::DetectProgram;
using Json = nlohmann::ordered_json;

const std::vector<std::string> kStages = {"sample", "normals", "vote", "segment", "look closer", "measure"};

/// Planes alone leave the ball to the second round.
const char* const kTwoRounds =
    " --rounds 2 --samples 2048 --closer_samples 0 --detect_spheres false --detect_cylinders false --detect_cones "
    "false";

std::size_t timesIn(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

double sumOfStages(const Json& timing) {
  double sum = 0.0;
  for (const std::string& stage : kStages) sum += timing.at(stage).get<double>();
  return sum;
}

std::vector<std::string> keysOf(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  return keys;
}

/// The text without times: key order and every digit count.
std::string withoutTimes(Json json) {
  for (const char* key : {"repeats", "timing_ms", "timing_min_ms", "timing_max_ms"}) json.erase(key);
  return json.dump();
}

class DetectRuns : public DetectProgram {
 protected:
  Json runOrdered(const std::string& arguments) {
    EXPECT_EQ(run(arguments + " --json -"), 0) << err;
    return Json::parse(out);
  }
};

TEST(StageTiming, AddsUpByNameInTheOrderOfFirstAppearance) {
  Timing timing;
  for (const auto& [stage, time] : Timing{{"vote", 1.0}, {"cluster", 2.0}, {"vote", 4.0}, {"cluster", 8.0}}) {
    primitect::tools::addTime(timing, stage, time);
  }
  EXPECT_EQ(timing, (Timing{{"vote", 5.0}, {"cluster", 10.0}}));
}

TEST(StageTiming, TakesMinimumMedianMaximumOfEachStage) {
  const auto summary = primitect::tools::summarize({{{"vote", 3.0}, {"total", 30.0}},
                                                    {{"vote", 1.0}, {"total", 20.0}},
                                                    {{"vote", 2.0}, {"total", 10.0}},
                                                    {{"vote", 6.0}, {"total", 40.0}}});
  EXPECT_EQ(summary.min_ms, (Timing{{"vote", 1.0}, {"total", 10.0}}));
  EXPECT_EQ(summary.median_ms, (Timing{{"vote", 2.5}, {"total", 25.0}}));
  EXPECT_EQ(summary.max_ms, (Timing{{"vote", 6.0}, {"total", 40.0}}));
}

TEST_F(DetectRuns, GiveTwoRoundsOneTimeForEachStage) {
  const Json json = runOrdered(ball + kTwoRounds);
  ASSERT_GT(json["samples"], 2048) << "only one round was run";
  std::vector<std::string> expected = kStages;
  expected.insert(expected.begin(), "read");
  expected.push_back("total");
  EXPECT_EQ(keysOf(json["timing_ms"]), expected);
  const std::string times = out.substr(out.find("timing_ms"));  // as text: the parser drops keys that come twice
  for (const std::string& key : expected) EXPECT_EQ(timesIn(times, '"' + key + "\":"), 1u) << times;
  const double total = json["timing_ms"]["total"];
  EXPECT_GE(sumOfStages(json["timing_ms"]), 0.8 * total) << json["timing_ms"];
  EXPECT_LE(sumOfStages(json["timing_ms"]), 1.005 * total) << json["timing_ms"];
}

TEST_F(DetectRuns, PrintEachStageOfTwoRoundsOnce) {
  EXPECT_EQ(run(ball + kTwoRounds), 0);
  const std::string times = out.substr(out.find("  ms:"));
  for (const std::string& stage : kStages) EXPECT_EQ(timesIn(times, " " + stage + " "), 1u) << times;
  EXPECT_EQ(run(ball + kTwoRounds + " --repeat 3"), 0);
  const std::string table = out.substr(out.find("3 runs"));
  for (const std::string& stage : kStages) EXPECT_EQ(timesIn(table, "\n  " + stage + " "), 1u) << table;
}

TEST_F(DetectRuns, GiveMinimumMedianMaximumOfStagesAndTotal) {
  EXPECT_EQ(run(ball + " --repeat 3"), 0);
  for (const char* word : {"3 runs", "min", "median", "max", "vote", "total"}) {
    EXPECT_NE(out.find(word), std::string::npos) << word;
  }
  const Json json = runOrdered(ball + kTwoRounds + " --repeat 3");
  EXPECT_EQ(json["repeats"], 3);
  const Json &least = json["timing_min_ms"], &median = json["timing_ms"], &most = json["timing_max_ms"];
  EXPECT_EQ(keysOf(least), keysOf(most));
  for (const std::string& stage : keysOf(least)) {
    EXPECT_LE(least[stage], median[stage]) << stage;
    EXPECT_LE(median[stage], most[stage]) << stage;
  }
  EXPECT_LE(sumOfStages(least), 1.005 * least["total"].get<double>());
  EXPECT_GE(sumOfStages(most), 0.8 * most["total"].get<double>());
}

TEST_F(DetectRuns, GiveTheSameResultEveryTime) {
  const std::string first = withoutTimes(runOrdered(ball));
  EXPECT_EQ(withoutTimes(runOrdered(ball)), first);
  EXPECT_EQ(withoutTimes(runOrdered(ball + " --repeat 3")), first) << "a used detector finds something else";
}

TEST_F(DetectRuns, UseFewerSamplesWhenTheyTakeLongerThanMaxLatency) {
  const Json all = runOrdered(ball + kTwoRounds);
  EXPECT_FALSE(all.contains("effort"));
  const Json bound = runOrdered(ball + kTwoRounds + " --max_latency 1e-6 --repeat 10");  // no machine is so fast
  EXPECT_EQ(bound["effort"], 0.125);                                                     // the least
  EXPECT_EQ(bound["samples"], 256);                                                      // of one round
  EXPECT_TRUE(bound["primitives"].is_array());
  EXPECT_EQ(run(ball + kTwoRounds + " --max_latency 1e-6 --repeat 10"), 0);
  EXPECT_NE(out.find("samples (max_latency leaves "), std::string::npos) << out;
}

TEST_F(DetectRuns, TakeAllFilesOfACallForFramesInARow) {
  const Json all = runOrdered(ball + " " + ball + " " + ball + " --max_latency 1e-6");
  EXPECT_EQ(all[0]["effort"], 1.0);
  EXPECT_LT(all[2]["effort"], 1.0);
  EXPECT_LT(all[2]["samples"], all[0]["samples"]);
}

TEST_F(DetectRuns, GiveTheSameResultForAFileAmongOthers) {
  primitect::test::writePng(path("image.png"), ballImage());
  const std::string lens = " --intrinsics 262.5,262.5,159.5,119.5";
  const std::string image = path("image.png"), second = write("second.ply", ballPly(1.5));
  const Json all = runOrdered(second + " " + ball + " " + image + " " + ball + lens);
  ASSERT_EQ(all.size(), 4u);
  const std::string alone = withoutTimes(runOrdered(ball));
  EXPECT_EQ(withoutTimes(all[1]), alone);
  EXPECT_EQ(withoutTimes(all[3]), alone);
  EXPECT_EQ(withoutTimes(all[0]), withoutTimes(runOrdered(second)));
  EXPECT_EQ(withoutTimes(all[2]), withoutTimes(runOrdered(image + lens)));
  EXPECT_NE(withoutTimes(all[0]), alone);
}

}  // namespace
}  // namespace detect_runs_test
