// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/reconstruct.h"

#include <string>

namespace ridgeline::apps {

/// The text of unmatched.csv, with the columns left_id,reason.
std::string unmatched_csv(const reconstruct::MatchList& list);

/// The text of chio.csv: a row for each line of `chio` with its provenance, in map coordinates:
///   left_id, right_id               the initial link
///   linked_right_ids                further fragments of the right edge, separated by spaces
///   process                         1 to 4
///   neighbour_left_id, neighbour_height_m, height_limit_m   the constraint on the line; empty in
///                                                           process 1
///   n_pieces, mean_rate, rate_sigma, azimuth_deg, mean_height_m, height_sigma_m   the edge pieces
///     of the line
///   start_x_m ... end_z_m, sigma_start_x_m ... sigma_end_z_m   the 3D line; may be empty
std::string chio_csv(const reconstruct::ChioResult& result, const LocalFrame& frame);

}  // namespace ridgeline::apps
