// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Patterns and JSON for the tests, compiled once: each takes the compiler seconds; see stages.h and json_text.h.
#include <regex>

#include "test/support/json_text.h"
#include "test/support/stages.h"

namespace primitect::test {

std::string turnsAsOne(const std::string& stages) {
  return std::regex_replace(stages, std::regex("(segment )?vote (vote |segment )*segment "), "vote segment ");
}

nlohmann::json parsedJson(const std::string& text) { return nlohmann::json::parse(text); }

}  // namespace primitect::test
