// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/line_facts.h"

#include "io/lines/attributes.h"

#include <algorithm>
#include <set>

namespace ridgeline::io {
namespace {

std::vector<std::string> attributes_of(const std::vector<Line>& lines) {
  std::vector<std::string> names;
  const auto add_if_any = [&](std::string_view name, auto&& has_it) {
    if (std::any_of(lines.begin(), lines.end(), has_it)) names.emplace_back(name);
  };
  for (const TextAttribute& attribute : text_attributes()) {
    add_if_any(attribute.name, [&](const Line& line) { return !(line.*attribute.member).empty(); });
  }
  for (const NumberAttribute& attribute : number_attributes()) {
    add_if_any(attribute.name,
               [&](const Line& line) { return (line.*attribute.member).has_value(); });
  }
  for (const SegmentAttribute& attribute : segment_attributes()) {
    add_if_any(attribute.name,
               [&](const Line& line) { return (line.*attribute.member).has_value(); });
  }
  add_if_any("observations", [](const Line& line) { return !line.observations.empty(); });
  add_if_any("epipolar_angle_deg",
             [](const Line& line) { return line.epipolar_angle_deg.has_value(); });
  add_if_any("n_points", [](const Line& line) { return line.n_points.has_value(); });
  add_if_any("n_images", [](const Line& line) { return line.n_images.has_value(); });
  add_if_any("plane_ids", [](const Line& line) { return !line.plane_ids.empty(); });
  add_if_any("covariance", [](const Line& line) { return line.covariance_m2.has_value(); });
  return names;
}

}  // namespace

LineFacts line_facts(const LineSet& set) {
  LineFacts facts;
  facts.n_lines = set.lines.size();
  std::set<std::string_view> polylines;
  for (const Line& line : set.lines) {
    if (!line.parent_id.empty()) polylines.insert(line.parent_id);
    if (!all_finite(line.segment_in_world)) {
      ++facts.n_non_finite;
      continue;
    }
    facts.total_length += length(line.segment_in_world);
    facts.bounds.extend(line.segment_in_world.start);
    facts.bounds.extend(line.segment_in_world.end);
  }
  facts.n_polylines = polylines.size();
  facts.attributes = attributes_of(set.lines);
  return facts;
}

CoordinateSteps steps_of(const LineSet& set, const Eigen::Vector3d& unit_m) {
  CoordinateSteps steps(unit_m);
  for (const Line& line : set.lines) {
    steps.add(line.segment_in_world.start);
    steps.add(line.segment_in_world.end);
  }
  return steps;
}

}  // namespace ridgeline::io
