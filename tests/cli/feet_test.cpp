// SPDX-License-Identifier: BSD-3-Clause
// Clouds and lines in feet, and data of PROJ and GDAL that are not found.
#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>

#include <filesystem>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kFoot_m = 0.3048;

class Feet : public Cli {
 protected:
  /// A flat roof of 20 m x 10 m with its eave at y = 0, above ground 6 m lower; coordinates times
  /// `scale`.
  void write_cloud(const std::string& name, double scale) const {
    std::string text;
    for (double x = 0.0; x <= 20.0; x += 0.25) {
      for (double y = -10.0; y <= 10.0; y += 0.25) {
        const double z = y < 0.0 ? 250.0 : 256.0;
        text += fmt::format("{:.4f} {:.4f} {:.4f}\n", scale * (513000.0 + x),
                            scale * (5403000.0 + y), scale * z);
      }
    }
    write(path(name), text);
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
                 AllOf(HasSubstr("not in the same frame"), HasSubstr("times 0.3048")));
  write_cloud("feet.xyz", 1.0 / kFoot_m);
  write_eave("metres.csv", 1.0);
  EXPECT_REFUSED(judge("metres.csv", "feet.xyz"),
                 AllOf(HasSubstr("not in the same frame"), HasSubstr("times 3.2808")));
}

TEST_F(Feet, InfoStatesOneUnit) {
  write_cloud("cloud.xyz", 1.0);
  const ProgramResult cloud = run({"info", "cloud.xyz"});
  EXPECT_EQ(cloud.exit_code, 0) << cloud.err;
  EXPECT_THAT(cloud.out, HasSubstr("units       not stated, taken as metre"));
  write(path("feet.geojson"),
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:2992"}},)"
        R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"LineString",)"
        R"("coordinates":[[1000000,2000,3],[1000003,2004,3]]}}]})");
  const ProgramResult lines = run({"info", "feet.geojson"});
  EXPECT_EQ(lines.exit_code, 0) << lines.err;
  EXPECT_THAT(lines.out,
              AllOf(HasSubstr("5.0 foot together"),
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
                 AllOf(HasSubstr("degrees.xyz"), HasSubstr("degrees by their size")));
}

TEST_F(Feet, MissingDataOfProjAreNamedAsTheCause) {
  const std::vector<std::string> nowhere{"PROJ_LIB=/nonexistent", "PROJ_DATA=/nonexistent"};
  for (const char* file : {"scene/truth.geojson", "scene/lidar.las"}) {
    EXPECT_REFUSED(run({"info", file}, nowhere),
                   AllOf(HasSubstr("proj.db"), HasSubstr("PROJ_DATA"), HasSubstr("/nonexistent")));
  }
}

}  // namespace
}  // namespace ridgeline::cli
