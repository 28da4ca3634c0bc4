// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/grid_scale.h"

#include "io/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// error of differences over 200 m; the scale's own curvature there is 1e-10
constexpr double kDifferences = 1e-7;

TEST(GridScale, OfUtmOnItsCentralMeridianIsItsScaleFactor) {
  const auto scale = grid_scale({"EPSG:25832"}, {500000.0, 5403000.0});
  ASSERT_TRUE(scale);
  EXPECT_NEAR(scale->scale.x(), 0.9996, kDifferences);
  EXPECT_NEAR(scale->scale.y(), 0.9996, kDifferences);
  EXPECT_NEAR(scale->skew, 0.0, kDifferences);
  EXPECT_NEAR(scale->lon_deg, 9.0, 1e-9);
  EXPECT_TRUE(scale->in_area_of_use);
}

TEST(GridScale, OfAConicalProjectionIsOneOnItsStandardParallels) {
  // 3 E, 44 N of Lambert-93; 79 W, 36 10' N of North Carolina, in US survey feet
  const auto france = grid_scale({"EPSG:2154"}, {700000.0, 6322333.1395});
  const auto carolina = grid_scale({"EPSG:2264"}, {2000000.0, 879570.8594});
  ASSERT_TRUE(france && carolina);
  for (const auto& scale : {*france, *carolina}) {
    EXPECT_NEAR(scale.scale.x(), 1.0, kDifferences);
    EXPECT_NEAR(scale.scale.y(), 1.0, kDifferences);
  }
  EXPECT_NEAR(carolina->lat_deg, 36.0 + 10.0 / 60.0, 1e-7);
}

TEST(GridScale, OfWebMercatorIsThatOfASphereOverTheEllipsoidsRadii) {
  const auto scale = grid_scale({"EPSG:3857"}, {1021578.967, 6237614.1076});
  ASSERT_TRUE(scale);
  constexpr double kA_m = 6378137.0;
  constexpr double kE2 = 0.00669437999014;  // WGS 84
  const double lat = 48.78 * std::numbers::pi / 180.0;
  const double w = std::sqrt(1.0 - kE2 * std::sin(lat) * std::sin(lat));
  const double meridian_m = kA_m * (1.0 - kE2) / (w * w * w);
  EXPECT_NEAR(scale->scale.x(), w / std::cos(lat), kDifferences);
  EXPECT_NEAR(scale->scale.y(), kA_m / (meridian_m * std::cos(lat)), kDifferences);
  EXPECT_FALSE(scale->is_true());
}

TEST(GridScale, OfEquidistantCylindersIsThatOfTheParallel) {
  const auto scale = grid_scale({"EPSG:4087"}, {1001875.4171, 5398995.3035});  // 9 E, 48.5 N
  ASSERT_TRUE(scale);
  EXPECT_GT(scale->scale.x(), 1.5);
  constexpr double kSphere = 2e-3;  // PROJ 9.1 takes a sphere
  EXPECT_NEAR(scale->scale.y(), 1.0, kSphere);
}

TEST(GridScale, GridsOfCountriesAreTrueFarOutsideOfTheirZones) {
  struct Place {
    const char* crs;
    Eigen::Vector2d x;
  };
  for (const Place& place :
       {Place{"EPSG:25833", {-100600.9, 6700651.8}},  // Bergen, in zone 33
        Place{"EPSG:31467", {3514720.3, 5395733.8}},  // northing first
        Place{"EPSG:2193", {1684102.1, 5460761.4}},   // New Zealand
        Place{"EPSG:27700", {400000.0, 300000.0}}, Place{"EPSG:2056", {2600000.0, 1200000.0}},
        Place{"EPSG:5514", {-700000.0, -1000000.0}}}) {
    const auto scale = grid_scale({place.crs}, place.x);
    ASSERT_TRUE(scale) << place.crs;
    EXPECT_TRUE(scale->is_true()) << place.crs << ": " << scale_text(*scale);
  }
}

TEST(GridScale, IsNoneOfWhatIsNotProjectedOrNowhere) {
  EXPECT_FALSE(grid_scale({}, {0.0, 0.0}));
  EXPECT_FALSE(grid_scale({"EPSG:4326"}, {9.0, 48.0}));
  EXPECT_FALSE(grid_scale({"EPSG:5703"}, {0.0, 0.0}));
  EXPECT_FALSE(grid_scale({"EPSG:25832"}, {1e12, 1e12}));
}

TEST(GridScale, AxesThatAreAskewOnTheGroundAreNotTrue) {
  const auto scale = grid_scale({"EPSG:3035"}, {1500000.0, 5400000.0});  // off Iceland
  ASSERT_TRUE(scale);
  EXPECT_GT(std::abs(scale->skew), kMaxScaleError);
  EXPECT_FALSE(scale->is_true());
}

TEST(RequireTrueScale, NamesScaleRuleZoneAndRemedy) {
  const auto message = [](const char* crs, const Eigen::Vector2d& x) {
    try {
      return require_true_scale("a.las", {crs}, x, ", or wait");
    } catch (const IoError& error) {
      return std::string("refused: ") + error.what();
    }
  };
  EXPECT_THAT(message("EPSG:3857", {1021578.967, 6237614.1076}),
              AllOf(HasSubstr("refused: a.las"), HasSubstr("WGS 84 / Pseudo-Mercator"),
                    HasSubstr("is 1.515 in x and 1.519 in y at"), HasSubstr("within 1 %"),
                    HasSubstr("WGS 84 / UTM zone 32N (EPSG:32632), or wait")));
  EXPECT_THAT(message("EPSG:3857", {-8000000.0, -4000000.0}),
              HasSubstr("WGS 84 / UTM zone 19S (EPSG:32719)"));
  EXPECT_THAT(message("EPSG:3034", {4000000.0, 2800000.0}),
              HasSubstr("ETRS89 / UTM zone 32N (EPSG:25832)"));
  EXPECT_EQ(message("EPSG:25832", {513000.0, 5403000.0}), "");
}

TEST(RequireTrueScale, OutsideTheAreaOfUseWarnsAlone) {
  EXPECT_THAT(require_true_scale("a.las", {"EPSG:2264"}, {1683067.0, 17726342.0}, ""),
              AllOf(HasSubstr("a.las: lies at 81.525 W, 76.869 N"), HasSubstr("area of use")));
}

}  // namespace
}  // namespace ridgeline::io
