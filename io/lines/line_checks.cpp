// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/line_checks.h"

#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ridgeline::io {
namespace {

bool within_degrees(const Eigen::Vector3d& x) {
  return std::abs(x.x()) <= 180.0 && std::abs(x.y()) <= 90.0;
}

/// Without lines nothing speaks for degrees.
bool looks_like_degrees(const LineSet& set) {
  constexpr double kLongestRoofDeg = 0.01;
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
  return *middle > 0.0 && *middle < kLongestRoofDeg;
}

bool lacks_only_z(const Segment3& s) {
  return s.start.head<2>().allFinite() && s.end.head<2>().allFinite() &&
         (std::isnan(s.start.z()) || std::isnan(s.end.z()));
}

/// Whether its tool gave it no place and says so by its status.
bool is_left_out(const Line& line) {
  const Segment3& s = line.segment_in_world;
  return !line.status.empty() && s.start.array().isNaN().all() && s.end.array().isNaN().all();
}

std::size_t count_repeated_ids(const std::vector<Line>& lines) {
  std::set<std::string_view> known;
  for (const Line& line : lines) known.insert(line.id);
  return lines.size() - known.size();
}

}  // namespace

void refuse_degrees(const LineSet& set) {
  if (set.crs.known() && describe(set.crs).is_geographic) {
    throw IoError(set.path, fmt::format("coordinates in degrees ({}); project the lines to the "
                                        "cloud's reference system",
                                        describe(set.crs).name));
  }
  if (!looks_like_degrees(set)) return;
  throw IoError(
      set.path,
      fmt::format("the coordinates are degrees by their size and {}; project the lines to "
                  "the cloud's reference system",
                  set.crs.known()
                      ? fmt::format("no metres or feet of \"{}\"", describe(set.crs).name)
                      : "no reference system is stated"));
}

void add_coordinate_warnings(LineSet& set) {
  std::size_t n_non_finite = 0;
  std::size_t n_without_z = 0;
  bool all_zero = true;
  for (const Line& line : set.lines) {
    const Segment3& s = line.segment_in_world;
    if (lacks_only_z(s)) ++n_without_z;
    if (!all_finite(s) && !is_left_out(line)) ++n_non_finite;
    all_zero = all_zero && s.start.z() == 0.0 && s.end.z() == 0.0;
  }
  const std::size_t n = set.lines.size();
  if (n > 0 && n_without_z == n) {
    throw IoError(set.path, "the lines have no z; 3D lines are needed");
  }
  const auto warn = [&set](std::string text) { set.warnings.push_back(std::move(text)); };
  if (n == 0) warn("holds no lines");
  if (n > 0 && all_zero) warn("all z are 0: heights are missing");
  if (n_non_finite > 0) {
    warn(fmt::format("{} of {} lines have coordinates that are not finite ({} lack only z)",
                     n_non_finite, n, n_without_z));
  }
  if (const std::size_t n_repeated = count_repeated_ids(set.lines); n_repeated > 0) {
    warn(fmt::format("{} lines have an id that an earlier line has", n_repeated));
  }
}

}  // namespace ridgeline::io
