// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/evaluation.h"
#include "evaluate/statistics/summary.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// One RMS in three interpretations; never printed without its label.
struct AccuracyNumbers {
  std::optional<double> observed_m;  ///< relative to the planes: the value in the published table
  /// sqrt(observed^2 + sigma_ref^2): relative to the true datum, as required by ASPRS Edition 2.
  std::optional<double> product_m;
  /// sqrt(observed^2 - sigma_ref^2): of the method only; empty if below_reference_noise.
  std::optional<double> method_only_m;
  double sigma_ref_m = 0.0;
  bool below_reference_noise = false;  ///< observed < sigma_ref, so method_only_m is unknown
};

/// The three interpretations of an observed RMS.
/// Throws std::invalid_argument for a negative observed RMS or sigma_ref.
AccuracyNumbers accuracy_numbers(std::optional<double> observed_m, double sigma_ref_m);

/// The qualifications of the accuracy of a class.
struct AccuracyStatement {
  std::string line_class;
  std::size_t n = 0;
  AccuracyNumbers numbers;
  std::size_t n_half_of_squares = 0;         ///< see Summary
  std::optional<double> rms_without_half_m;  ///< see Summary
  bool biased = false;        ///< |mean| above 25 % of the RMS, both of the signed distances
  bool few_samples = false;   ///< n < 30, the minimum that ASPRS Edition 2 accepts
  bool few_clusters = false;  ///< fewer than kMinClusters: the interval is unreliable
  /// Share of the evaluated lines that extend more than 0.5 m beyond the hull of a plane's inliers,
  /// where the plane's variance grows quadratically.
  double extrapolated_share = 0.0;
  bool extrapolated = false;  ///< extrapolated_share above 5 %

  [[nodiscard]] std::vector<std::string> flags() const;  ///< bias, n_below_30, few_clusters, ...
};

/// One statement per class of the evaluation. sigma_ref^2 = sigma_sys^2 + mean sigma_plane^2: the
/// random part averages down over a plane's inliers, the systematic part does not. The random part
/// is optimistic, because neighbouring scan points are correlated.
std::vector<AccuracyStatement> accuracy_statements(const Evaluation& evaluation);

}  // namespace ridgeline::evaluate
