// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/models/building_model.h"

namespace ridgeline::io {

/// The edges of the roofs of a model, building by building, as returned by edges_of_roofs(). The
/// model is normalised first, see settle(). `plane_ids` of a line are the numbers of its roof faces
/// in LineSet::model, `building` is the id of the building, and LineSet::features has a row for
/// each building. Edges of three or more roof faces are counted in `left_out`.
LineSet lines_of_model(BuildingModel model);

}  // namespace ridgeline::io
