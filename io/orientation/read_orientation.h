// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/conventions.h"
#include "io/orientation/orientation.h"

#include <optional>
#include <string>

namespace ridgeline::io {

/// What a user knows and the file does not state.
struct OrientationOptions {
  std::string cameras;  ///< file of cameras (read_cameras()), for formats without; may be empty
  Crs crs;  ///< declares the system of a file that states none; of geocentric and geographic poses
            ///< the system to convert them to. Unknown: as stated, else the UTM zone
  std::optional<AngleUnit> angles;
  std::optional<RotationOrder> rotation;
  std::optional<MatrixDirection> matrix;
  FindObservations
      find_observations;  ///< may be empty; asked only where the file leaves something open
};

/// Reads an orientation: a table of omega, phi and kappa, OpenSfM's reconstruction.json, Pix4D's
/// calibrated_camera_parameters.txt, an Inpho project, PAT-B, BlocksExchange, Metashape's own XML,
/// or the folder of a COLMAP model. What it is shows in the content. All images have names that
/// differ; positions are finite and rotations are rotations. Throws IoError for what is none of
/// these, for a damaged file, for a camera that is not central with Brown's distortion (fisheye and
/// others, by their name), for two images of one name, for no images at all, and where the file and
/// the options leave something open that neither rays nor strips decide.
Orientation read_orientation(const std::string& path, const OrientationOptions& options = {});

}  // namespace ridgeline::io
