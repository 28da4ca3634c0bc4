// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/geocentric.h"

#include <Eigen/LU>
#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

namespace ridgeline::io {
namespace {

constexpr double kRounding_m = 1e-6;

TEST(GeocentricMap, IsExactAlongTheCentralMeridian) {
  const GeocentricMap map({"EPSG:32632"});
  const Eigen::Isometry3d frame = map.geocentric_from_enu({0.0, 9.0, 100.0});
  // on the equator the frame is east, north, up of a sphere of 6378137 m
  EXPECT_NEAR(frame.translation().norm(), 6378237.0, kRounding_m);
  const Eigen::Vector3d x = map.map_from_geocentric(frame * Eigen::Vector3d::Zero());
  EXPECT_NEAR(x.x(), 500000.0, kRounding_m);
  EXPECT_NEAR(x.y(), 0.0, kRounding_m);
  EXPECT_NEAR(x.z(), 100.0, kRounding_m);
  // 100 m above the ellipsoid the plan is shorter than the ground there, by both radii of curvature
  const double along_equator = 6378137.0 / 6378237.0;
  const double along_meridian = 6335439.327 / 6335539.327;
  EXPECT_NEAR(map.plan_scale(frame.translation()), 0.9996 * 0.5 * (along_equator + along_meridian),
              1e-9);
  EXPECT_LT(
      (map.map_rotation_at(frame.translation()) * frame.linear() - Eigen::Matrix3d::Identity())
          .norm(),
      1e-8);
}

TEST(GeocentricMap, TurnsByTheConvergenceOfMeridians) {
  const GeocentricMap map({"EPSG:25832"});
  const GeodeticPlace place{50.0, 11.0, 0.0};
  const Eigen::Isometry3d frame = map.geocentric_from_enu(place);
  const Eigen::Matrix3d turned = map.map_rotation_at(frame.translation()) * frame.linear();
  // tan(convergence) = tan(longitude from the meridian) sin(latitude), to the third order
  const double rad = 3.14159265358979 / 180.0;
  const double convergence = std::atan(std::tan(2.0 * rad) * std::sin(50.0 * rad));
  EXPECT_NEAR(std::atan2(turned(0, 1), turned(1, 1)), -convergence, 1e-6);
  EXPECT_NEAR(turned(2, 2), 1.0, 1e-9);
}

TEST(GeocentricMap, KeepsHeightsAndThirdAxis) {
  const GeocentricMap map({"EPSG:25832+7837"});
  EXPECT_NE(map.crs().definition.find("ellipsoidal height"), std::string::npos);
  const GeodeticPlace place =
      map.place_of(map.geocentric_from_enu({48.0, 8.5, 321.0}).translation());
  EXPECT_NEAR(place.lat_deg, 48.0, 1e-11);
  EXPECT_NEAR(place.lon_deg, 8.5, 1e-11);
  EXPECT_NEAR(place.height_m, 321.0, kRounding_m);
}

TEST(GeocentricMap, RefusesWhatIsNotProjected) {
  EXPECT_THROW(GeocentricMap({"EPSG:4326"}), std::invalid_argument);
  EXPECT_THROW(GeocentricMap({"nonsense"}), std::invalid_argument);
}

TEST(UtmZoneOf, FollowsLongitudeAndHemisphere) {
  EXPECT_EQ(utm_zone_of({48.0, 9.0, 0.0}).definition, "EPSG:32632");
  EXPECT_EQ(utm_zone_of({-33.0, 25.0, 0.0}).definition, "EPSG:32735");
  EXPECT_EQ(utm_zone_of({0.0, 180.0, 0.0}).definition, "EPSG:32660");
  EXPECT_EQ(utm_zone_of({0.0, -180.0, 0.0}).definition, "EPSG:32601");
}

}  // namespace
}  // namespace ridgeline::io
