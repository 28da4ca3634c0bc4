// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/polyline.h"

#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace ridgeline::io {
namespace {

/// The segments between the bends of the parts; counts the vertices that are not bends.
std::vector<Segment3> segments_of(const std::vector<Vertices>& parts, std::size_t& n_straight) {
  std::vector<Segment3> segments;
  for (const Vertices& part : parts) {
    const Vertices bends = bends_of(part);
    n_straight += part.size() - bends.size();
    if (bends.size() == 1) segments.push_back({bends.front(), bends.front()});
    for (std::size_t i = 1; i < bends.size(); ++i) segments.push_back({bends[i - 1], bends[i]});
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
         line.building.size() + line.status.size() + line.base_id.size() + line.other_id.size() +
         sizeof(int) * line.plane_ids.size();
}

[[noreturn]] void throw_out_of_memory(const LineSet& set) {
  throw IoError(set.path,
                "its lines need too much memory for a file of its size: vertices, edges or "
                "attributes are repeated over and over; store them once per line");
}

std::size_t bytes_of(const SparseRow& values) {
  std::size_t bytes = sizeof(SparseRow) + values.size() * sizeof(SparseRow::value_type);
  for (const auto& [column, value] : values) {
    if (const auto* const text = std::get_if<std::string>(&value)) bytes += text->size();
  }
  return bytes;
}

void take_memory(const Line& attributes,
                 const SparseRow& values,
                 std::size_t n_segments,
                 LineSet& set) {
  const std::size_t each = sizeof(Line) + 2 * text_bytes(attributes);
  const std::size_t once = bytes_of(values);
  constexpr std::size_t kMaxSegments = 1'000'000;
  if (once <= set.memory_left_bytes &&
      n_segments <= std::min(kMaxSegments, (set.memory_left_bytes - once) / each)) {
    set.memory_left_bytes -= once + n_segments * each;
    return;
  }
  if (n_segments > kMaxSegments) {
    throw IoError(set.path, fmt::format("a polyline has {} segments; the limit is {}", n_segments,
                                        kMaxSegments));
  }
  throw_out_of_memory(set);
}

}  // namespace

LineSet lines_for_file(const std::string& path, const std::string& format, std::size_t n_bytes) {
  constexpr std::size_t kMinMemory_bytes = 64U << 20U;
  constexpr std::size_t kMaxGrowth = 30;
  LineSet set;
  set.path = path;
  set.format = format;
  set.memory_left_bytes = std::max(kMinMemory_bytes, kMaxGrowth * n_bytes);
  // Memory is reserved at once, because growth would hold the lines twice. Pages that stay unused
  // cost no memory.
  constexpr std::size_t kMaxReserved_bytes = 512U << 20U;
  set.lines.reserve(std::min(set.memory_left_bytes, kMaxReserved_bytes) / sizeof(Line));
  return set;
}

void require_room(const LineSet& set, std::size_t n_lines) {
  if (n_lines > set.memory_left_bytes / sizeof(Line)) throw_out_of_memory(set);
}

void append_feature(const Line& attributes,
                    const std::vector<Vertices>& parts,
                    std::int64_t fid,
                    LineSet& set,
                    SparseRow values) {
  const std::vector<Segment3> segments = segments_of(parts, set.n_straight_vertices);
  take_memory(attributes, values, segments.size(), set);
  const std::string id = attributes.id.empty() ? std::to_string(fid) : attributes.id;
  const std::size_t row = set.features.rows.size();
  set.features.rows.push_back(std::move(values));
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Line line = attributes;
    line.segment_in_world = segments[i];
    line.id = segments.size() == 1 ? id : id + "." + std::to_string(i);
    if (segments.size() > 1) line.parent_id = id;
    line.source_fid = fid;
    line.part = static_cast<int>(i);
    line.row = row;
    set.lines.push_back(std::move(line));
  }
}

void append_segment(const Line& attributes,
                    const Segment3& segment_in_world,
                    std::size_t number,
                    LineSet& set) {
  append_feature(attributes, {{segment_in_world.start, segment_in_world.end}},
                 static_cast<std::int64_t>(number), set);
}

}  // namespace ridgeline::io
