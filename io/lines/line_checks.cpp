// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/line_checks.h"

#include "io/error.h"
#include "io/lines/straight_vertices.h"
#include "io/lines/unique_ids.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace ridgeline::io {
namespace {

bool within_degrees(const Eigen::Vector3d& x) {
  return std::abs(x.x()) <= 180.0 && std::abs(x.y()) <= 90.0;
}

/// Whether the magnitude of the coordinates shows that they are degrees; false without lines.
bool looks_like_degrees(const LineSet& set) {
  constexpr double kMaxRoofLengthDeg = 0.01;
  std::vector<double> lengths;
  for (const Line& line : set.lines) {
    const Segment3& s = line.segment_in_world;
    if (!s.start.head<2>().allFinite() || !s.end.head<2>().allFinite()) continue;
    if (!within_degrees(s.start) || !within_degrees(s.end)) return false;
    lengths.push_back(length(plan(s)));
  }
  if (lengths.empty()) return false;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle > 0.0 && *middle < kMaxRoofLengthDeg;
}

bool has_nan(const Segment3& s) {
  return s.start.array().isNaN().any() || s.end.array().isNaN().any();
}

const LeftOutKind& kind_of_placeless(const Segment3& s) {
  if (s.start.array().isNaN().all() && s.end.array().isNaN().all()) return kinds::kNullGeometry;
  const bool has_plan = s.start.head<2>().allFinite() && s.end.head<2>().allFinite();
  return has_plan && has_nan(s) ? kinds::kFlatLine : kinds::kNonFiniteLine;
}

/// Whether our own tool left the line without a position, as its status states. In other files the
/// column may mean anything.
bool is_left_out(const Line& line) {
  constexpr std::array<std::string_view, 8> kReasons{
      "not_reconstructed", "horizontal",      "no_points",       "rank_deficient",
      "not_converged",     "ambiguous_depth", "no_intersection", "non_finite"};
  const Segment3& s = line.segment_in_world;
  return s.start.array().isNaN().all() && s.end.array().isNaN().all() &&
         std::ranges::find(kReasons, line.status) != kReasons.end();
}

[[noreturn]] void refuse_no_3d_lines(const std::string& path, const KindCounts& held) {
  throw IoError(
      path,
      fmt::format("has no 3D lines but {}; 3D lines, or polygons or faces with heights, are needed",
                  held.text()));
}

void refuse_degrees(const LineSet& set) {
  if (set.crs.known() && describe(set.crs).is_geographic) {
    throw IoError(
        set.path,
        fmt::format(
            "the coordinates are degrees ({}); project the lines to the cloud's reference system",
            describe(set.crs).name));
  }
  if (!looks_like_degrees(set)) return;
  throw IoError(set.path,
                fmt::format("the coordinates look like degrees, {}; project the lines to the "
                            "cloud's reference system",
                            set.crs.known() ? fmt::format("not the metres or feet of \"{}\"",
                                                          describe(set.crs).name)
                                            : "and no reference system is given"));
}

void add_coordinate_warnings(LineSet& set) {
  KindCounts placeless;
  std::size_t n_placeless = 0;
  std::size_t n_hopeless = 0;  // lines of a kind that does not occur in a 3D file
  bool all_zero = true;
  for (const Line& line : set.lines) {
    const Segment3& s = line.segment_in_world;
    all_zero = all_zero && s.start.z() == 0.0 && s.end.z() == 0.0;
    if (all_finite(s) || is_left_out(line)) continue;
    const LeftOutKind& kind = kind_of_placeless(s);
    placeless.add(kind);
    ++n_placeless;
    if (&kind != &kinds::kNonFiniteLine) ++n_hopeless;
  }
  const std::size_t n = set.lines.size();
  if (n_hopeless == n && (n > 0 || !set.left_out.empty())) {
    placeless.add(set.left_out);
    refuse_no_3d_lines(set.path, placeless);
  }
  const auto warn = [&set](std::string text) { set.warnings.push_back(std::move(text)); };
  if (n == 0) warn("has no lines");
  if (n > 0 && all_zero) warn("all z are 0: heights are missing");
  if (n_placeless > 0) {
    warn(fmt::format("{} of {} lines have non-finite coordinates: {}", n_placeless, n,
                     placeless.text()));
  }
  if (!set.left_out.empty()) warn("ignored: " + set.left_out.text());
  if (set.n_straight_vertices > 0) {
    warn(fmt::format("{} vertices within {} of a straight line are ignored",
                     set.n_straight_vertices, kStraightTolerance));
  }
}

}  // namespace

void check_lines(LineSet& set) {
  refuse_degrees(set);
  make_ids_unique(set);
  add_coordinate_warnings(set);
}

}  // namespace ridgeline::io
