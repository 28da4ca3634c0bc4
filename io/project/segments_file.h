// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Writes the segments of an image as CSV, one row each, completely or not at all. Columns:
///   id                            the index in `segments`, which match files refer to
///   x1_px, y1_px, x2_px, y2_px    start and end in ideal pixels, brighter side on the right
///   centroid_x_px, centroid_y_px, sigma_q_px, sigma_phi_rad, sigma_e_px   see UncertainSegment2
///   cov_x1_x1_px2 ... cov_y2_y2_px2   upper triangle of the covariance of (x1, y1, x2, y2) that
///                                 follows from these; for other tools, not read back
///   image_x1_px ... image_y2_px   start and end in pixels of the file
///   n_edge_pixels, rms_px, contrast
///   left_1 ... left_4, left_grey, right_1 ... right_grey   the flanks, 0 dark to 1 bright
///   scale_px                      pixels of the file per pixel of the reduced image in which it
///                                 was found; read as 1 if missing
///   guided                        1 if it was found by guidance from another view's segment,
///                                 otherwise 0; read as 0 if missing
/// Numbers have enough digits to read the same values back.
/// Throws IoError if the file cannot be written.
void write_segments(const std::string& path, const std::vector<EdgeSegment>& segments);

/// Reads what write_segments() wrote; the columns may be in any order, with others among them.
/// Throws IoError with the line for a missing column, a field that is not a finite number, an id
/// that is not the row's index, a segment without length, a non-positive sigma, and a scale that is
/// not an integer from 1 to 8.
std::vector<EdgeSegment> read_segments(const std::string& path);

/// Reads segments from another detector, for View::own_segments. Columns, in any order:
///   id                            row number, from 0
///   x1_px, y1_px, x2_px, y2_px    ends in pixels of the file, in any direction
///   sigma_px                      optional: standard deviation of an end across the line
///   scale_px                      optional, default 1: see EdgeSegment
/// Other columns are ignored, except in a file of write_segments(), whose columns image_x1_px ...
/// image_y2_px, sigma_q_px, sigma_phi_rad and sigma_e_px are read instead.
/// @param sigma_px  sigma for a file that states none
/// @param size_px   columns and rows of the image; empty: not checked
/// Throws IoError under the same conditions as read_segments(), and for an end more than 5 px
/// outside the image.
std::vector<EdgeSegment> read_own_segments(const std::string& path,
                                           double sigma_px,
                                           const std::optional<Eigen::Vector2i>& size_px = {});

}  // namespace ridgeline::io
