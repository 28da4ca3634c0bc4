// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/block/block_lines.h"
#include "evaluate/tables/summary_json.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// A row of patches.csv: the results of one method on a patch.
struct PatchFigures {
  std::size_t n_lines = 0, n_evaluated = 0;
  std::optional<double> rms_m, median_m, max_m;
  std::size_t n_reference_lines = 0, n_reference_found = 0;
};

/// A patch of a block as planned, with its results.
struct ShownPatch {
  std::string id;
  std::array<std::int64_t, 2> square{};  ///< column and row
  Eigen::AlignedBox2d core_m, area_m;
  std::array<double, 2> height_range_m{};
  std::vector<std::string> images;
  double estimated_s = 0.0, estimated_mib = 0.0;
  std::string reason;                 ///< why it has no lines; empty if it is finished
  std::vector<PatchFigures> figures;  ///< one per method
  evaluate::Json table2_rows = evaluate::Json::array();
};

/// A cloud against which the lines were judged, as it was at that time.
struct JudgingCloud {
  std::string path;
  std::uint64_t bytes = 0;
};

/// Everything that the report of a block shows except its LIDAR points, read from its folder.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct BlockFolder {
  evaluate::Json run;  ///< run.json, paths shortened
  std::string name, crs;
  double patch_size_m = 0.0, overlap_m = 0.0;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< whole metres, of the report's plan
  std::vector<Eigen::Vector2d> area_m;
  std::size_t n_without_views = 0;
  std::vector<std::string> notes;
  std::vector<ShownPatch> patches;
  std::vector<ShownLines> methods;  ///< the product first
  evaluate::Json table2_rows = evaluate::Json::array();
  evaluate::Json table2_footnote;
  std::vector<std::string> input_paths;
  std::vector<JudgingCloud> clouds;
};

/// Whether `ridgeline block` has merged its results in this folder.
bool is_block_folder(const std::filesystem::path& folder);

/// Reads plan.json, patches.csv, table2.json, run.json and the maps of the lines.
/// Throws IoError if a file is missing or invalid.
BlockFolder read_block_folder(const std::filesystem::path& folder);

}  // namespace ridgeline::apps
