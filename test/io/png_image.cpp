// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depths come out of PNGs as they went in, broken ones are told, and pictures can be read by others.
#include "io/png_image.h"

#include <opencv2/imgproc.hpp>

#include "core/random.h"
#include "temporary_folder.h"
#include "test/support/png_files.h"

namespace primitect::io::png_image_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t kMost = 1u << 24;

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
  EXPECT_EQ(causeOf(test::claiming(png, 4, 4)), "broken or truncated PNG data");
}

TEST(DepthPngs, ThatEndTooEarlyAreToldWhereverTheyEnd) {
  for (const Bytes& whole : {test::encodedPng(depths(9, 7)), interlaced(depths(9, 7))}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_EQ(causeOf(part), size < 33 ? "no PNG" : "broken or truncated PNG data") << size << " of " << whole.size();
    }
  }
}

TEST(DepthPngs, NeverCrashTheirReaderHoweverTheyAreBroken) {
  const cv::Mat image = depths(9, 7);
  const Bytes whole = test::encodedPng(image);
  Random random(5);
  int refused = 0;
  constexpr int kTimes = 3000;
  for (int time = 0; time < kTimes; ++time) {
    Bytes broken = whole;
    broken[random.below(broken.size())] ^= static_cast<std::uint8_t>(1 + random.below(255));
    const std::string cause = causeOf(broken);
    if (cause.empty()) expectSame(broken, image);  // a chunk that says nothing of the pixels
    refused += !cause.empty();
  }
  EXPECT_GT(refused, kTimes / 2);
}

class PicturePngs : public test::TemporaryFolder {};

TEST_F(PicturePngs, AreReadAsTheyWereWritten) {
  cv::Mat picture(30, 40, CV_8UC3);
  cv::randu(picture, cv::Scalar::all(0), cv::Scalar::all(256));
  const cv::Mat part = picture(cv::Rect(5, 6, 11, 13));  // rows lie farther apart than they are long
  writePicturePng(path("part.png"), part.data, 11, 13, part.step);
  const cv::Mat read = test::readPicture(path("part.png"));
  ASSERT_EQ(read.size(), part.size());
  EXPECT_EQ(cv::norm(read, part, cv::NORM_INF), 0.0);
}

TEST_F(PicturePngs, ThatCannotBeWrittenSayWhy) {
  const cv::Mat picture(30, 40, CV_8UC3, cv::Scalar::all(7));
  const auto causeOfWriting = [&](const std::string& to) -> std::string {
    try {
      writePicturePng(to, picture.data, 40, 30, picture.step);
    } catch (const PngError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(causeOfWriting(path("no/such/folder.png")), "No such file or directory");
  EXPECT_NE(causeOfWriting("/dev/full"), "");
}

}  // namespace
}  // namespace primitect::io::png_image_test
