// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/polyline.h"

#include <limits>

namespace ridgeline::io {
namespace {

std::vector<Segment3> segments_of(const std::vector<Vertices>& parts) {
  std::vector<Segment3> segments;
  for (const Vertices& part : parts) {
    if (part.size() == 1) segments.push_back({part.front(), part.front()});
    for (std::size_t i = 1; i < part.size(); ++i) segments.push_back({part[i - 1], part[i]});
  }
  if (segments.empty()) {
    const Eigen::Vector3d nowhere =
        Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    segments.push_back({nowhere, nowhere});
  }
  return segments;
}

}  // namespace

void append_feature(const Line& attributes,
                    const std::vector<Vertices>& parts,
                    std::size_t number,
                    LineSet& set) {
  const std::vector<Segment3> segments = segments_of(parts);
  const std::string id = attributes.id.empty() ? std::to_string(number) : attributes.id;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Line line = attributes;
    line.segment_in_world = segments[i];
    line.id = segments.size() == 1 ? id : id + "." + std::to_string(i);
    if (segments.size() > 1) line.parent_id = id;
    set.lines.push_back(std::move(line));
  }
}

void append_segment(const Line& attributes,
                    const Segment3& segment_in_world,
                    std::size_t number,
                    LineSet& set) {
  append_feature(attributes, {{segment_in_world.start, segment_in_world.end}}, number, set);
}

}  // namespace ridgeline::io
