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
  /// The judged lines in metres, in the order of `evaluation`; std::nullopt for a line that could
  /// not be read.
  std::vector<std::optional<io::Line>> lines;
  /// The judged lines as segments in the patch's frame, at the positions in their file;
  /// std::nullopt if `lines` has none or if coordinates are not finite.
  std::vector<std::optional<Segment3>> segments;
  /// The shift applied to the lines before they were judged.
  [[nodiscard]] Eigen::Vector3d moved_m() const {
    const auto& shift = evaluation.shift;
    return shift && shift->applied ? Eigen::Vector3d(-shift->shift_m) : Eigen::Vector3d::Zero();
  }
  /// A line at the position where it was judged.
  [[nodiscard]] std::optional<Segment3> judged_segment(std::size_t i) const {
    if (!segments[i]) return std::nullopt;
    return Segment3{segments[i]->start + moved_m(), segments[i]->end + moved_m()};
  }
  /// The rows of buildings.csv if the lines belong to a building model; otherwise empty.
  evaluate::Json buildings = evaluate::Json::array();
  /// The rows of to_fix.csv.
  evaluate::Json to_fix = evaluate::Json::array();
  std::vector<std::optional<double>>
      true_errors_m;  ///< error of each line; empty without true lines
};

/// The matches of a pair of images, which are given by their indices in the patch.
struct ReportPair {
  ViewPair views;
  std::vector<Correspondence> matches;
};

/// The images of a patch with their segments and matches. Present only if all of these could be
/// read.
struct ReportImages {
  std::vector<cv::Mat> pictures;          ///< display_image() of each image
  std::vector<Eigen::Vector2d> sizes_px;  ///< of the images, not of `pictures`
  std::array<cv::Mat, 2> base_pair;       ///< the first two images, normalised
  std::vector<std::vector<EdgeSegment>> segments;
  std::vector<ReportPair> pairs;  ///< the base pair, then further pairs that were matched
  std::vector<Track> tracks;      ///< only with three or more images
  std::optional<evaluate::MatchingScore> score;  ///< of the base pair; only with reference matches
  std::map<std::string, std::size_t> n_unmatched;  ///< unmatched left segments by reason
};

struct ReportPatch {
  std::string id;
  std::string subfolder;  ///< its folder in the results: "" or "PATCH/"
  LocalFrame frame;
  std::vector<ReportMethod> methods;
  std::optional<io::Patch> patch;
  std::optional<ReportImages> images;
  ShownCloud cloud;
  /// Points of the pair's surface; empty if it has none.
  std::vector<Eigen::Vector3d> surface_in_local;
  evaluate::JudgeOptions judge;  ///< with the widths used to fit the planes
  double max_aligned_angle_deg = kMaxAlignedAngle_deg;
  std::vector<std::string> notes;  ///< what could not be shown, and why; one sentence each

  /// The camera of an image of `patch`, for coordinates in `frame`.
  [[nodiscard]] ProjectionMatrix image_from_local(std::size_t image) const {
    return ridgeline::image_from_local(patch->images[image].image_from_world, frame.origin_m);
  }
};

/// Everything that a report shows, read from a results folder and from the data of the run, whose
/// paths are recorded in run.json.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct ReportInput {
  evaluate::Json run;  ///< run.json, folders removed from paths; an empty object if there is none
  evaluate::Table1 table1;               ///< empty without reference matches
  std::vector<std::string> input_paths;  ///< inputs of the run, which must not be overwritten
  std::vector<ReportPatch> patches;
};

/// Reads the results of `run`, `demo` or `evaluate` from a folder. Data of the run that has been
/// moved or has changed in size is omitted with a note. Throws IoError if the folder has no
/// evaluations or if one of its files is invalid.
ReportInput read_report_input(const std::string& folder);

}  // namespace ridgeline::apps
