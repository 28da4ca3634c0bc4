// SPDX-License-Identifier: BSD-3-Clause
#include "apps/reconstruct/reconstruct_patch.h"

#include "apps/common/patch_views.h"
#include "reconstruct/estimate/reconstruct_lines.h"
#include "reconstruct/match/connect_matches.h"
#include "reconstruct/match/profile_registration.h"
#include "reconstruct/match/sample_flanks.h"

#include <fmt/format.h>

#include <limits>
#include <numbers>

namespace ridgeline::apps {
namespace {

Segment3 in_world(const std::optional<Segment3>& segment_in_local, const LocalFrame& frame) {
  if (!segment_in_local) {
    const Eigen::Vector3d none =
        Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return {none, none};
  }
  return {frame.world_from_local(segment_in_local->start),
          frame.world_from_local(segment_in_local->end)};
}

/// The number of the match; with that of the part where it shows several lines.
std::string line_id(std::size_t match, int part) {
  return part == 0 ? std::to_string(match) : fmt::format("{}.{}", match, part);
}

io::LineSet line_set_of(std::span<const reconstruct::ReconstructedLine> lines,
                        const LocalFrame& frame,
                        const io::Crs& crs,
                        const std::string& method) {
  io::LineSet set;
  set.crs = crs;
  set.lines.reserve(lines.size());
  std::size_t num_matches = 0;
  for (const reconstruct::ReconstructedLine& line : lines) {
    if (line.part <= 1) ++num_matches;
    io::Line& out = set.lines.emplace_back();
    out.id = line_id(num_matches - 1, line.part);
    out.segment_in_world = in_world(line.segment_in_local, frame);
    out.method = method;
    out.line_class = reconstruct::name(line.line_class);
    out.status = reconstruct::name(line.status);
    out.epipolar_angle_deg = line.epipolar_angle_rad * 180.0 / std::numbers::pi;
    out.left_id = std::to_string(line.match.left);
    out.right_id = std::to_string(line.match.right);
    out.left_px = line.seen_px[0];
    out.right_px = line.seen_px[1];
    out.n_points = static_cast<int>(line.points.size()) + line.n_meetings;
    out.n_images = 2;
    out.covariance_m2 = line.covariance_m2;
  }
  return set;
}

/// All that an estimation needs.
std::vector<UncertainSegment2> geometry_of(const std::vector<EdgeSegment>& segments) {
  std::vector<UncertainSegment2> geometry;
  geometry.reserve(segments.size());
  for (const EdgeSegment& segment : segments) geometry.push_back(segment.line);
  return geometry;
}

}  // namespace

io::LineSet reconstruct_patch(const io::PatchFile& patch,
                              const std::array<std::vector<EdgeSegment>, 2>& segments,
                              const std::vector<LineMatch>& matches,
                              const std::array<cv::Mat, 2>& images,
                              const reconstruct::ReconstructOptions& options,
                              const reconstruct::MatchOptions& match_options) {
  const LocalFrame frame = patch_frame(patch);
  const std::array<ProjectionMatrix, 2> cameras = patch_cameras(patch, frame);
  const std::array<std::vector<UncertainSegment2>, 2> geometry{geometry_of(segments[0]),
                                                               geometry_of(segments[1])};
  const std::array<double, 2> heights_m = patch_heights_m(patch, frame);
  const std::vector<PairConnection> connections = reconstruct::connect_matches(
      segments[0], segments[1], matches, cameras, heights_m, match_options);
  reconstruct::ReconstructOptions in_patch = options;
  in_patch.lowest_height_m = heights_m[0];
  in_patch.highest_height_m = heights_m[1];
  std::vector<reconstruct::FlankStrips> strips;
  // only the consensus on depth hears them
  if (options.flanks && options.consensus && options.method != reconstruct::Method::kDirect) {
    strips = reconstruct::sample_flanks(cameras, images, segments, matches, heights_m,
                                        options.max_aligned_angle_deg);
  }
  std::vector<double> right_shifts_px;
  if (options.register_profiles) {
    right_shifts_px = reconstruct::registered_shifts_px(cameras, images, segments, matches,
                                                        heights_m, options.max_aligned_angle_deg);
  }
  return line_set_of(reconstruct::reconstruct_lines(cameras, geometry, matches, connections,
                                                    in_patch, strips, right_shifts_px),
                     frame, patch.crs, reconstruct::name(options.method));
}

}  // namespace ridgeline::apps
