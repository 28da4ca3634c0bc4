// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/edges_of_no_data.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

EdgeSegment edge_at(const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
  EdgeSegment edge;
  edge.in_image = {start, end};
  return edge;
}

TEST(EdgesOfNoData, AreRemovedAndNoOthers) {
  cv::Mat is_valid(100, 100, CV_8UC1, cv::Scalar(255));
  is_valid.colRange(0, 30).setTo(0);
  const EdgeSegment border = edge_at({30.5, 10.0}, {30.5, 80.0});
  const EdgeSegment within = edge_at({10.0, 10.0}, {10.0, 80.0});
  const EdgeSegment beside = edge_at({40.0, 10.0}, {40.0, 80.0});
  const EdgeSegment towards = edge_at({31.0, 50.0}, {70.0, 50.0});
  std::vector<EdgeSegment> edges{border, beside, within, towards};
  remove_edges_of_no_data(edges, far_from_no_data(is_valid));
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].in_image.start, beside.in_image.start);
  EXPECT_EQ(edges[1].in_image.start, towards.in_image.start);
  remove_edges_of_no_data(edges, {});
  EXPECT_EQ(edges.size(), 2U);
}

/// A trace with a sample at each pixel of a row or column.
EdgeTrace trace_between(const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
  EdgeTrace trace;
  const int n = static_cast<int>(std::lround((end - start).norm()));
  for (int i = 0; i <= n; ++i)
    trace.push_back(
        {.position_px = start + double(i) / n * (end - start), .strength = 1.0, .step = i});
  return trace;
}

TEST(EdgesOnData, EndWhereTheStripsBesideThemReachPixelsWithoutData) {
  cv::Mat is_valid(100, 100, CV_8UC1, cv::Scalar(255));
  is_valid.colRange(0, 30).setTo(0);
  const EdgeTrace border = trace_between({31.0, 10.0}, {31.0, 80.0});
  const EdgeTrace beside = trace_between({36.0, 10.0}, {36.0, 80.0});
  const EdgeTrace towards = trace_between({10.0, 50.0}, {70.0, 50.0});
  const EdgeTrace little = trace_between({25.0, 60.0}, {40.0, 60.0});
  constexpr double kMinLength_px = 10.0;
  const std::vector<EdgeTrace> edges =
      edges_on_data({border, beside, towards, little}, far_from_no_data(is_valid), kMinLength_px);
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].size(), beside.size());
  EXPECT_EQ(edges[1].front().position_px, Eigen::Vector2d(36.0, 50.0));
  EXPECT_EQ(edges[1].back().position_px, Eigen::Vector2d(70.0, 50.0));
}

TEST(EdgesOnData, CrossASinglePixelWithoutData) {
  cv::Mat is_valid(100, 100, CV_8UC1, cv::Scalar(255));
  is_valid.at<std::uint8_t>(50, 50) = 0;
  const EdgeTrace edge = trace_between({10.0, 50.0}, {90.0, 50.0});
  const std::vector<EdgeTrace> edges = edges_on_data({edge}, far_from_no_data(is_valid), 10.0);
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_EQ(edges[0].size(), edge.size());
  EXPECT_EQ(edges_on_data({edge, edge}, {}, 1000.0).size(), 2U);
}

}  // namespace
}  // namespace ridgeline::reconstruct
