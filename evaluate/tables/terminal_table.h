// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/table1.h"
#include "evaluate/tables/table2.h"

#include <string>

namespace ridgeline::evaluate {

// The main figures in aligned columns of plain text. The result files contain all figures.

/// Counts, correctness and completeness of the matches; "" if the table has no rows.
std::string to_terminal(const Table1& table);

/// Distances of the lines from LIDAR planes; columns for ridges only if there are ridges.
std::string to_terminal(const Table2& table);

}  // namespace ridgeline::evaluate
