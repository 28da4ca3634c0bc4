// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

namespace ridgeline::io {

/// Gives each line a unique id, because the judge, tables and maps identify lines by id. If several
/// layers have the same id, all ids are prefixed with their layer, "ridges.12". If an earlier line
/// has the same id, the later one is numbered like the parts of a polyline, "12.1", with a number
/// that is not in use. If the id of a part equals an id stated in the file, the part gets another
/// number. Changes are reported in a warning. A set whose ids are unique stays unchanged.
void make_ids_unique(LineSet& set);

}  // namespace ridgeline::io
