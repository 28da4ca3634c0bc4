// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/pluecker.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"
#include "reconstruct/ok2011/estimate/line_support.h"
#include "reconstruct/ok2011/estimate/options.h"
#include "reconstruct/ok2011/estimate/point_weight.h"
#include "reconstruct/views/stereo_lines.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// To the epipolar line. A property of the match, the same for all methods.
enum class LineClass : std::uint8_t { kNotAligned, kAligned };
const char* name(LineClass line_class);  ///< "not_aligned" | "aligned"

/// How a line came about.
enum class Status : std::uint8_t {
  kDirect,          ///< intersection of the projection planes
  kJoint,           ///< planes and two or three points; horizontality too where these agree on it
  kOnePoint,        ///< planes and one point: the direction still rests on the planes alone
  kSurface,         ///< points fix no direction; the surface beside the line does
  kSegmentEnds,     ///< points fix no direction; ends of both segments taken as the same
  kHorizontal,      ///< points fix no direction; the line taken as horizontal
  kNoPoints,        ///< `joint` without a usable point: identical to `direct`
  kRankDeficient,   ///< planes and points leave a direction free: one of many lines, no covariance
  kNotConverged,    ///< the adjustment still moved after its last pass; its last line
  kAmbiguousDepth,  ///< no depth explains the line clearly better than another: no segment
  kNoIntersection,  ///< coincident planes, or a line at infinity or behind a camera: no segment
  kNetwork,         ///< adjusted with all lines that it meets
  kPlanes,          ///< intersection of two surfaces where no edge was matched
};
const char* name(Status status);  ///< "direct", "one_point", ... as in the files

/// An artificial point that entered the adjustment.
struct UsedPoint {
  Eigen::Vector3d x_in_local;  ///< m
  Eigen::Matrix3d cov_m2;      ///< world axes
  int neighbour = 0;           ///< match that it was made with
  double weight = 0.0;         ///< W of Eq. 6
  double omega = 0.0;          ///< of its estimation, chi-square with 1 degree of freedom
  Region region = Region::kLeft;
};

struct ReconstructedLine {
  LineMatch match;
  /// Number of the part from the start of the left segment, where the match was cut into several
  /// lines (agree_on_depth()); 0 for a whole match.
  int part = 0;
  int n_meetings = 0;  ///< other lines that it meets, accepted by `network`
  LineClass line_class = LineClass::kNotAligned;
  Status status = Status::kNoIntersection;
  bool between_right_ends = false;              ///< which of its ends segment_in_local has
  std::array<Segment2, 2> seen_px;              ///< the line in the left and the right image
  double epipolar_angle_rad = 0.0;              ///< the smaller one of both images
  std::array<double, 2> epipolar_angles_rad{};  ///< left, right
  /// m; ends seen at those of the left segment, or of the right one (EstimateExtensions).
  std::optional<Segment3> segment_in_local;
  std::optional<Matrix6d> covariance_m2;           ///< of (start, end), world axes
  std::optional<Segment3> right_segment_in_local;  ///< the same line between the right ends
  /// Larger height sigma of the two endpoints by `direct`, whatever the method: tells weak lines
  /// apart by precision where the class does so by angle. Empty without an intersection.
  std::optional<double> direct_sigma_z_m;
  std::vector<UsedPoint> points;
  /// Sum of squared normalised misclosures of the adjustment; 0 for `direct`, of its images for
  /// `network`.
  double omega = 0.0;
};

/// A line by `joint` with what it rests on beside its planes.
struct JointLine {
  ReconstructedLine line;
  LineSupport support;
};

/// The lines of an aligned match, mostly one, and what each rests on.
using SupportOfMatch = std::function<std::vector<LineSupport>(const ObservedPair& line,
                                                              std::span<const int> neighbours)>;

/// Where what goes beyond the paper enters the estimation. Each may be empty.
struct EstimateExtensions {
  /// A not_aligned line whose end is less certain than this (height) is given between the ends of the right segment.
  double max_end_sigma_m = std::numeric_limits<double>::infinity();
  /// What aligned lines rest on in place of published_support(), given all lines and those by `direct`.
  std::function<SupportOfMatch(const StereoLines& lines, std::span<const ReconstructedLine> direct)>
      support;
  /// Method::kNetwork: adjusts the lines of `joint`, by match, together. `lines` have covariances of the centroid form.
  std::function<void(const StereoLines& lines,
                     std::span<const PairConnection> connections,
                     std::vector<std::vector<JointLine>>& by_match)>
      network;
};

/// The 3D lines of matched image segments of a stereo pair (Ok et al. 2011, section 3), in the order
/// of the matches: not_aligned lines by intersection of the projection planes, aligned ones, with
/// Method::kJoint, by adjustment of these planes and the best artificial points made with the lines
/// that they have a pair connection with; with Method::kNetwork all of them adjusted together
/// (adjust_network()) from there. Of a left segment with several mates each line gets the part
/// that its mate shows. One line per match, or several of an aligned one that
/// agree_on_depth() finds to show several.
///
/// @param matched  its cameras are free of error. Registrations say what the images beside the edges tell of their places
///                 (compare_profiles()); the points of other lines are made with the segments as they are.
/// Results do not depend on the number of threads or the order of the connections.
/// Throws std::invalid_argument for other than two images, options out of range, an index out of
/// range, a connection of a match with itself, a matched segment without length or precision, registrations
/// of another number than the matches, one that is not finite, and Method::kNetwork without its extension.
std::vector<ReconstructedLine> reconstruct_lines(const MatchedSegments& matched,
                                                 const ReconstructOptions& options = {},
                                                 const EstimateExtensions& beyond = {});

}  // namespace ridgeline::reconstruct
