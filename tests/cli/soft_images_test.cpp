// SPDX-License-Identifier: BSD-3-Clause
// Images whose edges are wider than a pixel.
#include "io/files/csv_table.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/segment.h"
#include "tests/cli/run_fixture.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace ridgeline::cli {
namespace {

/// Sample patch 1 with images that are blurred before their noise arises.
class SoftPatch : public RunSample {
 protected:
  SoftPatch() {
    constexpr double kBlur_px = 4.0;
    constexpr double kNoise = 2.0;  // of 255
    cv::RNG random(1);
    for (const char* image : {"left", "right"}) {
      const std::string file = path(fmt::format("patch/{}.tif", image)).string();
      cv::Mat blurred;
      cv::GaussianBlur(cv::imread(file, cv::IMREAD_UNCHANGED), blurred, {}, kBlur_px);
      cv::Mat noise(blurred.size(), CV_MAKETYPE(CV_16S, blurred.channels()));
      random.fill(noise, cv::RNG::NORMAL, 0.0, kNoise);
      cv::add(blurred, noise, blurred, cv::noArray(), CV_8U);
      cv::imwrite(file, blurred);
    }
  }

  [[nodiscard]] ProjectionMatrix camera(std::size_t image) const {
    const YAML::Node rows =
        YAML::LoadFile(path("patch/patch.yaml").string())["images"][image]["projection_matrix"];
    ProjectionMatrix p;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) p(row, column) = rows[row][column].as<double>();
    }
    return p;
  }
};

TEST_F(SoftPatch, LinesLieWhereTheirImagesShowThem) {
  const ProgramResult result =
      run({"reconstruct", "patch/patch.yaml", "--method", "network", "--out", "lines.geojson"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::array cameras{camera(0), camera(1)};
  const nlohmann::json lines = read_json(path("lines.geojson"));
  int n_seen = 0, n_far = 0;
  for (const nlohmann::json& line : lines["features"]) {
    if (line["geometry"].is_null()) continue;
    const nlohmann::json& ends = line["geometry"]["coordinates"];
    for (std::size_t image = 0; image < 2; ++image) {
      const nlohmann::json& px = line["properties"][image == 0 ? "left_px" : "right_px"];
      const Segment2 seen{{px[0].get<double>(), px[1].get<double>()},
                          {px[2].get<double>(), px[3].get<double>()}};
      const Eigen::Vector3d middle(0.5 * (ends[0][0].get<double>() + ends[1][0].get<double>()),
                                   0.5 * (ends[0][1].get<double>() + ends[1][1].get<double>()),
                                   0.5 * (ends[0][2].get<double>() + ends[1][2].get<double>()));
      // The line is a compromise of both images; pixels of the reduced image would be hundreds of
      // pixels away.
      constexpr double kMaxDistance_px = 10.0;
      n_far += distance(seen, project(cameras[image], middle)) > kMaxDistance_px ? 1 : 0;
    }
    ++n_seen;
  }
  EXPECT_GT(n_seen, 200);
  EXPECT_LE(n_far, n_seen / 100);  // false matches along the epipolar lines
}

using SoftSample = Cli;

TEST_F(SoftSample, SegmentsStateTheirScale) {
  const auto image = std::filesystem::path(test::source_dir()) / "sample_data/5/left.tif";
  ASSERT_EQ(run({"extract", image.string(), "--out", "left.csv"}).exit_code, 0);
  const io::CsvTable table(path("left.csv").string());
  ASSERT_GT(table.size(), 0U);
  for (std::size_t row = 0; row < table.size(); ++row)
    EXPECT_GE(table.number(row, table.column("scale_px")), 2.0);
}

/// Share of the length of the marked roof edges of an image that segments of a window cover.
double covered_share(const io::CsvTable& marks,
                     const std::string& image,
                     const io::CsvTable& segments,
                     const Eigen::Vector2d& corner_px) {
  constexpr double kBeside_px = 4.0;  // the marks are right to a few pixels
  constexpr double kMaxTurn_rad = 0.035;
  constexpr int kSamples = 400;
  const auto segment_of = [](const io::CsvTable& table, std::size_t row,
                             const std::string& prefix) {
    const auto at = [&](const char* name) {
      return table.number(row, table.column(prefix + name));
    };
    return Segment2{{at("x1_px"), at("y1_px")}, {at("x2_px"), at("y2_px")}};
  };
  double total_px = 0.0;
  double covered_px = 0.0;
  for (std::size_t row = 0; row < marks.size(); ++row) {
    if (marks.text(row, marks.column("image")) != image) continue;
    const Segment2 mark = segment_of(marks, row, "");
    std::vector<char> is_covered(kSamples, 0);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      Segment2 s = segment_of(segments, i, "image_");
      s = {s.start + corner_px, s.end + corner_px};
      if (acute_angle_rad(mark, s) > kMaxTurn_rad) continue;
      for (int k = 0; k < kSamples; ++k) {
        const Eigen::Vector2d x = point_at(mark, (k + 0.5) / kSamples);
        const double t = parameter_along(s, x);
        if (t >= 0.0 && t <= 1.0 && distance(s, x) <= kBeside_px)
          is_covered[static_cast<std::size_t>(k)] = 1;
      }
    }
    total_px += length(mark);
    covered_px +=
        length(mark) * static_cast<double>(std::ranges::count(is_covered, char{1})) / kSamples;
  }
  return covered_px / total_px;
}

class RealSoftFrames : public Cli {};

TEST_F(RealSoftFrames, ShowTheRoofEdgesThatPeopleSee) {
  const std::filesystem::path folder = shared_data("boruszyn");
  if (folder.empty()) GTEST_SKIP() << "no folder boruszyn beside the checkout";
  struct Window {
    const char* image;
    std::array<int, 4> px;
    double least_share;  // at full size 0.17 and 0.27
  };
  const std::string text = read(folder / "marked_edges.csv");
  write(path("marks.csv"), text.substr(text.find("image,")));  // the rows before are remarks
  const io::CsvTable marks(path("marks.csv").string());
  for (const Window& window : {Window{"img_4928.jpg", {346, 888, 2369, 2295}, 0.78},
                               Window{"img_4912.jpg", {1996, 257, 2320, 2323}, 0.65}}) {
    const auto& [column, row, columns, rows] = window.px;
    const ProgramResult result = run({"extract", (folder / "a" / window.image).string(), "--window",
                                      fmt::format("{},{},{},{}", column, row, columns, rows),
                                      "--out", "segments.csv", "--overwrite"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const io::CsvTable segments(path("segments.csv").string());
    EXPECT_GT(covered_share(marks, window.image, segments, Eigen::Vector2d(column, row)),
              window.least_share)
        << window.image;
  }
}

}  // namespace
}  // namespace ridgeline::cli
