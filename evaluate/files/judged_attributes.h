// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"

#include <string>

namespace ridgeline::results {

/// Throws std::invalid_argument unless the name ends in .json, .jsonl, .gml or .gpkg, and IoError
/// if there is already a file that write_model_with_figures() did not write.
void check_attributes_file(const std::string& file);

/// Writes the buildings of a judged model with their figures as attributes ridgeline_verdict,
/// ridgeline_rms_m, ..., in the format given by the extension of `file`. CityJSON input written as
/// CityJSON is the original file with further attributes; all other combinations contain the faces
/// as judged. `i`: index of the line file. Throws IoError if a file cannot be re-read or written.
void write_model_with_figures(const std::string& file, const JudgedFiles& judged, std::size_t i);

}  // namespace ridgeline::results
