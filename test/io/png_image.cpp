// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depths come out of PNGs as they went in, broken ones are told, and pictures can be read by others.
#include "io/png_image.h"

#include <sys/resource.h>

#include <opencv2/imgproc.hpp>

#include "core/random.h"
#include "temporary_folder.h"
#include "test/support/png_files.h"

namespace primitect::io::png_image_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t kMost = 1u << 24;
constexpr const char* kBroken = "broken or truncated PNG data (";

cv::Mat depths(int rows, int columns) {
  cv::Mat image(rows, columns, CV_16UC1);
  Random random(3);
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) image.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(random.below(65536));
  }
  return image;
}

void append(png_structp png, png_bytep data, std::size_t size) {
  auto& bytes = *static_cast<Bytes*>(png_get_io_ptr(png));
  bytes.insert(bytes.end(), data, data + size);
}

/// In seven passes, which the short way cannot write.
Bytes interlaced(const cv::Mat& image) {
  Bytes bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, static_cast<std::uint32_t>(image.cols), static_cast<std::uint32_t>(image.rows), 16,
               PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_set_swap(png);
  std::vector<png_bytep> rows;
  for (int v = 0; v < image.rows; ++v) rows.push_back(const_cast<png_bytep>(image.ptr(v)));
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

void expectSame(const Bytes& png, const cv::Mat& image) {
  const DepthPixels read = decodeDepthPng(png.data(), png.size(), kMost);
  ASSERT_EQ(read.width, static_cast<std::uint32_t>(image.cols));
  ASSERT_EQ(read.height, static_cast<std::uint32_t>(image.rows));
  EXPECT_EQ(read.values, std::vector<std::uint16_t>(image.begin<std::uint16_t>(), image.end<std::uint16_t>()));
}

std::string causeOf(const Bytes& png, std::uint64_t most = kMost) {
  try {
    decodeDepthPng(png.data(), png.size(), most);
  } catch (const PngError& error) {
    return error.what();
  }
  return "";
}

/// Pixels of one value, which pack well.
cv::Mat evenDepths(int rows, int columns) { return cv::Mat(rows, columns, CV_16UC1, cv::Scalar(1000)); }

TEST(DepthPngs, ComeOutAsTheyWentIn) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(37, 23), cv::Size(320, 240)}) {
    const cv::Mat image = depths(size.height, size.width);
    expectSame(test::encodedPng(image), image);
    expectSame(interlaced(image), image);
  }
}

TEST(DepthPngs, OfOtherPixelsAreRefused) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_16UC3}) {
    EXPECT_EQ(causeOf(test::encodedPng(cv::Mat(3, 4, type, cv::Scalar::all(1)))),
              "the PNG is not one of 16 bits and one channel");
  }
}

TEST(DepthPngs, OfTooManyPixelsAreRefused) {
  const Bytes png = test::encodedPng(depths(3, 4));
  EXPECT_EQ(causeOf(png, 12), "");
  EXPECT_EQ(causeOf(png, 11), "the PNG has 12 pixels, expected are at most 11");
  EXPECT_EQ(causeOf(test::claiming(png, 65536, 65536)), "the PNG has 4294967296 pixels, expected are at most 16777216");
  EXPECT_EQ(causeOf(test::claiming(png, 4, 4)).find(kBroken), 0u);
}

TEST(DepthPngs, ThatEndTooEarlyAreToldWhereverTheyEnd) {
  for (const Bytes& whole : {test::encodedPng(depths(9, 7)), interlaced(depths(9, 7))}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_EQ(causeOf(part).find(size < 8 ? "no PNG" : kBroken), 0u) << size << " of " << whole.size();
    }
  }
}

TEST(DepthPngs, SayWhatIsBroken) {
  Bytes png = test::encodedPng(depths(3, 4));
  png[png.size() - 13] ^= 1;  // of the checksum of the pixels
  EXPECT_NE(causeOf(png).find("CRC"), std::string::npos) << causeOf(png);
  png.resize(40);
  EXPECT_NE(causeOf(png).find("ends too early"), std::string::npos) << causeOf(png);
}

TEST(DepthPngs, NeverCrashTheirReaderHoweverTheyAreBroken) {
  Random random(5);
  int refused = 0;
  constexpr int kTimes = 6000;
  const Bytes wholes[] = {test::encodedPng(depths(9, 7)), interlaced(depths(9, 7)),
                          test::encodedPng(evenDepths(70, 90)), interlaced(evenDepths(70, 90))};
  for (int time = 0; time < kTimes; ++time) {
    Bytes broken = wholes[time % 4];
    broken[random.below(broken.size())] ^= static_cast<std::uint8_t>(1 + random.below(255));
    // Else nothing but the checksum is looked at.
    for (std::size_t at = 8; at != 0 && random.below(8) != 0;) at = test::checksumChunk(broken, at);
    refused += !causeOf(broken, 10000).empty();
  }
  EXPECT_GT(refused, kTimes / 10);
  EXPECT_LT(refused, kTimes) << "some are read";
}

/// What this process has taken from the system at most (kB).
long mostMemory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(DepthPngs, WithTextsThatUnpackToGigabytesAreReadWithoutThem) {
  const cv::Mat image = depths(9, 7);
  const Bytes whole = test::encodedPng(image);
  const std::vector<std::uint8_t> text(4 << 20, 'a');
  uLongf size = compressBound(text.size());
  Bytes chunk = {0, 0, 0, 0, 'z', 'T', 'X', 't', 'a', 0, 0};
  chunk.resize(chunk.size() + size);
  ASSERT_EQ(compress(chunk.data() + 11, &size, text.data(), text.size()), Z_OK);
  chunk.resize(11 + size + 4);
  const std::size_t length = 3 + size;
  chunk[2] = static_cast<std::uint8_t>(length >> 8), chunk[3] = static_cast<std::uint8_t>(length);
  ASSERT_LT(length, 65536u);
  ASSERT_EQ(test::checksumChunk(chunk, 0), chunk.size());
  Bytes png(whole.begin(), whole.begin() + 33);  // texts follow the header
  for (int time = 0; time < 50; ++time) png.insert(png.end(), chunk.begin(), chunk.end());
  png.insert(png.end(), whole.begin() + 33, whole.end());
  const long before = mostMemory();
  expectSame(png, image);
  EXPECT_LT(mostMemory() - before, 100000) << "of 200 MB";
}

class PngFiles : public test::TemporaryFolder {
 protected:
  static Bytes bytesOf(const std::string& text) { return Bytes(text.begin(), text.end()); }
};

TEST_F(PngFiles, OfDepthsAreReadAsTheyWereWritten) {
  const cv::Mat image = depths(23, 37);
  DepthPixels pixels = {37, 23, std::vector<std::uint16_t>(image.begin<std::uint16_t>(), image.end<std::uint16_t>())};
  pixels.values[0] = 0, pixels.values[1] = 65535;
  writeDepthPng(path("depth.png"), pixels);
  const Bytes png = bytesOf(read(path("depth.png")));
  const DepthPixels again = decodeDepthPng(png.data(), png.size(), kMost);
  EXPECT_EQ(again.width, 37u);
  EXPECT_EQ(again.height, 23u);
  EXPECT_EQ(again.values, pixels.values);
  pixels.values.pop_back();
  EXPECT_THROW(writeDepthPng(path("short.png"), pixels), std::invalid_argument);
  EXPECT_THROW(writeDepthPng(path("empty.png"), {}), std::invalid_argument);
}

TEST_F(PngFiles, OfPicturesAreReadAsTheyWereWritten) {
  cv::Mat picture(30, 40, CV_8UC3);
  cv::randu(picture, cv::Scalar::all(0), cv::Scalar::all(256));
  const cv::Mat part = picture(cv::Rect(5, 6, 11, 13));  // rows lie farther apart than they are long
  writePicturePng(path("part.png"), part.data, 11, 13, part.step);
  const cv::Mat read = test::readPicture(path("part.png"));
  ASSERT_EQ(read.size(), part.size());
  EXPECT_EQ(cv::norm(read, part, cv::NORM_INF), 0.0);
}

TEST_F(PngFiles, ThatCannotBeWrittenSayWhy) {
  const auto causeOfWriting = [](const std::string& to, int size) -> std::string {
    cv::Mat picture(size, size, CV_8UC3);
    cv::randu(picture, cv::Scalar::all(0), cv::Scalar::all(256));
    try {
      writePicturePng(to, picture.data, static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(size),
                      picture.step);
    } catch (const PngError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(causeOfWriting(path("no/such/folder.png"), 10), "No such file or directory");
  for (const int size : {10, 400}) EXPECT_EQ(causeOfWriting("/dev/full", size), "No space left on device") << size;
}

}  // namespace
}  // namespace primitect::io::png_image_test
