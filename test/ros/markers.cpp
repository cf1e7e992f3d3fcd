// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What RViz is told to show, and to stop showing.
#include "ros/markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ros/messages.h"

namespace primitect::markers_test {
namespace {

using namespace ros_layer;
using visualization_msgs::Marker;

Detection sphereAt(double x) {
  Detection detection;
  detection.shape = Sphere{Vec3(x, 0.0, 1.0), 0.039};
  detection.extent.origin = Vec3(x, 0.0, 1.0);
  detection.extent.radius = 0.039;
  return detection;
}

Detection squareFacingTheSensor() {
  Detection detection;
  detection.extent.origin = Vec3(0.0, 0.0, 1.0);
  detection.extent.rotation = Eigen::AngleAxisd(M_PI, Vec3::UnitX()).toRotationMatrix();
  detection.extent.size = Vec3(0.5, 0.5, 0.0);
  detection.extent.hull = {Vec3(-0.25, -0.25, 1), Vec3(-0.25, 0.25, 1), Vec3(0.25, 0.25, 1), Vec3(0.25, -0.25, 1)};
  detection.shape = Plane{detection.extent.origin, -Vec3::UnitZ()};
  return detection;
}

/// A face of a box, turned to a side by so much (rad), beside the edge that is nearest to the sensor; width: of the
/// face, m.
Detection faceOfBox(double turn, double width) {
  Detection detection;
  const Eigen::AngleAxisd turned(turn, Vec3::UnitY());
  const Vec3 normal = turned * -Vec3::UnitZ(), along = turned * Vec3::UnitX() * std::copysign(width, -turn);
  const Vec3 edge(0.0, 0.0, 1.0), up(0.0, -0.1, 0.0);
  detection.extent.origin = edge + 0.5 * along + 0.5 * up;
  detection.extent.rotation.col(2) = normal;
  detection.extent.rotation.col(1) = Vec3::UnitY();
  detection.extent.rotation.col(0) = Vec3::UnitY().cross(normal);
  detection.extent.size = Vec3(width, 0.1, 0.0);
  detection.extent.hull = {edge, edge + along, edge + along + up, edge + up};
  detection.shape = Plane{detection.extent.origin, normal};
  return detection;
}

Detection cylinderUpright() {
  Detection detection;
  detection.extent.origin = Vec3(0.0, 0.0, 1.0);
  detection.extent.rotation = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()).toRotationMatrix();
  detection.extent.size = Vec3(0.0, 0.0, 0.12);
  detection.extent.radius = 0.039;
  detection.shape = Cylinder{detection.extent.origin, detection.extent.rotation.col(2), 0.039};
  return detection;
}

Detection frustum() {
  Detection detection;
  detection.extent.origin = Vec3(0.0, 0.0, 1.0);
  detection.extent.size = Vec3(0.0, 0.0, 0.1);
  detection.extent.radius = 0.06;
  detection.extent.radius_small = 0.02;
  detection.shape = Cone{Vec3(0.0, 0.0, 0.9), Vec3::UnitZ(), std::atan(0.4)};
  return detection;
}

PrimitiveArray messageOf(std::vector<Detection> items) {
  Detections detections;
  detections.items = std::move(items);
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(5, 6);
  return toMessage(detections, header);
}

std::vector<Marker> withAction(const visualization_msgs::MarkerArray& array, int action) {
  std::vector<Marker> found;
  std::copy_if(array.markers.begin(), array.markers.end(), std::back_inserter(found),
               [action](const Marker& marker) { return marker.action == action; });
  return found;
}

Marker markerOf(const visualization_msgs::MarkerArray& array, const std::string& name_space) {
  for (const Marker& marker : array.markers) {
    if (marker.ns == name_space) return marker;
  }
  ADD_FAILURE() << "no marker in " << name_space;
  return {};
}

Vec3 toVec3(const geometry_msgs::Point& p) { return Vec3(p.x, p.y, p.z); }

TEST(Markers, KeepStampAndFrameAndHaveUnitOrientations) {
  MarkerWriter writer;
  const auto array =
      writer.update(messageOf({sphereAt(0.0), squareFacingTheSensor(), cylinderUpright(), frustum()}), MarkerStyle());
  for (const Marker& marker : array.markers) {
    EXPECT_EQ(marker.header.frame_id, "camera");
    EXPECT_EQ(marker.header.stamp, ros::Time(5, 6));
    EXPECT_FALSE(marker.frame_locked);
    const auto& q = marker.pose.orientation;
    EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, 1e-9) << marker.ns;
  }
}

TEST(Markers, NameTheFacesOfABoxWhereNeitherHidesTheOther) {
  constexpr double kLetter = 0.5;  // about so wide, in its height
  const auto placesOfTexts = [](double width) {
    MarkerWriter writer;
    std::vector<Marker> texts;
    for (const Marker& marker : writer.update(messageOf({faceOfBox(0.8, width), faceOfBox(-0.8, width)}), {}).markers) {
      if (marker.ns == "plane_text") texts.push_back(marker);
    }
    EXPECT_EQ(texts.size(), 2u);
    return texts;
  };
  const std::vector<Marker> narrow = placesOfTexts(0.05), wide = placesOfTexts(0.8);
  const double text_width = kLetter * narrow[0].scale.z * static_cast<double>(narrow[0].text.size());
  ASSERT_GT(text_width, 0.05);
  EXPECT_NEAR(narrow[0].pose.position.x, -0.5 * text_width, 0.02) << "it ends at the edge";
  EXPECT_NEAR(narrow[1].pose.position.x, 0.5 * text_width, 0.02);
  for (double turn = -0.3; turn < 0.3; turn += 0.02) {  // nothing jumps
    const auto placeOf = [](double angle) {
      MarkerWriter writer;
      return markerOf(writer.update(messageOf({faceOfBox(angle, 0.05)}), {}), "plane_text").pose.position.x;
    };
    EXPECT_NEAR(placeOf(turn + 0.009), placeOf(turn + 0.011), 0.002) << turn;
  }
  // Within a wide face there is room.
  EXPECT_NEAR(wide[0].pose.position.x, -0.4 * std::cos(0.8), 0.05);
}

TEST(Markers, ShowSphereAndCylinderInTheirSize) {
  MarkerWriter writer;
  const auto array = writer.update(messageOf({sphereAt(0.2), cylinderUpright()}), MarkerStyle());
  const Marker sphere = markerOf(array, "sphere");
  EXPECT_EQ(sphere.type, Marker::SPHERE);
  EXPECT_NEAR(sphere.scale.x, 0.078, 1e-6);
  EXPECT_NEAR(sphere.pose.position.x, 0.2, 1e-6);
  EXPECT_LT(sphere.color.a, 1.0f);
  const Marker cylinder = markerOf(array, "cylinder");
  EXPECT_EQ(cylinder.type, Marker::CYLINDER);
  EXPECT_NEAR(cylinder.scale.y, 0.078, 1e-6);
  EXPECT_NEAR(cylinder.scale.z, 0.12, 1e-6);
  EXPECT_EQ(markerOf(array, "cylinder_text").text, "cylinder r 39 mm x 120 mm");
}

TEST(Markers, OfAShapeSeenFromInsideSaySoAndAreDrawnAlike) {
  Detection tube = cylinderUpright();
  const auto outside = MarkerWriter().update(messageOf({tube}), MarkerStyle());
  tube.concave = true;
  const auto inside = MarkerWriter().update(messageOf({tube}), MarkerStyle());
  EXPECT_EQ(markerOf(inside, "cylinder_text").text, "concave cylinder r 39 mm x 120 mm");
  ASSERT_EQ(inside.markers.size(), outside.markers.size());
  EXPECT_EQ(markerOf(inside, "cylinder").scale.x, markerOf(outside, "cylinder").scale.x);
  EXPECT_EQ(markerOf(inside, "cylinder").scale.z, markerOf(outside, "cylinder").scale.z);
}

TEST(Markers, SayHowSureADetectionIsWhereItIsNot) {
  std::vector<Detection> items = {sphereAt(0.2), cylinderUpright(), frustum(), squareFacingTheSensor()};
  for (Detection& item : items) item.confidence = 0.733f;
  const auto doubtful = MarkerWriter().update(messageOf(items), MarkerStyle());
  EXPECT_EQ(markerOf(doubtful, "sphere_text").text, "sphere r 39 mm 73 %");
  EXPECT_EQ(markerOf(doubtful, "cylinder_text").text, "cylinder r 39 mm x 120 mm 73 %");
  EXPECT_EQ(markerOf(doubtful, "cone_text").text, "cone 22 deg x 100 mm 73 %");
  EXPECT_EQ(markerOf(doubtful, "plane_text").text, "plane 500 x 500 mm 73 %");
  for (Detection& item : items) item.confidence = 0.973f;
  const auto sure = MarkerWriter().update(messageOf(items), MarkerStyle());
  EXPECT_EQ(markerOf(sure, "sphere_text").text, "sphere r 39 mm");
  EXPECT_EQ(markerOf(sure, "plane_text").text, "plane 500 x 500 mm");
}

/// Three corners of each triangle, in the frame of the header.
std::vector<Vec3> cornersOf(const Marker& marker) {
  std::vector<Vec3> corners;
  for (const auto& point : marker.points) corners.push_back(toVec3(marker.pose.position) + toVec3(point));
  return corners;
}

TEST(Markers, FillThePlanesOutline) {
  MarkerWriter writer;
  const auto array = writer.update(messageOf({squareFacingTheSensor()}), MarkerStyle());
  const Marker surface = markerOf(array, "plane");
  ASSERT_EQ(surface.type, Marker::TRIANGLE_LIST);
  const std::vector<Vec3> corners = cornersOf(surface);
  ASSERT_EQ(corners.size(), 6u);
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Vec3 a = corners[i], b = corners[i + 1], c = corners[i + 2];
    const Vec3 normal = (b - a).cross(c - a);
    EXPECT_LT(normal.z(), 0.0);  // towards the sensor, where the light is
    area += 0.5 * normal.norm();
  }
  EXPECT_NEAR(area, 0.25, 1e-6);
  const Marker outline = markerOf(array, "plane_outline");
  EXPECT_EQ(outline.type, Marker::LINE_STRIP);
  ASSERT_EQ(outline.points.size(), 5u);
  EXPECT_TRUE(toVec3(outline.points.front()).isApprox(toVec3(outline.points.back())));
}

TEST(Markers, DrawTheConeAsAClosedFrustum) {
  MarkerWriter writer;
  const Detection detection = frustum();
  const auto array = writer.update(messageOf({detection}), MarkerStyle());
  const Marker surface = markerOf(array, "cone");
  ASSERT_EQ(surface.type, Marker::TRIANGLE_LIST);
  const std::vector<Vec3> corners = cornersOf(surface);
  ASSERT_EQ(corners.size() % 3, 0u);
  double wide = 0.0, narrow = 0.0;  // m^2, of the two ends
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Vec3 a = corners[i], b = corners[i + 1], c = corners[i + 2];
    const Vec3 area = 0.5 * (b - a).cross(c - a), middle = (a + b + c) / 3.0;
    if (std::abs(area.normalized().z()) > 0.999) {
      // Both ends are seen from outside.
      if (middle.z() > 1.0) {
        wide += area.z();
      } else {
        narrow -= area.z();
      }
      for (const Vec3& p : {a, b, c}) EXPECT_NEAR(std::abs(p.z() - 1.0), 0.05, 1e-6);
    } else {
      for (const Vec3& p : {a, b, c}) EXPECT_NEAR(distance(detection.shape, p), 0.0, 1e-6);
      EXPECT_GT(area.dot(normalAt(detection.shape, middle)), 0.0);
    }
  }
  EXPECT_NEAR(wide, M_PI * 0.06 * 0.06, 1e-4);  // of a polygon in the circle
  EXPECT_NEAR(narrow, M_PI * 0.02 * 0.02, 1e-5);
}

/// In the order of these RViz draws what can be looked through: the farther, the earlier.
TEST(Markers, PutTheSurfaceOfAPlaneWhereItsFarthestCornerIs) {
  MarkerStyle style;
  style.viewpoint = Vec3(0.1, 0.2, 0.0);
  const Marker surface = markerOf(MarkerWriter().update(messageOf({squareFacingTheSensor()}), style), "plane");
  double farthest = 0.0;
  for (const Vec3& corner : cornersOf(surface)) farthest = std::max(farthest, (corner - style.viewpoint).norm());
  EXPECT_NEAR((toVec3(surface.pose.position) - style.viewpoint).norm(), farthest, 1e-6);
}

TEST(Markers, DrawTheFarSideOfAConeBeforeTheNearOne) {
  MarkerStyle style;
  style.viewpoint = Vec3(0.5, 0.1, 0.6);
  const Marker surface = markerOf(MarkerWriter().update(messageOf({frustum()}), style), "cone");
  const std::vector<Vec3> corners = cornersOf(surface);
  std::vector<bool> near;  // of each triangle
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Vec3 a = corners[i], b = corners[i + 1], c = corners[i + 2];
    near.push_back((b - a).cross(c - a).dot(style.viewpoint - a) > 0.0);
  }
  EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
  EXPECT_NE(near.front(), near.back());
}

TEST(Markers, DeleteWhatVanished) {
  MarkerWriter writer;
  writer.update(messageOf({sphereAt(0.0), sphereAt(0.5)}), MarkerStyle());
  const auto array = writer.update(messageOf({sphereAt(0.0)}), MarkerStyle());
  std::vector<std::pair<std::string, int>> deleted;
  for (const Marker& marker : withAction(array, Marker::DELETE)) deleted.emplace_back(marker.ns, marker.id);
  EXPECT_EQ(deleted, (std::vector<std::pair<std::string, int>>{{"sphere", 1}, {"sphere_text", 1}}));
  EXPECT_TRUE(withAction(writer.update(messageOf({sphereAt(0.0)}), MarkerStyle()), Marker::DELETE).empty());
}

TEST(Markers, DeleteEverythingOnceAtTheStartAndWhenStartedAnew) {
  MarkerWriter writer;
  const PrimitiveArray message = messageOf({sphereAt(0.0)});
  EXPECT_EQ(writer.update(message, MarkerStyle()).markers.front().action, Marker::DELETEALL);
  EXPECT_TRUE(withAction(writer.update(message, MarkerStyle()), Marker::DELETEALL).empty());
  writer.startAnew();
  EXPECT_EQ(writer.update(message, MarkerStyle()).markers.front().action, Marker::DELETEALL);
}

TEST(Markers, UseTheTracksNumberWhereThereIsOne) {
  Detection tracked = sphereAt(0.0);
  tracked.track_id = 42;
  MarkerWriter writer;
  EXPECT_EQ(markerOf(writer.update(messageOf({tracked}), MarkerStyle()), "sphere").id, 42);
}

TEST(Markers, LeaveOutSurfacesWithoutAnExtent) {
  Detection flat = cylinderUpright();
  flat.extent.size.z() = 0.0;
  MarkerWriter writer;
  for (const Marker& marker : withAction(writer.update(messageOf({flat}), MarkerStyle()), Marker::ADD)) {
    EXPECT_EQ(marker.ns, "cylinder_text");
  }
}

}  // namespace
}  // namespace primitect::markers_test
