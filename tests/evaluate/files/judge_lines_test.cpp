// SPDX-License-Identifier: BSD-3-Clause
// Lines and points in memory are judged as their files are.
#include "evaluate/files/judge_files.h"
#include "io/cloud/binary_table.h"
#include "io/lines/read_lines.h"
#include "reconstruct/geometry/interruption.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace ridgeline::results {
namespace {

using ::testing::HasSubstr;

const std::string kSample = test::source_dir() + "/sample_data/1/";

JudgeFilesOptions sample_options() {
  JudgeFilesOptions options;
  options.line_paths = {kSample + "lines.fair.geojson"};
  options.cloud_paths = {kSample + "lidar.las"};
  return options;
}

/// A cloud source over points, which must outlive it.
std::unique_ptr<io::CloudSource> open_points(const std::vector<double>& xyz) {
  constexpr std::size_t kSize = sizeof(double), kRow = 3 * kSize;
  using io::PointAttribute;
  return io::open_binary_table(
      {.storage = std::monostate{},
       .bytes = std::as_bytes(std::span(xyz)),
       .columns = {{PointAttribute::kX, io::ScalarType::kFloat64, 0, kRow},
                   {PointAttribute::kY, io::ScalarType::kFloat64, kSize, kRow},
                   {PointAttribute::kZ, io::ScalarType::kFloat64, 2 * kSize, kRow}}},
      {.path = "memory", .format = "array", .has_sure_unit = true, .n_points = xyz.size() / 3});
}

std::vector<double> sample_points() {
  io::ReadOptions as_in_the_file;
  as_in_the_file.frame = LocalFrame{};
  const io::PointCloud cloud = io::read_cloud({kSample + "lidar.las"}, as_in_the_file);
  std::vector<double> xyz;
  for (const io::CloudPoint& p : cloud.points) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  return xyz;
}

TEST(JudgeLines, InMemoryGivesTheDistancesOfTheFiles) {
  constexpr double kRounding_m = 1e-9;  // rounding of the reduction to the local frame
  const JudgeFilesOptions options = sample_options();
  RunRecord record("test");
  const JudgedFiles by_files = judge_files(options, record);
  const std::vector<double> xyz = sample_points();
  io::CloudFiles cloud(open_points(xyz), {});
  const JudgedFiles in_memory =
      judge_lines({{io::read_lines(options.line_paths[0])}, {}}, cloud, options, record);
  const auto& expected = by_files.evaluations[0].lines;
  const auto& judged = in_memory.evaluations[0].lines;
  ASSERT_EQ(judged.size(), expected.size());
  for (std::size_t i = 0; i < judged.size(); ++i) {
    EXPECT_EQ(judged[i].status, expected[i].status) << judged[i].id;
    if (judged[i].status != evaluate::Status::kEvaluated) continue;
    EXPECT_NEAR(*judged[i].mean_distance_m, *expected[i].mean_distance_m, kRounding_m);
  }
  for (const std::string& warning : in_memory.warnings) {
    EXPECT_THAT(warning, Not(HasSubstr("assuming that its coordinates are in")));
  }
}

TEST(JudgeLines, StopWhenTheyAreAskedTo) {
  RunRecord record("test");
  Interruption::request();
  EXPECT_THROW(judge_files(sample_options(), record), Interrupted);
  Interruption::clear();
  EXPECT_EQ(judge_files(sample_options(), record).evaluations[0].lines.size(), 89U);
}

TEST(RunRecord, LeavesOutTheTimeBeforeItIsResumed) {
  using Seconds = std::chrono::duration<double>;
  constexpr Seconds kLeftOut{0.3};
  const auto start = std::chrono::steady_clock::now();
  RunRecord record("test");
  record.end_stage("work");
  std::this_thread::sleep_for(kLeftOut);
  record.resume();
  record.end_stage("write");
  const auto json = nlohmann::json(record.to_json());
  const Seconds all = std::chrono::steady_clock::now() - start;
  EXPECT_LE(json["seconds"].get<double>(), (all - kLeftOut).count());
  EXPECT_LE(json["stages"][1]["seconds"].get<double>(), (all - kLeftOut).count());
}

}  // namespace
}  // namespace ridgeline::results
