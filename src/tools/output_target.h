// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the results of each input file go.
#pragma once

#include <string>
#include <vector>

namespace primitect::tools {

/// One kind of output (JSON, labels, picture) for all inputs of a call.
class OutputTarget {
 public:
  /// `value` is empty (no such output), "-", a file, or a directory: one that exists or a name that ends in '/', which
  /// is then made; it gets <stem of the input><extension> for each input. Throws std::invalid_argument naming the
  /// option when two inputs would get the same file, when an output would overwrite an input or is named as
  /// another format, or when several inputs share a file and `shared` is false; std::runtime_error when a directory
  /// cannot be made.
  OutputTarget(const std::string& option, const std::string& value, const std::string& extension,
               const std::vector<std::string>& inputs, bool shared);

  const std::string& option() const { return option_; }
  bool wanted() const { return !value_.empty(); }
  bool toStdout() const { return value_ == "-"; }
  /// One file of its own for each input.
  bool perInput() const { return !paths_.empty(); }
  /// The file for that input, or for all of them.
  const std::string& path(std::size_t input) const { return perInput() ? paths_[input] : value_; }

 private:
  std::string option_, value_;
  std::vector<std::string> paths_;
};

/// Throws std::invalid_argument naming both options when two of the outputs of so many inputs would be the same file.
void refuseSharedFiles(const std::vector<const OutputTarget*>& targets, std::size_t inputs);

/// Before the work begins that would be lost: naming the option, throws std::invalid_argument when a directory is
/// missing, std::runtime_error when it or the file must not be written to.
void refuseUnwritable(const std::vector<const OutputTarget*>& targets, std::size_t inputs);

/// Writes a whole file; throws std::runtime_error naming it when that fails.
void writeTextFile(const std::string& path, const std::string& text);

}  // namespace primitect::tools
