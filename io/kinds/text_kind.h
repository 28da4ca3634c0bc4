// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"
#include "io/kinds/top_keys.h"

#include <string_view>

namespace ridgeline::io {

/// Identifies a JSON or YAML document by its outermost keys; kUnknown if they are inconclusive: no
/// known key, or as many keys of one kind as of another.
FileKind kind_of_document(const TopKeys& keys);

/// Identifies a text by its first rows: a JSON or YAML document, XML, a table, lines or numbers.
/// `is_whole`: nothing follows, so the last row is complete.
FileKind kind_of_text(std::string_view start, bool is_whole);

}  // namespace ridgeline::io
