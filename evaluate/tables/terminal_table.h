// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/table1.h"
#include "evaluate/tables/table2.h"

#include <string>

namespace ridgeline::evaluate {

// The figures that count, in aligned columns of plain text; the files have all of them.

/// "" without rows.
std::string to_terminal(const Table1& table);

/// With the columns of ridges only where there are ridges.
std::string to_terminal(const Table2& table);

}  // namespace ridgeline::evaluate
