// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/polyline.h"

#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
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

std::size_t text_bytes(const Line& line) {
  return line.id.size() + line.line_class.size() + line.method.size() + line.kind.size() +
         line.building.size() + line.status.size() + line.left_id.size() + line.right_id.size() +
         sizeof(int) * line.plane_ids.size();
}

[[noreturn]] void throw_out_of_memory(const LineSet& set) {
  throw IoError(set.path,
                "its lines take too much memory for a file of its size: vertices, edges or "
                "attributes are repeated over and over; lines of objects have their own");
}

void take_memory(const Line& attributes, std::size_t n_segments, LineSet& set) {
  const std::size_t each = sizeof(Line) + 2 * text_bytes(attributes);
  constexpr std::size_t kMostSegments = 1'000'000;
  if (n_segments <= std::min(kMostSegments, set.memory_left_bytes / each)) {
    set.memory_left_bytes -= n_segments * each;
    return;
  }
  if (n_segments > kMostSegments) {
    throw IoError(set.path, fmt::format("a polyline has {} segments; at most {} are read",
                                        n_segments, kMostSegments));
  }
  throw_out_of_memory(set);
}

}  // namespace

LineSet lines_for_file(const std::string& path, const std::string& format, std::size_t n_bytes) {
  constexpr std::size_t kLeast_bytes = 64U << 20U;
  constexpr std::size_t kMostGrowth = 28;
  LineSet set{.path = path, .format = format, .crs = {}, .lines = {}, .warnings = {}};
  set.memory_left_bytes = std::max(kLeast_bytes, kMostGrowth * n_bytes);
  // at once, as growth would hold them twice; pages that stay unused cost no memory
  constexpr std::size_t kMostReserved_bytes = 512U << 20U;
  set.lines.reserve(std::min(set.memory_left_bytes, kMostReserved_bytes) / sizeof(Line));
  return set;
}

void refuse_more_lines(const LineSet& set, std::size_t n_lines) {
  if (n_lines > set.memory_left_bytes / sizeof(Line)) throw_out_of_memory(set);
}

void append_feature(const Line& attributes,
                    const std::vector<Vertices>& parts,
                    std::size_t number,
                    LineSet& set) {
  const std::vector<Segment3> segments = segments_of(parts);
  take_memory(attributes, segments.size(), set);
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
