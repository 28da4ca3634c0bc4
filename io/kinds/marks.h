// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <string_view>

namespace ridgeline::io {

/// The kind of a file whose first bytes contain the signature of a format; kUnknown without such a
/// signature. `start` must not begin with a UTF-8 byte order mark.
FileKind kind_by_mark(std::string_view start);

/// The format with this extension (".gml", lower case), for use where the content is consistent
/// with it; kUnknown if there is none.
FileKind format_with_extension(std::string_view extension);

/// The kind that the extension suggests, based on the name only.
FileKind kind_by_extension(std::string_view extension);

}  // namespace ridgeline::io
