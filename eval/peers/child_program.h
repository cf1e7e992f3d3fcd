// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs a program and catches what it says.
#pragma once

#include <string>
#include <vector>

namespace primitect::eval {

struct ProgramResult {
  std::string out;         ///< all of its standard output
  std::string last_words;  ///< last line of its standard error that is not empty
  int exit_code = 0;       ///< as a shell gives it: 128 + n when it died of signal n
  bool timed_out = false;
};

/// Runs the program to its end, or ends it after timeout_s. It has no standard input.
/// Throws std::runtime_error when no program can be started at all.
ProgramResult runProgram(const std::string& program, const std::vector<std::string>& arguments, double timeout_s);

/// Folder of the programs that belong to this one: what the environment variable PRIMITECT_TOOLS_DIR says, else the one
/// that the running program lies in.
std::string toolsFolder();

}  // namespace primitect::eval
