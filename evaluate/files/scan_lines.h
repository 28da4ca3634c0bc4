// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/scan_edges.h"
#include "io/cloud/cloud_files.h"
#include "io/lines/line_set.h"
#include "io/lines/write_lines.h"

#include <string>

namespace ridgeline::results {

/// The edges of a cloud as lines in its own coordinates, with id, kind, covariance, support and
/// `moved_out_m`. Ids are numbers from 1; `plane_ids` likewise refer to ScanEdges::planes.
io::LineSet lines_of_scan(const evaluate::ScanEdges& edges, const io::CloudFiles& cloud);

/// Removes the edges shorter than this.
void drop_short_edges(double min_length_m, evaluate::ScanEdges& edges);

/// Writes the lines of lines_of_scan(). A GeoPackage is a map: the lines coloured by kind, and in
/// the layer `planes` the roof planes, with their ids as in `plane_ids`. Throws IoError if the file
/// cannot be written.
void write_scan_edges(const std::string& path,
                      const evaluate::ScanEdges& edges,
                      const io::CloudFiles& cloud,
                      io::LineFormat format,
                      const io::WriteLinesOptions& options = {});

}  // namespace ridgeline::results
