// SPDX-License-Identifier: BSD-3-Clause
// A cloud of PCL -> the edges of its roofs.
#include "evaluate/scan/roof_edge_extraction.h"

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// A gabled roof whose ridge runs along y, on level ground.
Cloud::Ptr house() {
  auto cloud = std::make_shared<Cloud>();
  for (float x = -15.0F; x <= 15.0F; x += 0.4F) {
    for (float y = -15.0F; y <= 15.0F; y += 0.4F) {
      const bool on_roof = std::abs(x) <= 6.0F && std::abs(y) <= 10.0F;
      cloud->emplace_back(x, y, on_roof ? 8.0F - 0.5F * std::abs(x) : 0.0F);
    }
  }
  return cloud;
}

}  // namespace

int main() {
  try {
    ridgeline::evaluate::RoofEdgeExtraction<pcl::PointXYZ> extraction;
    extraction.setInputCloud(house());
    extraction.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
    const ridgeline::evaluate::ScanEdges found = extraction.compute();
    bool has_ridge = false;
    for (const ridgeline::evaluate::ScanEdge& edge : found.edges) {
      const ridgeline::Segment3& s = edge.segment;
      std::printf("%-6s %6.2f %6.2f %6.2f  %6.2f %6.2f %6.2f\n", edge.kind.c_str(), s.start.x(),
                  s.start.y(), s.start.z(), s.end.x(), s.end.y(), s.end.z());
      constexpr double kTol_m = 0.01;
      has_ridge = has_ridge || (edge.kind == "ridge" && std::abs(s.start.x()) < kTol_m &&
                                std::abs(s.start.z() - 8.0) < kTol_m);
    }
    return has_ridge ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
