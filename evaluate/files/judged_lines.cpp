// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judged_lines.h"

#include "io/error.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/faces/face_geometry.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::ImageObservation;
using evaluate::JudgedLine;

Segment3 metric_segment(const io::Line& line, const Eigen::Vector3d& unit_m) {
  return {line.segment_in_world.start.cwiseProduct(unit_m),
          line.segment_in_world.end.cwiseProduct(unit_m)};
}

std::string class_of(const io::Line& line,
                     std::optional<double> epipolar_angle_deg,
                     double max_aligned_angle_deg) {
  if (!line.line_class.empty()) return line.line_class;
  if (!epipolar_angle_deg) return "all";
  return *epipolar_angle_deg <= max_aligned_angle_deg ? "aligned" : "not_aligned";
}

/// The segments of a line in the images of the patch.
std::vector<ImageObservation> seen_segments(const io::Line& line,
                                            const LocalFrame& frame,
                                            const io::Patch& patch) {
  std::vector<ImageObservation> seen;
  for (const io::LineObservation& s : observations_of(line, patch.images)) {
    const auto image = std::ranges::find(patch.images, s.image, &io::PatchImage::id);
    if (image == patch.images.end()) continue;
    seen.push_back({image_from_local(image->image_from_world, frame.origin_m), s.px});
  }
  return seen;
}

/// How well two images determine the position of a line: the extent of its segments across the
/// epipolar lines, pixels.
double across_epipolar_px(const ImageObservation& a, const ImageObservation& b) {
  if (a.image_from_local == b.image_from_local) return -1.0;
  const std::array cameras{a.image_from_local, b.image_from_local};
  return std::sin(epipolar_angle_rad(cameras, a.px, b.px)) * std::min(length(a.px), length(b.px));
}

/// The image segments stored with a line: that of its first image, then that of the image that,
/// together with the first, best determines the position of the line, then the others.
std::optional<evaluate::ImageEvidence> evidence_of(const io::Line& line,
                                                   const LocalFrame& frame,
                                                   const std::optional<io::Patch>& patch) {
  if (!patch) return std::nullopt;
  std::vector<ImageObservation> seen = seen_segments(line, frame, *patch);
  if (seen.size() < 2) return std::nullopt;
  const auto other = std::ranges::max_element(
      seen.begin() + 1, seen.end(), {},
      [&](const ImageObservation& s) { return across_epipolar_px(seen[0], s); });
  if (other->image_from_local == seen[0].image_from_local) return std::nullopt;
  std::rotate(seen.begin() + 1, other, other + 1);
  return evaluate::ImageEvidence{{std::move(seen)}, io::heights_in_local_m(*patch, frame)};
}

JudgedLine judged_line(const io::Line& line,
                       const Eigen::Vector3d& unit_m,
                       const LocalFrame& frame,
                       const std::optional<io::Patch>& patch,
                       const std::vector<ProjectionMatrix>& cameras,
                       double max_aligned_angle_deg) {
  JudgedLine judged;
  judged.id = line.id;
  judged.segment = segment_in_local(line, unit_m, frame);
  judged.building = line.building;
  judged.covariance_m2 = line.covariance_m2;
  judged.images = evidence_of(line, frame, patch);
  judged.reconstructed = line.status != "not_reconstructed" && line.status != "no_intersection" &&
                         line.status != "ambiguous_depth";
  judged.confirmed = line.status != "unconfirmed";
  judged.n_images = line.n_images;
  judged.class_base = line.class_base;
  judged.epipolar_angle_deg = line.epipolar_angle_deg;
  if (!judged.epipolar_angle_deg && cameras.size() >= 2 && evaluate::in_range(judged.segment)) {
    judged.epipolar_angle_deg =
        deg_from_rad(epipolar_angle_rad(cameras, metric_segment(line, unit_m)));
  }
  judged.line_class = class_of(line, judged.epipolar_angle_deg, max_aligned_angle_deg);
  return judged;
}

/// The inward direction, in plan, of the only roof face at an edge.
std::optional<Eigen::Vector2d> inside_of_border(const io::Line& line,
                                                const io::BuildingModel& model) {
  if (line.plane_ids.size() != 1) return std::nullopt;
  const Face& face = model.faces[static_cast<std::size_t>(line.plane_ids[0])];
  const auto inward = inward_of(face, *plane_of(face), line.segment_in_world);
  if (!inward || inward->head<2>().isZero()) return std::nullopt;
  return inward->head<2>().normalized();
}

std::vector<ProjectionMatrix> cameras_of(const std::optional<io::Patch>& patch) {
  std::vector<ProjectionMatrix> cameras;
  if (!patch) return cameras;
  for (const auto& image : patch->images) cameras.push_back(image.image_from_world);
  return cameras;
}

std::vector<Segment3> finite_segments(const std::vector<JudgedLine>& lines) {
  std::vector<Segment3> segments;
  for (const JudgedLine& line : lines) {
    if (line.reconstructed && evaluate::in_range(line.segment)) segments.push_back(line.segment);
  }
  return segments;
}

std::vector<Segment3> segments_of(const std::vector<evaluate::ReferenceLine>& references) {
  return transformed(references, [&](const evaluate::ReferenceLine& line) { return line.segment; });
}

}  // namespace

std::vector<io::LineObservation> observations_of(const io::Line& line,
                                                 const std::vector<io::PatchImage>& images) {
  if (!line.observations.empty() || !line.base_px || !line.other_px) return line.observations;
  return {{images[0].id, *line.base_px}, {images[1].id, *line.other_px}};
}

Eigen::Vector3d unit_m_of(const io::LineSet& set) {
  const io::CrsFacts crs = io::describe(set.crs);
  const Eigen::Vector3d unit_m =
      set.unit_m && !set.crs.known()
          ? *set.unit_m
          : Eigen::Vector3d(crs.horizontal_unit_m, crs.horizontal_unit_m, crs.vertical_unit_m);
  return unit_m.cwiseQuotient(Eigen::Vector3d(set.plan_scale.x(), set.plan_scale.y(), 1.0));
}

Segment3 segment_in_local(const io::Line& line,
                          const Eigen::Vector3d& unit_m,
                          const LocalFrame& frame) {
  const Segment3 in_world = metric_segment(line, unit_m);
  return {frame.local_from_world(in_world.start), frame.local_from_world(in_world.end)};
}

io::LineSet in_metres(io::LineSet set) {
  const Eigen::Vector3d unit_m = unit_m_of(set);
  for (io::Line& line : set.lines) line.segment_in_world = metric_segment(line, unit_m);
  set.crs = {};
  set.unit_m.reset();
  set.plan_scale.setOnes();
  return set;
}

std::vector<JudgedLine> judged_lines_of(const io::LineSet& set,
                                        const LocalFrame& frame,
                                        const std::optional<io::Patch>& patch,
                                        double max_aligned_angle_deg) {
  const std::vector<ProjectionMatrix> cameras = cameras_of(patch);
  const Eigen::Vector3d unit_m = unit_m_of(set);
  return transformed(set.lines, [&](const io::Line& line) {
    JudgedLine judged = judged_line(line, unit_m, frame, patch, cameras, max_aligned_angle_deg);
    if (set.model) judged.inside = inside_of_border(line, *set.model);
    return judged;
  });
}

std::vector<JudgedLine> moved(std::vector<JudgedLine> lines, const Eigen::Vector3d& by_m) {
  for (JudgedLine& line : lines) {
    line.segment = {line.segment.start + by_m, line.segment.end + by_m};
    if (!line.images) continue;
    for (ImageObservation& seen : line.images->observations) {
      seen.image_from_local = image_from_local(seen.image_from_local, -by_m);
    }
    for (double& height_m : line.images->height_range_m) height_m += by_m.z();
  }
  return lines;
}

io::LineSet moved(io::LineSet set, const Eigen::Vector3d& by_m) {
  const Eigen::Vector3d by = by_m.cwiseQuotient(unit_m_of(set));
  for (io::Line& line : set.lines) {
    line.segment_in_world = {line.segment_in_world.start + by, line.segment_in_world.end + by};
  }
  return set;
}

std::vector<evaluate::ReferenceLine> reference_lines_of(const io::LineSet& set,
                                                        const LocalFrame& frame) {
  const Eigen::Vector3d unit_m = unit_m_of(set);
  std::vector<evaluate::ReferenceLine> references;
  for (const io::Line& line : set.lines) {
    const Segment3 in_local = segment_in_local(line, unit_m, frame);
    if (!all_finite(in_local)) continue;
    if (!evaluate::in_range(in_local)) {
      throw io::IoError(set.path, fmt::format("reference line {} has a coordinate more than 10,000 "
                                              "km from the cloud; correct or remove it",
                                              line.id));
    }
    const double visible =
        std::min(line.visible_base.value_or(1.0), line.visible_other.value_or(1.0));
    references.push_back({in_local, line.kind, visible});
  }
  if (references.empty()) {
    throw io::IoError(set.path,
                      "has no reference lines; give a file of 3D lines, or of polygons with "
                      "heights, whose edges are used");
  }
  return references;
}

TruthRows compare_with_truth(
    const evaluate::Evaluation& evaluation,
    const std::vector<JudgedLine>& lines,
    const std::optional<std::vector<evaluate::ReferenceLine>>& references) {
  TruthRows rows;
  const auto add = [&](const char* reference, const auto& measures) {
    for (const evaluate::ToleranceMeasures& m : measures) {
      rows.tolerances.push_back({evaluation.patch, evaluation.method, reference, m});
    }
  };
  const evaluate::ToleranceOptions options;
  add("planes", evaluate::measure_against_planes(evaluation.lines, options));
  if (!references) return rows;
  add("lines",
      evaluate::measure_against_lines(finite_segments(lines), segments_of(*references), options));
  rows.references.push_back(
      {evaluation.patch, evaluation.method, evaluate::compare_with_references(lines, *references),
       evaluate::wireframe_scores(finite_segments(lines), segments_of(*references))});
  return rows;
}

}  // namespace ridgeline::results
