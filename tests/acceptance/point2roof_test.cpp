// SPDX-License-Identifier: BSD-3-Clause
// Four roofs of Point2Roof (Li et al. 2022): the true wireframe and the models of three methods,
// judged against one cloud of 1024 points each.

#include "evaluate/files/judged_lines.h"
#include "evaluate/statistics/tolerance_measures.h"
#include "io/cloud/read_cloud.h"
#include "io/lines/read_lines.h"
#include "tests/acceptance/judge_cloud.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace ridgeline::test {
namespace {

using evaluate::LineEvaluation;
using evaluate::Status;

constexpr const char* kMethods[] = {"Point2Roof", "TopoLAP", "2D_dual_contouring"};

struct Score {
  double rms_m = 0.0;          ///< of the evaluated lines
  double share_on_roof = 0.0;  ///< of the wireframe's length: within 5 cm of its planes
};

/// A line without a judgement (vertical, too short, ambiguous) counts as length that is not on the
/// roof, so that a method gains nothing by lines that cannot be judged.
Score score(const std::vector<LineEvaluation>& lines,
            const std::vector<evaluate::JudgedLine>& judged) {
  double length_m = 0.0, evaluated_m = 0.0, sum_m2 = 0.0;
  int n_evaluated = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double line_m = (judged[i].segment.end - judged[i].segment.start).norm();
    length_m += line_m;
    if (lines[i].status != Status::kEvaluated) continue;
    evaluated_m += line_m;
    sum_m2 += *lines[i].mean_distance_m * *lines[i].mean_distance_m;
    ++n_evaluated;
  }
  const auto measures =
      evaluate::measure_against_planes(lines, {.tolerances_m = {0.05}, .max_angle_deg = 5.0});
  return {std::sqrt(sum_m2 / n_evaluated),
          measures.front().precision.value_or(0.0) * evaluated_m / length_m};
}

class Point2Roof : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(test::shared_data_dir()) / "point2roof" /
              ("roof" + std::to_string(GetParam()));
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << folder_ << " is absent";
    cloud_ = io::read_cloud({(folder_ / "points.xyz").string()});
  }

  Score judge(const std::string& model) {
    const io::LineSet set = io::read_lines((folder_ / (model + ".obj")).string());
    const auto lines = results::judged_lines_of(set, cloud_.frame, {});
    const Score result = score(judge_each(grid_of(cloud_), lines), lines);
    RecordProperty(model + "_rms_m", std::to_string(result.rms_m));
    RecordProperty(model + "_share_on_roof", std::to_string(result.share_on_roof));
    return result;
  }

 private:
  std::filesystem::path folder_;
  io::PointCloud cloud_;
};

// The points of roof 2 are off its truth by 3 cm in the median (the data's README): there, and
// there only, a model may lie closer to the points than the truth.
constexpr int kRoofWithShiftedPoints = 2;
constexpr double kShift_m = 0.032;

// On roofs 3 and 4 other models are on the roof entirely, as the truth is: no method is better.
TEST_P(Point2Roof, NoModelIsMoreOnTheRoofThanTheTruth) {
  const Score truth = judge("ground_truth");
  EXPECT_GE(truth.share_on_roof, 0.9);
  if (GetParam() == kRoofWithShiftedPoints) return;
  for (const char* method : kMethods) {
    EXPECT_LE(judge(method).share_on_roof, truth.share_on_roof) << method;
  }
}

TEST_P(Point2Roof, TheTruthHasTheLeastRms) {
  const double truth_m = judge("ground_truth").rms_m;
  if (GetParam() == kRoofWithShiftedPoints) {
    EXPECT_NEAR(truth_m, kShift_m, 0.01);
    return;
  }
  for (const char* method : kMethods) {
    EXPECT_GT(judge(method).rms_m, truth_m) << method;
  }
}

INSTANTIATE_TEST_SUITE_P(Roofs, Point2Roof, ::testing::Range(1, 5));

}  // namespace
}  // namespace ridgeline::test
