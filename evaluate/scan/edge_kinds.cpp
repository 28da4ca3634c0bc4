// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/edge_kinds.h"

#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

constexpr std::array kKindsInOrder{"ridge", "hip", "valley", "eave", "verge", "step"};
constexpr const char* kAllKinds = "total";

EdgesOfKind row_of(const std::string& kind, std::span<const ScanEdge> edges) {
  EdgesOfKind row{.kind = kind};
  std::vector<double> sigmas_m;
  for (const ScanEdge& edge : edges) {
    if (kind != kAllKinds && edge.kind != kind) continue;
    ++row.n;
    row.length_m += length(edge.segment);
    sigmas_m.push_back(across_sigma_m(edge));
  }
  if (sigmas_m.empty()) return row;
  const auto middle = sigmas_m.begin() + static_cast<std::ptrdiff_t>(sigmas_m.size() / 2);
  std::ranges::nth_element(sigmas_m, middle);
  row.median_sigma_m = *middle;
  return row;
}

}  // namespace

double across_sigma_m(const ScanEdge& edge) {
  Eigen::Matrix<double, 3, 6> middle_of_ends;
  middle_of_ends << 0.5 * Eigen::Matrix3d::Identity(), 0.5 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d covariance_m2 =
      middle_of_ends * edge.covariance_m2 * middle_of_ends.transpose();
  const Eigen::Vector3d u = (edge.segment.end - edge.segment.start).normalized();
  return std::sqrt(std::max(0.0, covariance_m2.trace() - u.dot(covariance_m2 * u)));
}

std::vector<EdgesOfKind> by_kind(std::span<const ScanEdge> edges) {
  std::vector<EdgesOfKind> rows =
      transformed(kKindsInOrder, [&](const char* kind) { return row_of(kind, edges); });
  rows.push_back(row_of(kAllKinds, edges));
  return rows;
}

}  // namespace ridgeline::evaluate
