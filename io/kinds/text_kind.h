// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"
#include "io/kinds/top_keys.h"

#include <string_view>

namespace ridgeline::io {

/// What a JSON or YAML document is, by its outermost keys; kUnknown if they leave that open: none
/// of the keys that we know, or as many of one kind as of another.
FileKind kind_of_document(const TopKeys& keys);

/// What a text is by its first rows: a JSON or YAML document, XML, a table, lines or numbers.
/// `is_whole`: nothing follows, so the last row is not cut.
FileKind kind_of_text(std::string_view start, bool is_whole);

}  // namespace ridgeline::io
