// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/parameter_intervals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::evaluate {
namespace {

std::optional<ParameterInterval> intersection(const ParameterInterval& a,
                                              const ParameterInterval& b) {
  const ParameterInterval both{std::max(a.begin, b.begin), std::min(a.end, b.end)};
  return both.begin <= both.end ? std::optional(both) : std::nullopt;
}

/// Where |offset + t direction| <= limit, within [0, 1].
std::optional<ParameterInterval> where_short(const Eigen::Vector3d& offset,
                                             const Eigen::Vector3d& direction,
                                             double limit) {
  const double a = direction.squaredNorm();
  const double closest = a > 0.0 ? -offset.dot(direction) / a : 0.0;
  const double height2 = (offset + closest * direction).squaredNorm();
  if (height2 > limit * limit) return std::nullopt;
  if (!(a > 0.0)) return ParameterInterval{0.0, 1.0};
  const double half = std::sqrt((limit * limit - height2) / a);
  return intersection({closest - half, closest + half}, {0.0, 1.0});
}

/// Where low <= start + t (end - start) <= high, within [0, 1].
std::optional<ParameterInterval> where_between(double start, double end, double low, double high) {
  const double slope = end - start;
  if (slope == 0.0) {
    return start >= low && start <= high ? std::optional(ParameterInterval{0.0, 1.0})
                                         : std::nullopt;
  }
  const double t_low = (low - start) / slope;
  const double t_high = (high - start) / slope;
  return intersection({std::min(t_low, t_high), std::max(t_low, t_high)}, {0.0, 1.0});
}

}  // namespace

std::vector<ParameterInterval> join(std::vector<ParameterInterval> intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const ParameterInterval& a, const ParameterInterval& b) {
              return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
            });
  std::vector<ParameterInterval> joined;
  for (const ParameterInterval& next : intervals) {
    if (joined.empty() || next.begin > joined.back().end) {
      joined.push_back(next);
    } else {
      joined.back().end = std::max(joined.back().end, next.end);
    }
  }
  return joined;
}

double total_length(const std::vector<ParameterInterval>& disjoint) {
  double length = 0.0;
  for (const ParameterInterval& part : disjoint) length += part.end - part.begin;
  return length;
}

int count_samples(const std::vector<ParameterInterval>& disjoint, int n) {
  int count = 0;
  for (const ParameterInterval& part : disjoint) {
    const int first = std::max(0, static_cast<int>(std::ceil(part.begin * n - 0.5)));
    const int last = std::min(n - 1, static_cast<int>(std::floor(part.end * n - 0.5)));
    count += std::max(0, last - first + 1);
  }
  return count;
}

std::optional<ParameterInterval> where_within(double start, double end, double limit) {
  return where_between(start, end, -limit, limit);
}

std::optional<ParameterInterval> part_near(const Segment3& segment,
                                           const Segment3& reference,
                                           double tolerance) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d offset = segment.start - reference.start;
  const Eigen::Vector3d direction = segment.end - segment.start;
  const Eigen::Vector3d axis = reference.end - reference.start;
  const double axis2 = axis.squaredNorm();
  if (!(axis2 > 0.0)) return where_short(offset, direction, tolerance);

  // parameter of the foot point on the reference at the segment's start and end
  const double foot_start = offset.dot(axis) / axis2;
  const double foot_end = foot_start + direction.dot(axis) / axis2;
  const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - v.dot(axis) / axis2 * axis;
  };
  const auto both = [](const std::optional<ParameterInterval>& a,
                       const std::optional<ParameterInterval>& b) {
    return a && b ? intersection(*a, *b) : std::nullopt;
  };
  std::optional<ParameterInterval> result;
  for (const std::optional<ParameterInterval>& part :
       {both(where_between(foot_start, foot_end, -kInfinity, 0.0),
             where_short(offset, direction, tolerance)),
        both(where_between(foot_start, foot_end, 0.0, 1.0),
             where_short(across(offset), across(direction), tolerance)),
        both(where_between(foot_start, foot_end, 1.0, kInfinity),
             where_short(segment.start - reference.end, direction, tolerance))}) {
    if (!part) continue;
    if (!result) {
      result = part;
    } else {
      result->begin = std::min(result->begin, part->begin);
      result->end = std::max(result->end, part->end);
    }
  }
  return result;
}

}  // namespace ridgeline::evaluate
