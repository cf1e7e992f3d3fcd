// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What all command lines have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/similar_name.h"

namespace primitect::tools {

/// "; did you mean '--max_depth'?" of the first option that there is not; empty where none is like it.
inline std::string meantOption(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const std::string& text : app.remaining()) {
    if (text.rfind("--", 0) == 0) return similarNameHint(text.substr(0, text.find('=')), names);
  }
  return "";
}

/// False when all is said (--help, --version). Throws std::invalid_argument, one line, for what is wrong.
inline bool parseOrSay(CLI::App& app, int argc, char** argv) try {
  app.parse(argc, argv);
  return true;
} catch (const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) {
    throw std::invalid_argument(std::string(error.what()) + meantOption(app) + " (see --help)");
  }
  app.exit(error);
  return false;
}

}  // namespace primitect::tools
