// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "io/files/yaml_check.h"

namespace ridgeline::io {

/// The reference system that a file states by its key `crs`; unknown without the key. Throws
/// IoError with the line for one that cannot be understood.
Crs stated_crs(const YamlMap& file);

}  // namespace ridgeline::io
