// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/models/building_model.h"

namespace ridgeline::io {

struct ModelEdgeOptions {
  double least_angle_deg = 5.0;  ///< between roof faces: neighbours that differ less have no edge
};

/// The edges of the roofs of a model, building by building, each once:
///   ridge   two roof faces fall away from it, and it is level (up to 5 degrees)
///   hip     two roof faces fall away from it, and it is inclined
///   valley  two roof faces rise from it
///   eave    border of an inclined roof face across its slope (more than 45 degrees from it in
///           plan)
///   verge   border of an inclined roof face along its slope (up to 45 degrees from it in plan)
///   step    border of a level roof face (up to 5 degrees), or the foot of a wall that rises from a
///           roof face
/// The model is brought into order first, see settle(). Faces meet where their edges run along each
/// other, with or without common vertices (up to 1 cm); an edge ends where its faces change.
/// `plane_ids` of a line are the numbers of its roof faces in LineSet::model, `building` is the id
/// of the building, and LineSet::features has a row for each building. Edges of three roof faces
/// and more are counted in `left_out`.
LineSet lines_of_model(BuildingModel model, const ModelEdgeOptions& options = {});

}  // namespace ridgeline::io
