// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judged_map.h"

#include "io/lines/read_lines.h"
#include "tests/evaluate/statistics/lines.h"
#include "tests/support/temp_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ridgeline::results {
namespace {

/// The value of a column of the first line of a map; nothing if it is null.
io::Value value_in(const io::LineSet& map, const std::string& name) {
  const auto& columns = map.features.columns;
  const auto column = std::ranges::find(columns, name, &io::Column::name);
  if (column == columns.end()) throw std::out_of_range(name);
  for (const auto& [i, value] : map.features.rows.at(map.lines.at(0).row)) {
    if (i == static_cast<std::size_t>(column - columns.begin())) return value;
  }
  return {};
}

/// The map of one line of 5 m, read again.
io::LineSet map_of(const evaluate::LineEvaluation& line) {
  const io::TempFolder folder;
  io::LineSet set;
  set.crs = {"EPSG:25832"};
  set.lines.emplace_back().segment_in_world = {{0, 0, 5}, {5, 0, 5}};
  set.features.rows.resize(1);
  evaluate::Evaluation evaluation;
  evaluation.lines = {line};
  JudgedFiles judged;
  judged.line_sets = {set};
  judged.evaluations = {evaluation};
  judged.planes.resize(1);
  write_judged_map(folder.file("map.gpkg"), judged, 0, MapSchema::kPlain);
  return io::read_lines(folder.file("map.gpkg"));
}

TEST(WriteJudgedMap, NamesTheSurfaceAndWhatDecidedOnIt) {
  evaluate::LineEvaluation line = evaluate::evaluated_line("a", 0.1, 1);
  line.planes.clear();
  line.surface = evaluate::JudgingSurface::kGround;
  line.surface_other = evaluate::JudgingSurface::kUpper;
  line.surface_probability = 0.93;
  line.decided_by = evaluate::DecidedBy::kImages;
  const io::LineSet map = map_of(line);
  EXPECT_EQ(value_in(map, "surface"), io::Value("ground"));
  EXPECT_EQ(value_in(map, "surface_other"), io::Value("upper"));
  EXPECT_EQ(value_in(map, "surface_probability"), io::Value(0.93));
  EXPECT_EQ(value_in(map, "decided_by"), io::Value("images"));
}

TEST(WriteJudgedMap, LeavesEmptyWhatALineThatWasNotJudgedLacks) {
  const io::LineSet map = map_of(evaluate::excluded_line("a", evaluate::Status::kNoPlane));
  for (const char* name : {"surface", "surface_other", "surface_probability", "decided_by",
                           "mean_distance_m", "max_distance_m", "signed_mean_m", "sigma_m"}) {
    EXPECT_EQ(value_in(map, name), io::Value()) << name;
  }
}

}  // namespace
}  // namespace ridgeline::results
