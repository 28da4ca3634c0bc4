// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/ok2011/line_support.h"
#include "reconstruct/estimate/ok2011/options.h"
#include "reconstruct/estimate/ok2011/point_weight.h"
#include "reconstruct/estimate/tracked_lines.h"
#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/pluecker.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Whether a line is aligned with the epipolar lines of all pairs of its views. This is a property
/// of the track, the same for all methods.
enum class LineClass : std::uint8_t { kNotAligned, kAligned };
const char* name(LineClass line_class);  ///< "not_aligned" | "aligned"

/// How a line was determined.
enum class Determination : std::uint8_t {
  kDirect,         ///< intersection of the projection planes
  kJoint,          ///< planes and two or three points, and horizontality if the points agree on it
  kOnePoint,       ///< planes and one point: the direction still depends on the planes alone
  kSurface,        ///< points fix no direction; the surface beside the line does
  kSegmentEnds,    ///< points fix no direction; ends of both segments assumed to coincide
  kHorizontal,     ///< points fix no direction; the line is assumed to be horizontal
  kNoPoints,       ///< `joint` without a usable point: identical to `direct`
  kRankDeficient,  ///< planes and points leave a direction free: one of many lines, no covariance
  /// The adjustment had not converged after its last pass; the line is the result of that pass.
  kNotConverged,
  kNetwork,  ///< adjusted together with all lines that it meets
  kPlanes,   ///< intersection of two surfaces where no edge was matched
};

/// Why a line has no segment in space.
enum class Failure : std::uint8_t {
  kAmbiguousDepth,  ///< no depth explains the line clearly better than another
  kNoIntersection,  ///< coincident planes, or a line at infinity or behind a camera
};

/// An artificial point that entered the adjustment.
struct UsedPoint {
  Eigen::Vector3d x_in_local;  ///< m
  Eigen::Matrix3d cov_m2;      ///< world axes
  int neighbour = 0;           ///< index of the other track of the point
  double weight = 0.0;         ///< W of Eq. 6
  /// Omega of the point's estimation, chi-square with 1 degree of freedom.
  double omega = 0.0;
  Region region = Region::kLeft;
};

/// A line with its observations in the order of the track; those of an intersection of surfaces
/// have segment -1.
struct ReconstructedLine : TrackOf<ObservedSegment> {
  /// Number of the part, counted from the start of the base segment, if the track was cut into
  /// several lines (agree_on_depth()); 0 for a whole track.
  int part = 0;
  int n_meetings = 0;  ///< number of other lines that it meets, accepted by `network`
  LineClass line_class = LineClass::kNotAligned;
  Determination determination = Determination::kDirect;  ///< of a line with a segment
  std::optional<Failure> failure = Failure::kNoIntersection;
  /// False: two views show the line, and a further one that should show it does not.
  bool confirmed = true;
  /// The largest angle over all pairs of its observations; for each pair, the smaller angle of the
  /// two images.
  double epipolar_angle_rad = 0.0;
  /// The line in m, as assign_geometry() chooses its ends.
  std::optional<Segment3> segment_in_local;
  std::optional<Matrix6d> covariance_m2;           ///< of (start, end), world axes
  std::optional<Segment3> other_segment_in_local;  ///< the same line between the ends of other()
  /// The larger height sigma of the two endpoints by `direct`, whatever the method. It identifies
  /// weak lines by precision, as the class does by angle. Empty without an intersection.
  std::optional<double> direct_sigma_z_m;
  std::vector<UsedPoint> points;
  /// Sum of squared normalised misclosures of the adjustment; 0 for `direct`. For `network` only
  /// the conditions of the line's own images count.
  double omega = 0.0;
};

/// The status of a line as in the files: its failure, "unconfirmed", or how it was determined
/// ("direct", "one_point", ...).
const char* status_name(const ReconstructedLine& line);

/// A line by `joint` with its support in addition to its planes.
struct JointLine {
  ReconstructedLine line;
  LineSupport support;
};

/// Gives the lines of an aligned track, mostly one, with the support of each.
using SupportOfTrack = std::function<std::vector<LineSupport>(const ObservedTrack& line,
                                                              std::span<const int> neighbours)>;

/// Hooks for extensions of the estimation beyond the paper. Each may be empty.
struct EstimateExtensions {
  bool common_part = false;  ///< see TrackedLines::common_part
  /// Gives the support of aligned lines instead of published_support(), from all lines and the
  /// lines by `direct`.
  std::function<SupportOfTrack(const TrackedLines& lines,
                               std::span<const ReconstructedLine> direct)>
      support;
  /// For Method::kNetwork: jointly adjusts the lines of `joint`, given by track. `lines` have
  /// covariances of the centroid form.
  std::function<void(const TrackedLines& lines,
                     std::span<const PairConnection> connections,
                     std::vector<std::vector<JointLine>>& by_track)>
      network;
};

/// The 3D lines of tracks of image segments (Ok et al. 2011, section 3), in the order of the
/// tracks. A not_aligned line is the intersection of the projection planes, or is adjusted to those
/// of three or more observations. With Method::kJoint, an aligned line is adjusted to these planes
/// and to the best artificial points formed with the lines to which it has a pair connection. With
/// Method::kNetwork, all these lines are then adjusted together (adjust_network()). If a base
/// segment belongs to several tracks, each line gets the part that the other segment shows. There
/// is one line per track, or several for an aligned track that shows several lines by
/// agree_on_depth().
///
/// @param tracked  its cameras are assumed to be free of error; its registrations correct the
///                 positions of the segments (compare_profiles()), but artificial points use the
///                 neighbouring lines as extracted
/// Results do not depend on the number of threads or the order of the connections. Throws
/// std::invalid_argument for fewer than two images, options out of range, an index out of range, a
/// track that does not begin with two views, a connection of a track with itself, a segment without
/// length or precision, registrations that are not finite or not one per observation, and
/// Method::kNetwork without its extension.
std::vector<ReconstructedLine> reconstruct_lines(const TrackedSegments& tracked,
                                                 const ReconstructOptions& options = {},
                                                 const EstimateExtensions& beyond = {});

}  // namespace ridgeline::reconstruct
