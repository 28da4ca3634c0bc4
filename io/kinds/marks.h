// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <string_view>

namespace ridgeline::io {

/// The kind that the first bytes of a file state by a mark of its format; kUnknown without such a
/// mark. `start` must not begin with a byte order mark of UTF-8.
FileKind kind_by_mark(std::string_view start);

/// What files with such an extension (".gml", lower case) hold; kUnknown if that is not known.
FileKind kind_by_extension(std::string_view extension);

}  // namespace ridgeline::io
