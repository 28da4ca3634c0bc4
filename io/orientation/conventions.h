// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

enum class AngleUnit : std::uint8_t { kDegree, kGon, kRadian };

/// The order of the three rotations from camera axes to world axes: Rx(omega) Ry(phi) Rz(kappa) or
/// Ry(phi) Rx(omega) Rz(kappa).
enum class RotationOrder : std::uint8_t { kOmegaPhiKappa, kPhiOmegaKappa };

/// Whether a matrix rotates camera axes to world axes or vice versa.
enum class MatrixDirection : std::uint8_t { kWorldFromCamera, kCameraFromWorld };

/// One observation of a point in an image. Observations of one point have the same number.
struct PointObservation {
  std::size_t point = 0;
  std::size_t image = 0;  ///< index in Orientation::images
  Eigen::Vector2d x_px;
};

/// Finds points in the images of an orientation, using only its names and cameras.
using FindObservations = std::function<std::vector<PointObservation>(const Orientation&)>;

/// One interpretation of the rotations of a file.
struct RotationReading {
  std::string what;                                     ///< "angles in gon"
  std::string option;                                   ///< how the user selects it: "angles: gon"
  std::vector<Eigen::Matrix3d> world_from_camera_axes;  ///< one per image
};

/// The angles of one image, in the unit and with the names of the file.
struct Angles {
  double omega = 0.0, phi = 0.0, kappa = 0.0;
};

/// The rotation from camera axes (x right, y up, looking along -z) to world axes.
Eigen::Matrix3d rotation_of(const Angles& angles, AngleUnit unit, RotationOrder order);

/// The angles in degrees of Rx(omega) Ry(phi) Rz(kappa); phi is in [-90, 90].
Angles angles_deg(const Eigen::Matrix3d& world_from_camera_axes);

/// The possible units of the angles: those in which no angle exceeds a full turn.
std::vector<AngleUnit> possible_units(const std::vector<Angles>& angles);

/// The median distance, px, of the observations from the points where their rays meet, i.e. where
/// the sum of squared distances to the rays is minimal. std::nullopt with fewer than kMinMeetings
/// points that are observed by two images with cameras.
constexpr std::size_t kMinMeetings = 10;
std::optional<double> median_ray_distance_px(const Orientation& orientation,
                                             const std::vector<PointObservation>& observations);

/// The mean angle in [0, 45] degrees between the sides of vertical images and the direction to the
/// nearest image; small in a block flown in strips. std::nullopt with fewer than three vertical
/// images.
std::optional<double> mean_angle_to_strips_deg(const Orientation& orientation);

/// Gives the images the rotations of the one reading for which rays meet or, if rays do not decide,
/// for which the images are aligned with the strips. Records the decision and its basis in
/// orientation.decisions. `readings`: at least one; of readings that agree to 0.1 px at 10,000 px
/// focal length, the first is used. Throws IoError, naming the options, if the readings cannot be
/// distinguished.
void decide_rotations(const std::string& path,
                      const std::vector<RotationReading>& readings,
                      const FindObservations& find,
                      Orientation& orientation);

}  // namespace ridgeline::io
