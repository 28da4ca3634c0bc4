// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <string_view>

namespace ridgeline::io {

/// The kind that the first bytes of a file state by a mark of its format; kUnknown without such a
/// mark. `start` must not begin with a byte order mark of UTF-8.
FileKind kind_by_mark(std::string_view start);

/// The format of files with such an extension (".gml", lower case), where the content agrees;
/// kUnknown if there is none.
FileKind format_with_extension(std::string_view extension);

/// What files with such an extension hold, by the name alone.
FileKind kind_by_extension(std::string_view extension);

}  // namespace ridgeline::io
