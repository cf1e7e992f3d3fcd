// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Files and directories for results.
#include "tools/output_target.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include "io/file_checks.h"

namespace primitect::tools {
namespace {

namespace fs = std::filesystem;

void refuseOverwriting(const std::string& option, const std::string& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    std::error_code error;
    if (fs::equivalent(output, input, error)) {
      throw std::invalid_argument(option + ": " + output + " would overwrite the input");
    }
  }
}

/// <directory>/<stem><extension> of each input.
std::vector<std::string> pathsInside(const std::string& option, const fs::path& directory, const std::string& extension,
                                     const std::vector<std::string>& inputs) {
  std::vector<std::string> paths;
  std::map<std::string, std::string> input_of;
  for (const std::string& input : inputs) {
    paths.push_back((directory / (fs::path(input).stem().string() + extension)).string());
    const auto [other, added] = input_of.emplace(paths.back(), input);
    if (!added) {
      throw std::invalid_argument(option + ": " + other->second + " and " + input + " would both be written to " +
                                  paths.back());
    }
    refuseOverwriting(option, paths.back(), inputs);
  }
  return paths;
}

/// A name that promises another format would be read as that.
void refuseOtherFormats(const std::string& option, const std::string& output, const std::string& extension) {
  static const std::vector<std::string> kKnown = {".json", ".ply", ".png", ".pcd", ".jpg", ".jpeg", ".yaml"};
  const std::string own = io::lowerExtension(output);
  if (own.empty() || own == extension) return;
  // Of pictures any name: there are too many formats.
  const bool promises = extension == ".png" || std::find(kKnown.begin(), kKnown.end(), own) != kKnown.end();
  if (!promises) return;
  throw std::invalid_argument(option + ": " + output + " would not be a " + own.substr(1) +
                              " file; what is written is " + extension.substr(1));
}

}  // namespace

OutputTarget::OutputTarget(const std::string& option, const std::string& value, const std::string& extension,
                           const std::vector<std::string>& inputs, bool shared)
    : option_(option), value_(value) {
  if (value.empty() || (shared && value == "-")) return;
  if (value.back() == '/' || fs::is_directory(value)) {
    paths_ = pathsInside(option, value, extension, inputs);
    std::error_code error;
    fs::create_directories(value, error);
    if (error) throw std::runtime_error(option + ": cannot make directory " + value + ": " + error.message());
    return;
  }
  if (!shared && inputs.size() > 1) {
    throw std::invalid_argument(option + ": several files need a directory, '" + value + "' is none (append '/')");
  }
  refuseOverwriting(option, value, inputs);
  refuseOtherFormats(option, value, extension);
}

void refuseSharedFiles(const std::vector<const OutputTarget*>& targets, std::size_t inputs) {
  std::map<fs::path, const OutputTarget*> target_of;
  for (const OutputTarget* target : targets) {
    if (!target->wanted() || target->toStdout()) continue;
    for (std::size_t i = 0; i < inputs; ++i) {
      // Links and detours resolved, as far as the path exists.
      std::error_code error;
      const fs::path file = fs::weakly_canonical(fs::absolute(target->path(i)), error);
      const OutputTarget* other = target_of.emplace(file, target).first->second;
      if (other == target) continue;
      throw std::invalid_argument(other->option() + " and " + target->option() + " would both be written to " +
                                  target->path(i));
    }
  }
}

void refuseUnwritable(const std::vector<const OutputTarget*>& targets, std::size_t inputs) {
  for (const OutputTarget* target : targets) {
    if (!target->wanted() || target->toStdout()) continue;
    for (std::size_t i = 0; i < inputs; ++i) {
      const fs::path file = target->path(i), folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
      if (!fs::is_directory(folder)) {
        throw std::invalid_argument(target->option() + ": " + file.string() + ": there is no directory " +
                                    folder.string());
      }
      if (::access((fs::exists(file) ? file : folder).c_str(), W_OK) != 0) {
        throw std::runtime_error(target->option() + ": " + file.string() + ": cannot be written");
      }
    }
  }
}

void writeTextFile(const std::string& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace primitect::tools
