// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <string>

namespace ridgeline::io {

/// Whether a file is a building model according to its content.
bool is_model(const std::string& path);

/// The decompressed text of a CityJSON or CityGML file. Throws IoError.
std::string text_of_model(const std::string& path);

/// Reads a building model: CityJSON, CityJSONSeq or CityGML, optionally compressed with gzip; the
/// format is detected from the content. Throws IoError for a file that cannot be read, is not such
/// a model or has no building with faces in the requested LoD; the message states what is
/// available.
BuildingModel read_model(const std::string& path, const ReadModelOptions& options = {});

}  // namespace ridgeline::io
