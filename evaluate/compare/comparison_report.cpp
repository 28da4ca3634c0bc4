// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/comparison.h"
#include "evaluate/compare/pair_in_space.h"
#include "evaluate/tables/cells.h"
#include "evaluate/tables/format.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/table2.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>

namespace ridgeline::evaluate {
namespace {

std::string p_text(std::optional<double> p) {
  if (!p) return std::string(kNoValue);
  return *p < 0.001 ? "< 0.001" : fixed(p, 3);
}

PrintedTable common_table(const Comparison& c) {
  PrintedTable table({"class"},
                     {{"n:", "RMS A:", "RMS B:", "B / A:", "95 %:", "A - B:", "95 %:"},
                      {"median A - B:", "Wilcoxon p:", "B improved:", "unchanged:", "worse:"}});
  for (const PairedSummary& s : c.classes) {
    table.add(s.line_class, s.n, metres(s.rms_a_m), metres(s.rms_b_m), fixed(s.rms_ratio, 3),
              interval_text(s.rms_ratio_ci95), metres(s.rms_gain_m), interval_text(s.rms_gain_ci95),
              metres(s.median_gain_m), p_text(s.wilcoxon_p), s.n_improved, s.n_unchanged,
              s.n_worse);
  }
  return table;
}

PrintedTable own_table(const Comparison& c) {
  PrintedTable table({"class", "RMS A (evaluated/all):", "RMS B (evaluated/all):"});
  const std::vector<Summary>& longer = c.own_a.size() >= c.own_b.size() ? c.own_a : c.own_b;
  for (const Summary& s : longer) {
    table.add(s.line_class, rms_text(find_class(c.own_a, s.line_class)),
              rms_text(find_class(c.own_b, s.line_class)));
  }
  return table;
}

PrintedTable alone_table(const Comparison& c) {
  std::vector<std::string> columns{"only in"};
  for (const double upto_m : kAloneUpTo_m) columns.push_back(fmt::format("up to {} m:", upto_m));
  columns.emplace_back("above:");
  PrintedTable table(columns);
  for (const auto& [name, counts] : {std::pair("A", c.only_a), std::pair("B", c.only_b)}) {
    table.add(name, counts[0], counts[1], counts[2], counts[3], counts[4]);
  }
  return table;
}

PrintedTable worst_table(const Comparison& c) {
  PrintedTable table({"id", "class", "A:", "B:", "A - B:"});
  for (const PairedLine& l : c.worst) {
    table.add(l.id, l.line_class, metres(l.a_m), metres(l.b_m), metres(l.gain_m()));
  }
  return table;
}

std::string heading(const Comparison& c, Markup markup) {
  return fmt::format("{}Patch {}: A = {}, B = {}\n\n", markup == Markup::kMarkdown ? "## " : "",
                     in_sentence(c.patch, markup), in_sentence(c.name_a, markup),
                     in_sentence(c.name_b, markup));
}

std::string comparison_text(const Comparison& c, Markup markup) {
  std::string text = heading(c, markup);
  text += captioned("Each on its own lines:", own_table(c), markup) + "\n";
  if (c.in_space) {
    std::string how;
    if (c.n_views_a && c.n_views_b)
      how = fmt::format("A used {} images, B used {}. ", *c.n_views_a, *c.n_views_b);
    how += fmt::format(
        "Lines are paired one to one with the smallest sum of distances: at most {} m and {} "
        "degrees apart, overlapping by half of the shorter one.",
        kMaxPairDistance_m, kMaxPairAngle_deg);
    text += paragraph(how, markup) + "\n";
  }
  text += fmt::format("Lines evaluated in both {}, only in A {}, only in B {}. Metres.\n\n",
                      c.n_common, c.n_only_a, c.n_only_b);
  text += captioned("On the common lines:", common_table(c), markup);
  const std::size_t n_clusters = c.classes.back().n_clusters;
  if (n_clusters < kMinClusters) {
    text += fmt::format("\nToo few clusters ({}) for reliable intervals.\n", n_clusters);
  }
  if (c.n_only_a + c.n_only_b > 0) {
    text += "\n" + captioned("Unpaired lines, by distance:", alone_table(c), markup);
  }
  const PrintedTable worst = worst_table(c);
  if (!worst.empty()) {
    text += "\n" + captioned("Lines with the largest increase from A to B:", worst, markup);
  }
  if (c.n_not_aligned_differing.value_or(0) > 0) {
    text += "\n" + paragraph(fmt::format(
                                 "Warning: direct and joint differ on {} not_aligned lines, "
                                 "although both use the same code for them: a defect of ridgeline.",
                                 *c.n_not_aligned_differing),
                             markup);
  }
  return text + "\n";
}

std::string report_text(const ComparisonReport& report, Markup markup) {
  std::string text;
  for (const Comparison& c : report.comparisons) text += comparison_text(c, markup);
  for (const std::string& w : report.warnings) {
    text += paragraph("Warning: " + in_sentence(w, markup), markup) + "\n";
  }
  return text + paragraph(kFixedSentence, markup);
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
          {"in_space", c.in_space},
          {"n_views_a", c.n_views_a ? Json(*c.n_views_a) : Json(nullptr)},
          {"n_views_b", c.n_views_b ? Json(*c.n_views_b) : Json(nullptr)},
          {"n_common", c.n_common},
          {"n_only_a", c.n_only_a},
          {"n_only_b", c.n_only_b},
          {"only_up_to_m", kAloneUpTo_m},
          {"only_a_by_distance", c.only_a},
          {"only_b_by_distance", c.only_b},
          {"common", std::move(common)},
          {"own_a", own_json(c.own_a)},
          {"own_b", own_json(c.own_b)},
          {"worst", std::move(worst)},
          {"n_not_aligned_differing",
           c.n_not_aligned_differing ? Json(*c.n_not_aligned_differing) : Json(nullptr)}};
}

}  // namespace

std::string to_markdown(const ComparisonReport& report) {
  return report_text(report, Markup::kMarkdown);
}

std::string to_terminal(const ComparisonReport& report) {
  return report_text(report, Markup::kPlain);
}

std::string to_json(const ComparisonReport& report) {
  Json comparisons = Json::array();
  for (const Comparison& c : report.comparisons) comparisons.push_back(comparison_json(c));
  return dump(Json{{"comparisons", std::move(comparisons)},
                   {"warnings", report.warnings},
                   {"note", kFixedSentence}});
}

}  // namespace ridgeline::evaluate
