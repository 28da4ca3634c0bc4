// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/reference_errors.h"

#include "evaluate/tables/reference_table.h"
#include "reconstruct/geometry/epipolar.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kReferenceExact = 1e-9;

/// A frame looking straight down from 800 m, GSD 8 cm.
ProjectionMatrix camera_at(double x) {
  ProjectionMatrix p;
  p << 10000, 0, 0, -10000 * x, 0, -10000, 0, 0, 0, 0, -1, 800;
  return p;
}

/// A line that the images show exactly at `seen`, reconstructed at `found`.
JudgedLine reconstructed(const Segment3& seen, const Segment3& found, std::string line_class) {
  JudgedLine line;
  line.segment = found;
  line.line_class = std::move(line_class);
  line.images.emplace().height_range_m = {-10.0, 30.0};
  for (const ProjectionMatrix& camera : {camera_at(-104.0), camera_at(104.0)}) {
    line.images->observations.push_back({camera, project(camera, seen)});
  }
  return line;
}

Segment3 moved(const Segment3& s, const Eigen::Vector3d& by) { return {s.start + by, s.end + by}; }

const Segment3 kRidge{{0, 0, 8}, {10, 0, 8}};
const Segment3 kEave{{0, 5, 5}, {10, 5, 5}};

TEST(CompareWithReferences, ErrorIsTheMeanDistanceFromTheLineThatTheImagesShow) {
  // the ridge is shifted along itself, which is no error, and by a 3-4-5 triangle across
  const std::vector<JudgedLine> lines{
      reconstructed(kRidge, moved(kRidge, {0.7, 0.3, 0.4}), "aligned"),
      reconstructed(kEave, moved(kEave, {0, 0, 0.1}), "not_aligned")};
  const std::vector<ReferenceLine> truth{{kEave, "eave"}, {kRidge, "ridge"}};
  const ReferenceComparison found = compare_with_references(lines, truth);
  ASSERT_EQ(found.classes.size(), 3U);
  EXPECT_EQ(found.classes[0].line_class, "not_aligned");
  EXPECT_NEAR(*found.classes[0].rms_m, 0.1, kReferenceExact);
  EXPECT_EQ(found.classes[1].line_class, "aligned");
  EXPECT_NEAR(*found.classes[1].rms_m, 0.5, kReferenceExact);
  EXPECT_NEAR(*found.classes[2].rms_m, std::sqrt((0.01 + 0.25) / 2.0), kReferenceExact);
  EXPECT_EQ(found.classes[2].n_on_reference, 2U);
}

TEST(CompareWithReferences, PartsAreAcrossInPlanAndInHeightAtTheSamePlace) {
  // a hip that rises 4 m over 5 m in plan; moved along itself, then across to the left and up
  const Segment3 hip{{0, 0, 5}, {3, 4, 9}};
  const Eigen::Vector3d across(-0.8 * 0.2, 0.6 * 0.2, 0.0);
  const Eigen::Vector3d along = 0.1 * (hip.end - hip.start);
  const Segment3 found{hip.start + along + across + Eigen::Vector3d(0, 0, 0.3),
                       hip.end + across + Eigen::Vector3d(0, 0, -0.1)};
  const auto total =
      compare_with_references(std::vector<JudgedLine>{reconstructed(hip, found, "aligned")},
                              std::vector<ReferenceLine>{{hip, "hip"}})
          .classes[2];
  EXPECT_EQ(total.n_parts, 1U);
  EXPECT_NEAR(*total.rmse_horizontal_m, 0.2, kReferenceExact);
  EXPECT_NEAR(*total.mean_vertical_m, 0.1, kReferenceExact);
  // the height runs linearly from 0.3 to -0.1 m
  EXPECT_NEAR(*total.rmse_vertical_m, std::sqrt((0.09 - 0.03 + 0.01) / 3.0), kReferenceExact);
}

TEST(CompareWithReferences, UprightReferenceHasNoParts) {
  const Segment3 corner{{0, 0, 2}, {0, 0.1, 5}};
  const auto total =
      compare_with_references(std::vector<JudgedLine>{reconstructed(corner, corner, "aligned")},
                              std::vector<ReferenceLine>{{corner, "corner"}})
          .classes[2];
  EXPECT_EQ(total.n_on_reference, 1U);
  EXPECT_EQ(total.n_parts, 0U);
  EXPECT_FALSE(total.rmse_horizontal_m);
}

/// The line with independent errors of both ends that have this sigma in all directions.
JudgedLine with_sigma(JudgedLine line, double sigma_m) {
  line.covariance_m2 = sigma_m * sigma_m * Eigen::Matrix<double, 6, 6>::Identity();
  return line;
}

TEST(CompareWithReferences, NeesIsTheErrorOfBothEndsAcrossOverItsCovariance) {
  // ends 0.3 m beside and 0.4 m above, of sigma 0.25 m: 2 (0.3^2 + 0.4^2) / 0.25^2 = 8; moved along
  // itself, which is no error
  const JudgedLine line = reconstructed(kRidge, moved(kRidge, {0.7, 0.3, 0.4}), "aligned");
  const std::vector<ReferenceLine> truth{{kRidge, "ridge"}};
  const auto tested = [&](double sigma_m) {
    return compare_with_references(std::vector<JudgedLine>{with_sigma(line, sigma_m)}, truth)
        .classes[1];
  };
  constexpr double kMedian = 3.35669;  // median of chi-square with 4 degrees of freedom
  EXPECT_NEAR(*tested(0.25).median_nees_ratio, 8.0 / kMedian, kReferenceExact);
  EXPECT_EQ(*tested(0.25).nees_beyond_99_9_share, 0.0);
  EXPECT_EQ(*tested(0.1).nees_beyond_99_9_share, 1.0);  // it is 50, the limit 18.5
}

TEST(CompareWithReferences, NeesIsOfLinesWithCovarianceOnTheReferenceToOnePixel) {
  const Segment3 close = moved(kRidge, {0, 0.06, 0});   // 0.76 px
  const Segment3 beside = moved(kRidge, {0, 0.12, 0});  // 1.5 px: perhaps another edge
  JudgedLine exact = with_sigma(reconstructed(kRidge, kRidge, "aligned"), 0.1);
  exact.covariance_m2->setZero();
  const auto total =
      compare_with_references(
          std::vector<JudgedLine>{with_sigma(reconstructed(close, close, "aligned"), 0.1),
                                  with_sigma(reconstructed(beside, beside, "aligned"), 0.1),
                                  reconstructed(kRidge, kRidge, "aligned"), exact},
          std::vector<ReferenceLine>{{kRidge, "ridge"}})
          .classes[2];
  EXPECT_EQ(total.n_on_reference, 4U);
  EXPECT_EQ(total.n_tested, 1U);
}

TEST(ReferenceErrors, BelongToTheLinesInTheirOrder) {
  std::vector<JudgedLine> lines{reconstructed(moved(kRidge, {0, 0.5, 0}), kRidge, "aligned"),
                                reconstructed(kEave, moved(kEave, {0, 0, 0.1}), "not_aligned"),
                                reconstructed(kEave, kEave, "not_aligned")};
  lines[2].reconstructed = false;
  const auto errors_m =
      reference_errors_m(lines, std::vector<ReferenceLine>{{kRidge, "ridge"}, {kEave, "eave"}});
  ASSERT_EQ(errors_m.size(), 3U);
  EXPECT_FALSE(errors_m[0].has_value());  // it is on no reference line
  ASSERT_TRUE(errors_m[1].has_value());
  EXPECT_NEAR(*errors_m[1], 0.1, kReferenceExact);
  EXPECT_FALSE(errors_m[2].has_value());  // it has no geometry
}

TEST(CompareWithReferences, LineMetresOffIsStillComparedWithItsOwnReference) {
  const std::vector<JudgedLine> lines{reconstructed(kRidge, moved(kRidge, {0, 5, 30}), "aligned")};
  const ReferenceComparison found = compare_with_references(
      lines, std::vector<ReferenceLine>{{kEave, "eave"}, {kRidge, "ridge"}});
  EXPECT_NEAR(*found.classes[1].max_m, std::hypot(5.0, 30.0), kReferenceExact);
  EXPECT_EQ(*found.classes[1].gross_share, 1.0);
}

TEST(CompareWithReferences, LineThatTheImagesShowElsewhereHasNoReference) {
  // half a metre are six pixels; the reconstruction happens to lie on the ridge
  const std::vector<JudgedLine> lines{reconstructed(moved(kRidge, {0, 0.5, 0}), kRidge, "aligned")};
  const ReferenceComparison found =
      compare_with_references(lines, std::vector<ReferenceLine>{{kRidge, "ridge"}});
  EXPECT_EQ(found.classes[2].n_lines, 1U);
  EXPECT_EQ(found.classes[2].n_on_reference, 0U);
  EXPECT_FALSE(found.classes[2].rms_m.has_value());
}

TEST(ReferenceErrors, LinesOfSeveralPairsAreEachComparedInTheirOwnImages) {
  // each line lies on its reference line in its own images, but elsewhere in those of the other
  // line
  std::vector<JudgedLine> lines{reconstructed(kRidge, kRidge, "aligned"),
                                reconstructed(kEave, kEave, "aligned")};
  const std::array<ProjectionMatrix, 2> other{camera_at(40.0), camera_at(250.0)};
  lines[1].images =
      ImageEvidence{{{{other[0], project(other[0], kEave)}, {other[1], project(other[1], kEave)}}},
                    {-10.0, 30.0}};
  const auto found =
      reference_of_each(lines, std::vector<ReferenceLine>{{kEave, "eave"}, {kRidge, "ridge"}});
  EXPECT_EQ(found, (std::vector<std::optional<std::size_t>>{1, 0}));
}

TEST(ReferenceErrors, ReferenceLineThatIsNotFiniteBelongsToNoLine) {
  const std::vector<JudgedLine> lines{reconstructed(kRidge, kRidge, "aligned")};
  const Segment3 endless{{0, 0, 8}, {HUGE_VAL, 0, 8}};
  EXPECT_EQ(reference_of_each(lines, std::vector<ReferenceLine>{{endless, "ridge"}}),
            (std::vector<std::optional<std::size_t>>{std::nullopt}));
}

TEST(CompareWithReferences, CompletenessCountsHalfOfTheLengthOfVisibleLines) {
  // the ends reach 0.3 m farther, which is the tolerance
  const Segment3 most{{0, 0, 8.2}, {5.1, 0, 8.2}};
  const Segment3 less{{0, 5, 5}, {4.5, 5, 5}};
  const std::vector<JudgedLine> lines{reconstructed(most, most, "aligned"),
                                      reconstructed(less, less, "aligned")};
  const std::vector<ReferenceLine> truth{
      {kRidge, "ridge", 1.0}, {kEave, "eave", 0.6}, {moved(kEave, {0, 0, 9}), "eave", 0.4}};
  const auto rows = compare_with_references(lines, truth).completeness;
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].kind, "eave");
  EXPECT_EQ(rows[0].n_lines, 1U);  // the hidden line does not count
  EXPECT_EQ(rows[0].n_reconstructed, 0U);
  EXPECT_EQ(rows[1].kind, "ridge");
  EXPECT_EQ(rows[1].n_reconstructed, 1U);
  EXPECT_EQ(rows[2].kind, "all");
  EXPECT_EQ(rows[2].n_lines, 2U);
}

TEST(ReferenceTables, FigureThatDoesNotExistIsEmpty) {
  const std::vector<ReferenceRow> rows{
      {"1",
       "joint",
       compare_with_references({}, std::vector<ReferenceLine>{{kRidge, "ridge"}}),
       {}}};
  EXPECT_THAT(reference_errors_to_csv(rows),
              testing::HasSubstr("1,joint,total,0,0,,,,,,0,,,,0,,\n"));
  EXPECT_THAT(reference_completeness_to_csv(rows), testing::HasSubstr("1,joint,all,1,0,0.0000\n"));
}

}  // namespace
}  // namespace ridgeline::evaluate
