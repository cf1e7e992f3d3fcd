// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Child programs through the shell and coreutils' timeout; see child_program.h.
#include "eval/peers/child_program.h"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "eval/peers/scratch_folder.h"

namespace primitect::eval {
namespace {

/// One word for the shell, whatever is in it.
std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string lastLine(const std::string& path) {
  std::ifstream file(path);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

std::string readAll(std::FILE* pipe) {
  std::string text;
  char buffer[4096];
  for (std::size_t count; (count = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, count);
  return text;
}

int exitCode(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

ProgramResult runProgram(const std::string& program, const std::vector<std::string>& arguments, double timeout_s) {
  const ScratchFolder folder;
  // In the foreground, so that Ctrl-C reaches the program too.
  std::string command = "timeout --foreground --kill-after=5 " + std::to_string(timeout_s) + " " + quoted(program);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " </dev/null 2>" + quoted(folder.path("stderr"));
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("no program can be started: popen failed");
  ProgramResult result;
  result.out = readAll(pipe);
  result.exit_code = exitCode(pclose(pipe));
  result.last_words = lastLine(folder.path("stderr"));
  // Of timeout itself: 124, and 137 when it had to kill.
  result.timed_out = result.exit_code == 124;
  return result;
}

std::string toolsFolder() {
  if (const char* folder = std::getenv("PRIMITECT_TOOLS_DIR")) return folder;
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
}

}  // namespace primitect::eval
