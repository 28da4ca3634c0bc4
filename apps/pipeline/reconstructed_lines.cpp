// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/reconstructed_lines.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

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

/// Whether the line comes from a match of two edges rather than from the intersection of two
/// planes.
bool is_of_match(const reconstruct::ReconstructedLine& line) { return line.base().segment >= 0; }

/// The number of the match, "17"; followed by that of the part, "17.2", if the match shows several
/// lines. For an intersection of planes, `p` and a number.
std::string line_id(const reconstruct::ReconstructedLine& line, std::size_t number) {
  if (!is_of_match(line)) return fmt::format("p{}", number);
  return line.part == 0 ? std::to_string(number) : fmt::format("{}.{}", number, line.part);
}

/// Sets the ids and positions of the line in the base pair, i.e. the first two images of the patch.
void set_pair(const reconstruct::ReconstructedLine& line, io::Line& out) {
  for (const auto& [view, id, px] :
       {std::tuple(0U, &out.base_id, &out.base_px), std::tuple(1U, &out.other_id, &out.other_px)}) {
    const auto seen = std::ranges::find_if(
        line.observations, [&, v = view](const ObservedSegment& s) { return s.view == v; });
    if (seen == line.observations.end()) continue;
    *px = seen->px;
    if (is_of_match(line)) *id = std::to_string(seen->segment);
  }
}

/// The class according to the cameras of the base pair, i.e. the first two views: from the segments
/// in these views, else from the line in space; empty if there is neither.
std::string class_by_base_pair(const reconstruct::ReconstructedLine& line,
                               const reconstruct::Scene& scene,
                               const io::Line& out,
                               double max_aligned_angle_deg) {
  const std::array<ProjectionMatrix, 2> cameras{scene.views[0].image_from_local,
                                                scene.views[1].image_from_local};
  std::optional<double> angle_rad;
  if (out.base_px && out.other_px) {
    angle_rad = epipolar_angle_rad(cameras, *out.base_px, *out.other_px);
  } else if (line.segment_in_local) {
    angle_rad = epipolar_angle_rad(cameras, *line.segment_in_local);
  }
  if (!angle_rad) return "";
  return name(*angle_rad / kRadPerDeg <= max_aligned_angle_deg
                  ? reconstruct::LineClass::kAligned
                  : reconstruct::LineClass::kNotAligned);
}

int n_images(const reconstruct::ReconstructedLine& line) {
  std::set<std::size_t> views;
  for (const ObservedSegment& seen : line.observations) views.insert(seen.view);
  return static_cast<int>(views.size());
}

}  // namespace

io::LineSet line_set_of(std::span<const reconstruct::ReconstructedLine> lines,
                        const reconstruct::Scene& scene,
                        const io::Crs& crs,
                        reconstruct::Method method,
                        double max_aligned_angle_deg) {
  io::LineSet set;
  set.crs = crs;
  set.lines.reserve(lines.size());
  std::size_t num_matches = 0;
  std::size_t num_of_planes = 0;
  for (const reconstruct::ReconstructedLine& line : lines) {
    std::size_t& num_of_kind = is_of_match(line) ? num_matches : num_of_planes;
    if (line.part <= 1) ++num_of_kind;
    io::Line& out = set.lines.emplace_back();
    out.id = line_id(line, num_of_kind - 1);
    out.segment_in_world = in_world(line.segment_in_local, scene.frame);
    out.method = reconstruct::name(method);
    out.line_class = reconstruct::name(line.line_class);
    out.status = reconstruct::status_name(line);
    out.epipolar_angle_deg = deg_from_rad(line.epipolar_angle_rad);
    set_pair(line, out);
    if (scene.views.size() > 2) {
      out.class_base = class_by_base_pair(line, scene, out, max_aligned_angle_deg);
      out.observations = transformed(line.observations, [&](const ObservedSegment& seen) {
        return io::LineObservation{scene.views[seen.view].id, seen.px};
      });
    }
    out.n_points = static_cast<int>(line.points.size()) + line.n_meetings;
    out.n_images = n_images(line);
    out.covariance_m2 = line.covariance_m2;
  }
  return set;
}

}  // namespace ridgeline::apps
