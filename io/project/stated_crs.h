// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "io/files/yaml_check.h"

namespace ridgeline::io {

/// The reference system given by a file's key `crs`; unknown without the key. Throws IoError with
/// the line if the definition cannot be interpreted.
Crs stated_crs(const YamlMap& file);

}  // namespace ridgeline::io
