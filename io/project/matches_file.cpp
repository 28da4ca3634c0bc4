// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/matches_file.h"

#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/files/csv_table.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr std::array<const char*, 4> kEnds{"x1_px", "y1_px", "x2_px", "y2_px"};

/// Throws IoError for a table in which a pair of ids occurs twice.
class UniquePairs {
 public:
  void add(const CsvTable& table, std::size_t row, const Correspondence& match) {
    const auto [it, is_new] = seen_.try_emplace({match.base, match.other}, row);
    if (is_new) return;
    throw IoError(table.place_of(row),
                  fmt::format("the match {}, {} appears twice; first in {}", match.base,
                              match.other, table.place_of(it->second)));
  }

 private:
  std::map<std::pair<int, int>, std::size_t> seen_;
};

std::vector<Correspondence> pairs_of(const CsvTable& table) {
  const std::size_t left = table.column("left_id");
  const std::size_t right = table.column("right_id");
  std::vector<Correspondence> pairs;
  UniquePairs unique;
  for (std::size_t row = 0; row < table.size(); ++row) {
    pairs.push_back({table.index(row, left), table.index(row, right)});
    unique.add(table, row, pairs.back());
  }
  return pairs;
}

std::array<std::size_t, 4> end_columns(const CsvTable& table, const std::string& image) {
  std::array<std::size_t, 4> columns{};
  for (std::size_t i = 0; i < kEnds.size(); ++i) columns[i] = table.column(image + "_" + kEnds[i]);
  return columns;
}

Segment2 segment_of(const CsvTable& table,
                    std::size_t row,
                    const std::array<std::size_t, 4>& columns) {
  const auto value = [&](std::size_t i) { return table.number(row, columns[i]); };
  return {{value(0), value(1)}, {value(2), value(3)}};
}

bool is_wrong_pair(const CsvTable& table, std::size_t row) {
  if (!table.has("verdict")) return false;
  const std::string_view verdict = table.text(row, table.column("verdict"));
  if (verdict == "false") return true;
  if (verdict == "correct" || verdict == "missed") return false;
  throw IoError(table.place_of(row),
                fmt::format("verdict '{}'; must be correct, missed or false", verdict));
}

std::vector<ReferenceEdge> edges_of(const CsvTable& table) {
  const std::size_t id = table.column("id");
  const std::array<std::size_t, 4> left = end_columns(table, "left");
  const std::array<std::size_t, 4> right = end_columns(table, "right");
  std::vector<ReferenceEdge> edges;
  for (std::size_t row = 0; row < table.size(); ++row) {
    ReferenceEdge edge;
    edge.id = table.text(row, id);
    if (table.has("kind")) edge.kind = table.text(row, table.column("kind"));
    edge.base = segment_of(table, row, left);
    edge.other = segment_of(table, row, right);
    edge.is_wrong_pair = is_wrong_pair(table, row);
    edges.push_back(std::move(edge));
  }
  return edges;
}

std::string pixel_text(const Segment2& s) {
  return fmt::format("{:.3f},{:.3f},{:.3f},{:.3f}", s.start.x(), s.start.y(), s.end.x(), s.end.y());
}

}  // namespace

void write_matches(const std::string& path, std::span<const Correspondence> matches) {
  std::string text = "left_id,right_id,score,votes,matcher\n";
  for (const Correspondence& m : matches)
    text += fmt::format("{},{},{:.4f},{:.3f},{}\n", m.base, m.other, m.score, m.votes, m.matcher);
  write_file(path, text);
}

std::vector<Correspondence> read_matches(const std::string& path) {
  const CsvTable table(path, FileGroup::kMatches);
  std::vector<Correspondence> matches = pairs_of(table);
  for (std::size_t row = 0; row < matches.size(); ++row) {
    if (table.has("score")) matches[row].score = table.number(row, table.column("score"));
    if (table.has("votes")) matches[row].votes = table.number(row, table.column("votes"));
    if (table.has("matcher")) matches[row].matcher = table.text(row, table.column("matcher"));
  }
  return matches;
}

ReferenceMatches read_reference_matches(const std::string& path) {
  const CsvTable table(path, FileGroup::kReferenceMatches);
  if (table.has("left_id")) return pairs_of(table);
  return edges_of(table);
}

void write_reference_edges(const std::string& path, std::span<const ReferenceEdge> edges) {
  std::string text = "id,kind";
  for (const char* image : {"left", "right"}) {
    for (const char* end : kEnds) text += fmt::format(",{}_{}", image, end);
  }
  text += "\n";
  for (const ReferenceEdge& edge : edges) {
    text += fmt::format("{},{},{},{}\n", edge.id, edge.kind, pixel_text(edge.base),
                        pixel_text(edge.other));
  }
  write_file(path, text);
}

}  // namespace ridgeline::io
