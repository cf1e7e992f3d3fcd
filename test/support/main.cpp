// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tests of many files are one program, which takes half of the time to compile. It runs those of the files that it is
// told, without ".cpp", or all:  test_core hull extent
#include <gtest/gtest.h>

#include <iostream>
#include <string>

namespace {

/// Tests of NAME.cpp as googletest's filter has them, each with a colon behind; empty where there are none.
std::string testsOfFile(const std::string& name) {
  const std::string end = "/" + name + ".cpp";
  const testing::UnitTest& program = *testing::UnitTest::GetInstance();
  std::string tests;
  for (int i = 0; i < program.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *program.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      const std::string file = std::string("/") + test.file();
      if (file.size() < end.size() || file.compare(file.size() - end.size(), end.size(), end) != 0) continue;
      if (std::string(test.name()).rfind("DISABLED_", 0) == 0) continue;
      tests += std::string(suite.name()) + "." + test.name() + ":";
    }
  }
  return tests;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::string tests;
  if (argc > 1 && testing::GTEST_FLAG(filter) != "*") {
    std::cerr << argv[0] << ": either files or a filter, not both\n";
    return 2;
  }
  for (int i = 1; i < argc; ++i) {
    const std::string of_file = testsOfFile(argv[i]);
    if (of_file.empty()) {
      std::cerr << argv[0] << ": no test is in a file " << argv[i] << ".cpp\n";
      return 2;
    }
    tests += of_file;
  }
  if (!tests.empty()) testing::GTEST_FLAG(filter) = tests;
  return RUN_ALL_TESTS();
}
