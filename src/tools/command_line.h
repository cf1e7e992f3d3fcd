// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What all command lines have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/similar_name.h"

namespace primitect::tools {

/// "; did you mean '--max_depth'?" of each option that there is not, with one dash or two; empty where none is like it.
inline std::string meantOption(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  std::string hints;
  for (const std::string& text : app.remaining()) {
    const std::string name = text.substr(0, text.find('='));
    if (name.rfind("--", 0) == 0) {
      hints += similarNameHint(name, names);
    } else if (name.rfind('-', 0) == 0) {
      hints += similarNameHint("-" + name, names);
    }
  }
  return hints;
}

/// Throws std::invalid_argument for "max_depth:=1", as nodes and launch files take it, and for "max_depth=1", where a
/// file is expected and none has that name.
inline void refuseNodeArguments(const CLI::App& app, int argc, char** argv) {
  for (int k = 1; k < argc; ++k) {
    const std::string text = argv[k], before = argv[k - 1];
    const std::size_t name_end = text.find_first_of(":="), name_begin = text.find_first_not_of('_');
    const bool value = before[0] == '-' && before.find('=') == std::string::npos;
    if (name_end == std::string::npos || text[0] == '-' || value || std::filesystem::exists(text)) continue;
    const bool as_node = text.compare(name_end, 2, ":=") == 0;
    const std::string option = "--" + text.substr(name_begin, name_end - name_begin);
    const bool known = app.get_option_no_throw(option) != nullptr;
    if (!as_node && !known) continue;
    const std::string here = known ? option + " " + text.substr(name_end + (as_node ? 2 : 1)) : "--NAME VALUE";
    throw std::invalid_argument("'" + text + "' is " +
                                (as_node ? "how nodes and launch files are told; here it is '" : "no file; it is '") +
                                here + "' (see --help)");
  }
}

/// Throws std::invalid_argument for a value that was given and is empty, as an unset variable of a shell gives it.
inline void refuseEmpty(const CLI::App& app, const std::vector<const char*>& options, const std::string& expected) {
  for (const char* option : options) {
    if (app.count(option) == 0 || !app.get_option(option)->as<std::string>().empty()) continue;
    throw std::invalid_argument(std::string(option) + ": empty, expected " + expected);
  }
}

/// False when all is said (--help, --version). Throws std::invalid_argument, one line, for what is wrong.
inline bool parseOrSay(CLI::App& app, int argc, char** argv) try {
  refuseNodeArguments(app, argc, argv);
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
