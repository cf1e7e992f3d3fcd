// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What `detect --example` writes is a frame of a depth camera in which the program that it names finds all kinds.

#include <filesystem>

#include "detect_fixture.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"

namespace detect_example_test {
namespace {

namespace synthetic = primitect::synthetic;
using primitect::test::DetectProgram;
using Json = nlohmann::json;

class DetectExample : public DetectProgram {
 protected:
  /// What the program says to do with it, without the program's own name and the picture.
  std::string argumentsFor(const std::string& name) {
    EXPECT_EQ(run("--example " + path(name)), 0) << err;
    const std::string program = std::string(PRIMITECT_TOOLS_DIR) + "/detect ", picture = " --picture table_found.png";
    const std::size_t begin = out.find(program), end = out.find(picture);
    if (begin == std::string::npos || end == std::string::npos) return "?";
    return out.substr(begin + program.size(), end - begin - program.size());
  }
};

std::map<std::string, int> kindsIn(const Json& found) {
  std::map<std::string, int> kinds;
  for (const Json& primitive : found["primitives"]) ++kinds[primitive["type"].get<std::string>()];
  return kinds;
}

TEST_F(DetectExample, HasWhatTheSimulatedTableHas) {
  const synthetic::Frame frame =
      synthetic::renderFrame(synthetic::tabletop(1), {}, synthetic::cameraPose(0.0), {}, 1, 0);
  std::map<std::string, int> there;
  for (const primitect::Detection& item : frame.truth.items) ++there[kindName(kindOf(item.shape))];
  ASSERT_GE(there.size(), 4u);
  for (const char* name : {"table.pcd", "table.png"}) {
    const Json found = runJson(argumentsFor(name));
    EXPECT_EQ(found["points_in"], 640 * 480);
    EXPECT_GT(found["image_noise"], 0.5) << "seen as a depth camera's image";
    for (const char* curved : {"sphere", "cylinder", "cone"}) EXPECT_EQ(kindsIn(found)[curved], there[curved]) << name;
    EXPECT_GE(kindsIn(found)["plane"], 3) << name;
  }
}

TEST_F(DetectExample, OverwritesNothing) {
  const std::string mine = write("mine.pcd", "my recording");
  expectUsageError("--example " + mine, {"--example", "mine.pcd exists already"});
  EXPECT_EQ(read(mine), "my recording");
}

TEST_F(DetectExample, IsRefusedWhereItCannotBe) {
  expectUsageError("--example " + path("table.jpg"), {"--example", "table.jpg", ".pcd or .png"});
  for (const std::string& more :
       {ball, std::string("--picture x.png"), std::string("--max_depth 1"), std::string("--kernels")}) {
    expectUsageError("--example " + path("table.pcd") + " " + more, {"--example", "no other FILE and no option"});
  }
  EXPECT_FALSE(std::filesystem::exists(path("table.pcd")));
  for (const char* name : {"no/such/folder.pcd", "no/such/folder.png"}) {
    EXPECT_EQ(run("--example " + path(name)), 1) << name;
    EXPECT_NE(err.find("cannot be written"), std::string::npos) << err;
    EXPECT_EQ(errorLines(), 1) << err;
  }
}

TEST_F(DetectExample, IsRemovedWhereTheDiskIsFull) {
  for (const char* name : {"table.pcd", "table.png"}) {
    // The program that the shell starts may write no more than 100 blocks.
    const std::string command = "bash -c 'ulimit -f 100; trap \"\" XFSZ; " PRIMITECT_TOOLS_DIR "/detect --example " +
                                path(name) + "' >" + path("stdout") + " 2>" + path("stderr");
    EXPECT_NE(std::system(command.c_str()), 0);
    const std::string said = read(path("stderr"));
    EXPECT_NE(said.find("cannot be written"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_FALSE(std::filesystem::exists(path(name)));
  }
}

TEST_F(DetectExample, TellsNamesWithBlanksAsAShellTakesThem) {
  EXPECT_EQ(run("--example '" + path("my table.pcd") + "'"), 0) << err;
  EXPECT_NE(out.find("\"" + path("my table.pcd") + "\" --picture \"my table_found.png\""), std::string::npos) << out;
}

TEST_F(DetectExample, IsNamedWhereNoFileIs) { expectUsageError("", {"no FILE", "--example table.pcd"}); }

}  // namespace
}  // namespace detect_example_test
