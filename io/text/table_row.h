// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// A number in a table, with a decimal point or comma; a comma is accepted only where it cannot be
/// anything else: "1,5" but not "1,500.0" or "1,500,000".
std::optional<double> table_number(std::string_view field);

/// The separator of a table row: the first of semicolon, tab and comma, in this order, that occurs
/// in the row, otherwise blanks. Commas are decimal marks if blanks separate three numbers with
/// them.
char separator_of(std::string_view row);

/// Whether a row is a comment of a table or, as Excel writes it, states the separator ("sep=;").
bool is_comment_row(std::string_view row);

/// The fields of a row without the quotes ('...' or "...") around them; a quoted field may contain
/// the separator. A run of blanks counts as one separator; between two other separators a field may
/// be empty.
std::vector<std::string> table_fields(std::string_view row, char separator);

/// The program's name for a column of an orientation or a cloud, given any of its usual names with
/// or without a unit ("X [m]", "Easting", "NOM", "omega_deg"): name, x, y, z, omega, phi, kappa,
/// camera, roll, pitch, yaw, latitude, longitude. Other names are returned in lower case.
std::string column_name(std::string_view name);

/// The column names of a table of omega, phi and kappa; empty if the row does not name x, y, z and
/// the angles.
std::vector<std::string> opk_columns(std::string_view row);

}  // namespace ridgeline::io
