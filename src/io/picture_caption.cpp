// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Words in rows; see picture_caption.h.
#include "io/picture_caption.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <sstream>
#include <vector>

#include "io/cut_away.h"
#include "io/kind_color.h"
#include "io/length_text.h"
#include "io/name_tags.h"
#include "io/shape_text.h"

namespace primitect::io {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;

/// Something that is not broken, and where it stands.
struct Piece {
  std::string text;
  cv::Scalar color;
  std::optional<cv::Scalar> square = std::nullopt;  ///< before the text
  bool begins_row = false;
  int x = 0, row = 0;
};

/// Sizes in px.
struct Layout {
  double scale;
  int line, width;

  explicit Layout(int picture_width)
      : scale(textScale(picture_width)), line(static_cast<int>(42 * scale)), width(picture_width) {}

  int margin() const { return line / 2; }
  int lengthOf(const std::string& text) const { return cv::getTextSize(text, kFont, scale, 1, nullptr).width; }
  int lengthOf(const Piece& piece) const { return lengthOf(piece.text) + (piece.square ? line : 0); }
  bool fits(const std::string& text) const { return lengthOf(text) + 2 * margin() <= width; }
};

std::string shortened(std::string text, const Layout& layout) {
  if (layout.fits(text)) return text;
  while (text.size() > 1 && !layout.fits("..." + text)) text.erase(0, 1);
  return "..." + text;
}

/// Gives each piece its place; returns the number of rows.
int arrange(std::vector<Piece>& pieces, const Layout& layout) {
  int x = layout.margin(), row = 1;
  for (Piece& piece : pieces) {
    const int length = layout.lengthOf(piece);
    const bool too_long = x > layout.margin() && x + length + layout.margin() > layout.width;
    if (piece.begins_row || too_long) x = layout.margin(), ++row;
    piece.x = x, piece.row = row;
    x += length + (piece.square ? layout.line / 2 : layout.lengthOf(" "));
  }
  return row;
}

std::string countText(int count, Kind kind) {
  return std::to_string(count) + " " + kindName(kind) + (count == 1 ? "" : "s");
}

/// "nearer than 1.00 m or farther than 2.00 m", what of it there is.
std::string notUsedText(const LabelledPoints& points) {
  const CutAway cut = cutAway(points.cloud, points.used);
  std::string text = cut.nearer > 0 ? "nearer than " + lengthText(points.used.min) : "";
  if (cut.farther > 0) text += (text.empty() ? "" : " or ") + ("farther than " + lengthText(points.used.max));
  return text;
}

void addWords(const std::string& text, std::vector<Piece>& pieces) {
  std::istringstream words(text);
  bool first = true;
  for (std::string word; words >> word; first = false) {
    pieces.push_back({word, cv::Scalar::all(190), std::nullopt, first});
  }
}

std::vector<Piece> piecesOf(const LabelledPoints& points, const std::string& title) {
  std::array<int, kKindCount> counts = {};
  for (const Detection& detection : points.detections.items) ++counts[detection.shape.index()];
  std::vector<Piece> pieces = {{title + " ", cv::Scalar::all(255)}};
  for (std::size_t k = 0; k < kKindCount; ++k) {
    const Rgb color = kKindColors[k];
    pieces.push_back({countText(counts[k], static_cast<Kind>(k)), cv::Scalar::all(counts[k] > 0 ? 255 : 150),
                      cv::Scalar(color.blue, color.green, color.red)});
  }
  const std::string shades = points.detections.items.empty() ? "Nothing found: " + reasonText(points.detections) + "."
                                                             : "Tinted: of the outlined shape. Grey to white: of none.";
  addWords(shades + (points.cloud.organized() ? " Black: not measured." : ""), pieces);
  const std::string not_used = notUsedText(points);
  if (!not_used.empty()) addWords("Dark: " + not_used + ", not used.", pieces);
  return pieces;
}

}  // namespace

cv::Mat drawCaption(const LabelledPoints& points, const std::string& title, int width) {
  const Layout layout(width);
  const int line = layout.line;
  std::vector<Piece> pieces = piecesOf(points, shortened(title, layout));
  const int rows = arrange(pieces, layout);
  cv::Mat caption(rows * line + line / 2, width, CV_8UC3, cv::Scalar::all(30));
  for (const Piece& piece : pieces) {
    if (piece.square) {
      const cv::Rect square(piece.x, piece.row * line - 2 * line / 3, 3 * line / 4, 3 * line / 4);
      cv::rectangle(caption, square, *piece.square, cv::FILLED);
    }
    cv::putText(caption, piece.text, {piece.x + (piece.square ? line : 0), piece.row * line}, kFont, layout.scale,
                piece.color, 1, cv::LINE_AA);
  }
  return caption;
}

}  // namespace primitect::io
