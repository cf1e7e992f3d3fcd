// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// printf into a string.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace primitect::tools {

/// At most 255 bytes.
__attribute__((format(printf, 1, 2))) inline std::string format(const char* pattern, ...) {
  char text[256];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof(text), pattern, arguments);
  va_end(arguments);
  return text;
}

}  // namespace primitect::tools
