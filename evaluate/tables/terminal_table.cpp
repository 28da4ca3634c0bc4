// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/terminal_table.h"

#include "evaluate/tables/cells.h"
#include "evaluate/tables/format.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {
namespace {

bool has_ridges(const Table2& table) {
  return std::ranges::any_of(table.results, [](const PatchMethodResult& result) {
    return std::ranges::any_of(result.classes, [](const Summary& s) { return s.n_parts > 0; });
  });
}

/// How few lines dominate each headline figure, one line of text per result.
std::string squares_notes(const Table2& table) {
  std::string text;
  for (const PatchMethodResult& result : table.results) {
    const Summary* total = find_class(result.classes, kTotal);
    if (total == nullptr) continue;
    const Summary headline = total->of_group(DecidedGroup::kPlanImages);
    if (headline.n_evaluated == 0) continue;
    text += paragraph(
        fmt::format(
            "{}, {}: {} of {} lines contribute half of the sum of squares; RMS of the others {} m.",
            in_sentence(result.patch, Markup::kPlain), in_sentence(result.method, Markup::kPlain),
            headline.n_half_of_squares, headline.n_evaluated, metres(headline.rms_without_half_m)),
        Markup::kPlain);
  }
  return text;
}

/// The tracks by number of images, for all classes combined.
PrintedTable tracks_in_short(const Table1& table) {
  PrintedTable written({"patch", "images", "edges:", "found:", "edge recall %:",
                        "observation recall %:", "observation precision %:"});
  for (const PatchTracks& of_patch : table.tracks) {
    for (const TrackCell& cell : of_patch.cells) {
      if (cell.line_class != kTotal || cell.counts.n_edges == 0) continue;
      written.add(of_patch.patch, cell.group ? image_group_name(*cell.group) : std::string("all"),
                  cell.counts.n_edges, cell.counts.n_edges_found,
                  percent(cell.counts.edge_recall()), percent(cell.counts.observation_recall()),
                  percent(cell.counts.observation_precision()));
    }
  }
  return written;
}

}  // namespace

std::string to_terminal(const Table1& table) {
  if (table.rows.empty() && table.tracks.empty()) return "";
  PrintedTable written(
      {"patch", "matcher", "correct:", "false:", "missed:", "correctness %:", "completeness %:"});
  for (const Table1Row& row : table.rows) {
    const MatchQuality quality = match_quality(row.counts);
    written.add(row.patch, row.matcher, row.counts.n_correct, row.counts.n_false,
                row.counts.n_missed, percent(quality.correctness), percent(quality.completeness));
  }
  std::string text =
      table.rows.empty() ? std::string() : captioned("Matches", written, Markup::kPlain);
  if (table.tracks.empty()) return text;
  if (!text.empty()) text += "\n";
  return text + captioned("Tracks, by true edges", tracks_in_short(table), Markup::kPlain);
}

std::string to_terminal(const Table2& table) {
  std::vector<std::string> columns{"patch", "method",         "class",   "judged:", "lines:",
                                   "RMS:",  "95 % interval:", "median:", "95 %:"};
  const bool with_ridges = has_ridges(table);
  if (with_ridges) columns.insert(columns.end(), {"ridges:", "RMSE_H:", "RMSE_V:"});
  PrintedTable written(columns);
  for (const PatchMethodResult& result : table.results) {
    for (const Summary& of_class : result.classes) {
      for (const auto& [class_name, s] : rows_of(of_class)) {
        std::vector<std::string> row{result.patch,
                                     result.method,
                                     class_name,
                                     std::to_string(s.n_evaluated),
                                     std::to_string(s.n_lines),
                                     metres(s.rms_m),
                                     interval_text(s.ci95_m),
                                     metres(s.median_m),
                                     metres(s.q95_m)};
        if (with_ridges) {
          row.insert(row.end(), {std::to_string(s.n_parts), metres(s.rmse_horizontal_m),
                                 metres(s.rmse_vertical_m)});
        }
        written.add_row(std::move(row));
      }
    }
  }
  const std::string note = footnote(table);
  return captioned("Distances of the lines from LIDAR planes, m", written, Markup::kPlain) +
         squares_notes(table) + (note.empty() ? "" : paragraph(note, Markup::kPlain));
}

}  // namespace ridgeline::evaluate
