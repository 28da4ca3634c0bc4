// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <string>
#include <string_view>

namespace ridgeline::io {

// One reader per format. Each throws IoError for a file that cannot be read or is incomplete, and
// counts in BuildingModel::left_out anything that is not a face of a building. Faces are returned
// as they are in the file, whether or not they make sense.

/// CityJSON 1.0 to 2.0, one document or a sequence of features (CityJSONSeq).
BuildingModel read_cityjson(const std::string& path,
                            std::string_view content,
                            const ReadModelOptions& options);

/// CityGML 1.0 to 3.0, optionally compressed with gzip. The file is read piece by piece.
BuildingModel read_citygml(const std::string& path, const ReadModelOptions& options);

}  // namespace ridgeline::io
