// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"

#include <string>

namespace ridgeline::results {

/// Throws std::invalid_argument unless the name ends in .json, .jsonl, .gml or .gpkg, and IoError
/// if a file stands there that is none of write_model_with_figures().
void check_attributes_file(const std::string& file);

/// Writes the buildings of a judged model with their figures as attributes ridgeline_verdict,
/// ridgeline_rms_m, ..., in the format that the ending of `file` names. CityJSON of CityJSON is the
/// file itself with further attributes; all other pairs of formats have the faces that were judged.
/// `i`: number of the line file. Throws IoError if a file cannot be read again or written.
void write_model_with_figures(const std::string& file, const JudgedFiles& judged, std::size_t i);

}  // namespace ridgeline::results
