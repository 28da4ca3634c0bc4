// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/segment_plane.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/track.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// The outcome for a line. Every input line has exactly one status.
enum class Status : std::uint8_t {
  kEvaluated,
  kNoLidar,           ///< outside the cloud, or too few points in the corridor
  kNoPlane,           ///< there are points, but they contain no roof or ground plane
  kLowCoverage,       ///< no plane runs along enough of the line (half of it, by default)
  kAmbiguous,         ///< several candidate planes that the evidence cannot distinguish
  kNotReconstructed,  ///< the tool that produced the line gives no geometry for it
  kDegenerate,        ///< zero length, or vertical: no plan direction
  kTooShort,
  kNonFinite,
  kOutOfRange,  ///< in_range() is false, or the height is a marker for a missing height
  kDuplicateId,
  kUnconfirmed,  ///< its tool reports that further images should show it but do not
};
inline constexpr int kNumStatuses = 12;

/// The name of a status as used in the files: `evaluated`, `no_lidar`, ...
const char* name(Status status);

/// Step edge (one plane) or the intersection of two planes.
enum class Kind : std::uint8_t { kNone, kStep, kRidge };
const char* name(Kind kind);  ///< "" | "step" | "ridge"

/// The surface that a line is assumed to be an edge of.
enum class JudgingSurface : std::uint8_t {
  kUpper,   ///< the highest surface beside the line, or the only one
  kLower,   ///< a surface with a higher one beside the line
  kGround,  ///< a lower surface that is the lowest around, a storey below the highest
  kRidge,   ///< two surfaces that meet along the line: ridge, hip, valley
  kObject,  ///< an object for which the cloud has no plane
};
inline constexpr int kNumSurfaces = 5;
const char* name(JudgingSurface surface);  ///< "upper" | "lower" | "ground" | "ridge" | "object"

/// The evidence without which the decision about the surface would have remained open.
enum class DecidedBy : std::uint8_t {
  kPlan,    ///< borders, sides and coverage in plan
  kImages,  ///< the line's segments in the images
  kPoints,  ///< points along the line that no plane explains
  kPlace,   ///< the line's own height
};
inline constexpr int kNumDecidedBy = 4;
const char* name(DecidedBy evidence);  ///< "plan" | "images" | "points" | "place"

/// The name of a surface or of the evidence; "" if it is unknown.
template <typename Named>
const char* name(const std::optional<Named>& value) {
  return value ? name(*value) : "";
}

/// The segment of a line observed in one image.
struct ImageObservation {
  ProjectionMatrix image_from_local;
  Segment2 px;  ///< ideal pixels
};

/// The image segments from which a line was made. Independently of the method that made it, they
/// show where its edge lies in plan and which plane the edge belongs to.
struct ImageEvidence : TrackOf<ImageObservation> {
  std::array<double, 2> height_range_m{};  ///< lowest and highest object height, local
};

/// Whether both ends lie within 10,000 km of the local origin in x, y and z. A line farther away is
/// an error in the file; its length may not even be finite.
bool in_range(const Segment3& segment_in_local);

/// A line is `out_of_range` if both ends have exactly the same height and lie more than this above
/// or below all points around the line. Such a height was not measured: it is a marker for a
/// missing height (0, -9999). A tool's error may be as large, but it does not give both ends the
/// same height.
inline constexpr double kMaxHeightOffset_m = 100.0;

/// A line to be judged. Local frame, metres.
struct JudgedLine {
  std::string id;
  Segment3 segment;
  std::string line_class = "all";  ///< aligned | not_aligned | all | a class from the file
  std::string class_base;          ///< class from the base pair only, if given in the file
  std::string building;  ///< cluster for the bootstrap; if empty, shared planes form the clusters
  std::optional<double> epipolar_angle_deg;
  /// Covariance of (start, end), m^2, world axes.
  std::optional<Eigen::Matrix<double, 6, 6>> covariance_m2;
  /// If the line is the border of a single surface and its file says on which side: direction in
  /// plan towards the inside, where the surface's plane lies.
  std::optional<Eigen::Vector2d> inside = {};
  std::optional<ImageEvidence> images =
      {};                       ///< if empty, the line's own plan view is its footprint
  bool reconstructed = true;    ///< if false, the status is not_reconstructed
  bool confirmed = true;        ///< if false, the status is unconfirmed
  bool repeats_id = false;      ///< an earlier line, which may not be judged here, has the same id
  std::optional<int> n_images;  ///< number of supporting images, if given in the file
};

/// Points of a plane that a plane of an earlier line already contained.
struct SharedPoints {
  std::size_t line = 0;   ///< number of that line
  std::size_t plane = 0;  ///< index among the planes of that line
  std::size_t n = 0;
};

/// How many points a plane was fitted to, and which of them it shares; see find_shared_points().
struct PlanePoints {
  std::size_t n = 0;
  std::vector<SharedPoints> shared;
};

/// A LIDAR plane chosen for a line.
struct JudgingPlane {
  Plane3 plane{Eigen::Vector3d::UnitZ(), 0.0};  ///< local frame, normal upwards
  int n_inliers = 0;
  double rms_m = 0.0;            ///< of the inliers' orthogonal distances
  double coverage = 0.0;         ///< share of the line that has inliers beside it, 0..1
  double extrapolation_m = 0.0;  ///< largest distance in plan from the line to the inliers' hull
  double sigma_m = 0.0;          ///< of the plane, at the line's midpoint; see plane_sigma_m()
  double sigma_random_m = 0.0;   ///< sigma_m if the points' errors were independent
  SegmentPlaneDistance distance;
  std::uint64_t id = 0;  ///< the same id for the same plane: lines that share a plane are dependent
  PlanePoints points = {};
};

/// How far a line lies from the intersection of its two planes; see ridge_displacement().
struct RidgeDisplacement {
  double horizontal_m = 0.0;  ///< across the line in plan, positive towards larger x
  double vertical_m = 0.0;    ///< positive if the line is too high
  Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Zero();  ///< of (horizontal, vertical)
};

/// The judgement of one line. The planes, and all fields from `mean_distance_m` on, exist only for
/// status `evaluated`.
struct LineEvaluation {
  std::string id;
  std::string line_class;
  std::string building;
  Status status = Status::kNoLidar;
  Kind kind = Kind::kNone;
  /// What the line is most probably, and second most probably, an edge of; empty if no surface was
  /// searched for.
  std::optional<JudgingSurface> surface, surface_other;
  std::optional<DecidedBy> decided_by;        ///< only for lines that are `evaluated`
  std::optional<double> surface_probability;  ///< of `surface`
  std::string reason;                         ///< one sentence for a status other than `evaluated`
  std::vector<std::string> flags;             ///< merged
  std::vector<JudgingPlane> planes;           ///< one (step) or two (ridge)
  double length_m = 0.0;                      ///< 0 unless the line is in_range()
  std::optional<double> epipolar_angle_deg;
  std::optional<int> n_images;  ///< number of supporting images, if given in the file
  std::string class_base;       ///< class from the base pair only, if given in the file
  /// The position used to pair lines in space. Local; empty for lines that are not in range.
  std::optional<Segment3> segment;

  /// Mean over the planes of the mean |distance| (Ok et al. 2011).
  std::optional<double> mean_distance_m;
  std::optional<double> max_distance_m;
  std::optional<double> signed_mean_m;  ///< mean over the planes of the signed mean distance
  std::optional<double> sigma_plane_m;  ///< of the mean distance, from the plane(s) at the midpoint
  /// Standard deviation of the line's midpoint along the plane's normal (mean of two planes), from
  /// covariance_m2.
  std::optional<double> sigma_line_m;
  std::optional<double> z;  ///< signed midpoint distance / sqrt(sigma_line^2 + sigma_plane^2)
  /// Ridge only: distance and angle between the line and the intersection line of the planes.
  std::optional<double> intersection_distance_m, intersection_angle_deg;
  std::optional<RidgeDisplacement> displacement;  ///< ridge only
  /// Step only: the height error if the whole distance were vertical, signed mean / n_z. A single
  /// plane cannot separate the horizontal and vertical parts of an error.
  std::optional<double> height_if_vertical_m;
};

}  // namespace ridgeline::evaluate
