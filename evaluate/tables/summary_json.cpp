// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/summary_json.h"

namespace ridgeline::evaluate {

std::string dump(const Json& json) {
  constexpr int kIndent = 2;
  return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json interval_json(const std::optional<Interval>& interval) {
  if (!interval) return nullptr;
  return Json::array({number_json(interval->low), number_json(interval->high)});
}

Json summary_json(const Summary& s) {
  Json excluded = Json::object();
  for (std::size_t i = 0; i < s.n_by_status.size(); ++i) {
    const auto status = static_cast<Status>(i);
    if (status != Status::kEvaluated && s.n_by_status[i] > 0) {
      excluded[name(status)] = s.n_by_status[i];
    }
  }
  return Json{
      {"n_lines", s.n_lines},
      {"n_evaluated", s.n_evaluated},
      {"n_excluded", std::move(excluded)},
      {"evaluated_share", number_json(s.evaluated_share())},
      {"evaluated_share_by_length", number_json(s.evaluated_share_by_length())},
      {"length_m", number_json(s.length_m)},
      {"rms_m", number_json(s.rms_m)},
      {"ci95_m", interval_json(s.ci95_m)},
      {"n_clusters", s.n_clusters},
      {"few_clusters", s.few_clusters()},
      {"ci95_chi_square_m", interval_json(s.ci95_chi_square_m)},
      {"rms_length_weighted_m", number_json(s.rms_length_weighted_m)},
      {"mean_m", number_json(s.mean_m)},
      {"std_m", number_json(s.std_m)},
      {"rms_signed_m", number_json(s.rms_signed_m)},
      {"median_m", number_json(s.median_m)},
      {"median_signed_m", number_json(s.median_signed_m)},
      {"nmad_m", number_json(s.nmad_m)},
      {"q683_m", number_json(s.q683_m)},
      {"q90_m", number_json(s.q90_m)},
      {"q95_m", number_json(s.q95_m)},
      {"max_m", number_json(s.max_m)},
      {"max_id", s.max_id},
      {"gross_share", number_json(s.gross_share)},
      {"n_outliers", s.n_outliers},
      {"rms_without_outliers_m", number_json(s.rms_without_outliers_m)},
      {"n_half_of_squares", s.n_half_of_squares},
      {"rms_without_half_m", number_json(s.rms_without_half_m)},
      {"n_parts", s.n_parts},
      {"rmse_horizontal_m", number_json(s.rmse_horizontal_m)},
      {"rmse_vertical_m", number_json(s.rmse_vertical_m)},
      {"mean_vertical_m", number_json(s.mean_vertical_m)},
  };
}

Json class_json(const Summary& summary) {
  Json json = summary_json(summary);
  for (const DecidedGroup group : kDecidedGroups) {
    json["decided_by"][name(group)] = summary_json(summary.of_group(group));
  }
  return json;
}

}  // namespace ridgeline::evaluate
