// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <pybind11/pybind11.h>

namespace ridgeline::python {

/// A set of lines as a dict. Arrays: segments (n, 2, 3), covariance_m2 (n, 6, 6), left_px and
/// right_px (n, 2, 2), epipolar_angle_deg, support and moved_out_m (n). Lists of n texts: ids,
/// line_class, status, method, kind, building. A list of n lists of ids: plane_ids. A text: crs.
/// Missing numbers are NaN, missing texts "".
pybind11::dict dict_of(const io::LineSet& set);

/// The set of lines from such a dict, in which only `segments` is required. Messages show `name`
/// instead of a path. Throws std::invalid_argument for arrays of a different shape.
io::LineSet line_set_of(const pybind11::dict& arrays, const std::string& name);

}  // namespace ridgeline::python
