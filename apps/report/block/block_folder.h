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

/// A row of patches.csv: what became of a patch by one method.
struct PatchFigures {
  std::size_t n_lines = 0, n_evaluated = 0;
  std::optional<double> rms_m, median_m, max_m;
  std::size_t n_reference_lines = 0, n_reference_found = 0;
};

/// A patch of a block as its plan has it, and its results.
struct ShownPatch {
  std::string id;
  std::array<std::int64_t, 2> square{};  ///< column and row
  Eigen::AlignedBox2d core_m, area_m;
  std::array<double, 2> height_range_m{};
  std::vector<std::string> images;
  double estimated_s = 0.0, estimated_mib = 0.0;
  std::string reason;                 ///< why it has no lines; empty if it is done
  std::vector<PatchFigures> figures;  ///< of each method
  evaluate::Json table2_rows = evaluate::Json::array();
};

/// A cloud that the lines were judged by, as it was then.
struct JudgingCloud {
  std::string path;
  std::uint64_t bytes = 0;
};

/// All that the report of a block shows but its LIDAR, as read from its folder.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct BlockFolder {
  evaluate::Json run;  ///< run.json, paths shortened
  std::string name, crs;
  double patch_size_m = 0.0, overlap_m = 0.0;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< whole metres, of all plan coordinates
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

/// Whether `ridgeline block` has merged its results there.
bool is_block_folder(const std::filesystem::path& folder);

/// Reads plan.json, patches.csv, table2.json, run.json and the maps of the lines.
/// Throws IoError for a file that is missing or not what it should be.
BlockFolder read_block_folder(const std::filesystem::path& folder);

}  // namespace ridgeline::apps
