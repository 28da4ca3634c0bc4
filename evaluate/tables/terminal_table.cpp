// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/terminal_table.h"

#include "evaluate/tables/cells.h"
#include "evaluate/tables/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ridgeline::evaluate {
namespace {

using Row = std::vector<std::string>;

/// Characters of UTF-8, each taken to be one column wide.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// The first `n_left` columns flush left, the figures flush right.
std::string aligned(const std::vector<Row>& rows, std::size_t n_left) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - width_of(row[i]), ' ');
      line += i == 0 ? "" : "  ";
      line += i < n_left ? row[i] + padding : padding + row[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace

std::string to_terminal(const Table1& table) {
  if (table.rows.empty()) return "";
  std::vector<Row> rows{
      {"patch", "matcher", "correct", "false", "missed", "correctness %", "completeness %"}};
  for (const Table1Row& row : table.rows) {
    const MatchQuality quality = match_quality(row.counts);
    rows.push_back({row.patch, row.matcher, std::to_string(row.counts.n_correct),
                    std::to_string(row.counts.n_false), std::to_string(row.counts.n_missed),
                    percent(quality.correctness), percent(quality.completeness)});
  }
  return "Matches\n" + aligned(rows, 2);
}

std::string to_terminal(const Table2& table) {
  const bool has_ridges = std::ranges::any_of(table.results, [](const PatchMethodResult& result) {
    return std::ranges::any_of(result.classes, [](const Summary& s) { return s.n_parts > 0; });
  });
  std::vector<Row> rows{
      {"patch", "method", "class", "judged", "lines", "RMS", "95 % interval", "median", "95 %"}};
  if (has_ridges) rows[0].insert(rows[0].end(), {"ridges", "RMSE_H", "RMSE_V"});
  for (const PatchMethodResult& result : table.results) {
    for (const Summary& s : result.classes) {
      Row row{result.patch,
              result.method,
              s.line_class,
              std::to_string(s.n_evaluated),
              std::to_string(s.n_lines),
              metres(s.rms_m),
              interval_text(s.ci95_m),
              metres(s.median_m),
              metres(s.q95_m)};
      if (has_ridges) {
        row.insert(row.end(), {std::to_string(s.n_parts), metres(s.rmse_horizontal_m),
                               metres(s.rmse_vertical_m)});
      }
      rows.push_back(std::move(row));
    }
  }
  const std::string_view note = footnote(table);
  return fmt::format("Distances of the lines from LIDAR planes, m\n{}{}{}", aligned(rows, 3), note,
                     note.empty() ? "" : "\n");
}

}  // namespace ridgeline::evaluate
