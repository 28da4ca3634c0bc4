// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <string>

namespace ridgeline::io {

/// Takes ids and buildings of the lines from columns that the user names, upper and lower case
/// being the same; an empty name changes nothing. A feature of several lines gives them "ID.0",
/// "ID.1", ...; a line without a value keeps what it has. Of a model, the second column names its
/// buildings. Throws IoError for a column that the file does not have, for the id of the lines of a
/// model, and for buildings of CityJSON and CityGML, which state their ids.
void name_by_columns(const std::string& id_column,
                     const std::string& building_column,
                     LineSet& set);

}  // namespace ridgeline::io
