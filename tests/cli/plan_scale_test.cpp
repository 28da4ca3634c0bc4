// SPDX-License-Identifier: BSD-3-Clause
// Plans that are not true to scale, heights above the ellipsoid, bounds in the cloud's own
// coordinates.
#include "io/cloud/las_writer.h"
#include "tests/cli/cli_fixture.h"

#include <Eigen/Core>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Scale of Web Mercator at 48.78 N, over the ellipsoid.
constexpr double kEast = 1.514680;
constexpr double kNorth = 1.519113;
const Eigen::Vector3d kMercator(1021600.0, 6237600.0, 250.0);  // 9.177 E, 48.780 N
constexpr double kPlanFoot_m = 0.3048;

/// A gable of 20 m x 10 m whose ridge runs north, in a grid whose metres are `scale` long.
class PlanScale : public Cli {
 protected:
  void write_cloud(const std::string& name,
                   const std::string& crs,
                   const Eigen::Vector3d& origin,
                   const Eigen::Vector3d& scale) const {
    constexpr double kSpacing_m = 0.25;
    std::vector<io::CloudPoint> points;
    for (int i = -20; i <= 20; ++i) {
      for (int j = 0; j <= 80; ++j) {
        const double x = kSpacing_m * i;
        io::CloudPoint& point = points.emplace_back();
        point.x = scale.x() * x;
        point.y = scale.y() * kSpacing_m * j;
        point.z = scale.z() * (8.0 - 0.7 * std::abs(x));
        point.return_number = 1;
      }
    }
    io::write_las(path(name).string(), points, {origin}, {crs});
  }

  /// The ridge, 0.2 m west of where it is, as GeoJSON with or without a reference system.
  void write_ridge(const std::string& name,
                   const std::string& crs,
                   const Eigen::Vector3d& origin,
                   const Eigen::Vector3d& scale) const {
    const std::string member =
        crs.empty() ? ""
                    : fmt::format(R"("crs":{{"type":"name","properties":{{"name":"{}"}}}},)", crs);
    const Eigen::Vector3d a = origin + scale.cwiseProduct(Eigen::Vector3d(-kShift_m, 2.0, 8.0));
    const Eigen::Vector3d b = origin + scale.cwiseProduct(Eigen::Vector3d(-kShift_m, 18.0, 8.0));
    write(
        path(name),
        fmt::format(
            R"({{"type":"FeatureCollection",{}"features":[{{"type":"Feature","properties":{{"id":1}},)"
            R"("geometry":{{"type":"LineString","coordinates":[[{:.4f},{:.4f},{:.4f}],[{:.4f},{:.4f},{:.4f}]]}}}}]}})",
            member, a.x(), a.y(), a.z(), b.x(), b.y(), b.z()));
  }

  [[nodiscard]] ProgramResult judge(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"evaluate",  "--lines", "ridge.geojson", "--cloud",
                                       "cloud.las", "--out",   "judged"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  [[nodiscard]] nlohmann::json line() const {
    return read_json(path("judged/evaluation.ridge.json"))["lines"][0];
  }

  static constexpr double kShift_m = 0.2;
};

TEST_F(PlanScale, WebMercatorIsRefusedWithScaleRuleAndZone) {
  const Eigen::Vector3d scale(kEast, kNorth, 1.0);
  write_cloud("cloud.las", "EPSG:3857", kMercator, scale);
  write_ridge("ridge.geojson", "EPSG:3857", kMercator, scale);
  EXPECT_REFUSED(judge(),
                 AllOf(HasSubstr("cloud.las"), HasSubstr("is 1.515 in x"), HasSubstr("within 1 %"),
                       HasSubstr("EPSG:32632"), HasSubstr("--scale-to-ground")));
  for (const char* const file : {"cloud.las", "ridge.geojson"}) {
    EXPECT_THAT(run({"info", file}).out,
                AllOf(HasSubstr("map scale 1.515 in x"), HasSubstr("not true to scale")));
  }
}

TEST_F(PlanScale, OnRequestFiguresAreMetresOnTheGround) {
  const Eigen::Vector3d scale(kEast, kNorth, 1.0);
  write_cloud("cloud.las", "EPSG:3857", kMercator, scale);
  // the distance from a slope of 0.7 is the shift times the sine of the slope
  const double expected_m = kShift_m * 0.7 / std::hypot(1.0, 0.7);
  constexpr double kResolution_m = 2e-3;  // steps of the LAS file and of the line's digits
  for (const char* const crs : {"EPSG:3857", ""}) {
    write_ridge("ridge.geojson", crs, kMercator, scale);
    const ProgramResult result = judge({"--scale-to-ground"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("figures are metres on the ground"));
    EXPECT_NEAR(line()["length_m"].get<double>(), 16.0, 16.0 * 1e-4);
    EXPECT_NEAR(line()["mean_distance_m"].get<double>(), expected_m, kResolution_m) << crs;
    const nlohmann::json record = read_json(path("judged/run.json"));
    EXPECT_NEAR(record["cloud"]["plan_scale"][0].get<double>(), kEast, 1e-4);
    EXPECT_THAT(record["warnings"].dump(), HasSubstr("metres on the ground"));
    // the map stays in the coordinates of the file
    EXPECT_THAT(run({"info", "judged/judged.ridge.gpkg"}).out, HasSubstr("x 1021599."));
  }
}

TEST_F(PlanScale, APageThatIsMadeAgainHasTheSameScale) {
  const Eigen::Vector3d scale(kEast, kNorth, 1.0);
  write_cloud("cloud.las", "EPSG:3857", kMercator, scale);
  write_ridge("ridge.geojson", "EPSG:3857", kMercator, scale);
  ASSERT_EQ(judge({"--scale-to-ground"}).exit_code, 0);
  const std::string page = read(path("judged/report.html"));
  const ProgramResult again = run({"report", "judged"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(read(path("judged/report.html")), page);
}

TEST_F(PlanScale, CamerasCannotBeScaled) {
  write_cloud("cloud.las", "EPSG:3857", kMercator, {kEast, kNorth, 1.0});
  write_ridge("ridge.geojson", "", kMercator, {kEast, kNorth, 1.0});
  write(path("patch.yaml"), fmt::format(R"(id: p
crs: EPSG:3857
height_range: [240, 270]
images:
  - {{id: a, path: a.tif, projection_matrix: [[1, 0, 0, {0}], [0, 1, 0, {1}], [0, 0, 1, -1500]]}}
  - {{id: b, path: b.tif, projection_matrix: [[1, 0, 0, {2}], [0, 1, 0, {1}], [0, 0, 1, -1500]]}}
)",
                                        -kMercator.x(), -kMercator.y(), -kMercator.x() - 100));
  const ProgramResult judged = judge({"--patch", "patch.yaml", "--scale-to-ground"});
  EXPECT_THAT(judged.err, HasSubstr("cameras cannot be scaled"));
  EXPECT_REFUSED(run({"run", "patch.yaml", "--out", "out"}),
                 AllOf(HasSubstr("patch.yaml"), HasSubstr("is 1.515 in x"), HasSubstr("EPSG:32632"),
                       Not(HasSubstr("--scale-to-ground"))));
}

TEST_F(PlanScale, PlacesOutsideOfTheAreaOfUseAreWarnedOf) {
  const Eigen::Vector3d far(513000.0 / kPlanFoot_m, 5403000.0 / kPlanFoot_m, 100.0);
  const Eigen::Vector3d feet = Eigen::Vector3d::Constant(1.0 / kPlanFoot_m);
  write_cloud("cloud.las", "EPSG:2992", far, feet);
  write_ridge("ridge.geojson", "EPSG:2992", far, feet);
  const ProgramResult result = judge();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("outside its area of use"));
  EXPECT_THAT(run({"info", "cloud.las"}).out, HasSubstr("outside the reference system's area"));
}

TEST_F(PlanScale, BoundsAreInTheCoordinatesOfTheCloud) {
  const Eigen::Vector3d origin(1000000.0, 600000.0, 300.0);  // feet, in Oregon
  const Eigen::Vector3d feet = Eigen::Vector3d::Constant(1.0 / kPlanFoot_m);
  write_cloud("cloud.las", "EPSG:2992", origin, feet);
  write_ridge("ridge.geojson", "EPSG:2992", origin, feet);
  const ProgramResult inside = judge({"--bounds", "999900,599900,1000100,600100"});
  EXPECT_EQ(inside.exit_code, 0) << inside.err;
  EXPECT_EQ(line()["status"], "evaluated");
  EXPECT_REFUSED(judge({"--bounds", "304769,182849,304831,182911"}),  // the same bounds in metres
                 AllOf(HasSubstr("own coordinates"), HasSubstr("unit foot (0.3048 m)")));
}

TEST_F(PlanScale, HeightsAboveTheEllipsoidAreJudgedAndMapped) {
  const Eigen::Vector3d origin(513000.0, 5403000.0, 250.0);
  const std::string plan =
      R"-(PROJCS["UTM 32",GEOGCS["ETRS89",DATUM["European_Terrestrial_Reference_System_1989",)-"
      R"-(SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],)-"
      R"-(UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4258"]],)-"
      R"-(PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],)-"
      R"-(PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],)-"
      R"-(PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1]])-";
  const std::string three_axes =
      R"-(COMPD_CS["UTM 32 + Ellipsoid",)-" + plan +
      R"-(,VERT_CS["Ellipsoid",VERT_DATUM["Ellipsoid",2002],UNIT["metre",1],AXIS["Up",UP]]])-";
  write_cloud("cloud.las", three_axes, origin, Eigen::Vector3d::Ones());
  write_ridge("ridge.geojson", "EPSG:25832", origin, Eigen::Vector3d::Ones());
  ProgramResult result = judge({"--write-points", "points.las"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("heights may differ by tens of metres"));
  EXPECT_THAT(run({"info", "points.las"}).out, HasSubstr("crs         UTM 32"));
  result = judge({"--assume-crs", three_axes});  // so that the map has it
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("overrides")));
  EXPECT_THAT(run({"info", "judged/judged.ridge.gpkg"}).out, HasSubstr("metre (1 m) in plan"));
}

}  // namespace
}  // namespace ridgeline::cli
