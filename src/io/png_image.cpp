// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// libpng, which leaves its functions by longjmp where something is wrong; see png_image.h.
#include "io/png_image.h"

#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>

namespace primitect::io {
namespace {

constexpr std::size_t kSignature = 8;  // bytes

/// libpng's own words on why it gave up.
struct Cause {
  char text[80] = "";
};

[[noreturn]] void giveUp(png_structp png, png_const_charp cause) {
  std::snprintf(static_cast<Cause*>(png_get_error_ptr(png))->text, sizeof(Cause::text), "%s", cause);
  png_longjmp(png, 1);
}

void ignore(png_structp /*png*/, png_const_charp /*warning*/) {}

/// Functions that return false gave up. Between setjmp and longjmp nothing may have a destructor.
class Reader {
 public:
  Reader(const std::uint8_t* bytes, std::size_t size)
      : next_(bytes), left_(size), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &cause_, giveUp, ignore)) {
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) return;
    png_set_read_fn(png_, this, take);
    // Texts and profiles say nothing of depths, and a few bytes of them may unpack to gigabytes.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  bool readHead() {
    if (!info_) return false;
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    return true;
  }
  bool hasDepths() const {
    return png_get_bit_depth(png_, info_) == 16 && png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY;
  }
  /// One line, after a function gave up.
  PngError error() const {
    const std::string cause = cause_.text[0] == '\0' ? "not enough memory" : cause_.text;
    return PngError("broken or truncated PNG data (" + cause + ")");
  }
  std::uint32_t width() const { return png_get_image_width(png_, info_); }
  std::uint32_t height() const { return png_get_image_height(png_, info_); }

  /// To width() * height() values.
  bool readRows(std::uint16_t* values) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    if (isLittleEndian()) png_set_swap(png_);
    const int passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t row = 0; row < height(); ++row) {
        png_read_row(png_, reinterpret_cast<png_bytep>(values + row * width()), nullptr);
      }
    }
    png_read_end(png_, nullptr);
    return true;
  }

 private:
  static bool isLittleEndian() {
    const std::uint16_t one = 1;
    std::uint8_t first = 0;
    std::memcpy(&first, &one, 1);
    return first == 1;
  }
  static void take(png_structp png, png_bytep to, std::size_t count) {
    auto& reader = *static_cast<Reader*>(png_get_io_ptr(png));
    if (count > reader.left_) giveUp(png, "ends too early");
    std::memcpy(to, reader.next_, count);
    reader.next_ += count, reader.left_ -= count;
  }

  Cause cause_;
  const std::uint8_t* next_;
  std::size_t left_;
  png_structp png_;
  png_infop info_ = nullptr;
};

struct Layout {
  std::uint32_t width, height, format;
};

/// stride: from row to row, in numbers.
void write(const std::string& path, const Layout& layout, const void* pixels, std::size_t stride) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = layout.width, image.height = layout.height, image.format = layout.format;
  image.flags = PNG_IMAGE_FLAG_FAST;
  // Not by its name: what cannot be written would be removed, whatever it is.
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (!file) throw PngError(std::strerror(errno));
  const bool made = png_image_write_to_stdio(&image, file, 0, pixels, static_cast<png_int_32>(stride), nullptr) != 0;
  const int fault = std::ferror(file) != 0 ? errno : 0;  // fclose() may have another one
  const bool closed = std::fclose(file) == 0;
  if (fault != 0) throw PngError(std::strerror(fault));
  if (!made) throw PngError(image.message);
  if (!closed) throw PngError(std::strerror(errno));
}

}  // namespace

DepthPixels decodeDepthPng(const std::uint8_t* bytes, std::size_t size, std::uint64_t most_pixels) {
  if (size < kSignature || png_sig_cmp(bytes, 0, kSignature) != 0) throw PngError("no PNG");
  Reader reader(bytes, size);
  if (!reader.readHead()) throw reader.error();
  if (!reader.hasDepths()) throw PngError("the PNG is not one of 16 bits and one channel");
  DepthPixels image = {reader.width(), reader.height(), {}};
  const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
  if (pixels > most_pixels) {
    throw PngError("the PNG has " + std::to_string(pixels) + " pixels, expected are at most " +
                   std::to_string(most_pixels));
  }
  image.values.resize(pixels);
  if (!reader.readRows(image.values.data())) throw reader.error();
  return image;
}

void writeDepthPng(const std::string& path, const DepthPixels& image) {
  if (image.values.empty() || image.values.size() != std::uint64_t{image.width} * image.height) {
    throw std::invalid_argument("an image has width * height values, and at least one");
  }
  write(path, {image.width, image.height, PNG_FORMAT_LINEAR_Y}, image.values.data(), image.width);
}

void writePicturePng(const std::string& path, const std::uint8_t* bgr, std::uint32_t width, std::uint32_t height,
                     std::size_t stride) {
  write(path, {width, height, PNG_FORMAT_BGR}, bgr, stride);
}

}  // namespace primitect::io
