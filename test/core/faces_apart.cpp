// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces in one plane, by what is seen between them.
#include "core/faces_apart.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/label_runs.h"

namespace primitect {
namespace {

const Plane kWall = {Vec3(0, 0, 1), -Vec3::UnitZ()};
const NoiseModel kNoise = {0.0, 0.002};

/// An image as it is drawn, each character a square of pixels: `#` the wall, `.` 20 cm behind it, `+` 20 cm before it,
/// `-` less behind it than noise may take a point, a space for nothing measured.
class Image {
 public:
  explicit Image(const std::vector<std::string>& drawing, std::uint32_t pixels = 8) {
    width_ = pixels * static_cast<std::uint32_t>(drawing.front().size());
    const auto height = pixels * static_cast<std::uint32_t>(drawing.size());
    cloud_.reset(width_, height, false);
    for (std::uint32_t i = 0; i < width_ * height; ++i) {
      const std::uint32_t column = i % width_, row = i / width_;
      const char drawn = drawing[row / pixels][column / pixels];
      labels_.push_back(drawn == '#' ? 1 : 0);
      const float z = drawn == '#' ? 1.0f : drawn == '.' ? 1.2f : drawn == '+' ? 0.8f : drawn == '-' ? 1.006f : 0.0f;
      cloud_.setPoint(i, z * (0.002f * static_cast<float>(column) - 0.2f),
                      z * (0.002f * static_cast<float>(row) - 0.2f), z, {});
    }
  }

  FacesApart faces(std::size_t least = 64) const {
    const List<LabelRun> runs = labelRuns(labels_);
    FacesApart result(boxesOfLabels(runs, 1, width_).front(), width_);
    for (const LabelRun& run : runs) result.add(run);
    result.find(cloud_, kWall, kNoise, least);
    return result;
  }

  /// Of how many points each face is; empty: the wall is one.
  std::vector<std::size_t> counts(std::size_t least = 64) const {
    const FacesApart found = faces(least);
    return {found.faces().begin(), found.faces().end()};
  }

  std::uint32_t width() const { return width_; }

 private:
  Cloud cloud_;
  std::vector<std::uint32_t> labels_;
  std::uint32_t width_;
};

using Counts = std::vector<std::size_t>;

TEST(FacesApart, AreThoseBetweenWhichIsSeenWhatLiesBehind) {
  const Image image({"............",  //
                     ".###...####.",  //
                     ".###...####.",  //
                     ".###...####.",  //
                     "............"});
  EXPECT_EQ(image.counts(), (Counts{12 * 64, 9 * 64})) << "the larger one first";
}

TEST(FacesApart, HoldTheirPointsAndNoOthers) {
  const Image image({"###...####",  //
                     "###...####",  //
                     "###.......",  //
                     ".........#"});
  const FacesApart faces = image.faces(65);
  ASSERT_EQ(faces.faces(), (List<std::size_t>{9 * 64, 8 * 64}));
  EXPECT_EQ(faces.count(), 18u * 64);
  const auto at = [&](std::uint32_t column, std::uint32_t row) {
    return faces.faceAt(8 * row * image.width() + 8 * column);
  };
  EXPECT_EQ(at(0, 0), 0);
  EXPECT_EQ(at(2, 2), 0);
  EXPECT_EQ(at(6, 0), 1);
  EXPECT_EQ(at(9, 1), 1);
  EXPECT_EQ(at(9, 3), FacesApart::kNone) << "too few points for a face";
}

TEST(FacesApart, AreOneWhereTheyTouch) {
  EXPECT_EQ(Image({"###...###",  //
                   "###...###",  //
                   "#########"})
                .counts(),
            Counts());
}

TEST(FacesApart, AreApartWhereOnlyALineJoinsThem) {
  // Where the table meets the plane of two fronts its points lie in that plane, too.
  const Image image({"######......######",  //
                     "######......######",  //
                     "######......######",  //
                     "######......######",  //
                     "######......######",  //
                     "##################"},
                    4);
  const FacesApart faces = image.faces();
  ASSERT_EQ(faces.faces().size(), 2u);
  EXPECT_EQ(faces.faceAt(23 * image.width() + 36), FacesApart::kNone) << "of neither";
}

TEST(FacesApart, AreOneWhereTheyMayGoOnBehindWhatHidesThem) {
  EXPECT_EQ(Image({"###.+.###",  //
                   "###+++###",  //
                   "###.+.###"})
                .counts(),
            Counts());
}

TEST(FacesApart, AreOneWhereNothingWasMeasuredBetweenThem) {
  EXPECT_EQ(Image({"###...###",  //
                   "###   ###",  //
                   "###...###"})
                .counts(),
            Counts());
}

TEST(FacesApart, AreOneWhereWhatIsBetweenThemMayBeNoise) {
  EXPECT_EQ(Image({"###...###",  //
                   "###---###",  //
                   "###...###"})
                .counts(),
            Counts());
}

TEST(FacesApart, AreApartWhereBelowThemAllSomethingIsNearer) {
  // The fronts of two boxes on a table.
  EXPECT_EQ(Image({"....................",  //
                   "..######....######..",  //
                   "..######....######..",  //
                   "..######....######..",  //
                   "..######....######..",  //
                   "..######....######..",  //
                   "..######....######..",  //
                   "++++++++++++++++++++",  //
                   "++++++++++++++++++++"})
                .counts(),
            (Counts{36 * 64, 36 * 64}));
}

TEST(FacesApart, AreThreeOfThree) {
  EXPECT_EQ(Image({"##...###..",  //
                   "##...###..",  //
                   "..........",  //
                   "..........",  //
                   "...#######"})
                .counts(),
            (Counts{7 * 64, 6 * 64, 4 * 64}));
}

TEST(FacesApart, NeedTheirLeastPoints) {
  const Image image({"###...##",  //
                     "###...##"});
  EXPECT_EQ(image.counts(4 * 64), (Counts{6 * 64, 4 * 64}));
  EXPECT_EQ(image.counts(4 * 64 + 1), Counts()) << "then the plane stays whole";
}

TEST(FacesApart, AreToldApartInLargeImagesToo) {
  // 648 x 162 pixels.
  const Image image({"########........########",  //
                     "########........########",  //
                     "########........########",  //
                     "########........########",  //
                     "########........########",  //
                     "########........########"},
                    27);
  EXPECT_EQ(image.counts(), (Counts{48 * 27 * 27, 48 * 27 * 27}));
}

TEST(FacesApart, AreOneInNarrowStripsWhereNothingWasMeasuredBetweenThem) {
  const std::vector<std::string> strip = {"################    ################"};
  for (const std::uint32_t pixels : {2, 4, 6, 8}) {
    EXPECT_EQ(Image(strip, pixels).counts(16), Counts()) << pixels / 2 << " cells wide";
  }
  EXPECT_EQ(Image({"################....################"}, 6).counts(16), (Counts{16 * 36, 16 * 36}))
      << "but not here";
}

TEST(BoxesOfLabels, HoldTheirRunsOverSeveralRows) {
  // 4 x 3 pixels.
  const std::vector<std::uint32_t> labels = {0, 0, 0, 1,  //
                                             1, 0, 2, 2,  //
                                             0, 0, 2, 9};
  const List<PixelBox> boxes = boxesOfLabels(labelRuns(labels), 3, 4);
  ASSERT_EQ(boxes.size(), 3u);
  const auto expectBox = [&](std::size_t k, const PixelBox& box) {
    EXPECT_EQ(boxes[k].left, box.left) << k;
    EXPECT_EQ(boxes[k].right, box.right) << k;
    EXPECT_EQ(boxes[k].top, box.top) << k;
    EXPECT_EQ(boxes[k].bottom, box.bottom) << k;
  };
  expectBox(0, {0, 3, 0, 1});
  expectBox(1, {2, 3, 1, 2});
  EXPECT_GT(boxes[2].left, boxes[2].right) << "no point has this label";
}

}  // namespace
}  // namespace primitect
