// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The first look at any file, and the head of a PNG.
#include "io/file_checks.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace primitect::io {
namespace {

constexpr std::size_t kHeadBytes = 1 << 20;  // far more than any sane header

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

std::string pngFormat(int bit_depth, int color_type) {
  static const std::array<const char*, 7> kColors = {"gray", "?", "RGB", "palette", "gray with alpha", "?", "RGBA"};
  const bool known = color_type >= 0 && color_type < static_cast<int>(kColors.size());
  return std::to_string(bit_depth) + "-bit " + (known ? kColors[color_type] : "?");
}

/// Returns where the last chunk ends; says what is missing where the file ends before, which libpng does not.
std::uint64_t checkPngChunks(const std::string& path, std::uint64_t file_size) {
  std::ifstream stream(path, std::ios::binary);
  std::uint64_t at = 8;
  for (std::string name; name != "IEND";) {
    std::string head(8, '\0');
    stream.seekg(static_cast<std::streamoff>(at));
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (!stream) throw FileError(path, "truncated PNG: no IEND chunk");
    name = head.substr(4);
    at += std::uint64_t{12} + bigEndian(head, 0);  // length, name, data, checksum
    if (at > file_size) throw FileError(path, "truncated PNG: a chunk claims more bytes than the file has");
  }
  return at;
}

/// Printable, and short enough for a message.
std::string quoted(const std::string& word) {
  std::string text = word.substr(0, 20);
  for (char& c : text) c = c > ' ' && c < 127 ? c : '?';
  return "'" + text + "'";
}

/// The number of words of a line. Throws FileError for one that is no number.
std::uint64_t countNumbers(const std::string& path, std::uint64_t row, const std::string& line) {
  std::uint64_t count = 0;
  std::size_t at = 0;
  constexpr const char* kBlank = " \t\r";
  while ((at = line.find_first_not_of(kBlank, at)) != std::string::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    char* parsed = nullptr;
    std::strtod(line.c_str() + at, &parsed);
    if (parsed != line.c_str() + end) {
      throw FileError(path,
                      "data line " + std::to_string(row) + ": " + quoted(line.substr(at, end - at)) + " is no number");
    }
    ++count;
    at = end;
  }
  return count;
}

}  // namespace

FileHead readFileHead(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw FileError(path, "no such file");
  if (status.type() == fs::file_type::directory) throw FileError(path, "is a directory, not a file");
  if (status.type() != fs::file_type::regular) throw FileError(path, "is not a regular file");
  FileHead head;
  head.file_size = fs::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) throw FileError(path, "cannot be opened (no permission?)");
  head.bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(head.file_size, kHeadBytes)));
  stream.read(head.bytes.data(), static_cast<std::streamsize>(head.bytes.size()));
  if (!stream) throw FileError(path, "cannot be read");
  if (head.bytes.empty()) throw FileError(path, "is empty (0 bytes)");
  return head;
}

void checkAsciiBody(const std::string& path, std::uint64_t begin, const TextTable& table) {
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(begin));
  std::uint64_t rows = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::uint64_t words = countNumbers(path, rows + 1, line);
    if (words == 0) continue;
    ++rows;
    if (table.words_per_line > 0 && words != table.words_per_line) {
      throw FileError(path, "data line " + std::to_string(rows) + " has " + std::to_string(words) +
                                " numbers, expected " + std::to_string(table.words_per_line));
    }
  }
  if (table.lines > 0 && rows != table.lines) {
    throw FileError(path,
                    "has " + std::to_string(rows) + " lines of data, its header says " + std::to_string(table.lines));
  }
}

std::uint64_t mostDepthPixels(std::uint64_t bytes) {
  constexpr std::uint64_t kPacked = 1032, kPixel = 2;  // bytes that deflate packs into one at most; of a pixel
  return bytes * kPacked / kPixel;
}

std::uint64_t checkDepthPng(const std::string& path, const FileHead& head) {
  static const std::string kSignature = "\x89PNG\r\n\x1a\n";
  // Signature, then the IHDR chunk: length, name, width, height, bit depth, color type.
  constexpr std::size_t kHeadEnd = 8 + 8 + 13 + 4;
  if (head.bytes.compare(0, 8, kSignature) != 0) throw FileError(path, "is not a PNG (wrong signature)");
  if (head.bytes.size() < kHeadEnd || head.bytes.compare(12, 4, "IHDR") != 0) {
    throw FileError(path, "broken PNG: no IHDR chunk");
  }
  const int bit_depth = static_cast<unsigned char>(head.bytes[24]);
  const int color_type = static_cast<unsigned char>(head.bytes[25]);
  if (bit_depth != 16 || color_type != 0) {
    throw FileError(path, "PNG of " + pngFormat(bit_depth, color_type) + ", expected 16-bit gray (depth)");
  }
  const std::uint64_t width = bigEndian(head.bytes, 16), height = bigEndian(head.bytes, 20);
  if (width == 0 || height == 0 || width * height > mostDepthPixels(head.file_size)) {
    throw FileError(path, "broken PNG: " + std::to_string(width) + " x " + std::to_string(height) +
                              " pixels cannot be in " + std::to_string(head.file_size) + " bytes");
  }
  return checkPngChunks(path, head.file_size);
}

std::string lowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

}  // namespace primitect::io
