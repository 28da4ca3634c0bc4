// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/edges_of_no_data.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

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
  remove_edges_of_no_data(edges, is_valid);
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].in_image.start, beside.in_image.start);
  EXPECT_EQ(edges[1].in_image.start, towards.in_image.start);
  remove_edges_of_no_data(edges, {});
  EXPECT_EQ(edges.size(), 2U);
}

}  // namespace
}  // namespace ridgeline::reconstruct
