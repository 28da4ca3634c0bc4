// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/matcher_table.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ridgeline::evaluate {
namespace {

constexpr const char* kAllPatches = "all";

std::optional<double> share(double part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return part / static_cast<double>(whole);
}

std::optional<double> rms(double sum_squares, std::size_t n) {
  const auto mean = share(sum_squares, n);
  return mean ? std::optional(std::sqrt(*mean)) : std::nullopt;
}

/// The rows and, for several patches, the sums of each run over all patches.
std::vector<MatcherFigures> with_pooled(std::span<const MatcherFigures> rows) {
  std::vector<MatcherFigures> all(rows.begin(), rows.end());
  const bool several = std::any_of(rows.begin(), rows.end(), [&](const MatcherFigures& row) {
    return row.patch != rows.front().patch;
  });
  if (!several) return all;
  const std::size_t n_rows = all.size();
  for (const MatcherFigures& row : rows) {
    const auto pooled = std::find_if(all.begin() + static_cast<std::ptrdiff_t>(n_rows), all.end(),
                                     [&](const MatcherFigures& one) { return one.run == row.run; });
    if (pooled != all.end()) {
      *pooled += row;
    } else {
      all.push_back(row);
      all.back().patch = kAllPatches;
    }
  }
  return all;
}

/// The figures of Table 1, then the matches that only one run finds, accuracy and coverage.
PrintedTable table_of(std::span<const MatcherFigures> rows) {
  PrintedTable table({"patch", "run", "matcher"},
                     {{"matches:", "correct:", "false:", "missed:", "correctness %:",
                       "completeness %:", "quality %:"},
                      {"alone:", "alone, false:", "LIDAR RMS (n):", "true RMS (n):", "gross %:",
                       "roof found %:"}});
  for (const MatcherFigures& row : with_pooled(rows)) {
    const MatchQuality quality = match_quality(row.counts);
    table.add(row.patch, row.run, row.matcher, row.n_matches, row.counts.n_correct,
              row.counts.n_false, row.counts.n_missed, percent(quality.correctness),
              percent(quality.completeness), percent(quality.quality), row.n_alone,
              row.n_alone_false,
              fmt::format("{} ({}/{})", metres(rms(row.sum_squares_m2, row.n_evaluated)),
                          row.n_evaluated, row.n_lines),
              fmt::format("{} ({})", metres(rms(row.true_sum_squares_m2, row.n_true)), row.n_true),
              percent(share(row.n_true_gross, row.n_true)),
              percent(share(static_cast<double>(row.n_roof_lines_found), row.n_roof_lines)));
  }
  return table;
}

std::string text_of(std::span<const MatcherFigures> rows, Markup markup) {
  return table_of(rows).text(markup) + "\n" +
         paragraph(
             "Alone: matches found by no other run (with reference matches, only the correct "
             "ones). Lines of the last method; n: judged of all lines, and lines on a true line.",
             markup);
}

}  // namespace

MatcherFigures& MatcherFigures::operator+=(const MatcherFigures& other) {
  counts.n_correct += other.counts.n_correct;
  counts.n_false += other.counts.n_false;
  counts.n_missed += other.counts.n_missed;
  n_matches += other.n_matches;
  n_alone += other.n_alone;
  n_alone_false += other.n_alone_false;
  n_lines += other.n_lines;
  n_evaluated += other.n_evaluated;
  sum_squares_m2 += other.sum_squares_m2;
  n_true += other.n_true;
  true_sum_squares_m2 += other.true_sum_squares_m2;
  n_true_gross += other.n_true_gross;
  n_roof_lines += other.n_roof_lines;
  n_roof_lines_found += other.n_roof_lines_found;
  return *this;
}

std::string to_markdown(std::span<const MatcherFigures> rows) {
  return text_of(rows, Markup::kMarkdown);
}

std::string to_terminal(std::span<const MatcherFigures> rows) {
  return text_of(rows, Markup::kPlain);
}

std::string to_json(std::span<const MatcherFigures> rows) {
  Json list = Json::array();
  for (const MatcherFigures& row : with_pooled(rows)) {
    const MatchQuality quality = match_quality(row.counts);
    list.push_back(
        {{"patch", row.patch},
         {"run", row.run},
         {"matcher", row.matcher},
         {"matches", row.n_matches},
         {"correct", row.counts.n_correct},
         {"false", row.counts.n_false},
         {"missed", row.counts.n_missed},
         {"correctness", number_json(quality.correctness)},
         {"completeness", number_json(quality.completeness)},
         {"quality", number_json(quality.quality)},
         {"alone", row.n_alone},
         {"alone_false", row.n_alone_false},
         {"n_lines", row.n_lines},
         {"n_evaluated", row.n_evaluated},
         {"lidar_rms_m", number_json(rms(row.sum_squares_m2, row.n_evaluated))},
         {"n_true", row.n_true},
         {"true_rms_m", number_json(rms(row.true_sum_squares_m2, row.n_true))},
         {"true_gross_share", number_json(share(row.n_true_gross, row.n_true))},
         {"roof_lines_found_share",
          number_json(share(static_cast<double>(row.n_roof_lines_found), row.n_roof_lines))}});
  }
  return dump(Json{{"rows", std::move(list)}});
}

}  // namespace ridgeline::evaluate
