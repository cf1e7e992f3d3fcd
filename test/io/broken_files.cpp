// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A zoo of broken files: each is refused in one line that names file and cause; nothing crashes.
#include <algorithm>

#include "core/random.h"
#include "io/point_files.h"
#include "temporary_folder.h"
#include "test/support/png_files.h"

namespace primitect::io::broken_files_test {
namespace {

constexpr Intrinsics kLens = {500.0, 500.0, 20.0, 15.0};

using test::bytesOf;

class BrokenFiles : public test::TemporaryFolder {
 protected:
  /// The message without the path; fails when the file is taken.
  std::string causeOf(const std::string& file) {
    DepthImageOptions options;
    options.intrinsics = kLens;
    try {
      readPointFile(file, options);
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(file + ": "), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.substr(file.size() + 2);
    }
    ADD_FAILURE() << file << " was taken";
    return "";
  }

  void expectCause(const std::string& name, const std::string& bytes, const std::string& cause) {
    const std::string found = causeOf(write(name, bytes));
    EXPECT_NE(found.find(cause), std::string::npos) << name << ": '" << found << "' says nothing of '" << cause << "'";
  }
};

/// A PCD header in which one line can be replaced.
std::string pcd(const std::string& data, const std::string& key = "", const std::string& replacement = "") {
  std::string header;
  for (const std::string line : {"VERSION 0.7", "FIELDS x y z", "SIZE 4 4 4", "TYPE F F F", "COUNT 1 1 1", "WIDTH 3",
                                 "HEIGHT 1", "VIEWPOINT 0 0 0 1 0 0 0", "POINTS 3"}) {
    const bool replaced = !key.empty() && line.rfind(key, 0) == 0;
    const std::string text = replaced ? replacement : line;
    if (!text.empty()) header += text + "\n";
  }
  return header + "DATA " + data + "\n";
}

std::string ply(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

const std::string kText = "1 2 3\n4 5 6\n7 8 9\n";
const std::string kFloats = bytesOf<float>({1, 2, 3, 4, 5, 6, 7, 8, 9});
const std::string kVertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

TEST_F(BrokenFiles, AreRefusedWhenTheyAreNoFilesAtAll) {
  EXPECT_EQ(causeOf(path("nothing.pcd")), "no such file");
  std::filesystem::create_directories(path("folder.pcd"));
  EXPECT_EQ(causeOf(path("folder.pcd")), "is a directory, not a file");
  for (const char* name : {"empty.pcd", "empty.ply", "empty.png"}) expectCause(name, "", "is empty");
  expectCause("points.xyz", kText, "unknown extension '.xyz'");
  expectCause("points", kText, "unknown extension ''");
  expectCause("points.bag", kText, "detect_bag takes bags");
}

TEST_F(BrokenFiles, AreRefusedWhenThePcdIsTruncated) {
  expectCause("header.pcd", "VERSION 0.7\nFIELDS x y z\n", "no DATA line");
  expectCause("nothing.pcd", pcd("ascii"), "");
  expectCause("line.pcd", pcd("ascii") + "1.5 2.5 3.5\n4.5 5.5 6.5\n", "2 lines of data, its header says 3");
  expectCause("number.pcd", pcd("ascii") + "1.5 2.5 3.5\n4.5 5.5\n7 8 9\n", "data line 2 has 2 numbers, expected 3");
  expectCause("byte.pcd", pcd("binary") + kFloats.substr(1), "truncated PCD: 3 points need at least 36 bytes");
  expectCause("packed.pcd", pcd("binary_compressed") + bytesOf<std::uint32_t>({100, 36}) + "abc", "truncated PCD");
  expectCause("sizes.pcd", pcd("binary_compressed") + "ab", "truncated PCD");
}

TEST_F(BrokenFiles, AreRefusedWhenThePcdLiesAboutItsSize) {
  expectCause("many.pcd", pcd("binary", "WIDTH", "WIDTH 2000000000") + kFloats, "POINTS 3 is not WIDTH * HEIGHT");
  expectCause("huge.pcd", pcd("binary", "HEIGHT", "HEIGHT 2000000000") + kFloats, "above 2147483647");
  expectCause("negative.pcd", pcd("ascii", "WIDTH", "WIDTH -3") + kText, "WIDTH -3");
  expectCause("long.pcd", pcd("ascii", "WIDTH", "WIDTH 99999999999999999999999") + kText, "WIDTH 999");
  expectCause("points.pcd", pcd("ascii", "POINTS", "POINTS 4") + kText, "POINTS 4");
  expectCause("more.pcd", pcd("ascii") + kText + kText, "6 lines of data, its header says 3");
  expectCause("unpacked.pcd", pcd("binary_compressed") + bytesOf<std::uint32_t>({4, 4000000000u}) + "abcd",
              "claim 4000000000");
  expectCause("garbled.pcd", pcd("binary_compressed") + bytesOf<std::uint32_t>({4, 36}) + "\xff\xff\xff\xff", "PCD");
}

TEST_F(BrokenFiles, AreRefusedWhenThePcdHeaderIsWrong) {
  expectCause("size.pcd", pcd("ascii", "SIZE", "SIZE 3 4 4") + kText, "field x has TYPE F SIZE 3");
  expectCause("zero.pcd", pcd("ascii", "SIZE", "SIZE 0 4 4") + kText, "SIZE 0");
  expectCause("fewer.pcd", pcd("ascii", "SIZE", "SIZE 4 4") + kText, "differ in length");
  expectCause("count.pcd", pcd("ascii", "COUNT", "COUNT -1 1 1") + kText, "COUNT -1");
  expectCause("wide.pcd", pcd("ascii", "COUNT", "COUNT 1 1 60000") + kText, "truncated PCD");
  expectCause("twice.pcd", pcd("ascii", "FIELDS", "FIELDS x x z") + kText, "field x twice");
  expectCause("data.pcd", pcd("zip") + kText, "DATA zip");
  expectCause("no_type.pcd", pcd("ascii", "TYPE", "") + kText, "no TYPE");
  expectCause("word.pcd", pcd("ascii") + "1 2 3\n4 five 6\n7 8 9\n", "data line 2: 'five' is no number");
  expectCause("noise.pcd", std::string("\x01\x02\xff\n\x03", 5), "is not a PCD");
  expectCause("other.pcd", ply("ascii", kVertices) + kText, "is not a PCD");
}

TEST_F(BrokenFiles, AreRefusedWithoutUsableFields) {
  expectCause("no_x.pcd", pcd("ascii", "FIELDS", "FIELDS a y z") + kText, "has no field x");
  expectCause("whole.pcd", pcd("ascii", "TYPE", "TYPE F F I") + kText, "field z is not one float32 or float64");
  expectCause("part.pcd", pcd("ascii", "FIELDS", "FIELDS x y normal_x") + kText, "only a part of normal_x");
  expectCause("no_x.ply", ply("ascii", "element vertex 1\nproperty float y\nproperty float z\n") + "1 2\n",
              "has no field x");
}

/// PCL leaves out padding of a compressed file, and takes what follows from its place.
TEST_F(BrokenFiles, AreRefusedWhenACompressedPcdHasPadding) {
  const auto padded = [](const std::string& data) {
    return "VERSION 0.7\nFIELDS x y _ z\nSIZE 4 4 1 4\nTYPE F F U F\nCOUNT 1 1 4 1\nWIDTH 2\nHEIGHT 1\nPOINTS "
           "2\nDATA " +
           data + "\n";
  };
  // One run of bytes as they are, after its length less one.
  const std::string columns = bytesOf<float>({1, 4, 2, 5}) + std::string(8, '\7') + bytesOf<float>({3, 6});
  const std::string packed = bytesOf<std::uint32_t>({33, 32}) + '\x1f' + columns;
  expectCause("packed.pcd", padded("binary_compressed") + packed, "fields '_' in a compressed PCD");
  const std::string plain = bytesOf<float>({1, 2}) + "pad " + bytesOf<float>({3, 4, 5}) + "pad " + bytesOf<float>({6});
  const Cloud cloud = readPointFile(write("plain.pcd", padded("binary") + plain)).cloud;
  EXPECT_EQ(cloud.z, std::vector<float>({3, 6}));
}

TEST_F(BrokenFiles, AreRefusedWhenThePlyIsTruncated) {
  expectCause("header.ply", "ply\nformat ascii 1.0\n" + kVertices, "header is cut off");
  expectCause("line.ply", ply("ascii", kVertices) + "1.5 2.5 3.5\n4.5 5.5 6.5\n", "truncated PLY");
  expectCause("byte.ply", ply("binary_little_endian", kVertices) + kFloats.substr(1), "truncated PLY");
  expectCause("face.ply",
              ply("binary_little_endian", kVertices + "element face 1\nproperty list uint int vertex_indices\n") +
                  kFloats + bytesOf<std::uint32_t>({4000000000u}),
              "broken or truncated PLY");
}

TEST_F(BrokenFiles, AreRefusedWhenThePlyLies) {
  const std::string grid = "element range_grid 6\nproperty list uchar int vertex_indices\n";
  const std::string cells = "1 0\n1 1\n0\n1 2\n1 0\n1 1\n";
  const std::string info = "obj_info num_cols 3\nobj_info num_rows 2\n";
  expectCause("many.ply", ply("ascii", "element vertex 2000000000\nproperty float x\n") + kText, "truncated PLY");
  expectCause("negative.ply", ply("ascii", "element vertex -3\nproperty float x\n") + kText, "element vertex '-3'");
  expectCause("grid.ply",
              ply("ascii", "obj_info num_cols 30000\nobj_info num_rows 20000\n" + kVertices + grid) + kText + cells,
              "not num_cols * num_rows");
  expectCause("no_info.ply", ply("ascii", kVertices + grid) + kText + cells, "both obj_info num_cols and num_rows");
  expectCause("no_grid.ply", ply("ascii", info + kVertices) + kText, "vertex 3 is not num_cols * num_rows = 6");
  // PCL aborts the program when vertices do not fit into the grid.
  expectCause("full.ply",
              ply("ascii", "obj_info num_cols 1\nobj_info num_rows 2\n" + kVertices +
                               "element range_grid 2\nproperty list uchar int vertex_indices\n") +
                  kText + "1 0\n1 1\n",
              "more vertices than cells");
  const std::string camera = "element camera 1\nproperty int viewportx\nproperty int viewporty\n";
  expectCause("camera.ply", ply("ascii", kVertices + camera) + kText + "2 1\n", "broken or truncated PLY");
  for (const int index : {-1, -1000000, 3, 4000000}) {
    const std::string named = "names vertex " + std::to_string(index) + " of 3";
    expectCause(
        "text_grid.ply",
        ply("ascii", info + kVertices + grid) + kText + "1 0\n1 1\n0\n1 2\n1 0\n1 " + std::to_string(index) + "\n",
        named);
    std::string lists = std::string(5, '\0');
    lists += '\1' + bytesOf<std::int32_t>({index});
    expectCause("grid_of_bytes.ply", ply("binary_little_endian", info + kVertices + grid) + kFloats + lists, named);
  }
  expectCause("short_grid.ply", ply("ascii", info + kVertices + grid) + kText + "1 0\n1 1\n0\n1 2\n1 0\n2 1\n",
              "broken or truncated PLY");
}

TEST_F(BrokenFiles, AreRefusedWhenThePlyHeaderIsWrong) {
  expectCause("magic.ply", pcd("ascii") + kText, "is not a PLY");
  expectCause("format.ply", ply("zip", kVertices) + kText, "format 'zip'");
  expectCause("none.ply", ply("ascii", "element face 1\nproperty list uchar int vertex_indices\n") + "1 0\n",
              "no element vertex");
  expectCause("twice.ply", ply("ascii", kVertices + "property float x\n") + kText, "property x twice");
  expectCause("type.ply", ply("ascii", "element vertex 1\nproperty vec3 x\n") + kText, "unknown type 'vec3'");
  expectCause("first.ply", ply("ascii", "property float x\n") + kText, "before the first element");
  expectCause("word.ply", ply("ascii", kVertices) + "1 2 3\n4 five 6\n7 8 9\n", "'five' is no number");
  // PCL would read x, y and z from the wrong bytes, or abort the program.
  expectCause("list.ply", ply("ascii", "element vertex 1\nproperty list uchar int a\nproperty float x\n") + "1 5 1\n",
              "vertices with a list ('a')");
  expectCause("char.ply",
              ply("ascii", kVertices + "property char red\nproperty uchar green\nproperty uchar blue\n") +
                  "1 2 3 4 5 6\n1 2 3 4 5 6\n1 2 3 4 5 6\n",
              "red, green, blue next to each other");
  expectCause("red.ply",
              ply("ascii",
                  "element vertex 1\nproperty uchar red\nproperty float x\nproperty float y\nproperty "
                  "float z\n") +
                  "1 1 2 3\n",
              "red, green, blue next to each other");
}

/// PCL writes them beside their point, or aborts the program.
TEST_F(BrokenFiles, AreRefusedWhenThePlyHasBlueBeforeRed) {
  for (const std::string prefix : {"", "diffuse_"}) {
    std::vector<std::string> order = {"blue", "green", "red"};
    do {
      std::string colors;
      for (const std::string& color : order) colors += "property uchar " + prefix + color + "\n";
      const std::string bytes = ply("ascii", kVertices + colors) + "1 2 3 4 5 6\n1 2 3 4 5 6\n7 8 9 4 5 6\n";
      const auto place = [&](const char* color) { return std::find(order.begin(), order.end(), color); };
      if (place("blue") < place("red")) {
        expectCause("blue.ply", bytes, "blue behind red");
      } else {
        EXPECT_EQ(readPointFile(write("red.ply", bytes)).cloud.point(2), Eigen::Vector3f(7, 8, 9).cast<double>());
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST_F(BrokenFiles, AreRefusedWhenThePngIsNoDepthImage) {
  test::writePng(path("color.png"), cv::Mat(30, 40, CV_8UC3, cv::Scalar(1, 2, 3)));
  test::writePng(path("gray.png"), cv::Mat(30, 40, CV_8UC1, cv::Scalar(1)));
  test::writePng(path("wide.png"), cv::Mat(30, 40, CV_16UC3, cv::Scalar(1, 2, 3)));
  EXPECT_EQ(causeOf(path("color.png")), "PNG of 8-bit RGB, expected 16-bit gray (depth)");
  EXPECT_EQ(causeOf(path("gray.png")), "PNG of 8-bit gray, expected 16-bit gray (depth)");
  EXPECT_EQ(causeOf(path("wide.png")), "PNG of 16-bit RGB, expected 16-bit gray (depth)");
  expectCause("text.png", kText, "is not a PNG");
}

TEST_F(BrokenFiles, AreRefusedWhenThePngIsBroken) {
  cv::Mat image(30, 40, CV_16UC1);
  Random random(1);
  for (int i = 0; i < 30 * 40; ++i)
    image.at<std::uint16_t>(i / 40, i % 40) = static_cast<std::uint16_t>(random.below(9000));
  test::writePng(path("good.png"), image);
  const std::string good = read(path("good.png"));
  expectCause("cut.png", good.substr(0, good.size() / 2), "truncated PNG: a chunk claims more");
  expectCause("end.png", good.substr(0, good.size() - 12), "truncated PNG: no IEND");
  expectCause("head.png", good.substr(0, 20), "broken PNG");
  std::string huge = good, flipped = good;
  huge.replace(16, 8, "\0\1\0\0\0\1\0\0", 8);
  expectCause("huge.png", huge, "65536 x 65536 pixels cannot be in");
  flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 0x55);
  expectCause("flipped.png", flipped, "broken or truncated PNG");
  // What follows belongs to no image, and counts neither as its own nor for how many pixels it may have.
  const std::vector<std::uint8_t> claiming = test::claiming({good.begin(), good.end()}, 20000, 20000);
  const std::string rest(1 << 20, '\0');
  EXPECT_EQ(readPointFile(write("longer.png", good + rest), {kLens}).cloud.size(), 30u * 40u);
  expectCause("claims.png", std::string(claiming.begin(), claiming.end()) + rest, "the PNG has 400000000 pixels");
}

TEST_F(BrokenFiles, NeverCrashTheReaderHoweverTheyAreBroken) {
  const std::vector<std::pair<std::string, std::string>> whole = {
      {"a.pcd", pcd("ascii") + kText},
      {"b.pcd", pcd("binary") + kFloats},
      {"a.ply", ply("ascii", kVertices) + kText},
      {"b.ply", ply("binary_little_endian", kVertices) + kFloats}};
  Random random(7);
  for (int round = 0; round < 2000; ++round) {
    auto [name, bytes] = whole[random.below(whole.size())];
    const std::size_t place = random.below(bytes.size());
    switch (random.below(4)) {
      case 0:
        bytes[place] = static_cast<char>(random.below(256));
        break;
      case 1:
        bytes.resize(place);
        break;
      case 2:
        bytes.insert(place, 1, static_cast<char>('0' + random.below(10)));
        break;
      case 3:
        bytes.erase(place, 1 + random.below(6));
        break;
    }
    const std::string file = write(name, bytes);
    try {
      const Cloud cloud = readPointFile(file).cloud;
      EXPECT_EQ(cloud.size(), std::size_t{cloud.width} * cloud.height);
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).find(file), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace primitect::io::broken_files_test
