// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The shipped YAML files load, and say what the code says.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/params_file.h"
#include "primitect/params.h"

namespace primitect::configuration_test {
namespace {

const std::filesystem::path kConfig = std::filesystem::path(PRIMITECT_SOURCE_DIR) / "config";

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Configuration, DefaultYamlIsTheParameterTable) {
  EXPECT_EQ(textOf(kConfig / "default.yaml"), paramsAsYaml("default"))
      << "write it anew: build/devel/lib/primitect/detect --print-params > config/default.yaml";
}

TEST(Configuration, EveryShippedYamlLoads) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kConfig)) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(checkParams(io::loadParams(entry.path().string()))) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 1);
}

TEST(Configuration, DefaultYamlGivesTheDefaults) {
  const Params params = io::loadParams((kConfig / "default.yaml").string());
  for (const ParamInfo& info : paramTable()) EXPECT_EQ(getParam(params, info.name), info.default_value) << info.name;
}

/// Every line of default.yaml, with its # taken away, sets the parameter to the value that it has anyway.
TEST(Configuration, DefaultYamlLoadsWithEveryLineSwitchedOn) {
  std::istringstream lines(textOf(kConfig / "default.yaml"));
  const std::filesystem::path all_on =
      std::filesystem::temp_directory_path() / ("primitect_all_on_" + std::to_string(getpid()) + ".yaml");
  std::ofstream file(all_on);
  int switched_on = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string name = line.substr(0, 2) == "# " ? line.substr(2, line.find(':') - 2) : "";
    const bool parameter =
        std::any_of(paramTable().begin(), paramTable().end(), [&](const ParamInfo& info) { return info.name == name; });
    switched_on += parameter;
    file << (parameter ? line.substr(2) : line) << "\n";
  }
  file.close();
  EXPECT_EQ(switched_on, static_cast<int>(paramTable().size()));
  const Params params = io::loadParams(all_on.string());
  for (const ParamInfo& info : paramTable()) EXPECT_EQ(getParam(params, info.name), info.default_value) << info.name;
  std::filesystem::remove(all_on);
}

}  // namespace
}  // namespace primitect::configuration_test
