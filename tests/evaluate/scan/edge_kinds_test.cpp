// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/edge_kinds.h"

#include <gtest/gtest.h>

namespace ridgeline::evaluate {
namespace {

ScanEdge edge_of(const std::string& kind, double length_m, double across_m) {
  ScanEdge edge{.segment = {{0.0, 0.0, 0.0}, {length_m, 0.0, 0.0}}, .kind = kind, .planes = {}};
  // fully correlated ends: the middle has the same variance; along x it must not count
  Eigen::Matrix3d end_m2 = Eigen::Matrix3d::Zero();
  end_m2.diagonal() << 1.0, 0.5 * across_m * across_m, 0.5 * across_m * across_m;
  edge.covariance_m2 << end_m2, end_m2, end_m2, end_m2;
  return edge;
}

TEST(AcrossSigma, IgnoresTheDirectionOfTheEdge) {
  EXPECT_NEAR(across_sigma_m(edge_of("eave", 4.0, 0.03)), 0.03, 1e-12);
}

TEST(ByKind, CountsEveryKindAndTheTotal) {
  const std::vector<ScanEdge> edges{edge_of("eave", 4.0, 0.01), edge_of("eave", 6.0, 0.02),
                                    edge_of("eave", 1.0, 0.09), edge_of("ridge", 5.0, 0.03)};
  const std::vector<EdgesOfKind> rows = by_kind(edges);
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(rows[0].kind, "ridge");
  EXPECT_EQ(rows[0].n, 1U);
  EXPECT_EQ(rows[1].n, 0U);  // hip
  EXPECT_EQ(rows[3].kind, "eave");
  EXPECT_EQ(rows[3].n, 3U);
  EXPECT_NEAR(rows[3].length_m, 11.0, 1e-12);
  EXPECT_NEAR(rows[3].median_sigma_m, 0.02, 1e-12);
  EXPECT_EQ(rows[6].kind, "total");
  EXPECT_EQ(rows[6].n, 4U);
}

}  // namespace
}  // namespace ridgeline::evaluate
