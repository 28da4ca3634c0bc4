// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <string>

namespace ridgeline::io {

/// Takes the ids and buildings of the lines from columns named by the user, ignoring case; an empty
/// name changes nothing. Several lines of one feature become "ID.0", "ID.1", ...; a line without a
/// value keeps its own. For a model, the second column names its buildings. Throws IoError for a
/// column that the file does not have, for an id column with a model, and for a building column
/// with CityJSON and CityGML, which state their own ids.
void name_by_columns(const std::string& id_column,
                     const std::string& building_column,
                     LineSet& set);

}  // namespace ridgeline::io
