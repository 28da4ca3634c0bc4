// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/table1.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/text_table.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

constexpr int kShareDecimals = 3;  // the published tenths of a percent

std::string share_with_interval(std::optional<double> share, const std::optional<Interval>& ci95) {
  if (!ci95) return percent(share);
  return fmt::format("{} ({} - {})", percent(share), percent(ci95->low), percent(ci95->high));
}

std::size_t number_of(const Json& row, const char* key) {
  const Json& value = row.at(key);
  check(value.is_number_unsigned(), key, ": ", value.dump(), "; must be a whole number >= 0");
  return value.get<std::size_t>();
}

std::string images_text(const std::optional<std::size_t>& group) {
  return group ? image_group_name(*group) : std::string("all");
}

/// The table of tracks; see to_tracks_csv().
PrintedTable tracks_table(const Table1& table) {
  PrintedTable written({"patch", "class", "images", "edges:", "found:", "edge recall %:", "shown:",
                        "observation recall %:", "right:", "wrong:", "observation precision %:"});
  for (const PatchTracks& of_patch : table.tracks) {
    for (const TrackCell& cell : of_patch.cells) {
      const TrackCounts& c = cell.counts;
      if (c.n_edges == 0) continue;
      written.add(of_patch.patch, cell.line_class, images_text(cell.group), c.n_edges,
                  c.n_edges_found, percent(c.edge_recall()), c.n_shown,
                  percent(c.observation_recall()), c.n_right, c.n_wrong,
                  percent(c.observation_precision()));
    }
  }
  return written;
}

Json tracks_json(const PatchTracks& of_patch) {
  Json cells = Json::array();
  for (const TrackCell& cell : of_patch.cells) {
    const TrackCounts& c = cell.counts;
    cells.push_back(
        {{"class", cell.line_class},
         {"n_images",
          cell.group ? Json(*cell.group + static_cast<std::size_t>(kMinImages)) : Json(nullptr)},
         {"edges", c.n_edges},
         {"edges_found", c.n_edges_found},
         {"edge_recall", number_json(c.edge_recall())},
         {"shown", c.n_shown},
         {"shown_found", c.n_shown_found},
         {"observation_recall", number_json(c.observation_recall())},
         {"right", c.n_right},
         {"wrong", c.n_wrong},
         {"observation_precision", number_json(c.observation_precision())}});
  }
  return {
      {"patch", of_patch.patch}, {"unjudged", of_patch.n_unjudged}, {"cells", std::move(cells)}};
}

PatchTracks parse_tracks(const Json& json) {
  PatchTracks tracks{json.at("patch").get<std::string>(), {}, number_of(json, "unjudged")};
  for (const Json& cell : json.at("cells")) {
    std::optional<std::size_t> group;
    if (!cell.at("n_images").is_null())
      group = image_group(static_cast<int>(number_of(cell, "n_images")));
    tracks.cells.push_back(
        {cell.at("class").get<std::string>(),
         group,
         {number_of(cell, "edges"), number_of(cell, "edges_found"), number_of(cell, "shown"),
          number_of(cell, "shown_found"), number_of(cell, "right"), number_of(cell, "wrong")}});
  }
  return tracks;
}

}  // namespace

std::string to_markdown(const Table1& table) {
  PrintedTable written({"patch", "matcher", "correct:", "false:", "missed:", "correctness %:",
                        "completeness %:", "quality %:"});
  for (const Table1Row& row : table.rows) {
    const MatchQuality q = match_quality(row.counts);
    written.add(row.patch, row.matcher, row.counts.n_correct, row.counts.n_false,
                row.counts.n_missed, share_with_interval(q.correctness, q.correctness_ci95),
                share_with_interval(q.completeness, q.completeness_ci95),
                share_with_interval(q.quality, q.quality_ci95));
  }
  std::string text = written.text(Markup::kMarkdown) +
                     "\nIn parentheses: 95 % Wilson interval. Basis: number of matches.\n";
  for (const Table1Row& row : table.rows) {
    if (row.n_unjudged == 0) continue;
    text +=
        fmt::format("Patch {}, {}: {} further matches concern lines absent from the reference.\n",
                    escape_markdown(row.patch), escape_markdown(row.matcher), row.n_unjudged);
  }
  if (table.tracks.empty()) return text;
  text += "\nTracks, by true edges visible in two or more images:\n\n" +
          tracks_table(table).text(Markup::kMarkdown) + "\n";
  for (const PatchTracks& of_patch : table.tracks) {
    if (of_patch.n_unjudged == 0) continue;
    text +=
        fmt::format("Patch {}: {} further observations concern lines absent from the reference.\n",
                    escape_markdown(of_patch.patch), of_patch.n_unjudged);
  }
  return text;
}

std::string to_csv(const Table1& table) {
  std::string text = "patch,matcher,correct,false,missed,correctness,completeness,quality\n";
  const auto share = [](std::optional<double> value) { return fixed(value, kShareDecimals, ""); };
  for (const Table1Row& row : table.rows) {
    const MatchQuality q = match_quality(row.counts);
    text += fmt::format("{},{},{},{},{},{},{},{}\n", escape_csv(row.patch), escape_csv(row.matcher),
                        row.counts.n_correct, row.counts.n_false, row.counts.n_missed,
                        share(q.correctness), share(q.completeness), share(q.quality));
  }
  return text;
}

std::string to_tracks_csv(const Table1& table) {
  std::string text =
      "patch,class,n_images,edges,edges_found,edge_recall,shown,shown_found,observation_recall,"
      "right,"
      "wrong,observation_precision\n";
  const auto share = [](std::optional<double> value) { return fixed(value, kShareDecimals, ""); };
  for (const PatchTracks& of_patch : table.tracks) {
    for (const TrackCell& cell : of_patch.cells) {
      const TrackCounts& c = cell.counts;
      if (c.n_edges == 0) continue;
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", escape_csv(of_patch.patch),
                          cell.line_class, images_text(cell.group), c.n_edges, c.n_edges_found,
                          share(c.edge_recall()), c.n_shown, c.n_shown_found,
                          share(c.observation_recall()), c.n_right, c.n_wrong,
                          share(c.observation_precision()));
    }
  }
  return text;
}

std::string to_json(const Table1& table) {
  Json rows = Json::array();
  for (const Table1Row& row : table.rows) {
    const MatchQuality q = match_quality(row.counts);
    rows.push_back({{"patch", row.patch},
                    {"matcher", row.matcher},
                    {"correct", row.counts.n_correct},
                    {"false", row.counts.n_false},
                    {"missed", row.counts.n_missed},
                    {"unjudged", row.n_unjudged},
                    {"correctness", number_json(q.correctness)},
                    {"correctness_ci95", interval_json(q.correctness_ci95)},
                    {"completeness", number_json(q.completeness)},
                    {"completeness_ci95", interval_json(q.completeness_ci95)},
                    {"quality", number_json(q.quality)},
                    {"quality_ci95", interval_json(q.quality_ci95)}});
  }
  Json json{{"rows", std::move(rows)}};
  for (const PatchTracks& of_patch : table.tracks) json["tracks"].push_back(tracks_json(of_patch));
  return dump(json);
}

Table1 parse_table1(std::string_view json) {
  Table1 table;
  try {
    const Json parsed = Json::parse(json);
    for (const Json& row : parsed.at("rows")) {
      table.rows.push_back(
          {row.at("patch").get<std::string>(),
           row.at("matcher").get<std::string>(),
           {number_of(row, "correct"), number_of(row, "false"), number_of(row, "missed")},
           number_of(row, "unjudged")});
    }
    if (!parsed.contains("tracks")) return table;
    for (const Json& of_patch : parsed["tracks"]) table.tracks.push_back(parse_tracks(of_patch));
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("is not a Table 1: ") + error.what());
  }
  return table;
}

}  // namespace ridgeline::evaluate
