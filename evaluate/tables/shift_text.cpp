// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/shift_text.h"

#include "evaluate/tables/format.h"
#include "reconstruct/geometry/degrees.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr std::array kAxisNames{"x", "y", "z"};

std::string plus_minus_text(double shift_m, double half_m) {
  return fmt::format("{} +- {} m", metres(shift_m), metres(half_m));
}

std::string along_text(const ConstantShift& shift, const Eigen::Vector3d& direction) {
  constexpr double kHalfWidth95 = 1.959964;
  return plus_minus_text(
      shift.shift_m.dot(direction),
      kHalfWidth95 * std::sqrt(std::max(0.0, direction.dot(shift.covariance_m2 * direction))));
}

/// The shift along a direction other than the axes, if the planes determine such a direction; else
/// "".
std::string oblique_text(const ConstantShift& shift) {
  constexpr double kLevel = 0.1;  // maximum z component of a horizontal unobservable direction
  const auto& [x, y, z] = shift.axes;
  if (x.shift_m || y.shift_m) return "";
  if (shift.unobservable.size() == 1 && std::abs(shift.unobservable[0].z()) < kLevel) {
    const Eigen::Vector3d& unobservable = shift.unobservable[0];
    Eigen::Vector3d told = Eigen::Vector3d(-unobservable.y(), unobservable.x(), 0.0).normalized();
    if (told.x() < 0.0) told = -told;
    const double azimuth_deg = deg_from_rad(std::atan2(told.x(), told.y()));
    return fmt::format("towards azimuth {:.0f} degrees {}", azimuth_deg, along_text(shift, told));
  }
  if (z.shift_m || shift.unobservable.size() == 3) return "";
  // planes of one orientation determine one direction, planes of two orientations two
  const Eigen::Vector3d told = shift.shift_m.normalized();
  return fmt::format("along ({:.2f}, {:.2f}, {:.2f}) {}", told.x(), told.y(), told.z(),
                     along_text(shift, told));
}

std::string shift_message(const Evaluation& evaluation, bool apply_shift) {
  const std::string whose = fmt::format("Patch {}: {}: ", evaluation.patch, evaluation.method);
  const auto& shift = evaluation.shift;
  if (!shift || !shift->is_significant()) {
    return apply_shift
               ? whose +
                     "no shift of the lines is significant, so no line was moved (`apply_shift`)."
               : "";
  }
  const std::string what =
      fmt::format("all lines are shifted from the LIDAR planes by {} (95 %; {} lines, {} planes)",
                  shift_text(*shift), shift->n_lines, shift->n_planes);
  const std::string cause =
      shift->cause.empty() ? "cause unknown" : "likely cause: " + shift->cause;
  return fmt::format("{}{}; {}. {}", whose, what, cause,
                     shift->applied
                         ? "They were moved against it before they were judged (`apply_shift`)."
                         : "Figures include it; `apply_shift` judges the lines without it.");
}

}  // namespace

std::string shift_text(const ConstantShift& shift) {
  std::vector<std::string> told, unobservable;
  for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
    const ShiftAxis& axis = shift.axes[i];
    if (axis.shift_m) {
      told.push_back(fmt::format(
          "{} {}", kAxisNames[i],
          plus_minus_text(*axis.shift_m, 0.5 * (axis.ci95_m->high - axis.ci95_m->low))));
    } else {
      unobservable.emplace_back(kAxisNames[i]);
    }
  }
  if (std::string oblique = oblique_text(shift); !oblique.empty()) {
    told.insert(told.begin(), std::move(oblique));
  }
  if (!unobservable.empty()) {
    told.push_back(
        fmt::format("{} not observable from these planes", fmt::join(unobservable, ", ")));
  }
  return fmt::format("{}", fmt::join(told, ", "));
}

std::string moved_note(const Evaluation& evaluation) {
  if (!evaluation.shift || !evaluation.shift->applied) return "";
  const Eigen::Vector3d by_m = -evaluation.shift->shift_m;
  return fmt::format(
      "{} of patch {}: before they were judged, the lines were moved by x {}, y {}, z {} m, "
      "against the shift that was estimated (`apply_shift`).",
      evaluation.method, evaluation.patch, metres(by_m.x()), metres(by_m.y()), metres(by_m.z()));
}

std::vector<std::string> moved_notes(std::span<const Evaluation> evaluations) {
  std::vector<std::string> notes;
  for (const Evaluation& evaluation : evaluations) {
    if (std::string note = moved_note(evaluation); !note.empty()) notes.push_back(std::move(note));
  }
  return notes;
}

std::vector<std::string> shift_messages(std::span<const Evaluation> evaluations, bool apply_shift) {
  std::vector<std::string> messages;
  for (const Evaluation& evaluation : evaluations) {
    if (std::string text = shift_message(evaluation, apply_shift); !text.empty())
      messages.push_back(std::move(text));
  }
  return messages;
}

}  // namespace ridgeline::evaluate
