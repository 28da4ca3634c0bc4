// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/completeness_table.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr const char* kEdgesNote =
    "Edges of roofs in the LIDAR cloud, at least 2 m long and with points along 80 %. An edge is "
    "found if lines within 0.3 m and 5 degrees of it cover half of its length together. Not all "
    "edges of a scan are right, so perfect lines do not reach 100 %.";

bool has_completeness(const Evaluation& evaluation) { return evaluation.completeness.has_value(); }

std::string interval_cell(const std::optional<Interval>& interval) {
  if (!interval) return std::string(kNoValue);
  return fmt::format("{} - {}", percent(interval->low), percent(interval->high));
}

std::string recall_cell(const Completeness& completeness,
                        const std::string& kind,
                        const char* length) {
  const CompletenessRow* row = find_row(completeness, kind, length);
  return percent(row != nullptr ? row->recall() : std::nullopt);
}

std::string area_words(const std::string& area_from) {
  if (area_from == "stated") return "the given area";
  if (area_from == "images") return "the ground that the first image shows";
  if (area_from == "block") return "the area of the block";
  return "the convex hull of the judged lines, 5 m wider";
}

/// "area: ..., 1.25 ha; 12 of 80 lines follow no edge of the scan; ...".
std::string facts_of(const Completeness& c) {
  constexpr double kM2PerHa = 1e4;
  std::string text = fmt::format(
      "Area: {}, {} ha. {} of {} lines follow no edge of the scan; they may be right "
      "(markings, shadows).",
      area_words(c.area_from), fixed(c.area_m2 / kM2PerHa, 2), c.n_without_edge, c.n_lines);
  const CompletenessRow* all = find_row(c, "all");
  if (all != nullptr && all->n_not_shown > 0) {
    text += fmt::format(" {} further edges are shown in fewer than two images and do not count.",
                        all->n_not_shown);
  }
  if (all == nullptr) text += " The scan has no such edges there.";
  return text;
}

}  // namespace

std::string completeness_to_terminal(std::span<const Evaluation> evaluations) {
  if (std::ranges::none_of(evaluations, has_completeness)) return "";
  PrintedTable table({"patch", "method", "edges", "in the scan:", "found %:", "95 % interval:",
                      "of the length %:", "2-4 m %:", "4-8 m %:", "above 8 m %:"});
  std::string facts;
  for (const Evaluation& e : evaluations) {
    if (!e.completeness) continue;
    for (const CompletenessRow& row : e.completeness->rows) {
      if (row.length != "all") continue;
      table.add(e.patch, e.method, row.kind, row.n, percent(row.recall()), interval_cell(row.ci95),
                percent(row.recall_by_length()), recall_cell(*e.completeness, row.kind, "2-4"),
                recall_cell(*e.completeness, row.kind, "4-8"),
                recall_cell(*e.completeness, row.kind, "8+"));
    }
    facts +=
        paragraph(fmt::format("{}, {}. {}", in_sentence(e.patch, Markup::kPlain),
                              in_sentence(e.method, Markup::kPlain), facts_of(*e.completeness)),
                  Markup::kPlain);
  }
  return captioned("Edges of the scan that the lines have found", table, Markup::kPlain) + facts +
         paragraph(kEdgesNote, Markup::kPlain);
}

std::string completeness_to_markdown(const Evaluation& evaluation) {
  if (!has_completeness(evaluation)) return "";
  PrintedTable table({"edges of the scan", "length m:", "edges:", "found:", "found %:",
                      "95 % interval:", "clusters:", "of the length %:"});
  for (const CompletenessRow& row : evaluation.completeness->rows) {
    table.add(row.kind, row.length, row.n, row.n_found, percent(row.recall()),
              interval_cell(row.ci95), row.n_clusters, percent(row.recall_by_length()));
  }
  return "\n" + table.text(Markup::kMarkdown) + "\n" + facts_of(*evaluation.completeness) + " " +
         kEdgesNote + "\n";
}

std::string completeness_to_csv(std::span<const Evaluation> evaluations) {
  std::string text =
      "patch,method,kind,length,n,n_found,recall,ci95_low,ci95_high,n_clusters,length_m,covered_m,"
      "recall_length,n_not_in_images,n_lines,n_lines_without_edge,area_from,area_m2\n";
  const auto share = [](std::optional<double> value) {
    constexpr int kShareDecimals = 6;
    return fixed(value, kShareDecimals, "");
  };
  for (const Evaluation& e : evaluations) {
    if (!e.completeness) continue;
    const Completeness& c = *e.completeness;
    for (const CompletenessRow& row : c.rows) {
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", escape_csv(e.patch),
          escape_csv(e.method), row.kind, row.length, row.n, row.n_found, share(row.recall()),
          share(row.ci95 ? std::optional(row.ci95->low) : std::nullopt),
          share(row.ci95 ? std::optional(row.ci95->high) : std::nullopt), row.n_clusters,
          metres(row.length_m), metres(row.covered_m), share(row.recall_by_length()),
          row.n_not_shown, c.n_lines, c.n_without_edge, c.area_from, fixed(c.area_m2, 1));
    }
  }
  return text;
}

}  // namespace ridgeline::evaluate
