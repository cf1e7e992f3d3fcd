// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// YAML files of parameters: what they may say, and how they are refused.
#include "io/params_file.h"

#include "temporary_folder.h"

namespace primitect::io::params_file_test {
namespace {

class ParamsFiles : public test::TemporaryFolder {
 protected:
  std::string refusalOf(const std::string& yaml) {
    const std::string file = write("params.yaml", yaml);
    try {
      loadParams(file);
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(file + ": "), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.substr(file.size() + 2);
    }
    ADD_FAILURE() << "taken: " << yaml;
    return "";
  }

  void expectRefusal(const std::string& yaml, const std::vector<std::string>& says) {
    const std::string refusal = refusalOf(yaml);
    for (const std::string& part : says) EXPECT_NE(refusal.find(part), std::string::npos) << refusal << " / " << part;
  }
};

TEST_F(ParamsFiles, SetWhatTheySayOnTopOfTheirPreset) {
  const std::string file = write("params.yaml",
                                 "samples: 512\npreset: drost\nmax_depth: 3\npair_distance: 1.5e-1\n"
                                 "detect_cones: false\ntarget_frame: \"base\"\n");
  const Params params = loadParams(file);
  EXPECT_EQ(params.samples, 512);
  EXPECT_EQ(params.max_depth, 3.0);
  EXPECT_EQ(params.pair_distance, 0.15);
  EXPECT_FALSE(params.detect_cones);
  EXPECT_EQ(params.target_frame, "base");
  EXPECT_EQ(params.clustering, presetParams("drost").clustering);
  EXPECT_NE(params.clustering, Params{}.clustering);
}

TEST_F(ParamsFiles, SayNothingWhenTheyAreEmptyOrAllComments) {
  for (const char* yaml : {"", "\n\n", "# samples: 512\n#max_depth: 3\n", "---\n# nothing\n"}) {
    const ParamsFile file = readParamsFile(write("params.yaml", yaml));
    EXPECT_TRUE(file.preset.empty()) << yaml;
    EXPECT_TRUE(file.values.empty()) << yaml;
    EXPECT_EQ(loadParams(path("params.yaml")).samples, presetParams("default").samples);
  }
}

TEST_F(ParamsFiles, TakeWhatTheTablePrints) {
  for (const std::string& preset : presetNames()) {
    EXPECT_EQ(readParamsFile(write("params.yaml", paramsAsYaml(preset))).preset, preset);
  }
}

TEST_F(ParamsFiles, TakeEveryParameterAtItsDefault) {
  std::string yaml;
  for (const ParamInfo& info : paramTable()) yaml += info.name + ": " + valueText(info.default_value) + "\n";
  EXPECT_EQ(readParamsFile(write("params.yaml", yaml)).values.size(), paramTable().size());
  loadParams(path("params.yaml"));
}

TEST_F(ParamsFiles, AreRefusedForUnknownNames) {
  expectRefusal("max_dpth: 3.0\n", {"max_dpth"});
  expectRefusal("preset: best\n", {"preset", "best", "paper"});
  expectRefusal("preset:\n", {"preset"});
}

TEST_F(ParamsFiles, AreRefusedForAllThatIsWrongAtOnce) {
  expectRefusal("max_dpth: 3.0\nsamples: 512\nmin_radus: 0.1\npreset: best\nsamples: 512\n[a]: 1\n",
                {"'max_dpth'; did you mean 'max_depth'?; and: ", "'min_radus'", "preset", "twice", "not a name"});
}

TEST_F(ParamsFiles, AreRefusedForValuesOutOfRange) {
  expectRefusal("max_depth: 1000\n", {"max_depth", "1000", "100"});
  expectRefusal("max_depth: .nan\n", {"max_depth"});
  expectRefusal("samples: 3\n", {"samples", "3", "16"});
  expectRefusal("clustering: best\n", {"clustering", "best", "average", "nms"});
}

TEST_F(ParamsFiles, AreRefusedForWrongTypes) {
  expectRefusal("samples: many\n", {"samples", "many", "65536"});
  expectRefusal("samples: \"512\"\n", {"samples", "512"});
  expectRefusal("samples: 512.5\n", {"samples", "512.5"});
  expectRefusal("detect_cones: 1\n", {"detect_cones", "1", "true or false"});
  expectRefusal("max_depth: true\n", {"max_depth", "true"});
  expectRefusal("max_depth:\n", {"max_depth", "empty"});
  expectRefusal("max_depth: [1, 2]\n", {"max_depth", "list"});
}

TEST_F(ParamsFiles, AreRefusedForContradictions) {
  expectRefusal("min_depth: 3.0\nmax_depth: 2.5\n", {"min_depth", "max_depth"});
  expectRefusal("samples: 512\nsamples: 1024\n", {"samples", "twice"});
}

TEST_F(ParamsFiles, AreRefusedWhenTheyAreNotFlatYaml) {
  expectRefusal("samples: [1, 2\n", {"YAML"});
  expectRefusal("just text\n", {"parameter: value"});
  expectRefusal("- samples\n", {"parameter: value"});
  expectRefusal("detector:\n  samples: 512\n", {"'detector' has names below it"});
  expectRefusal(std::string("a\0b", 3), {"binary"});
  EXPECT_THROW(loadParams(path("nothing.yaml")), std::invalid_argument);
  EXPECT_THROW(loadParams(path("")), std::invalid_argument);
}

}  // namespace
}  // namespace primitect::io::params_file_test
