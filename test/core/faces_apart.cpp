// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces in one plane, by what is seen between them.
#include "core/faces_apart.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/label_runs.h"

namespace primitect::faces_apart_test {
namespace {

const Plane kWall = {Vec3(0, 0, 1), -Vec3::UnitZ()};
const NoiseModel kNoise = {0.0, 0.002};

/// An image as it is drawn, each character a square of pixels: `#` the wall, `.` 20 cm behind it, `+` 20 cm before it,
/// `-` and `:` 11 and 14 mm behind it, where six standard deviations are 12, `_` a point of something else 3 mm behind
/// it, `*` what was cut away at 2 m, a space for nothing measured.
class Image {
 public:
  explicit Image(const std::vector<std::string>& drawing, std::uint32_t pixels = 8) {
    width_ = pixels * static_cast<std::uint32_t>(drawing.front().size());
    const auto height = pixels * static_cast<std::uint32_t>(drawing.size());
    cloud_.reset(width_, height, false);
    for (std::uint32_t i = 0; i < width_ * height; ++i) {
      const std::uint32_t column = i % width_, row = i / width_;
      const char drawn = drawing[row / pixels][column / pixels];
      labels_.push_back(drawn == '#' ? 1 : drawn == '_' ? 2 : 0);
      const float z = depthOf(drawn);
      cloud_.setPoint(i, z * (0.002f * static_cast<float>(column) - 0.2f),
                      z * (0.002f * static_cast<float>(row) - 0.2f), z, {0.0f, 2.0f});
    }
  }

  FacesApart faces(std::size_t least = 64, const Plane& wall = kWall, bool far_is_behind = true) const {
    const List<LabelRun> runs = labelRuns(labels_);
    FacesApart result(boxesOfLabels(runs, 1, width_).front(), width_);
    for (const LabelRun& run : runs) {
      if (run.label == 1) result.add(run);
    }
    result.find({cloud_, labels_, kNoise, far_is_behind}, wall, least);
    return result;
  }

  /// Of how many points each face is; empty: the wall is one.
  std::vector<std::size_t> counts(std::size_t least = 64) const {
    const FacesApart found = faces(least);
    return {found.faces().begin(), found.faces().end()};
  }

  std::uint32_t width() const { return width_; }

 private:
  /// m; 0: missing.
  static float depthOf(char drawn) {
    switch (drawn) {
      case '#':
        return 1.0f;
      case '.':
        return 1.2f;
      case '+':
        return 0.8f;
      case '-':
        return 1.011f;
      case ':':
        return 1.014f;
      case '_':
        return 1.003f;
      case '*':
        return 3.0f;
      default:
        return 0.0f;
    }
  }

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

TEST(FacesApart, AreThoseBetweenWhichWhatWasCutAwayLiesFarBehind) {
  const Image image({"************",  //
                     "*###***####*",  //
                     "*###***####*",  //
                     "*###***####*",  //
                     "************"});
  EXPECT_EQ(image.counts(), (Counts{12 * 64, 9 * 64}));
  // The plane comes near to the bound: noise may have taken the points between.
  EXPECT_TRUE(image.faces(64, kWall, false).faces().empty());
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
  // Cells are two pixels wide. Where the table meets the plane of two fronts its points lie in that plane, too.
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

/// Three rows of a face, something nearer, and another face.
std::vector<std::string> hiddenBetween(std::size_t one, std::size_t gap, std::size_t other) {
  return std::vector<std::string>(3, std::string(one, '#') + std::string(gap, '+') + std::string(other, '#'));
}

std::vector<std::string> turned(const std::vector<std::string>& drawing) {
  std::vector<std::string> columns(drawing.front().size());
  for (const std::string& row : drawing) {
    for (std::size_t k = 0; k < row.size(); ++k) columns[k] += row[k];
  }
  return columns;
}

TEST(FacesApart, AreOneBehindWhatIsNoWiderThanBothTogetherAreLong) {
  struct Case {
    std::size_t one, other, narrow, wide;
  };
  for (const Case& lengths : {Case{3, 3, 5, 7}, Case{5, 5, 9, 11}, Case{12, 3, 14, 16}}) {
    const auto [one, other, narrow, wide] = lengths;
    EXPECT_EQ(Image(hiddenBetween(one, narrow, other)).counts(), Counts()) << one;
    EXPECT_EQ(Image(turned(hiddenBetween(one, narrow, other))).counts(), Counts()) << one;
    const Counts apart = {one * 3 * 64, other * 3 * 64};
    EXPECT_EQ(Image(hiddenBetween(one, wide, other)).counts(), apart) << one;
    EXPECT_EQ(Image(turned(hiddenBetween(one, wide, other))).counts(), apart) << one;
  }
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
  EXPECT_EQ(Image({"###...###",  //
                   "###:::###",  //
                   "###...###"})
                .counts(),
            (Counts{9 * 64, 9 * 64}));
}

TEST(FacesApart, AreApartWhereSomethingElseLiesBetweenThem) {
  EXPECT_EQ(Image({"###...###",  //
                   "###___###",  //
                   "###___###"})
                .counts(),
            (Counts{9 * 64, 9 * 64}));
}

TEST(FacesApart, AreOneWhereMostOfWhatIsBetweenThemHidesThem) {
  // Cells are four of these pixels.
  std::vector<std::string> quarter, half;
  for (int row = 0; row < 24; ++row) {
    quarter.push_back(std::string(24, '#') + std::string(24, '+') + std::string(24, '#'));
    half.push_back(quarter.back());
    for (int column = 24; column < 48; column += 2) {
      if (row % 2 == 0) quarter.back()[column] = '.';
      half.back()[column] = '.';
    }
  }
  EXPECT_EQ(Image(quarter, 1).counts(), Counts());
  EXPECT_EQ(Image(half, 1).counts(), (Counts{24 * 24, 24 * 24}));
}

TEST(FacesApart, AreTheSameWhicheverWayTheNormalPoints) {
  const Plane turned = {kWall.point, -kWall.normal};
  const Image gap({"###...###",  //
                   "###...###",  //
                   "###...###"});
  EXPECT_EQ(gap.faces(64, turned).faces(), gap.faces(64, kWall).faces());
  const Image hidden({"###.+.###",  //
                      "###+++###",  //
                      "###.+.###"});
  EXPECT_TRUE(hidden.faces(64, turned).faces().empty());
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

TEST(FacesApart, MayBeThreeCellsWide) {
  const Image image({"###..###",  //
                     "###..###",  //
                     "###..###"},
                    2);
  EXPECT_EQ(image.counts(36), (Counts{36, 36}));
  const Image narrower({"##..##",  //
                        "##..##"},
                       2);
  EXPECT_EQ(narrower.counts(16), Counts());
  EXPECT_EQ(narrower.faces(16).faceAt(0), FacesApart::kNone) << "it has none";
}

TEST(FacesApart, EndWhereTheyBecomeNarrow) {
  // One cell wide: it may be where another surface passes through the plane.
  const Image image({"########...####",  //
                     "####.......####",  //
                     "####.......####",  //
                     "####.......####"},
                    2);
  const FacesApart faces = image.faces(36);
  EXPECT_EQ(faces.faces(), (List<std::size_t>{16 * 4, 16 * 4}));
  EXPECT_NEAR(faces.left(), 4.0 / 36.0, 1e-9);
}

TEST(FacesApart, InAnImageThatThePlaneFillsAreNineteenPixelsWideAndSeventeenApart) {
  constexpr std::uint32_t kWidth = 640, kHeight = 480;
  // A frame around all, and a square at any place in it.
  const auto facesOf = [](std::uint32_t left, std::uint32_t size, std::uint32_t gap) {
    std::vector<std::string> image(kHeight, std::string(kWidth, '#'));
    for (std::uint32_t row = 100 - gap; row < 100 + size + gap; ++row) {
      for (std::uint32_t column = left - gap; column < left + size + gap; ++column) {
        const bool square = row >= 100 && row < 100 + size && column >= left && column < left + size;
        image[row][column] = square ? '#' : '.';
      }
    }
    return Image(image, 1).counts(300).size();
  };
  for (std::uint32_t place = 300; place < 309; ++place) {
    EXPECT_EQ(facesOf(place, 19, 40), 2u) << place;
    EXPECT_EQ(facesOf(place, 60, 17), 2u) << place;
    EXPECT_EQ(facesOf(place, 60, 8), 0u) << place;
  }
}

TEST(FacesApart, AreOneInNarrowStripsWhereNothingWasMeasuredBetweenThem) {
  const std::vector<std::string> strip = {"################    ################"};
  for (const std::uint32_t pixels : {6, 8}) EXPECT_EQ(Image(strip, pixels).counts(16), Counts()) << pixels;
  EXPECT_EQ(Image({"################....################"}, 6).counts(16), (Counts{16 * 36, 16 * 36}))
      << "but not here";
}

}  // namespace
}  // namespace primitect::faces_apart_test
