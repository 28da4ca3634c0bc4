// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// The separator of a row of a table: a semicolon, a tab or a comma, whichever comes first in this
/// order, else blanks.
char separator_of(std::string_view row);

/// The fields of a row without the quotes ('...' or "...") around them; a quoted field may hold the
/// separator. Blanks separate in runs; a field between two other separators may be empty.
std::vector<std::string> table_fields(std::string_view row, char separator);

/// The name of a column of an orientation or a cloud as this program calls it, by any of its usual
/// names, with or without a unit ("X [m]", "Easting", "NOM", "omega_deg"): name, x, y, z, omega,
/// phi, kappa, camera, roll, pitch, yaw, latitude, longitude. Others are given back in lower case.
std::string column_name(std::string_view name);

/// The names of the columns of a table of omega, phi and kappa; empty if the row does not name x,
/// y, z and the angles.
std::vector<std::string> opk_columns(std::string_view row);

}  // namespace ridgeline::io
