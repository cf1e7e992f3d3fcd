// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// JSON that programs printed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace primitect::test {

/// Throws nlohmann::json::parse_error where it is none.
nlohmann::json parsedJson(const std::string& text);

}  // namespace primitect::test
