// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// peer_cgal CLOUD: CGAL Efficient RANSAC (Schnabel et al. 2007) on a point file with normals, the shapes as JSON on
// standard output. A program of its own as CGAL's shape detection is GPL: built, it falls under the GPL, and nothing
// else is linked with it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/property_map.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <ctime>
#include <iostream>
#include <set>
#include <stdexcept>

#include "eval/peers/points.h"
#include "eval/peers/sides.h"
#include "io/point_files.h"
#include "io/shape_json.h"

namespace {

using namespace primitect;

// The kernel of CGAL's own examples; Simple_cartesian<double> gives the same shapes in the same time.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PointWithNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Points = std::vector<PointWithNormal>;
using Traits =
    CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, Points, CGAL::First_of_pair_property_map<PointWithNormal>,
                                                   CGAL::Second_of_pair_property_map<PointWithNormal>>;
using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
using CgalPlane = CGAL::Shape_detection::Plane<Traits>;
using CgalSphere = CGAL::Shape_detection::Sphere<Traits>;
using CgalCylinder = CGAL::Shape_detection::Cylinder<Traits>;
using CgalCone = CGAL::Shape_detection::Cone<Traits>;

struct Options {
  std::string file;
  std::vector<std::string> kinds = {"plane", "sphere", "cylinder", "cone"};
  std::size_t samples = 0;
  std::uint64_t seed = 1;
  double epsilon = -1.0;  ///< m; negative: CGAL's default
  int repeat = 1;
};

struct Result {
  std::vector<Shape> shapes;
  double prepare_ms = 0.0, total_ms = 0.0, cpu_ms = 0.0;
};

template <class Triple>
Vec3 toVec3(const Triple& t) {
  return {t.x(), t.y(), t.z()};
}

Points readPoints(const Options& options) {
  const Cloud cloud = io::readPointFile(options.file).cloud;
  if (!cloud.hasNormals()) throw std::runtime_error(options.file + ": has no normals");
  Points points;
  for (const std::uint32_t i : eval::drawPoints(eval::usablePoints(cloud), options.samples, options.seed)) {
    points.emplace_back(Kernel::Point_3(cloud.x[i], cloud.y[i], cloud.z[i]),
                        Kernel::Vector_3(cloud.nx[i], cloud.ny[i], cloud.nz[i]));
  }
  constexpr std::size_t kFewest = 10;
  if (points.size() < kFewest) {
    throw std::runtime_error(options.file + ": has " + std::to_string(points.size()) +
                             " points with normals, must be at least " + std::to_string(kFewest));
  }
  return points;
}

/// Means over the points that CGAL has assigned to a shape.
struct Means {
  Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
};

Means meansOf(const Ransac::Shape& shape, const Points& points) {
  Means means;
  for (const std::size_t i : shape.indices_of_assigned_points()) {
    means.point += toVec3(points[i].first);
    means.normal += toVec3(points[i].second);
  }
  const double count = static_cast<double>(shape.indices_of_assigned_points().size());
  return {means.point / count, means.normal / count};
}

Shape shapeOf(const Ransac::Shape& shape, const Points& points) {
  const Means means = meansOf(shape, points);
  if (const auto* plane = dynamic_cast<const CgalPlane*>(&shape)) {
    const Vec3 normal = toVec3(plane->plane_normal()).normalized();
    return eval::turnedTo({means.point - normal * (normal.dot(means.point) + plane->d()), normal}, means.normal);
  }
  if (const auto* sphere = dynamic_cast<const CgalSphere*>(&shape)) {
    return Sphere{toVec3(sphere->center()), sphere->radius()};
  }
  if (const auto* cylinder = dynamic_cast<const CgalCylinder*>(&shape)) {
    const Vec3 axis = toVec3(cylinder->axis().to_vector()).normalized();
    return Cylinder{toVec3(cylinder->axis().point()), axis, cylinder->radius()};
  }
  const auto& cone = dynamic_cast<const CgalCone&>(shape);
  return eval::openedTo({toVec3(cone.apex()), toVec3(cone.axis()).normalized(), cone.angle()}, means.point);
}

void addKinds(const std::vector<std::string>& kinds, Ransac& ransac) {
  const std::set<std::string> wanted(kinds.begin(), kinds.end());
  if (wanted.count("plane")) ransac.add_shape_factory<CgalPlane>();
  if (wanted.count("sphere")) ransac.add_shape_factory<CgalSphere>();
  if (wanted.count("cylinder")) ransac.add_shape_factory<CgalCylinder>();
  if (wanted.count("cone")) ransac.add_shape_factory<CgalCone>();
}

/// Unless epsilon is given, the default parameters, which adapt to the cloud: probability 0.01, at least 1 % of the
/// points, epsilon and cluster epsilon 1 % of the bounding box' diagonal, normals within acos 0.9.
Result detectOnce(Points points, const Options& options) {
  using Milliseconds = std::chrono::duration<double, std::milli>;
  CGAL::get_default_random() = CGAL::Random(static_cast<unsigned int>(options.seed));
  const std::clock_t cpu_start = std::clock();
  const auto start = std::chrono::steady_clock::now();
  Ransac ransac;
  ransac.set_input(points);
  addKinds(options.kinds, ransac);
  ransac.preprocess();
  const auto prepared = std::chrono::steady_clock::now();
  Ransac::Parameters parameters;
  parameters.epsilon = options.epsilon;
  ransac.detect(parameters);
  const auto end = std::chrono::steady_clock::now();
  const std::clock_t cpu_end = std::clock();
  Result result{{},
                Milliseconds(prepared - start).count(),
                Milliseconds(end - start).count(),
                1e3 * static_cast<double>(cpu_end - cpu_start) / CLOCKS_PER_SEC};
  for (const auto& shape : ransac.shapes()) result.shapes.push_back(shapeOf(*shape, points));
  return result;
}

Result detectRepeatedly(const Points& points, const Options& options) {
  Result best = detectOnce(points, options);
  for (int run = 1; run < options.repeat; ++run) {
    Result result = detectOnce(points, options);
    if (result.total_ms < best.total_ms) best = std::move(result);
  }
  return best;
}

nlohmann::ordered_json toJson(const Result& result, std::size_t points) {
  nlohmann::ordered_json shapes = nlohmann::ordered_json::array();
  for (const Shape& shape : result.shapes) shapes.push_back(io::shapeJson(shape));
  return {{"primitives", shapes},
          {"total_ms", result.total_ms},
          {"prepare_ms", result.prepare_ms},
          {"cpu_ms", result.cpu_ms},
          {"points", points}};
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("CGAL Efficient RANSAC on a point file with normals (PCD, PLY); JSON on standard output");
  app.add_option("CLOUD", options.file, "point file")->required();
  app.add_option("--kinds", options.kinds, "what to look for")
      ->delimiter(',')
      ->check(CLI::IsMember({"plane", "sphere", "cylinder", "cone"}));
  app.add_option("--samples", options.samples, "random points to use; 0: all")->check(CLI::Range(0, 1000000000));
  app.add_option("--seed", options.seed, "of the drawing and of the RANSAC");
  app.add_option("--epsilon", options.epsilon, "a point's distance to its shape, m; default: 1 % of the diagonal")
      ->check(CLI::PositiveNumber);
  app.add_option("--repeat", options.repeat, "runs; the shortest time counts")->check(CLI::Range(1, 1000));
  try {
    app.parse(argc, argv);
    const Points points = readPoints(options);
    std::cout << toJson(detectRepeatedly(points, options), points.size()) << std::endl;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "peer_cgal: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
