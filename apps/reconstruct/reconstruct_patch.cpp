// SPDX-License-Identifier: BSD-3-Clause
#include "apps/reconstruct/reconstruct_patch.h"

#include "apps/common/patch_views.h"
#include "reconstruct/estimate/reconstruct_lines.h"
#include "reconstruct/match/connect_matches.h"

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

io::LineSet line_set_of(std::span<const reconstruct::ReconstructedLine> lines,
                        const std::array<std::vector<UncertainSegment2>, 2>& segments,
                        const LocalFrame& frame,
                        const io::Crs& crs,
                        const std::string& method) {
  io::LineSet set;
  set.crs = crs;
  set.lines.reserve(lines.size());
  for (const reconstruct::ReconstructedLine& line : lines) {
    const auto left = static_cast<std::size_t>(line.match.left);
    const auto right = static_cast<std::size_t>(line.match.right);
    io::Line& out = set.lines.emplace_back();
    out.id = std::to_string(set.lines.size() - 1);
    out.segment_in_world = in_world(line.segment_in_local, frame);
    out.method = method;
    out.line_class = reconstruct::name(line.line_class);
    out.status = reconstruct::name(line.status);
    out.epipolar_angle_deg = line.epipolar_angle_rad * 180.0 / std::numbers::pi;
    out.left_id = std::to_string(left);
    out.right_id = std::to_string(right);
    out.left_px = segments[0][left].segment;
    out.right_px = segments[1][right].segment;
    out.n_points = static_cast<int>(line.points.size());
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
                              const reconstruct::ReconstructOptions& options,
                              const reconstruct::MatchOptions& match_options) {
  const LocalFrame frame = patch_frame(patch);
  const std::array<ProjectionMatrix, 2> cameras = patch_cameras(patch, frame);
  const std::array<std::vector<UncertainSegment2>, 2> geometry{geometry_of(segments[0]),
                                                               geometry_of(segments[1])};
  const std::vector<PairConnection> connections =
      reconstruct::connect_matches(segments[0], segments[1], matches, cameras, match_options);
  reconstruct::ReconstructOptions in_patch = options;
  const auto [lowest_m, highest_m] = patch_heights_m(patch, frame);
  in_patch.lowest_height_m = lowest_m;
  in_patch.highest_height_m = highest_m;
  return line_set_of(
      reconstruct::reconstruct_lines(cameras, geometry, matches, connections, in_patch), geometry,
      frame, patch.crs, reconstruct::name(options.method));
}

}  // namespace ridgeline::apps
