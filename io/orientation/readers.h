// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/read_orientation.h"

#include <string>

/// One function a format. Each gives the images as the file states them; read_orientation() checks
/// them.
namespace ridgeline::io {

/// Rows of name, x, y, z, omega, phi, kappa and perhaps the camera, with or without names of
/// columns. The system of coordinates may stand in a `.prj` beside the table.
Orientation read_opk_table(const std::string& path, const OrientationOptions& options);

/// OpenSfM's reconstruction.json: topocentric poses are converted to a map.
Orientation read_opensfm(const std::string& path, const OrientationOptions& options);

/// Pix4D's PREFIX_calibrated_camera_parameters.txt, with PREFIX_offset.xyz and PREFIX_wkt.prj
/// beside it.
Orientation read_pix4d(const std::string& path, const OrientationOptions& options);

/// The project file of Inpho (Trimble).
Orientation read_inpho(const std::string& path, const OrientationOptions& options);

/// PAT-B: three records an image.
Orientation read_pat_b(const std::string& path, const OrientationOptions& options);

/// BlocksExchange XML of ContextCapture, Metashape and others.
Orientation read_blocks_exchange(const std::string& path, const OrientationOptions& options);

/// The cameras.xml of Metashape.
Orientation read_metashape(const std::string& path, const OrientationOptions& options);

/// A model of COLMAP, text or binary.
Orientation read_colmap_orientation(const std::string& folder, const OrientationOptions& options);

}  // namespace ridgeline::io
