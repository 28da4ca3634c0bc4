// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/shown_cloud.h"
#include "evaluate/judge/options.h"
#include "evaluate/matching/match_scoring.h"
#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/table1.h"
#include "io/lines/line_set.h"
#include "io/project/matches_file.h"
#include "io/project/patch.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/local_frame.h"
#include "reconstruct/geometry/track.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// One method (or line file) on one patch.
struct ReportMethod {
  evaluate::Evaluation evaluation;
  /// The judged lines in metres, by the index in `evaluation`; nothing for a line whose file is
  /// gone.
  std::vector<std::optional<io::Line>> lines;
  /// The judged lines as segments in the patch's frame, where their file has them; nothing where
  /// `lines` has none or coordinates are not finite.
  std::vector<std::optional<Segment3>> segments;
  /// By how much the lines were moved before they were judged.
  [[nodiscard]] Eigen::Vector3d moved_m() const {
    const auto& shift = evaluation.shift;
    return shift && shift->applied ? Eigen::Vector3d(-shift->shift_m) : Eigen::Vector3d::Zero();
  }
  /// A line where it was judged.
  [[nodiscard]] std::optional<Segment3> judged_segment(std::size_t i) const {
    if (!segments[i]) return std::nullopt;
    return Segment3{segments[i]->start + moved_m(), segments[i]->end + moved_m()};
  }
  /// The rows of buildings.csv, if the lines are those of a model; else empty.
  evaluate::Json buildings = evaluate::Json::array();
  /// The rows of to_fix.csv.
  evaluate::Json to_fix = evaluate::Json::array();
  std::vector<std::optional<double>> true_errors_m;  ///< error of each line; empty without truth
};

/// The matches of a pair of images, given by their places in the patch.
struct ReportPair {
  ViewPair views;
  std::vector<Correspondence> matches;
};

/// The images of a patch with segments and matches. It exists only if all of these could be read.
struct ReportImages {
  std::vector<cv::Mat> pictures;          ///< display_image() of each image
  std::vector<Eigen::Vector2d> sizes_px;  ///< of the images themselves
  std::array<cv::Mat, 2> base_pair;       ///< the first two images, normalised
  std::vector<std::vector<EdgeSegment>> segments;
  std::vector<ReportPair> pairs;  ///< the base pair, then further pairs that were matched
  std::vector<Track> tracks;      ///< of three images and more
  std::optional<evaluate::MatchingScore>
      score;  ///< of the base pair; exists with reference matches
  std::map<std::string, std::size_t> n_unmatched;  ///< left segments by reason
};

struct ReportPatch {
  std::string id;
  std::string subfolder;  ///< folder of its files in the results: "" or "PATCH/"
  LocalFrame frame;
  std::vector<ReportMethod> methods;
  std::optional<io::Patch> patch;
  std::optional<ReportImages> images;
  ShownCloud cloud;
  /// Points of the pair's surface; empty if it has none.
  std::vector<Eigen::Vector3d> surface_in_local;
  evaluate::JudgeOptions judge;  ///< widths that its planes were fitted with
  double max_aligned_angle_deg = kMaxAlignedAngle_deg;
  std::vector<std::string> notes;  ///< what could not be shown, and why; one sentence each

  /// The camera of an image of `patch` in `frame`.
  [[nodiscard]] ProjectionMatrix image_from_local(std::size_t image) const {
    return ridgeline::image_from_local(patch->images[image].image_from_world, frame.origin_m);
  }
};

/// All that a report shows, as read from a folder of results and, by the paths that run.json
/// records, from the data of the run.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct ReportInput {
  evaluate::Json run;       ///< run.json without folders; an empty object if there is none
  evaluate::Table1 table1;  ///< empty without reference matches
  std::vector<std::string> input_paths;  ///< inputs of the run, which must not be written over
  std::vector<ReportPatch> patches;
};

/// Reads what `run`, `demo` or `evaluate` left in the folder. Data that is no longer where it was,
/// or not the same size, is left out with a note. Throws IoError for a folder without evaluations
/// and for files of the folder that are not what they should be.
ReportInput read_report_input(const std::string& folder);

}  // namespace ridgeline::apps
