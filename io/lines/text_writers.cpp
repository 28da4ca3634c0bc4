// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/attributes.h"
#include "io/lines/writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

/// A field according to RFC 4180, quoted if it contains a separator, a quote or a line end.
std::string field(std::string_view text) {
  if (text.find_first_of(",;\t\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + "\"";
}

std::string attribute_header() {
  std::string header;
  for (const TextAttribute& attribute : text_attributes()) {
    header += fmt::format(",{}", attribute.name);
  }
  for (const NumberAttribute& attribute : number_attributes()) {
    header += fmt::format(",{}", attribute.name);
  }
  for (const SegmentAttribute& attribute : segment_attributes()) {
    header += fmt::format(",{}", attribute.name);
  }
  return header + ",epipolar_angle_deg,n_points,n_images,plane_ids,covariance\n";
}

template <typename T>
std::string optional_field(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::string attribute_fields(const Line& line) {
  std::string row;
  const auto add = [&row](std::string_view text) { row += fmt::format(",{}", field(text)); };
  for (const TextAttribute& attribute : text_attributes()) add(line.*attribute.member);
  for (const NumberAttribute& attribute : number_attributes()) {
    add(optional_field(line.*attribute.member));
  }
  for (const SegmentAttribute& attribute : segment_attributes()) {
    const std::optional<Segment2>& segment = line.*attribute.member;
    add(segment ? segment_text(*segment) : std::string());
  }
  add(optional_field(line.epipolar_angle_deg));
  add(optional_field(line.n_points));
  add(optional_field(line.n_images));
  add(line.plane_ids.empty() ? std::string() : fmt::format("[{}]", fmt::join(line.plane_ids, ",")));
  add(line.covariance_m2 ? covariance_text(*line.covariance_m2) : std::string());
  return row + "\n";
}

std::string coordinates(const Eigen::Vector3d& x, char separator) {
  return fmt::format("{:.4f}{}{:.4f}{}{:.4f}", x.x(), separator, x.y(), separator, x.z());
}

std::string wkt(const Segment3& s) {
  if (!all_finite(s)) return {};
  return fmt::format("\"LINESTRING Z ({},{})\"", coordinates(s.start, ' '),
                     coordinates(s.end, ' '));
}

/// What a mesh file cannot otherwise state, as comments of one line each.
std::vector<std::string> facts(const LineSet& set, const Eigen::Vector3d& origin) {
  std::vector<std::string> facts;
  if (set.crs.known()) {
    std::string definition = set.crs.definition;
    std::ranges::replace_if(
        definition, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    facts.push_back("crs " + definition);
  }
  if (!origin.isZero(0.0)) {
    facts.push_back(fmt::format("origin {:.0f} {:.0f} {:.0f}, to be added to the coordinates",
                                origin.x(), origin.y(), origin.z()));
  }
  return facts;
}

}  // namespace

std::string csv_text(const LineSet& set) {
  std::string text = "x1,y1,z1,x2,y2,z2" + attribute_header();
  for (const Line& line : set.lines) {
    text += coordinates(line.segment_in_world.start, ',') + "," +
            coordinates(line.segment_in_world.end, ',') + attribute_fields(line);
  }
  return text;
}

std::string wkt_csv_text(const LineSet& set) {
  std::string text = "wkt" + attribute_header();
  for (const Line& line : set.lines) text += wkt(line.segment_in_world) + attribute_fields(line);
  return text;
}

std::string obj_text(const LineSet& set, const Eigen::Vector3d& origin) {
  std::string text = "# 3D line segments, metres\n";
  for (const std::string& fact : facts(set, origin)) text += fmt::format("# {}\n", fact);
  for (const Line& line : set.lines) {
    const Segment3& s = line.segment_in_world;
    text += fmt::format("v {}\nv {}\n", coordinates(s.start - origin, ' '),
                        coordinates(s.end - origin, ' '));
  }
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    text += fmt::format("l {} {}\n", 2 * i + 1, 2 * i + 2);
  }
  return text;
}

std::string ply_text(const LineSet& set, const Eigen::Vector3d& origin) {
  const std::size_t n = set.lines.size();
  std::string text = "ply\nformat ascii 1.0\ncomment 3D line segments, metres\n";
  for (const std::string& fact : facts(set, origin)) text += fmt::format("comment {}\n", fact);
  text += fmt::format(
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element edge {}\nproperty int vertex1\nproperty int vertex2\nend_header\n",
      2 * n, n);
  for (const Line& line : set.lines) {
    text += coordinates(line.segment_in_world.start - origin, ' ') + "\n" +
            coordinates(line.segment_in_world.end - origin, ' ') + "\n";
  }
  for (std::size_t i = 0; i < n; ++i) text += fmt::format("{} {}\n", 2 * i, 2 * i + 1);
  return text;
}

}  // namespace ridgeline::io
