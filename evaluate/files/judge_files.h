// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judged_lines.h"
#include "evaluate/files/judged_model.h"
#include "evaluate/files/run_record.h"
#include "evaluate/judge/judged_planes.h"
#include "evaluate/judge/options.h"
#include "evaluate/statistics/evaluation.h"
#include "io/cloud/cloud_files.h"
#include "io/cloud/read_cloud.h"
#include "io/lines/read_lines.h"
#include "io/project/patch.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::results {

struct JudgeFilesOptions {
  /// Judge only the lines that belong to this area, given in the cloud's own coordinates; see
  /// keep_area(). Checks that need all lines are then skipped.
  std::optional<Eigen::AlignedBox2d> area = {};
  std::vector<std::string> line_paths;
  std::vector<std::string> cloud_paths;                 ///< files and patterns
  std::optional<io::Patch> patch;                       ///< its cameras classify the lines
  double max_aligned_angle_deg = kMaxAlignedAngle_deg;  ///< limit of the class `aligned`
  std::string patch_name;                               ///< in the tables
  std::optional<std::string> reference_lines;           ///< file of true lines, for precision etc.
  io::ReadOptions cloud;
  io::ReadLinesOptions lines;
  evaluate::JudgeOptions judge;
  evaluate::SummaryOptions summary;
  /// Number of decoys per file, see evaluate::make_decoys(); default: evaluate::default_n_decoys().
  /// With 0, the lines are not compared with themselves elsewhere either.
  std::optional<std::size_t> n_decoys = {};
  std::string geoid;  ///< grid for explaining a shift, see io::geoid_at(); may be empty
  /// Memory for the points held at a time, see judge_in_batches(). 512 MiB hold
  /// about 5.6 million.
  std::uint64_t cloud_memory_mib = 512;
  /// Attributes of the buildings by which the figures of models are grouped.
  std::vector<std::string> by;
  bool scale_to_ground = false;  ///< see set_plan_scale()
  /// Whether to remove a significant shift from the lines and judge them again.
  bool apply_shift = false;
  /// Whether lines that fit the cloud no better than elsewhere cause an error instead of a warning.
  bool refuse_other_places = true;
  bool needs_models = false;  ///< whether line files must be models of buildings
  /// Whether to find the edges of the scan and compare the lines with them, see scan_area().
  bool completeness = false;
  /// Corners of the area of a block, convex, counter-clockwise, metres in the CRS; may be empty.
  std::vector<Eigen::Vector2d> block_area_m = {};
};

struct JudgedFiles {
  LocalFrame frame;
  std::vector<io::LineSet> line_sets;  ///< as read, or moved according to Evaluation::shift
  std::vector<evaluate::Evaluation> evaluations;  ///< one per line file; method: the file's stem
  std::vector<std::vector<evaluate::JudgedPlane>> planes;  ///< of each evaluation
  std::vector<evaluate::PlanePoint> points;  ///< of all planes, if JudgeOptions::keep_points
  io::Crs cloud_crs;
  Eigen::Vector3d cloud_unit_m = Eigen::Vector3d::Ones();
  std::vector<TruthRows> truth;  ///< one per evaluation
  /// One per line file: the buildings and faces of a model, std::nullopt for other files.
  std::vector<std::optional<JudgedModel>> models;
  std::vector<evaluate::AreaPart> areas;  ///< one per line file, if only an area is judged
  std::vector<std::string> warnings;
  std::vector<std::string> unread_clouds;  ///< cloud files without any line nearby
};

/// The lines of a run, as read; each set is identified by its path.
struct LinesToJudge {
  std::vector<io::LineSet> sets;
  std::optional<io::LineSet> references;  ///< true lines
};

/// Reads lines and the points near them into one local frame, judges the lines, estimates the shift
/// of each file and computes the figures. Throws IoError for an invalid file, for a CRS or unit
/// mismatch (naming both), and for lines that are not in the frame of the cloud or do not fit it.
JudgedFiles judge_files(const JudgeFilesOptions& options, RunRecord& record);

/// Like judge_files(), but for lines and a cloud that are already open or come from another source.
/// Does not read the paths in the options.
JudgedFiles judge_lines(LinesToJudge lines,
                        io::CloudFiles& cloud,
                        const JudgeFilesOptions& options,
                        RunRecord& record);

/// Throws IoError for the file at `path`, naming both reference systems, if `crs` and `other` do
/// not agree. `what` names the two data sets in the message, e.g. "lines and cloud". Anything that
/// one of the systems leaves undefined becomes a warning.
void require_same_frame(std::string_view what,
                        const std::string& path,
                        const io::Crs& crs,
                        const io::Crs& other,
                        std::vector<std::string>* warnings = nullptr);

/// The warnings from reading the lines, each prefixed with the file's path.
std::vector<std::string> own_warnings(const io::LineSet& set);

/// A file's name without folder and extension, in UTF-8.
std::string stem_of(const std::string& path);

}  // namespace ridgeline::results
