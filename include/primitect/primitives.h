// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The four shapes as plain values, their distance functions, and what one frame's detection holds.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "primitect/evidence.h"

namespace primitect {

using Vec3 = Eigen::Vector3d;

/// Plane through point (m) with unit normal, towards the sensor.
struct Plane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
};

/// Sphere, metres.
struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 0.0;
};

/// Infinite cylinder around the line point + t * axis (unit), metres.
struct Cylinder {
  Vec3 point = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius = 0.0;
};

/// One-sided cone; axis (unit) points from the apex into the body, half_angle in rad, in (0, pi/2).
struct Cone {
  Vec3 apex = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double half_angle = 0.0;
};

/// A primitive with its numbers. The index of the alternative is the Kind, and the type number in the messages.
using Shape = std::variant<Plane, Sphere, Cylinder, Cone>;

enum class Kind : std::uint8_t { plane = 0, sphere = 1, cylinder = 2, cone = 3 };
constexpr std::size_t kKindCount = 4;

inline Kind kindOf(const Shape& shape) { return static_cast<Kind>(shape.index()); }

/// "plane", "sphere", "cylinder", "cone".
const char* kindName(Kind kind);

/// Signed distance in metres: positive outside (for the plane: on the side of its normal).
double distance(const Plane& plane, const Vec3& p);
double distance(const Sphere& sphere, const Vec3& p);
double distance(const Cylinder& cylinder, const Vec3& p);
double distance(const Cone& cone, const Vec3& p);
double distance(const Shape& shape, const Vec3& p);

/// Outward unit normal of the surface at the point nearest to p: the gradient of distance().
/// On an axis, a centre or an apex, where it is undefined, some unit vector.
Vec3 normalAt(const Plane& plane, const Vec3& p);
Vec3 normalAt(const Sphere& sphere, const Vec3& p);
Vec3 normalAt(const Cylinder& cylinder, const Vec3& p);
Vec3 normalAt(const Cone& cone, const Vec3& p);
Vec3 normalAt(const Shape& shape, const Vec3& p);

/// The point of the surface that is nearest to p.
Vec3 project(const Shape& shape, const Vec3& p);

/// Ends of an axis; bits of Extent::unseen_ends.
enum End : std::uint8_t {
  kEndAtMinusZ = 1,
  kEndAtPlusZ = 2,
  kEndsUnknown = 128,
};

constexpr std::int32_t kNoFace = -1;

/// The part of a shape that was seen.
struct Extent {
  /// Origin: centre of the observed plane part, sphere centre, middle of the observed axis part (m).
  Vec3 origin = Vec3::Zero();
  /// Columns x, y, z of the pose; z = plane normal / cylinder axis / cone axis from the apex into the body.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  /// Plane: length along x and y; cylinder and cone: length along z; else 0 (m).
  Vec3 size = Vec3::Zero();
  double radius = 0.0;        ///< sphere, cylinder; cone: at the wide end of the observed part (m)
  double radius_small = 0.0;  ///< cone: at the narrow end of the observed part (m)
  std::vector<Vec3> hull;     ///< plane: convex outline, counter-clockwise seen from the sensor (m)
  /// Cylinder and cone: the ends along z where it may go on: it is cut off there (Detection::truncated) or seen along
  /// its axis, and ends on no face and in no tip. Bits of End; other kinds: 0.
  std::uint8_t unseen_ends = 0;
  /// Cylinder and cone: the plane on which the axis ends at -z and +z, as the table that it stands on or its lid; index
  /// in Detections::items, kNoFace: none.
  std::int32_t face_at_minus_z = kNoFace, face_at_plus_z = kNoFace;
};

/// Why the extent is only a lower bound; bits of Detection::truncated.
enum Truncation : std::uint8_t {
  kTruncatedByImage = 1,
  kTruncatedByDepth = 2,
  kTruncatedByOcclusion = 4,
  kTruncationUnknown = 128,
};

/// A number that no stage has filled.
constexpr float kUnknown = -1.0f;

/// A shape reported for one frame. Fields that no stage fills hold kUnknown.
struct Detection {
  Shape shape;
  Extent extent;
  float votes = 0.0f;  ///< of the candidate that it grew from (verify: false: of all that were merged); 0: of facets
  /// Points of the cloud on its observed part, of a large cloud extrapolated; not verified: samples.
  std::uint32_t inlier_count = 0;
  float rms_error = kUnknown;          ///< of the inliers' distances (m)
  float confidence = kUnknown;         ///< [0, 1]
  float coverage = kUnknown;           ///< observed share of the full turn or area, [0, 1]
  float radius_stddev = kUnknown;      ///< m
  float half_angle_stddev = kUnknown;  ///< rad
  /// Of the extent's origin (m) and z axis (rad), along the worst of the directions in which they can be observed:
  /// the origin of a plane along its normal, of a cylinder across its axis; a sphere has no axis, 0.
  float position_stddev = kUnknown, axis_stddev = kUnknown;
  /// 6 x 6 row-major, x y z rotX rotY rotZ (m, rad); [0] = -1: unknown.
  std::array<double, 36> covariance = {-1.0};
  bool concave = false;
  std::uint8_t truncated = kTruncationUnknown;
  /// The other kind that would explain the same samples nearly as well; a cone sharper than min_half_angle_deg that
  /// would explain the points better.
  std::optional<Kind> rival;
  Evidence evidence;           ///< behind confidence; of verified detections
  std::uint32_t track_id = 0;  ///< 0 = untracked
  std::uint32_t age = 0;       ///< frames since the track was first seen
};

/// Why nothing came out; the numbers are those of PrimitiveArray.status.
enum class Status : std::uint8_t { ok = 0, empty_input = 1, too_few_points = 2, rejected_input = 3, no_transform = 4 };

/// "ok", "empty_input", ...
const char* statusName(Status status);

/// Why shapes that were tried did not come out.
enum class Refusal : std::uint8_t {
  few_inliers,  ///< fewer than min_inliers samples around a candidate fit
  too_large,    ///< a fit's radius is above max_radius or what samples of such a scene can tell: mostly a plane
  too_small,    ///< a fit's radius is below min_radius or what the noise lets tell from an edge; a band of a ball or a
                ///< plane is too narrow to tell what it is
  half_angle,   ///< a fit is a cone sharper than min_half_angle_deg or flatter than max_half_angle_deg
  edge_on,      ///< a fit is a plane in which the sensor lies
  unlikely,     ///< less than min_confidence
  not_seen,     ///< a tube or a cone of which the image shows no part, a ball that the camera looks into
};
constexpr std::size_t kRefusalCount = 7;

/// "few inliers", ...
const char* refusalName(Refusal refusal);

/// How often each; one candidate may count several times.
struct Refusals {
  std::array<std::uint32_t, kRefusalCount> counts = {};
  std::uint32_t& operator[](Refusal refusal) { return counts[static_cast<std::size_t>(refusal)]; }
  std::uint32_t operator[](Refusal refusal) const { return counts[static_cast<std::size_t>(refusal)]; }
  Refusals& operator+=(const Refusals& others) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += others.counts[i];
    return *this;
  }
};

/// All that was found in one frame.
struct Detections {
  std::vector<Detection> items;
  Status status = Status::ok;
  std::uint32_t points_in = 0;    ///< points received
  std::uint32_t points_used = 0;  ///< of these, measured and within the depth range; of a large image extrapolated
  std::uint32_t samples = 0;      ///< points that voted
  double scene_diameter = 0.0;    ///< d_s (m), see Params::scene_diameter
  /// Of the image of a depth camera: how far its points stray from surfaces, in standard deviations of structured
  /// light, up to about five. 0 where this is not measured.
  double image_noise = 0.0;
  /// What the depth of a depth camera is off by in waves over the image, as large planes show it: a share of the depth,
  /// one standard deviation. 0: these show none; -1: no plane tells.
  double depth_waves = -1.0;
  /// False: the points are not those of a sensor at the origin that looks along z, as is assumed. Then the image cannot
  /// be used, and normals may be turned to the wrong side. Of lists with normals only points behind the sensor tell.
  bool seen_from_origin = true;
  /// Most normals that the cloud brought, and that were kept as they are, face away from the sensor at the origin:
  /// what is convex then passes for concave.
  bool normals_face_away = false;
  Refusals refusals;
};

}  // namespace primitect
