// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A folder for files that nobody needs afterwards.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace primitect::eval {

/// Made by mkdtemp in the folder for temporary files, removed with all that is in it.
class ScratchFolder {
 public:
  /// Throws std::runtime_error naming the folder when it cannot be made.
  ScratchFolder() : folder_((std::filesystem::temp_directory_path() / "primitect_XXXXXX").string()) {
    if (!mkdtemp(folder_.data())) throw std::runtime_error(folder_ + ": cannot be made");
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path(const std::string& name) const { return folder_ + "/" + name; }

 private:
  std::string folder_;
};

}  // namespace primitect::eval
