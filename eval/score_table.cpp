// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Adding up scores and printing them; see score_table.h.
#include "eval/score_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace primitect::eval {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double quotient(double part, double whole) { return whole > 0.0 ? part / whole : kNone; }

double median(std::vector<double> values) {
  if (values.empty()) return kNone;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

std::string cell(double value, int width, int decimals) {
  char text[32];
  if (std::isnan(value)) {
    std::snprintf(text, sizeof text, "%*s", width, "-");
  } else {
    std::snprintf(text, sizeof text, "%*.*f", width, decimals, value);
  }
  return text;
}

}  // namespace

void addCase(Totals& totals, const CaseScore& score, const Answer& answer) {
  constexpr std::size_t kTwoCentimeters = 10;
  static_assert(kTwoCentimeters < kCurvePoints && kCurveStep * kTwoCentimeters == 0.02, "an entry of the curves");
  ++totals.clouds;
  totals.failures += answer.failure.empty() ? 0 : 1;
  totals.counts += score.all;
  totals.false_curved += score.false_curved;
  totals.point_coverage += score.p_coverage[kTwoCentimeters];
  if (!score.s_coverage.empty()) {
    totals.shape_coverage += score.s_coverage[kTwoCentimeters];
    ++totals.shape_clouds;
  }
  if (answer.vote_ms >= 0.0) totals.vote_ms.push_back(answer.vote_ms);
  if (answer.total_ms > 0.0) totals.total_ms.push_back(answer.total_ms);
}

std::string tableHeading() {
  return "                  typed          |-------- any kind, % --------------------|   DOD / unit  coverage 0.02"
         "  false     median ms\n"
         "               prec.    rec.  prec.   rec. missed  noise   over  under    any  typed      p      s"
         " curved    vote   total";
}

std::string tableLine(const std::string& name, const Totals& totals) {
  const Counts& c = totals.counts;
  char label[32];
  std::snprintf(label, sizeof label, "%-14.14s", name.c_str());
  std::string line = label;
  for (const auto& [part, whole] :
       {std::pair{c.typed_correct, c.found}, std::pair{c.typed_correct, c.truths}, std::pair{c.correct, c.found},
        std::pair{c.correct, c.truths}, std::pair{c.missed, c.truths}, std::pair{c.noise, c.found},
        std::pair{c.over_segmented, c.truths}, std::pair{c.under_segmented, c.found}}) {
    line += cell(100.0 * quotient(part, whole), 7, 1);
  }
  line += cell(quotient(c.dod, c.correct), 7, 2) + cell(quotient(c.typed_dod, c.typed_correct), 7, 2);
  line += cell(100.0 * quotient(totals.point_coverage, totals.clouds), 7, 1);
  line += cell(100.0 * quotient(totals.shape_coverage, totals.shape_clouds), 7, 1);
  line += cell(quotient(totals.false_curved, totals.clouds), 7, 2);
  line += cell(median(totals.vote_ms), 8, 1) + cell(median(totals.total_ms), 8, 1);
  if (totals.failures > 0) line += "  (" + std::to_string(totals.failures) + " without an answer)";
  return line;
}

}  // namespace primitect::eval
