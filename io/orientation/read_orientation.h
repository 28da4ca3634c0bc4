// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/conventions.h"
#include "io/orientation/orientation.h"

#include <optional>
#include <string>

namespace ridgeline::io {

/// Information from the user that the file does not contain.
struct OrientationOptions {
  std::string cameras;  ///< camera file (read_cameras()), for formats without cameras; may be empty
  Crs crs;  ///< the system of a file that states none; for geocentric and geographic poses, the
            ///< system to convert them to. If unknown: the stated system, otherwise the UTM zone
  std::optional<AngleUnit> angles;
  std::optional<RotationOrder> rotation;
  std::optional<MatrixDirection> matrix;
  FindObservations find_observations;  ///< may be empty; called only if the file is ambiguous
};

/// Reads an orientation: a table of omega, phi and kappa, OpenSfM's reconstruction.json, Pix4D's
/// calibrated_camera_parameters.txt, an Inpho project, PAT-B, BlocksExchange, Metashape's own XML,
/// or the folder of a COLMAP model. The format is recognised by content. In the result, image names
/// are unique, positions are finite and rotation matrices valid. Throws IoError for another format,
/// a damaged file, a camera that is not a central one with Brown distortion (fisheye and others,
/// naming the type), two images with the same name, no images at all, and an ambiguity that neither
/// the options nor rays nor strips resolve.
Orientation read_orientation(const std::string& path, const OrientationOptions& options = {});

}  // namespace ridgeline::io
