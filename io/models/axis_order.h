// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

namespace ridgeline::io {

/// Turns plan coordinates that come as north, east into east, north, and warns of it. It looks only
/// at a CRS that has its north axis first at EPSG, where files are of both kinds, whatever they
/// should be. The order is decided
///   1. by the place: if the median vertex lies in the CRS's area of use by one of the two orders
///      alone, it is that order;
///   2. else a projected CRS is read as east, north, which most programs write;
///   3. else degrees are read in the order of EPSG if `keeps_axis_order`, see SrsName.
void settle_axis_order(bool keeps_axis_order, BuildingModel& model);

}  // namespace ridgeline::io
