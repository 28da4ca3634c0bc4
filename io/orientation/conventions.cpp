// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/conventions.h"

#include "io/error.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ridgeline::io {
namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

double full_turn(AngleUnit unit) {
  switch (unit) {
    case AngleUnit::kDegree:
      return 360.0;
    case AngleUnit::kGon:
      return 400.0;
    default:
      return 2.0 * std::numbers::pi;
  }
}

/// The angle in [0, 45] degrees between two directions, modulo a quarter turn.
double angle_modulo_quarter_deg(double a_rad, double b_rad) {
  constexpr double kQuarter_deg = 90.0;
  const double angle = std::fmod(std::abs(a_rad - b_rad) * kDegPerRad, kQuarter_deg);
  return std::min(angle, kQuarter_deg - angle);
}

/// The plan vector from an image to the nearest one taken at a different place; zero if there is
/// none.
Eigen::Vector2d to_nearest(const std::vector<OrientedImage>& images, std::size_t image) {
  constexpr double kSamePlace_m = 1e-3;
  Eigen::Vector2d nearest = Eigen::Vector2d::Zero();
  double least_m = std::numeric_limits<double>::infinity();
  for (const OrientedImage& other : images) {
    const Eigen::Vector2d vector =
        (other.exterior.position_m - images[image].exterior.position_m).head<2>();
    const double distance_m = vector.norm();
    if (distance_m <= kSamePlace_m || distance_m >= least_m) continue;
    least_m = distance_m;
    nearest = vector;
  }
  return nearest;
}

/// Whether two readings rotate all images equally: to 0.1 px at a focal length of 10,000 px.
bool mean_the_same(const RotationReading& a, const RotationReading& b) {
  constexpr double kSame = 1e-5;
  for (std::size_t i = 0; i < a.world_from_camera_axes.size(); ++i) {
    if ((a.world_from_camera_axes[i] - b.world_from_camera_axes[i]).norm() > kSame) return false;
  }
  return true;
}

std::vector<const RotationReading*> different_ones(const std::vector<RotationReading>& readings) {
  std::vector<const RotationReading*> different;
  for (const RotationReading& reading : readings) {
    const bool is_new = std::ranges::none_of(
        different, [&](const RotationReading* other) { return mean_the_same(*other, reading); });
    if (is_new) different.push_back(&reading);
  }
  return different;
}

void turn_images(const RotationReading& reading, Orientation& orientation) {
  for (std::size_t i = 0; i < orientation.images.size(); ++i) {
    orientation.images[i].exterior.world_from_camera_axes = reading.world_from_camera_axes[i];
  }
}

/// The evidence for each reading: the smaller the value, the better.
struct Evidence {
  const char* text;  ///< "rays intersect within {:.2g} px"
  double most;       ///< a reading with a larger value is rejected
  double margin;     ///< the second best must exceed three times the best by this
  std::vector<double> values;
};

/// The index of the reading that the evidence singles out; std::nullopt if there is none.
std::optional<std::size_t> decided_by(const Evidence& evidence) {
  constexpr double kTimes = 3.0;
  std::vector<double> sorted = evidence.values;
  std::ranges::sort(sorted);
  if (sorted.empty() || sorted[0] > evidence.most) return std::nullopt;
  if (sorted.size() > 1 && sorted[1] < kTimes * sorted[0] + evidence.margin) return std::nullopt;
  return std::ranges::min_element(evidence.values) - evidence.values.begin();
}

/// The largest distance by which rays of the correct reading may miss each other. Points are found
/// in images reduced to 1500 pixels, so in large frames they are less accurate.
double most_ray_distance_px(const Orientation& orientation) {
  constexpr double kMinDistance_px = 5.0;
  constexpr double kOfLongerSide = 0.002;
  double most_px = kMinDistance_px;
  for (const Camera& camera : orientation.cameras) {
    if (!camera.interior.size_px) continue;
    most_px = std::max(most_px, kOfLongerSide * camera.interior.size_px->maxCoeff());
  }
  return most_px;
}

Evidence ray_evidence(const std::vector<const RotationReading*>& readings,
                      const std::vector<PointObservation>& observations,
                      Orientation& orientation) {
  Evidence evidence{"rays intersect within {:.2g} px", most_ray_distance_px(orientation), 0.5, {}};
  for (const RotationReading* reading : readings) {
    turn_images(*reading, orientation);
    const auto distance_px = median_ray_distance_px(orientation, observations);
    if (!distance_px) return {evidence.text, evidence.most, evidence.margin, {}};
    evidence.values.push_back(*distance_px);
  }
  return evidence;
}

Evidence strip_evidence(const std::vector<const RotationReading*>& readings,
                        Orientation& orientation) {
  constexpr double kLooksAway_deg = 45.0;  // for a reading under which no images look down
  bool any = false;
  Evidence evidence{"images are aligned with the strips within {:.1f} degrees", 5.0, 2.0, {}};
  for (const RotationReading* reading : readings) {
    turn_images(*reading, orientation);
    const std::optional<double> angle_deg = mean_angle_to_strips_deg(orientation);
    any = any || angle_deg.has_value();
    evidence.values.push_back(angle_deg.value_or(kLooksAway_deg));
  }
  if (!any) evidence.values.clear();
  return evidence;
}

/// "with angles in degrees rays intersect within 0.3 px, with angles in gon rays intersect within
/// 90 px".
std::string evidence_text(const Evidence& evidence,
                          const std::vector<const RotationReading*>& readings) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < evidence.values.size(); ++i) {
    texts.push_back(fmt::format("with {} {}", readings[i]->what,
                                fmt::format(fmt::runtime(evidence.text), evidence.values[i])));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

[[noreturn]] void refuse_open(const std::string& path,
                              const std::vector<const RotationReading*>& readings,
                              const std::vector<Evidence>& evidences) {
  std::vector<std::string> options;
  options.reserve(readings.size());
  for (const RotationReading* reading : readings) options.push_back(reading->option);
  std::vector<std::string> texts;
  for (const Evidence& evidence : evidences) {
    if (!evidence.values.empty()) texts.push_back(evidence_text(evidence, readings));
  }
  const std::string tried = texts.empty() ? "tie points require images and cameras (cameras: "
                                            "FILE), strips require three vertical images"
                                          : fmt::format("{}", fmt::join(texts, "; "));
  throw IoError(path, fmt::format("the rotation convention is ambiguous and could not be "
                                  "determined from tie points or strips ({}); give one of: {}",
                                  tried, fmt::join(options, " | ")));
}

}  // namespace

Eigen::Matrix3d rotation_of(const Angles& angles, AngleUnit unit, RotationOrder order) {
  const double rad = 2.0 * std::numbers::pi / full_turn(unit);
  if (order == RotationOrder::kOmegaPhiKappa) {
    return world_from_camera_axes(rad * angles.omega, rad * angles.phi, rad * angles.kappa);
  }
  return (Eigen::AngleAxisd(rad * angles.phi, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rad * angles.omega, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(rad * angles.kappa, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

Angles angles_deg(const Eigen::Matrix3d& world_from_camera_axes) {
  const Eigen::Matrix3d& R = world_from_camera_axes;
  return {kDegPerRad * std::atan2(-R(1, 2), R(2, 2)),
          kDegPerRad * std::asin(std::clamp(R(0, 2), -1.0, 1.0)),
          kDegPerRad * std::atan2(-R(0, 1), R(0, 0))};
}

std::vector<AngleUnit> possible_units(const std::vector<Angles>& angles) {
  constexpr double kRounding = 1e-3;
  double largest = 0.0;
  for (const Angles& a : angles) {
    largest = std::max({largest, std::abs(a.omega), std::abs(a.phi), std::abs(a.kappa)});
  }
  std::vector<AngleUnit> units;
  for (const AngleUnit unit : {AngleUnit::kDegree, AngleUnit::kGon, AngleUnit::kRadian}) {
    if (largest <= full_turn(unit) + kRounding) units.push_back(unit);
  }
  return units;
}

std::optional<double> mean_angle_to_strips_deg(const Orientation& orientation) {
  constexpr double kLooksDown = 0.9;  // cosine of the angle to the plumb line
  constexpr std::size_t kEnough = 500;
  const std::size_t step = orientation.images.size() / kEnough + 1;
  double sum_deg = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < orientation.images.size(); i += step) {
    const Eigen::Matrix3d& R = orientation.images[i].exterior.world_from_camera_axes;
    const Eigen::Vector2d base = to_nearest(orientation.images, i);
    if (R(2, 2) < kLooksDown || base.isZero()) continue;
    sum_deg +=
        angle_modulo_quarter_deg(std::atan2(base.y(), base.x()), std::atan2(R(1, 0), R(0, 0)));
    ++count;
  }
  if (count < 3) return std::nullopt;
  return sum_deg / count;
}

void decide_rotations(const std::string& path,
                      const std::vector<RotationReading>& readings,
                      const FindObservations& find,
                      Orientation& orientation) {
  const std::vector<const RotationReading*> different = different_ones(readings);
  if (different.size() == 1) return turn_images(*different.front(), orientation);
  std::vector<Evidence> evidences;
  if (find) evidences.push_back(ray_evidence(different, find(orientation), orientation));
  evidences.push_back(strip_evidence(different, orientation));
  for (const Evidence& evidence : evidences) {
    const std::optional<std::size_t> decided = decided_by(evidence);
    if (!decided) continue;
    turn_images(*different[*decided], orientation);
    orientation.decisions.push_back(
        fmt::format("The file does not define its rotation convention. Determined: {} ({}).",
                    different[*decided]->what, evidence_text(evidence, different)));
    return;
  }
  refuse_open(path, different, evidences);
}

}  // namespace ridgeline::io
