// SPDX-License-Identifier: BSD-3-Clause
// Clouds and lines in feet, and data of PROJ and GDAL that are not found.
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

constexpr double kFoot_m = 0.3048;

class Feet : public Cli {
 protected:
  /// A flat roof of 20 m x 10 m with its eave at y = 0, above ground 6 m lower, from an origin.
  static std::vector<Eigen::Vector3d> roof_points_m() {
    constexpr double kSpacing_m = 0.25;
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= 80; ++i) {
      for (int j = -40; j <= 40; ++j) {
        points.emplace_back(kSpacing_m * i, kSpacing_m * j, j < 0 ? 250.0 : 256.0);
      }
    }
    return points;
  }

  /// Writes the roof as text without a reference system, with coordinates times `scale`.
  void write_cloud(const std::string& name, double scale) const {
    std::string text;
    for (const Eigen::Vector3d& x : roof_points_m()) {
      text += fmt::format("{:.4f} {:.4f} {:.4f}\n", scale * (513000.0 + x.x()),
                          scale * (5403000.0 + x.y()), scale * x.z());
    }
    write(path(name), text);
  }

  /// Writes the roof in feet, with a reference system that says so.
  void write_cloud_in_feet(const std::string& name) const {
    const double scale = 1.0 / kFoot_m;
    const LocalFrame frame{{std::round(scale * 513000.0), std::round(scale * 5403000.0), 0.0}};
    std::vector<io::CloudPoint> points;
    for (const Eigen::Vector3d& x : roof_points_m()) {
      const Eigen::Vector3d local = frame.local_from_world(
          scale * Eigen::Vector3d(513000.0 + x.x(), 5403000.0 + x.y(), x.z()));
      points.emplace_back();
      points.back().x = local.x();
      points.back().y = local.y();
      points.back().z = local.z();
      points.back().return_number = 1;
    }
    io::write_las(path(name).string(), points, frame, {"EPSG:2992"});
  }

  void write_eave(const std::string& name, double scale) const {
    write(path(name),
          fmt::format("id,x1,y1,z1,x2,y2,z2\n0,{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n",
                      scale * 513002.0, scale * 5403000.0, scale * 256.0, scale * 513018.0,
                      scale * 5403000.0, scale * 256.0));
  }

  [[nodiscard]] ProgramResult judge(const std::string& lines,
                                    const std::string& cloud,
                                    const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"evaluate", "--lines",        lines, "--cloud", cloud,
                                       "--out",    "judged_" + lines};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  [[nodiscard]] double mean_distance_m(const std::string& stem) const {
    const auto json = read_json(path(fmt::format("judged_{0}.csv/evaluation.{0}.json", stem)));
    const auto& line = json["lines"][0];
    EXPECT_EQ(line["status"], "evaluated");
    return line["mean_distance_m"].is_number() ? line["mean_distance_m"].get<double>() : -1.0;
  }
};

TEST_F(Feet, LinesOutsideByTheFootNameTheFactor) {
  write_cloud("cloud.xyz", 1.0);
  write_eave("feet.csv", 1.0 / kFoot_m);
  EXPECT_REFUSED(judge("feet.csv", "cloud.xyz"),
                 AllOf(HasSubstr("not in the same frame"), HasSubstr("scaled by 0.3048")));
  write_cloud("feet.xyz", 1.0 / kFoot_m);
  write_eave("metres.csv", 1.0);
  EXPECT_REFUSED(judge("metres.csv", "feet.xyz"),
                 AllOf(HasSubstr("not in the same frame"), HasSubstr("scaled by 3.2808")));
}

TEST_F(Feet, LinesWithoutASystemAreInTheUnitsOfTheCloud) {
  write_cloud_in_feet("feet.las");
  write_eave("eave.csv", 1.0 / kFoot_m);
  const ProgramResult result = judge("eave.csv", "feet.las");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("has no horizontal reference system"));
  constexpr double kRounding_m = 1e-3;  // the LAS file's resolution, a thousandth of a foot
  EXPECT_NEAR(mean_distance_m("eave"), 0.0, kRounding_m);
  EXPECT_THAT(run({"info", "feet.las"}).out,
              AllOf(HasSubstr("units       foot (0.3048 m) in plan"), Not(HasSubstr("metre"))));
}

TEST_F(Feet, InfoStatesOneUnit) {
  write_cloud("cloud.xyz", 1.0);
  const ProgramResult cloud = run({"info", "cloud.xyz"});
  EXPECT_EQ(cloud.exit_code, 0) << cloud.err;
  EXPECT_THAT(cloud.out, HasSubstr("units       unknown, assuming metres"));
  write(path("feet.geojson"),
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:2992"}},)"
        R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"LineString",)"
        R"("coordinates":[[1000000,2000,3],[1000003,2004,3]]}}]})");
  const ProgramResult lines = run({"info", "feet.geojson"});
  EXPECT_EQ(lines.exit_code, 0) << lines.err;
  EXPECT_THAT(lines.out,
              AllOf(HasSubstr("total length 5.0 foot"),
                    HasSubstr("units       foot (0.3048 m) in plan"), Not(HasSubstr("metre"))));
}

TEST_F(Feet, AssumedSystemMustBeACodeOrADefinition) {
  for (const char* name : {"foo", "ETRS89 / UTM zone 32N", "25832"}) {
    EXPECT_REFUSED(evaluate("scene/truth.geojson", "out", {"--assume-crs", name}),
                   AllOf(HasSubstr(name), HasSubstr("must be a code (EPSG:25832")));
  }
  EXPECT_EQ(evaluate("scene/truth.geojson", "out", {"--assume-crs", "EPSG:25832", "--no-report"})
                .exit_code,
            0);
}

TEST_F(Feet, DegreesOfACloudBehindAnAssumedSystemAreRefused) {
  std::string text;
  for (int i = 0; i < 1000; ++i)
    text += fmt::format("{:.7f} {:.7f} {}\n", 9.17 + i * 1e-6, 48.78, 250 + i % 20);
  write(path("degrees.xyz"), text);
  EXPECT_REFUSED(judge("scene/truth.geojson", "degrees.xyz", {"--assume-crs", "EPSG:25832"}),
                 AllOf(HasSubstr("degrees.xyz"), HasSubstr("look like degrees")));
}

TEST_F(Feet, MissingDataOfProjAreNamedAsTheCause) {
  const std::vector<std::string> nowhere{"PROJ_LIB=/nonexistent", "PROJ_DATA=/nonexistent"};
  EXPECT_REFUSED(run({"info", "scene/truth.geojson"}, nowhere),
                 AllOf(HasSubstr("proj.db"), HasSubstr("PROJ_DATA"), HasSubstr("/nonexistent")));
  const ProgramResult wkt = run({"info", "scene/lidar.las"}, nowhere);  // WKT needs no data base
  EXPECT_EQ(wkt.exit_code, 0);
  EXPECT_EQ(wkt.err, "");
}

}  // namespace
}  // namespace ridgeline::cli
