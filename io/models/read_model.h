// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <string>

namespace ridgeline::io {

/// Whether the content of a file says that it is a model of buildings.
bool is_model(const std::string& path);

/// The text of a file of CityJSON or CityGML, decompressed. Throws IoError.
std::string text_of_model(const std::string& path);

/// Reads a model of buildings: CityJSON, CityJSONSeq or CityGML, also compressed by gzip; the
/// content tells the format. Throws IoError for a file that cannot be read, that is no such model
/// or has no building with faces in the LoD that is wanted; the message says what there is.
BuildingModel read_model(const std::string& path, const ReadModelOptions& options = {});

}  // namespace ridgeline::io
