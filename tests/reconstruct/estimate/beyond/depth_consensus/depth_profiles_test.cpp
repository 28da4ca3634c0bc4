// SPDX-License-Identifier: BSD-3-Clause
// Aligned matches that show several lines: straight in both images, but not in space.
#include "reconstruct/estimate/beyond/depth_consensus/depth_profiles.h"

#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"

#include <gtest/gtest.h>

namespace ridgeline::reconstruct {
namespace {

using test::kDegree;
using test::LineGroup;
using test::segment_of;

constexpr double kProfileRecoveredM = 1e-6;
constexpr double kProfileAssumedM = 1e-3;  // horizontality is weighted, not forced
constexpr double kEaveM = 6.0, kRidgeM = 8.0;
constexpr double kLengthPx = 96.0;

const test::StereoScene kProfileScene;

/// What the left camera sees at a parameter of a segment along the epipolar line.
Eigen::Vector3d seen_at(double parameter, double z_m) {
  const Eigen::Vector2d centre = kProfileScene.left_centre();
  return kProfileScene.at_height(
      centre + (parameter - 0.5) * kLengthPx * kProfileScene.epipolar_direction(centre), z_m);
}

void add(LineGroup& group, const Segment3& line) {
  group.truth.push_back(line);
  const std::array<Segment2, 2> images = kProfileScene.images(line);
  for (std::size_t j = 0; j < 2; ++j) group.segments[j].push_back(test::exact(images[j], {}));
  const int i = static_cast<int>(group.matches.size());
  group.matches.push_back({i, i});
}

/// Adds a horizontal line that meets the first match at a point of it.
void add_meeting(LineGroup& group, const Eigen::Vector3d& x, double angle_deg) {
  const Eigen::Vector2d image = project(kProfileScene.cameras[0], x);
  const Eigen::Vector2d direction =
      Eigen::Rotation2Dd(angle_deg * kDegree) * kProfileScene.epipolar_direction(image);
  add(group, {x, kProfileScene.at_height(image + 80.0 * direction, x.z())});
  group.connections.push_back({0, static_cast<int>(group.matches.size()) - 1});
}

/// A group whose only match reaches from the first to the last end of these lines; `truth` holds
/// the lines.
LineGroup match_of(const std::vector<Segment3>& lines) {
  LineGroup group;
  add(group, {lines.front().start, lines.back().end});
  group.truth = lines;
  return group;
}

const std::vector<Segment3> kVerges{{seen_at(0.0, kEaveM), seen_at(0.5, kRidgeM)},
                                    {seen_at(0.5, kRidgeM), seen_at(1.0, kEaveM)}};

/// The verges of a dormer, of this length each in the left image.
std::vector<Segment3> short_verges(double each_px) {
  const double half = each_px / kLengthPx;
  const double ridge_m = kEaveM + each_px / 14.4;
  return {{seen_at(0.5 - half, kEaveM), seen_at(0.5, ridge_m)},
          {seen_at(0.5, ridge_m), seen_at(0.5 + half, kEaveM)}};
}

/// Both verges of a gable; its ridge and eaves meet them.
LineGroup gable(const std::vector<Segment3>& verges = kVerges) {
  LineGroup group = match_of(verges);
  add_meeting(group, verges[0].start, 80.0);
  add_meeting(group, verges[0].end, 85.0);
  add_meeting(group, verges[1].end, 90.0);
  return group;
}

double worst_error_m(const Segment3& truth, const ReconstructedLine& line) {
  return std::max((segment_of(line).start - truth.start).norm(),
                  (segment_of(line).end - truth.end).norm());
}

TEST(MatchOfSeveralLines, GivesBothVergesOfAGable) {
  const LineGroup group = gable();
  const std::vector<ReconstructedLine> lines = group.reconstruct(EstimationOptions{});
  ASSERT_EQ(lines.size(), group.matches.size() + 1);
  const Eigen::Vector2d top = project(kProfileScene.cameras[1], kVerges[0].end);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(lines[p].part, static_cast<int>(p) + 1);
    EXPECT_EQ(lines[p].base().segment, 0);
    EXPECT_STREQ(status_name(lines[p]), "joint");
    ASSERT_TRUE(lines[p].segment_in_local && lines[p].covariance_m2);
    EXPECT_LT(worst_error_m(kVerges[p], lines[p]), kProfileRecoveredM);
    const Segment2& right = lines[p].other().px;
    EXPECT_LT(((p == 0 ? right.end : right.start) - top).norm(), kProfileRecoveredM);
  }
  EXPECT_EQ(lines[2].part, 0);
  EXPECT_EQ(lines[2].base().segment, 1);
}

TEST(MatchOfSeveralLines, OneEaveIsEnoughForBothVerges) {
  LineGroup group = gable();
  group.connections.pop_back();
  const std::vector<ReconstructedLine> lines = group.reconstruct(EstimationOptions{});
  ASSERT_EQ(lines.size(), group.matches.size() + 1);
  EXPECT_STREQ(status_name(lines[1]), "segment_ends");
  for (std::size_t p = 0; p < 2; ++p)
    EXPECT_LT(worst_error_m(kVerges[p], lines[p]), kProfileRecoveredM);
}

TEST(MatchOfSeveralLines, GivesTheVergesOfADormerToo) {
  // the segment is too short for the steps of a row
  const std::vector<Segment3> verges = short_verges(14.4);
  const LineGroup group = gable(verges);
  const std::vector<ReconstructedLine> lines = group.reconstruct(EstimationOptions{});
  ASSERT_EQ(lines.size(), group.matches.size() + 1);
  for (std::size_t p = 0; p < 2; ++p)
    EXPECT_LT(worst_error_m(verges[p], lines[p]), kProfileRecoveredM);
}

TEST(MatchOfSeveralLines, DoesNotDependOnTheDirectionOfTheSegments) {
  LineGroup group = gable();
  Segment2& right = group.segments[1][0].segment;
  std::swap(right.start, right.end);
  const std::vector<ReconstructedLine> lines = group.reconstruct(EstimationOptions{});
  ASSERT_EQ(lines.size(), group.matches.size() + 1);
  for (std::size_t p = 0; p < 2; ++p)
    EXPECT_LT(worst_error_m(kVerges[p], lines[p]), kProfileRecoveredM);
}

TEST(MatchOfSeveralLines, GivesTheStepsOfARow) {
  const std::vector<Segment3> eaves{{seen_at(-0.5, 5.0), seen_at(0.17, 5.0)},
                                    {seen_at(0.17, 6.0), seen_at(0.83, 6.0)},
                                    {seen_at(0.83, 5.2), seen_at(1.5, 5.2)}};
  LineGroup group = match_of(eaves);
  add_meeting(group, eaves[0].start, 80.0);
  add_meeting(group, eaves[1].start, 85.0);  // the verges of the highest house hide the others'
  add_meeting(group, eaves[1].end, 85.0);
  add_meeting(group, eaves[2].end, 80.0);
  const std::vector<ReconstructedLine> lines = group.reconstruct(EstimationOptions{});
  ASSERT_EQ(lines.size(), group.matches.size() + 2);
  for (std::size_t p = 0; p < 3; ++p) {
    ASSERT_TRUE(lines[p].segment_in_local) << p;
    EXPECT_LT(worst_error_m(eaves[p], lines[p]), kProfileAssumedM) << p;
  }
}

TEST(MatchOfSeveralLines, AnEaveIsOneWhereverOthersMeetIt) {
  const Segment3 eave{seen_at(0.0, kEaveM), seen_at(1.0, kEaveM)};
  LineGroup group = match_of({eave});
  for (const double parameter : {0.0, 0.4, 1.0}) {
    add_meeting(group, seen_at(parameter, kEaveM), 80.0);
  }
  add_meeting(group, seen_at(0.5, 0.0), 70.0);  // a line of the ground that it hides
  const std::vector<ReconstructedLine> lines = group.reconstruct(EstimationOptions{});
  ASSERT_EQ(lines.size(), group.matches.size());
  EXPECT_EQ(lines[0].part, 0);
  EXPECT_LT(worst_error_m(eave, lines[0]), kProfileRecoveredM);
}

TEST(MatchOfSeveralLines, AsPublishedIsOneLine) {
  EstimationOptions direct;
  direct.lines.method = Method::kDirect;
  const LineGroup group = gable();
  EXPECT_EQ(group.reconstruct(direct).size(), group.matches.size());
  EXPECT_EQ(group.reconstruct(test::published()).size(), group.matches.size());
}

TEST(MatchOfSeveralLines, HasNoPartBelowSevenPixels) {
  const auto n_lines = [](double each_px) {
    return gable(short_verges(each_px)).reconstruct(EstimationOptions{}).size();
  };
  const std::size_t n_matches = gable().matches.size();
  EXPECT_EQ(n_lines(9.5), n_matches + 1);  // the second one is 7.2 px long in the right image
  EXPECT_EQ(n_lines(9.0), n_matches);      // 6.8 px
}

}  // namespace
}  // namespace ridgeline::reconstruct
