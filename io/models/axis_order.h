// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

namespace ridgeline::io {

/// Swaps plan coordinates given as north, east to east, north, with a warning. This concerns only
/// CRSs whose first axis in EPSG is north, because their files come in both orders, whatever the
/// standard requires. The order is decided
///   1. by location: if the median vertex lies in the CRS's area of use in only one of the two
///      orders, that order is used;
///   2. otherwise a projected CRS is read as east, north, which most programs write;
///   3. otherwise degrees are read in EPSG axis order if `keeps_axis_order`, see SrsName.
void settle_axis_order(bool keeps_axis_order, BuildingModel& model);

}  // namespace ridgeline::io
