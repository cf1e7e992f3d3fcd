// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What sets use and allow; see recipe.h.
#include "eval/recipe.h"

#include <cstdio>
#include <stdexcept>

#include "synthetic/sensors.h"

namespace primitect::eval {
namespace {

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

void check(bool fine, const std::string& name, double value, const std::string& range) {
  if (!fine) throw std::invalid_argument(name + " = " + numberText(value) + ": must be in " + range);
}

void checkUnused(bool used, const Recipe& recipe, const std::string& name, double value, double usual) {
  if (used || value == usual) return;
  throw std::invalid_argument(name + " = " + numberText(value) + ": the set " + recipe.set + " does not use it");
}

}  // namespace

bool isDepthFrame(const std::string& set) {
  return set == "tabletop" || set == "clutter" || set == "household" || set == "heap" || set == "hall";
}

UsedBySet usedBySet(const std::string& set) {
  const bool on_paper_grid = startsWith(set, "paper-") || startsWith(set, "concave-") || set == "small";
  return {on_paper_grid || set == "parts", isDepthFrame(set) || set == "objects", on_paper_grid};
}

void checkRecipe(const Recipe& recipe) {
  const Recipe usual;
  const UsedBySet used = usedBySet(recipe.set);
  checkUnused(used.sigma, recipe, "sigma", recipe.sigma, usual.sigma);
  checkUnused(used.depth_frame, recipe, "noise_scale", recipe.noise_scale, usual.noise_scale);
  checkUnused(used.depth_frame, recipe, "noise_grain", recipe.noise_grain, usual.noise_grain);
  checkUnused(used.depth_frame, recipe, "blots", recipe.blots, usual.blots);
  if (!used.depth_frame && recipe.sensor != usual.sensor) {
    throw std::invalid_argument("sensor = " + recipe.sensor + ": the set " + recipe.set + " does not use it");
  }
  synthetic::noiseOf(recipe.sensor);  // throws for other names
  checkUnused(used.depth_frame, recipe, "width", recipe.width, usual.width);
  checkUnused(used.outliers, recipe, "outliers", recipe.outliers, usual.outliers);
  check(recipe.noise_scale >= 0.0 && recipe.noise_scale <= 10.0, "noise_scale", recipe.noise_scale, "0 to 10");
  check(recipe.noise_grain >= 1 && recipe.noise_grain <= 31 && recipe.noise_grain % 2 == 1, "noise_grain",
        recipe.noise_grain, "1 to 31, odd");
  check(recipe.blots >= 0.0 && recipe.blots < 1.0, "blots", recipe.blots, "[0, 1)");
  check(recipe.width >= 160 && recipe.width <= 2560, "width", recipe.width, "160 to 2560");
  check(recipe.keep > 0.0 && recipe.keep <= 1.0, "keep", recipe.keep, "(0, 1]");
  check(recipe.uneven >= 1.0 && recipe.uneven <= 1000.0, "uneven", recipe.uneven, "1 to 1000");
  check(recipe.voxel == 0.0 || (recipe.voxel >= 1e-3 && recipe.voxel <= 1.0), "voxel", recipe.voxel,
        "0, or 0.001 to 1");
}

std::string describe(const Recipe& recipe) {
  const UsedBySet used = usedBySet(recipe.set);
  std::string text;
  const auto add = [&text](bool said, const std::string& what) {
    if (said) text += (text.empty() ? "" : ", ") + what;
  };
  add(used.sigma, "sigma " + numberText(recipe.sigma));
  add(used.depth_frame, "noise x " + numberText(recipe.noise_scale));
  add(recipe.sensor != Recipe().sensor, "sensor " + recipe.sensor);
  add(recipe.blots != 0.0, "blots " + numberText(recipe.blots));
  add(recipe.noise_grain != 1, "grain " + numberText(recipe.noise_grain) + " px");
  add(recipe.width != Recipe().width, "width " + numberText(recipe.width));
  add(recipe.outliers != 0.0, "outliers " + numberText(recipe.outliers));
  add(recipe.keep != 1.0, "keep " + numberText(recipe.keep));
  add(recipe.uneven != 1.0, "uneven " + numberText(recipe.uneven));
  add(recipe.voxel != 0.0, "voxels " + numberText(recipe.voxel));
  add(recipe.listed, "as a list");
  add(recipe.shuffle, "shuffled");
  add(recipe.robot_frame, "in a robot's frame");
  return text;
}

}  // namespace primitect::eval
