// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/value_warnings.h"

#include "evaluate/files/judged_lines.h"
#include "io/crs/coordinate_steps.h"
#include "io/error.h"
#include "io/lines/line_facts.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ridgeline::results {
namespace {

using evaluate::LineEvaluation;
using evaluate::Status;

/// Largest distance that is assumed to be an error of the line. check_frame() applies the same
/// limit to the median.
constexpr double kMaxError_m = 20.0;

/// Root mean square of the distances of the judged lines for which `is_counted` holds; std::nullopt
/// if there are none.
template <typename Predicate>
std::optional<double> rms_m(const std::vector<LineEvaluation>& lines, const Predicate& is_counted) {
  double sum = 0.0;
  std::size_t n = 0;
  for (const LineEvaluation& line : lines) {
    if (line.status != Status::kEvaluated || !is_counted(line)) continue;
    sum += *line.mean_distance_m * *line.mean_distance_m;
    ++n;
  }
  if (n == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(n));
}

/// The steps that may have degraded the lines: always float32 steps, and steps due to too few
/// digits unless the lines fit too well for these. Rounding moves a coordinate by 0.29 of the step
/// (RMS) and a line across its plane by less; many of the lines that move the farthest are not
/// judged.
Eigen::Vector3d harmful_steps_m(const io::LineSet& set, const std::vector<LineEvaluation>& lines) {
  constexpr double kMinHarm = 0.05;
  const io::CoordinateSteps steps = io::steps_of(set, unit_m_of(set));
  Eigen::Vector3d steps_m = steps.steps_m();
  const auto rms = rms_m(lines, [](const LineEvaluation&) { return true; });
  if (!rms || steps.went_through_float32()) return steps_m;
  return (kMinHarm * steps_m.array() <= *rms).select(steps_m, 0.0);
}

std::string ids_text(const std::vector<std::string>& ids) {
  constexpr std::size_t kShown = 5;
  const std::size_t n = std::min(kShown, ids.size());
  const std::vector<std::string> first(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(n));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     ids.size() > n ? fmt::format(" and {} more", ids.size() - n) : "");
}

template <typename Predicate>
std::vector<std::string> ids_of(const std::vector<LineEvaluation>& lines, const Predicate& is_one) {
  std::vector<std::string> ids;
  for (const LineEvaluation& line : lines) {
    if (is_one(line)) ids.push_back(line.id);
  }
  return ids;
}

bool is_far_in_height(const LineEvaluation& line) {
  return line.status == Status::kOutOfRange && line.length_m > 0.0;
}

/// Whether the line is far from its planes and parallel to them. A line that a tool misplaced that
/// far is seldom parallel.
bool is_far_from_planes(const LineEvaluation& line) {
  constexpr double kParallel = 0.2;  // difference of the ends' distances over the mean distance
  if (line.status != Status::kEvaluated || *line.mean_distance_m <= kMaxError_m) return false;
  return std::ranges::all_of(line.planes, [&](const evaluate::JudgingPlane& p) {
    return std::abs(p.distance.start - p.distance.end) <= kParallel * *line.mean_distance_m;
  });
}

std::optional<std::string> out_of_range_text(const std::vector<LineEvaluation>& lines) {
  const std::vector<std::string> ids = ids_of(lines, is_far_in_height);
  if (ids.empty()) return std::nullopt;
  return fmt::format(
      "{} of {} lines have the same height more than {:.0f} m above or below all points around "
      "them and are not judged (out_of_range): {}; perhaps a no-data value (0, -9999)",
      ids.size(), lines.size(), evaluate::kMaxHeightOffset_m, ids_text(ids));
}

std::optional<std::string> far_text(const std::vector<LineEvaluation>& lines) {
  const std::vector<std::string> ids = ids_of(lines, is_far_from_planes);
  if (ids.empty()) return std::nullopt;
  const auto all = rms_m(lines, [](const LineEvaluation&) { return true; });
  const auto rest = rms_m(lines, [](const LineEvaluation& l) { return !is_far_from_planes(l); });
  return fmt::format(
      "{} of {} lines are more than {:.0f} m from their planes and dominate the RMS, {:.3f} m with "
      "and {} without them: {}; are their heights missing, or in another unit or height system?",
      ids.size(), lines.size(), kMaxError_m, *all, rest ? fmt::format("{:.3f} m", *rest) : "-",
      ids_text(ids));
}

}  // namespace

void add_value_warnings(const io::LineSet& set,
                        const evaluate::Evaluation& evaluation,
                        bool strict,
                        std::vector<std::string>& warnings) {
  const auto warn = [&](const std::string& text) { warnings.push_back(set.path + ": " + text); };
  if (const auto steps_m = harmful_steps_m(set, evaluation.lines); !steps_m.isZero()) {
    const std::string text = fmt::format(
        "coordinates have {}: they were written with too few digits or converted to float32, which "
        "affects the distances; steps must be at most {} m",
        io::steps_text(steps_m), io::kMaxCoordinateStep_m);
    if (strict) throw io::IoError(set.path, text);
    warn(text);
  }
  if (const auto text = out_of_range_text(evaluation.lines)) warn(*text);
  if (const auto text = far_text(evaluation.lines)) warn(*text);
}

}  // namespace ridgeline::results
