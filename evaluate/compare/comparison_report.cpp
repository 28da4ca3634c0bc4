// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/comparison.h"
#include "evaluate/tables/cells.h"
#include "evaluate/tables/format.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/table2.h"

#include <fmt/format.h>

namespace ridgeline::evaluate {
namespace {

std::string p_text(std::optional<double> p) {
  if (!p) return std::string(kNoValue);
  return *p < 0.001 ? "< 0.001" : fixed(p, 3);
}

std::string common_table(const Comparison& c) {
  std::string text =
      markdown_head({"class", "n:", "RMS A:", "RMS B:", "B / A:", "95 %:", "A - B:", "95 %:",
                     "median A - B:", "Wilcoxon p:", "B improved:", "unchanged:", "worse:"});
  for (const PairedSummary& s : c.classes) {
    text += markdown_row(
        s.line_class, s.n, metres(s.rms_a_m), metres(s.rms_b_m), fixed(s.rms_ratio, 3),
        interval_text(s.rms_ratio_ci95), metres(s.rms_gain_m), interval_text(s.rms_gain_ci95),
        metres(s.median_gain_m), p_text(s.wilcoxon_p), s.n_improved, s.n_unchanged, s.n_worse);
  }
  if (c.classes.back().n_clusters < kMinClusters) {
    text += fmt::format("\nToo few clusters ({}) for reliable intervals.\n",
                        c.classes.back().n_clusters);
  }
  return text;
}

std::string own_table(const Comparison& c) {
  std::string text = markdown_head({"class", "RMS A (evaluated/all):", "RMS B (evaluated/all):"});
  const std::vector<Summary>& longer = c.own_a.size() >= c.own_b.size() ? c.own_a : c.own_b;
  for (const Summary& s : longer) {
    text += markdown_row(s.line_class, rms_text(find_class(c.own_a, s.line_class)),
                         rms_text(find_class(c.own_b, s.line_class)));
  }
  return text;
}

std::string worst_table(const Comparison& c) {
  if (c.worst.empty()) return "";
  std::string text = "\nLines that lost most from A to B:\n\n" +
                     markdown_head({"id", "class", "A:", "B:", "A - B:"});
  for (const PairedLine& l : c.worst) {
    text += markdown_row(escape_markdown(l.id), escape_markdown(l.line_class), metres(l.a_m),
                         metres(l.b_m), metres(l.gain_m()));
  }
  return text;
}

std::string comparison_markdown(const Comparison& c) {
  std::string text = fmt::format(
      "## Patch {}: A = {}, B = {}\n\nLines evaluated in both {}, only in A {}, only in B {}. "
      "Metres.\n\nOn the common lines:\n\n{}\nEach on its own lines:\n\n{}{}\n",
      escape_markdown(c.patch), escape_markdown(c.name_a), escape_markdown(c.name_b), c.n_common,
      c.n_only_a, c.n_only_b, common_table(c), own_table(c), worst_table(c));
  if (c.n_not_aligned_differing.value_or(0) > 0) {
    text += fmt::format(
        "Warning: direct and joint differ on {} not_aligned lines, which both solve by the same "
        "code: a defect of the tool.\n\n",
        *c.n_not_aligned_differing);
  }
  return text;
}

Json paired_json(const PairedSummary& s) {
  return {{"class", s.line_class},
          {"n", s.n},
          {"n_clusters", s.n_clusters},
          {"rms_a_m", number_json(s.rms_a_m)},
          {"rms_b_m", number_json(s.rms_b_m)},
          {"rms_ratio", number_json(s.rms_ratio)},
          {"rms_ratio_ci95", interval_json(s.rms_ratio_ci95)},
          {"rms_gain_m", number_json(s.rms_gain_m)},
          {"rms_gain_ci95_m", interval_json(s.rms_gain_ci95)},
          {"median_gain_m", number_json(s.median_gain_m)},
          {"wilcoxon_p", number_json(s.wilcoxon_p)},
          {"n_improved", s.n_improved},
          {"n_unchanged", s.n_unchanged},
          {"n_worse", s.n_worse}};
}

Json own_json(const std::vector<Summary>& summaries) {
  Json json = Json::object();
  for (const Summary& s : summaries) json[s.line_class] = summary_json(s);
  return json;
}

Json comparison_json(const Comparison& c) {
  Json common = Json::array();
  for (const PairedSummary& s : c.classes) common.push_back(paired_json(s));
  Json worst = Json::array();
  for (const PairedLine& l : c.worst) {
    worst.push_back({{"id", l.id}, {"class", l.line_class}, {"a_m", l.a_m}, {"b_m", l.b_m}});
  }
  return {{"patch", c.patch},
          {"a", c.name_a},
          {"b", c.name_b},
          {"n_common", c.n_common},
          {"n_only_a", c.n_only_a},
          {"n_only_b", c.n_only_b},
          {"common", std::move(common)},
          {"own_a", own_json(c.own_a)},
          {"own_b", own_json(c.own_b)},
          {"worst", std::move(worst)},
          {"n_not_aligned_differing",
           c.n_not_aligned_differing ? Json(*c.n_not_aligned_differing) : Json(nullptr)}};
}

}  // namespace

std::string to_markdown(const ComparisonReport& report) {
  std::string text;
  for (const Comparison& c : report.comparisons) text += comparison_markdown(c);
  for (const std::string& w : report.warnings) text += "Warning: " + escape_markdown(w) + "\n\n";
  return text + std::string(kFixedSentence) + "\n";
}

std::string to_json(const ComparisonReport& report) {
  Json comparisons = Json::array();
  for (const Comparison& c : report.comparisons) comparisons.push_back(comparison_json(c));
  return dump(Json{{"comparisons", std::move(comparisons)},
                   {"warnings", report.warnings},
                   {"note", kFixedSentence}});
}

}  // namespace ridgeline::evaluate
