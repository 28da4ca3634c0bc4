// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/common/progress.h"
#include "apps/common/shared_options.h"
#include "apps/pipeline/check_pair.h"
#include "apps/pipeline/parameters.h"
#include "evaluate/files/judged_lines.h"
#include "evaluate/files/judged_map.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/files/run_record.h"
#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/table1.h"
#include "io/crs/crs.h"
#include "io/lines/write_lines.h"
#include "io/project/patch.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The last stage of a run.
inline constexpr const char* kLastStage = "evaluate";

struct RunOptions {
  std::vector<reconstruct::Method> methods{reconstruct::Method::kLines};
  Parameters parameters;
  evaluate::SummaryOptions summary;
  std::vector<io::LineFormat> line_formats;  ///< formats in addition to GeoJSON
  results::MapSchema map_schema = results::MapSchema::kPlain;
  bool local_origin = false;  ///< see io::WriteLinesOptions
  io::Crs assume_crs;         ///< declares or overrides the CRS of patch, cloud and reference lines
  double max_image_mpx = 0.0;                          ///< limit of io::read_image()
  double max_y_parallax_px = kDefaultMaxYParallax_px;  ///< limit of check_pairs()
  std::string config_path;                             ///< parameter file; may be empty
  ShiftArguments shift;
  std::optional<std::size_t> n_decoys;  ///< see results::JudgeFilesOptions
  bool completeness = false;            ///< see results::JudgeFilesOptions
  bool resume = false;
  std::string until = kLastStage;  ///< the last stage: extract, match, reconstruct or evaluate
  bool report = true;              ///< report.html and the figures
  PageFacts page;
};

/// The results of matching and evaluation of one patch, besides its files.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct PatchResult {
  std::optional<evaluate::Table1Row> matching;    ///< of score_matches()
  std::optional<evaluate::PatchTracks> tracks;    ///< score_tracks()
  nlohmann::ordered_json edges;                   ///< sharpness by image, see edge_facts()
  std::vector<evaluate::Evaluation> evaluations;  ///< one per method
  std::vector<results::TruthRows> truth;
  std::vector<std::string> messages;  ///< outcome_messages()
  std::size_t n_skipped_stages = 0;   ///< stages finished by an earlier run (--resume)
};

/// The number of steps that run_patch() reports to the progress bar.
std::size_t count_steps(const RunOptions& options);

/// Checks everything that can be checked before the work begins. `record` contains the inputs.
/// Throws IoError if an output is also an input, and for a cloud that cannot be read, whose CRS
/// differs from the patch's or that fails check_scale().
void check_run(const io::Patch& patch,
               const RunOptions& options,
               const results::OutputFolder& out,
               results::RunRecord& record);

/// Images -> segments -> matches -> 3D lines by each method -> judged lines (Ok et al. 2011);
/// writes the files of one patch to the folder named after its id. A stage finished by an earlier
/// run is skipped (RunOptions::resume). Stages after RunOptions::until do not run; files of these
/// stages from an earlier run are removed if they are out of date. Without LIDAR, the lines are
/// reconstructed and get the status `no_lidar`. Throws IoError for an invalid file.
PatchResult run_patch(const io::Patch& patch,
                      const RunOptions& options,
                      const results::OutputFolder& out,
                      Progress& progress,
                      results::RunRecord& record);

}  // namespace ridgeline::apps
