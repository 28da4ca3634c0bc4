// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/degrade.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace ridgeline::simulate {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr int kLines = 20000;

io::LineSet many_lines() {
  io::LineSet set;
  for (int i = 0; i < kLines; ++i) {
    io::Line line;
    line.id = std::to_string(i);
    line.kind = "ridge";
    line.segment_in_world = {{1.0 * i, 0.0, 10.0}, {1.0 * i, 8.0, 10.0}};
    set.lines.push_back(line);
  }
  return set;
}

Vector6d error_of(const io::Line& line) {
  const double x = std::stod(line.id);
  Vector6d error;
  error << line.segment_in_world.start - Eigen::Vector3d(x, 0.0, 10.0),
      line.segment_in_world.end - Eigen::Vector3d(x, 8.0, 10.0);
  return error;
}

TEST(DegradeLines, ErrorsHaveTheClaimedCovariance) {
  DegradeOptions options;
  options.plan_sigma_m = 0.2;
  options.height_sigma_m = 0.3;
  options.tilt_sigma_m = 0.1;
  const io::LineSet lines = degrade_lines(many_lines(), options);
  ASSERT_EQ(lines.lines.size(), static_cast<std::size_t>(kLines));
  Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
  double nees = 0.0;
  for (const io::Line& line : lines.lines) {
    const Vector6d error = error_of(line);
    sum += error * error.transpose();
    nees += error.dot(line.covariance_m2->inverse() * error);
  }
  const Eigen::Matrix<double, 6, 6> claimed = *lines.lines.front().covariance_m2;
  EXPECT_LT((sum / kLines - claimed).cwiseAbs().maxCoeff(), 0.005);  // 5 % of the largest entry
  EXPECT_NEAR(nees / kLines, 6.0, 0.12);  // 5 standard errors, sqrt(2 * 6 / n)
}

TEST(DegradeLines, AnOptimisticToolClaimsLessThanItsErrors) {
  DegradeOptions options;
  options.claimed_sigma_ratio = 0.5;
  double nees = 0.0;
  for (const io::Line& line : degrade_lines(many_lines(), options).lines) {
    const Vector6d error = error_of(line);
    nees += error.dot(line.covariance_m2->inverse() * error);
  }
  EXPECT_NEAR(nees / kLines, 24.0, 0.5);
}

TEST(DegradeLines, WithoutErrorsGivesTheLinesThemselves) {
  DegradeOptions options;
  options.plan_sigma_m = options.height_sigma_m = options.tilt_sigma_m = 0.0;
  for (const io::Line& line : degrade_lines(many_lines(), options).lines) {
    EXPECT_EQ(error_of(line).norm(), 0.0);
    EXPECT_EQ(line.kind, "ridge");
  }
}

TEST(DegradeLines, BiasShiftsAllLines) {
  DegradeOptions options;
  options.plan_sigma_m = options.height_sigma_m = options.tilt_sigma_m = 0.0;
  options.bias_m = {0.25, -0.5, 1.0};
  for (const io::Line& line : degrade_lines(many_lines(), options).lines) {
    EXPECT_EQ(error_of(line).head<3>(), options.bias_m);
    EXPECT_EQ(error_of(line).tail<3>(), options.bias_m);
  }
}

TEST(DegradeLines, MissingLinesLeaveTheErrorsOfTheOthers) {
  DegradeOptions options;
  std::map<std::string, Vector6d> all;
  for (const io::Line& line : degrade_lines(many_lines(), options).lines) {
    all[line.id] = error_of(line);
  }
  options.missing_share = 0.3;
  const io::LineSet lines = degrade_lines(many_lines(), options);
  EXPECT_NEAR(static_cast<double>(lines.lines.size()) / kLines, 0.7, 0.017);  // 5 sigma
  for (const io::Line& line : lines.lines) EXPECT_EQ(error_of(line), all.at(line.id));
}

TEST(DegradeLines, GrossErrorsAreOfTwoToEightMetres) {
  DegradeOptions options;
  options.plan_sigma_m = options.height_sigma_m = options.tilt_sigma_m = 0.0;
  options.gross_share = 0.1;
  int gross = 0;
  for (const io::Line& line : degrade_lines(many_lines(), options).lines) {
    const double size_m = std::abs(error_of(line)[2]);
    if (size_m == 0.0) continue;
    ++gross;
    EXPECT_GE(size_m, 2.0);
    EXPECT_LE(size_m, 8.0);
  }
  EXPECT_NEAR(static_cast<double>(gross) / kLines, 0.1, 0.011);  // 5 sigma
}

TEST(DegradeLines, GradesAreOrderedByTheirHeightErrors) {
  const std::map<Grade, double> expected_m{
      {Grade::kGood, 0.058}, {Grade::kFair, 0.206}, {Grade::kPoor, 0.6}};
  for (const auto& [grade, sigma_m] : expected_m) {
    DegradeOptions options = options_of(grade, 3);
    options.gross_share = 0.0;
    double squares = 0.0;
    const io::LineSet lines = degrade_lines(many_lines(), options);
    for (const io::Line& line : lines.lines) squares += std::pow(error_of(line)[2], 2);
    const double rms_m = std::sqrt(squares / static_cast<double>(lines.lines.size()));
    EXPECT_NEAR(rms_m, sigma_m, 0.03 * sigma_m);
  }
  EXPECT_GT(options_of(Grade::kPoor, 1).gross_share, 0.0);
}

TEST(DegradeLines, RejectsNegativeSigmasAndSharesBeyondOne) {
  const auto rejects = [](auto change) {
    DegradeOptions options;
    change(options);
    EXPECT_THROW(degrade_lines({}, options), std::invalid_argument);
  };
  rejects([](DegradeOptions& o) { o.plan_sigma_m = -1.0; });
  rejects([](DegradeOptions& o) { o.height_sigma_m = std::nan(""); });
  rejects([](DegradeOptions& o) { o.tilt_sigma_m = -0.1; });
  rejects([](DegradeOptions& o) { o.missing_share = 1.1; });
  rejects([](DegradeOptions& o) { o.gross_share = -0.1; });
  rejects([](DegradeOptions& o) { o.claimed_sigma_ratio = -1.0; });
}

}  // namespace
}  // namespace ridgeline::simulate
