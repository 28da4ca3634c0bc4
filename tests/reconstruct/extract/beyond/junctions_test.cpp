// SPDX-License-Identifier: BSD-3-Clause
// Edges along x and others that end on them.
#include "reconstruct/extract/beyond/junctions.h"

#include "reconstruct/extract/beyond/extensions.h"
#include "reconstruct/scene/normalised_image.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

using testing::ElementsAre;

constexpr double kEdgeNoisePx = 0.05;  // noise of edge pixels in an aerial image
constexpr int kLength = 120;
constexpr int kRidgeAt = 60;

EdgeTrace trace_of(const std::vector<Eigen::Vector2d>& points) {
  EdgeTrace trace;
  for (const Eigen::Vector2d& x : points) {
    trace.push_back({x, 1.0, static_cast<int>(std::lround(x.x()))});
  }
  return trace;
}

/// An edge along x from 0 to kLength, displaced by `across`.
template <typename Across>
EdgeTrace trace_across(Across across) {
  test::Random random(3);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < kLength; ++i) points.emplace_back(i, across(i) + random.normal(kEdgeNoisePx));
  return trace_of(points);
}

/// An edge of 30 px across that ends `gap` px before the first one.
EdgeTrace stem(double at, double gap = 1.5) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 30; ++i) points.emplace_back(at, gap + i);
  return trace_of(points);
}

double gable_px(int i) { return 0.005 * (kRidgeAt - std::abs(i - kRidgeAt)); }

/// Where the parts of an edge along x begin.
std::vector<double> begins(const std::vector<EdgeTrace>& edges) {
  std::vector<double> x;
  for (const EdgeTrace& e : edges) {
    const Eigen::Vector2d along = e.back().position_px - e.front().position_px;
    if (std::abs(along.x()) > std::abs(along.y())) x.push_back(e.front().position_px.x());
  }
  return x;
}

TEST(CutAtJunctions, TheVergesOfAGableApartBelowItsRidge) {
  // 0.3 px at the ridge: 2.5 m of height, a degree off the nadir, at 8 cm
  const auto cut = cut_at_junctions({trace_across(gable_px), stem(kRidgeAt)}, {});
  EXPECT_EQ(cut.size(), 3U);
  EXPECT_THAT(begins(cut), ElementsAre(0.0, kRidgeAt));
}

TEST(CutAtJunctions, WhereAStripInterruptsTheEdge) {
  EdgeTrace interrupted = trace_across(gable_px);
  auto& trace = interrupted;
  trace.erase(trace.begin() + kRidgeAt - 2, trace.begin() + kRidgeAt + 2);
  EXPECT_THAT(begins(cut_at_junctions({interrupted}, {})), ElementsAre(0.0, kRidgeAt + 2.0));
  // the edge is as straight as it would be without the strip
  EdgeTrace straight = trace_across([](int) { return 0.0; });
  straight.erase(straight.begin() + kRidgeAt - 2, straight.begin() + kRidgeAt + 2);
  EXPECT_THAT(begins(cut_at_junctions({straight}, {})), ElementsAre(0.0));
}

TEST(CutAtJunctions, NotWhereNoEdgeEnds) {
  EXPECT_THAT(begins(cut_at_junctions({trace_across(gable_px)}, {})), ElementsAre(0.0));
  EXPECT_THAT(begins(cut_at_junctions({trace_across(gable_px), stem(kRidgeAt, 8.0)}, {})),
              ElementsAre(0.0));
}

TEST(CutAtJunctions, NotAStraightEdge) {
  const auto cut = cut_at_junctions(
      {trace_across([](int) { return 0.0; }), stem(30), stem(kRidgeAt), stem(90)}, {});
  EXPECT_THAT(begins(cut), ElementsAre(0.0));
}

TEST(CutAtJunctions, EveryEaveOfATerraceThatStepsDownASlope) {
  // one line fits this staircase better than two do
  const auto terrace = [](int i) { return 0.35 * std::floor(i / 30.0); };
  const auto cut = cut_at_junctions({trace_across(terrace), stem(30), stem(60), stem(90)}, {});
  EXPECT_THAT(begins(cut), ElementsAre(0.0, 30.0, 60.0, 90.0));
}

TEST(CutAtJunctions, AtTheOneOfTwoCloseJunctionsWhereTheEdgeStepsAside) {
  // the corner of a patio ends 12 px from the party wall of two eaves
  const auto eaves = [](int i) { return i < kRidgeAt ? 0.0 : 0.8; };
  EXPECT_THAT(
      begins(cut_at_junctions({trace_across(eaves), stem(kRidgeAt - 12), stem(kRidgeAt)}, {})),
      ElementsAre(0.0, kRidgeAt));
  EXPECT_THAT(
      begins(cut_at_junctions({trace_across(eaves), stem(kRidgeAt), stem(kRidgeAt + 12)}, {})),
      ElementsAre(0.0, kRidgeAt));
}

TEST(CutAtJunctions, NotAtAnEdgeThatRunsAlong) {
  EdgeTrace beside = trace_across([](int) { return 2.0; });
  beside.erase(beside.begin(), beside.begin() + kRidgeAt);
  const auto cut = cut_at_junctions({trace_across(gable_px), beside}, {});
  EXPECT_EQ(cut.size(), 2U);
}

TEST(CutAtJunctions, PartsKeepTheLeastLengthAndEverySample) {
  const auto step = [](int i) { return i < 5 ? 2.0 : 0.0; };
  const auto cut = cut_at_junctions({trace_across(step), stem(5), stem(kLength - 4)}, {});
  EXPECT_THAT(begins(cut), ElementsAre(0.0));
  std::size_t n = 0;
  for (const EdgeTrace& e : cut_at_junctions({trace_across(gable_px), stem(kRidgeAt)}, {})) {
    n += e.size();
  }
  EXPECT_EQ(n, static_cast<std::size_t>(kLength) + 30U);
}

/// Four roofs, each with an eave above and below two verges that rise by 0.3 px to the ridge, on
/// both sides of which the roof has other colours, if there is a ridge.
cv::Mat gables(bool with_ridge) {
  constexpr double kBlurPx = 0.8;
  const auto below = [](double x) { return test::normal_below(x / kBlurPx); };
  cv::Mat raw(160, 160, CV_8UC1);
  for (int y = 0; y < raw.rows; ++y) {
    for (int x = 0; x < raw.cols; ++x) {
      const double verge_px = 80.0 - 0.3 * (1.0 - std::abs(x - 80.0) / 60.0);
      const double roof =
          below(x - 20.0) * below(140.0 - x) * below(y - 20.0) * below(verge_px - y);
      const double colour = 70.0 + (with_ridge ? 30.0 * below(x - 80.0) : 0.0);
      raw.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(90.0 + roof * colour);
    }
  }
  return cv::repeat(raw, 2, 2);
}

std::size_t n_along_x(const std::vector<EdgeSegment>& segments) {
  return static_cast<std::size_t>(
      std::count_if(segments.begin(), segments.end(), [](const EdgeSegment& s) {
        const Eigen::Vector2d along = s.in_image.end - s.in_image.start;
        return std::abs(along.x()) > std::abs(along.y());
      }));
}

std::vector<EdgeSegment> extracted(const cv::Mat& raw) {
  EdgeExtensionOptions beyond;
  beyond.separate_edges = false;
  return extract_segments(normalised_image(raw), {}, {}, edge_refinement({{}, beyond}));
}

TEST(CutAtJunctions, MakesTwoSegmentsOfTheVergesOfAGable) {
  EXPECT_EQ(n_along_x(extracted(gables(true))), 4U * 3U);
  EXPECT_EQ(n_along_x(extracted(gables(false))), 4U * 2U);
}

}  // namespace
}  // namespace ridgeline::reconstruct
