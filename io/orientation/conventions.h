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

/// In which order three rotations turn camera axes into world axes: Rx(omega) Ry(phi) Rz(kappa) or
/// Ry(phi) Rx(omega) Rz(kappa).
enum class RotationOrder : std::uint8_t { kOmegaPhiKappa, kPhiOmegaKappa };

/// Whether a matrix turns camera axes into world axes or the other way round.
enum class MatrixDirection : std::uint8_t { kWorldFromCamera, kCameraFromWorld };

/// One observation of a point in an image. Observations of one point have the same number.
struct PointObservation {
  std::size_t point = 0;
  std::size_t image = 0;  ///< number in Orientation::images
  Eigen::Vector2d x_px;
};

/// Finds points in the images of an orientation, of which only names and cameras are asked for.
using FindObservations = std::function<std::vector<PointObservation>(const Orientation&)>;

/// One way to read the rotations of a file.
struct RotationReading {
  std::string what;                                     ///< "angles in gon"
  std::string option;                                   ///< how the user asks for it: "angles: gon"
  std::vector<Eigen::Matrix3d> world_from_camera_axes;  ///< of every image
};

/// The angles of one image, in the unit and with the names of the file.
struct Angles {
  double omega = 0.0, phi = 0.0, kappa = 0.0;
};

/// Turns camera axes (x right, y up, looking along -z) into world axes.
Eigen::Matrix3d rotation_of(const Angles& angles, AngleUnit unit, RotationOrder order);

/// The angles in degrees of Rx(omega) Ry(phi) Rz(kappa); phi is in [-90, 90].
Angles angles_deg(const Eigen::Matrix3d& world_from_camera_axes);

/// The units in which the angles can be: those that are at most a full turn.
std::vector<AngleUnit> possible_units(const std::vector<Angles>& angles);

/// The median distance, px, of the observations from the points in which their rays meet; the rays
/// meet where the sum of squared distances to them is least. Nothing with fewer than kMinMeetings
/// points that two images with cameras observe.
constexpr std::size_t kMinMeetings = 10;
std::optional<double> median_ray_distance_px(const Orientation& orientation,
                                             const std::vector<PointObservation>& observations);

/// The mean angle in [0, 45] degrees by which the sides of vertical images are turned against the
/// line to the nearest image; small in a block that was flown in strips. Nothing with fewer than
/// three images that look down.
std::optional<double> mean_angle_to_strips_deg(const Orientation& orientation);

/// Gives the images the rotations of the one reading under which rays meet, or, if `find` finds no
/// points, under which the images lie along the strips. Says in orientation.decisions which one it
/// was and by what. `readings`: at least one; of several that cannot be told apart because they
/// mean the same to 0.1 px at 10,000 px focal length, the first counts. Throws IoError, which names
/// the options, if the readings cannot be told apart.
void decide_rotations(const std::string& path,
                      const std::vector<RotationReading>& readings,
                      const FindObservations& find,
                      Orientation& orientation);

}  // namespace ridgeline::io
