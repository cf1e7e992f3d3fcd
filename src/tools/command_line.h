// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What all command lines have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>

namespace primitect::tools {

/// False when all is said (--help, --version). Throws std::invalid_argument, one line, for what is wrong.
inline bool parseOrSay(CLI::App& app, int argc, char** argv) try {
  app.parse(argc, argv);
  return true;
} catch (const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) throw std::invalid_argument(std::string(error.what()) + " (see --help)");
  app.exit(error);
  return false;
}

}  // namespace primitect::tools
