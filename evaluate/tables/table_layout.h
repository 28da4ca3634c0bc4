// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/table2.h"

#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// The published layout of Table 2: a row per patch, a group of columns per method.
struct Table2Layout {
  struct LayoutRow {
    std::string patch;
    std::vector<const Summary*> cells;  ///< methods x classes; nullptr for a cell without figures
  };
  std::vector<std::string> methods;
  std::vector<std::string> classes;  ///< not_aligned, aligned, total; or only total
  std::vector<LayoutRow> rows;
};

/// The layout of a table, with patches and methods in order of first appearance. Its pointers refer
/// to `table`.
Table2Layout lay_out(const Table2& table);

}  // namespace ridgeline::evaluate
