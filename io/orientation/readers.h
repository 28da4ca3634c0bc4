// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/read_orientation.h"

#include <string>

/// One function per format. Each returns the images as stated in the file; read_orientation()
/// checks them.
namespace ridgeline::io {

/// Rows of name, x, y, z, omega, phi, kappa and optionally the camera, with or without column
/// names. The coordinate system may be given in a `.prj` file next to the table.
Orientation read_opk_table(const std::string& path, const OrientationOptions& options);

/// OpenSfM's reconstruction.json: topocentric poses are converted to a map.
Orientation read_opensfm(const std::string& path, const OrientationOptions& options);

/// Pix4D's PREFIX_calibrated_camera_parameters.txt, with PREFIX_offset.xyz and PREFIX_wkt.prj next
/// to it.
Orientation read_pix4d(const std::string& path, const OrientationOptions& options);

/// Inpho (Trimble) project file.
Orientation read_inpho(const std::string& path, const OrientationOptions& options);

/// PAT-B: three records per image.
Orientation read_pat_b(const std::string& path, const OrientationOptions& options);

/// BlocksExchange XML from ContextCapture, Metashape and others.
Orientation read_blocks_exchange(const std::string& path, const OrientationOptions& options);

/// Metashape's cameras.xml.
Orientation read_metashape(const std::string& path, const OrientationOptions& options);

/// A COLMAP model, text or binary.
Orientation read_colmap_orientation(const std::string& folder, const OrientationOptions& options);

}  // namespace ridgeline::io
