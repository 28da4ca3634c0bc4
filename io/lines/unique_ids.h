// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

namespace ridgeline::io {

/// Gives each line an id of its own, as the judge, tables and maps know lines by their ids. If
/// several layers have the same id, all lines are named by their layer, "ridges.12". If an earlier
/// line has the same id, the later one is numbered as the parts of a polyline are, "12.1", never by
/// a number that another line has. If the id of a part equals an id that the file states, the part
/// gets another number. A warning says so. A set whose ids differ stays as it is.
void make_ids_unique(LineSet& set);

}  // namespace ridgeline::io
