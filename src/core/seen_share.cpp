// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Asks the image at a grid of pixels; see seen_share.h.
#include "core/seen_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/observed_part.h"
#include "core/ramp.h"

namespace primitect {
namespace {

/// Below the one share nothing is left of the confidence, above the other all of it.
constexpr double kNoTrust = 0.75, kFullTrust = 0.9;

/// The box around some pixels.
class Box {
 public:
  Box(const List<std::uint32_t>& pixels, std::uint32_t width) {
    for (const std::uint32_t i : pixels) {
      const int column = static_cast<int>(i % width), row = static_cast<int>(i / width);
      left_ = std::min(left_, column), right_ = std::max(right_, column);
      top_ = std::min(top_, row), bottom_ = std::max(bottom_, row);
    }
  }

  /// Calls use(column, row) for at most about so many places, in a grid: for every third one of every third row, then
  /// for another such ninth, until settled().
  template <class Use, class Settled>
  void forPlaces(double count, const Use& use, const Settled& settled) const {
    const double area = static_cast<double>(right_ - left_ + 1) * static_cast<double>(bottom_ - top_ + 1);
    const int step = std::max(1, static_cast<int>(std::sqrt(area / count)));
    constexpr Place kFirst[] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}, {0, 2}, {1, 0}, {2, 1}};
    for (const Place& first : kFirst) {
      for (int row = top_ + first.row * step; row <= bottom_; row += 3 * step) {
        for (int column = left_ + first.column * step; column <= right_; column += 3 * step) use(column, row);
      }
      if (settled()) return;
    }
  }

 private:
  struct Place {
    int column, row;
  };

  int left_ = std::numeric_limits<int>::max(), right_ = -1;
  int top_ = std::numeric_limits<int>::max(), bottom_ = -1;
};

/// How much of what was looked for was seen.
struct Count {
  double surface = 0.0, behind = 0.0, other = 0.0;

  void add(Sight sight) {
    // With a fifth of its surface missing a can keeps all of its confidence, with a half nearly none.
    constexpr double kBlot = 0.25;
    // Holes of glossy and dark things reach to their limb, or to what stands before them. With 1 a hundredth less is
    // found on tables a fifth of whose points are lost in blots; with 0.25 a calibration board whose dark squares are
    // missing carries cones in twice as many draws.
    constexpr double kHole = 0.5;
    surface += sight == Sight::surface ? 1.0 : 0.0;
    behind += sight == Sight::behind ? 1.0 : 0.0;
    other += sight == Sight::other ? 1.0 : sight == Sight::hole ? kHole : sight == Sight::blot ? kBlot : 0.0;
  }
  void add(const Count& more) { surface += more.surface, behind += more.behind, other += more.other; }
  double asked() const { return surface + behind + other; }
  double of(double some) const { return some / asked(); }
  double share() const { return of(surface); }
  bool enough() const {
    constexpr double kFewest = 100.0;  // a share of 0.9 is then known to 0.03
    return asked() >= kFewest;
  }

  /// More places would hardly change what is left of the confidence, as if each was seen or not on its own: most shapes
  /// are seen to nearly all. A ninth or two of the places settle them: with quarters, .4 % more of a table's time. Of
  /// others it is to be told where along their axis they are seen.
  bool settled() const {
    constexpr double kDeviations = 3.0;
    // A share of 0.85 is then known to 0.016, in a grid rather better. Of what is seen to about so much all places were
    // asked: 2 % of the instructions of a frame that is full of it.
    constexpr double kMost = 500.0;
    if (!enough()) return false;
    if (asked() >= kMost) return true;
    const double margin = kDeviations * std::sqrt(share() * (1.0 - share()) / asked());
    return share() - margin > kFullTrust;
  }
};

/// The places by where they are along the axis of an extent.
class CountsAlong {
 public:
  explicit CountsAlong(const Extent& extent)
      : origin_(extent.origin), axis_(extent.rotation.col(2)), length_(extent.size.z()) {}

  void add(const Vec3& point, Sight sight) {
    const double along = (point - origin_).dot(axis_) / length_ + 0.5;  // 0 to 1; of no length no number
    const double bin = std::clamp(along * static_cast<double>(kBins), 0.0, static_cast<double>(kBins - 1));
    in_bin_[bin == bin ? static_cast<std::size_t>(bin) : 0].add(sight);
    all_.add(sight);
  }

  const Count& all() const { return all_; }

  /// Bins in a row.
  struct Run {
    std::size_t first = 0, end = kBins;
    Count count;

    bool isWhole() const { return end - first == kBins; }
  };

  /// Those whose places speak most for the surface, where this share of them says neither, with those beside them that
  /// nobody could look at; all where none speak for it.
  Run bestRun(double neither) const {
    Run best, run;
    best.count = all_;
    double most = 0.0, sum = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      if (sum < 0.0) sum = 0.0, run = {bin, bin, {}};
      sum += in_bin_[bin].surface - neither * in_bin_[bin].asked();
      run.count.add(in_bin_[bin]), run.end = bin + 1;
      if (sum > most) most = sum, best = run;
    }
    while (best.end < kBins && in_bin_[best.end].asked() == 0.0) ++best.end;
    return best;
  }

  /// Without an end where the extent has its own.
  AxisPart along(const Run& run) const {
    constexpr float kNone = std::numeric_limits<float>::infinity();
    return {run.first > 0 ? at(run.first) : -kNone, run.end < kBins ? at(run.end) : kNone};
  }

 private:
  static constexpr std::size_t kBins = 24;

  /// m, from the origin.
  float at(std::size_t bin) const {
    return static_cast<float>((static_cast<double>(bin) / static_cast<double>(kBins) - 0.5) * length_);
  }

  Vec3 origin_, axis_;
  double length_;
  std::array<Count, kBins> in_bin_;
  Count all_;
};

template <class T>
CountsAlong countOn(const T& shape, const Detection& detection, const List<std::uint32_t>& pixels,
                    const AskedImage& image) {
  constexpr double kProbes = 2000.0;  // of the box: even a tube across it gets some hundred
  const ObservedPart part(detection.shape, detection.extent);
  const auto on = opened(shape);
  const double middle = image.cloud.z[pixels[pixels.size() / 2]];
  const Looking looking(on, middle, image);
  double nearby = middle;
  CountsAlong count(detection.extent);
  const auto lookAt = [&](int column, int row) {
    const Vec3 ray = image.rays.through(column, row);
    const std::optional<double> z = depthOn(on, ray, nearby);
    nearby = middle;
    if (!z) return;
    const Vec3 point = *z * ray;
    const Eigen::Vector3f flat = point.cast<float>();
    if (!faces(shape, detection.concave, point)) return;
    nearby = *z;  // from a probe that met the far side, the next would, too
    if (part.depth(flat.x(), flat.y(), flat.z()) < 0.0f) return;
    count.add(point, looking.at(column, row, point));
  };
  Box(pixels, image.cloud.width).forPlaces(kProbes, lookAt, [&count] { return count.all().settled(); });
  return count;
}

/// Nothing for other kinds, and where there are too few places to tell.
std::optional<CountsAlong> countAt(const Detection& detection, const List<std::uint32_t>& pixels,
                                   const AskedImage& image) {
  if (!image.rays.known || pixels.empty()) return std::nullopt;
  std::optional<CountsAlong> count;
  if (const Cylinder* tube = std::get_if<Cylinder>(&detection.shape)) {
    count = countOn(*tube, detection, pixels, image);
  } else if (const Cone* cone = std::get_if<Cone>(&detection.shape)) {
    count = countOn(*cone, detection, pixels, image);
  }
  return count && count->all().enough() ? count : std::nullopt;
}

}  // namespace

SeenShare seenShare(const Detection& detection, const List<std::uint32_t>& pixels, const AskedImage& image) {
  // Of the places in what is no more of a tube or cone there is a third at most on other surfaces by chance. With .6
  // clutter that a stereo camera sees carries .21 false curved shapes a frame instead of .17 (compare --set clutter
  // --sensor stereo --seeds 5200:40 --algorithm-seeds 1,2).
  constexpr double kByChance = 0.35;
  const std::optional<CountsAlong> count = countAt(detection, pixels, image);
  if (!count) return {};
  const double all = count->all().share();
  if (all >= kFullTrust) return {all, std::nullopt, all};
  const CountsAlong::Run run = count->bestRun(kByChance);
  if (run.isWhole()) return {all, std::nullopt, all};
  return {all, count->along(run), run.count.share()};
}

bool isSeenSomewhere(const Detection& detection, const List<std::uint32_t>& pixels, const AskedImage& image) {
  constexpr double kLeast = 0.2;
  const std::optional<CountsAlong> count = countAt(detection, pixels, image);
  if (!count || count->all().share() > kNoTrust) return true;
  const Count best = count->bestRun(kNoTrust).count;
  return best.share() > kNoTrust && best.asked() >= kLeast * count->all().asked();
}

double behindShare(const Detection& detection, const List<std::uint32_t>& pixels, const AskedImage& image) {
  const std::optional<CountsAlong> count = countAt(detection, pixels, image);
  return count ? count->all().of(count->all().behind) : 0.0;
}

double trustInShare(double seen_share) { return ramp(kNoTrust, kFullTrust, seen_share); }

}  // namespace primitect
