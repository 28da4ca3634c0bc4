// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/info/info_warnings.h"
#include "io/crs/crs.h"

#include <string>

namespace ridgeline::apps {

/// Prints the name of a reference system and its units.
void print_crs(const io::Crs& crs);

/// Prints the facts of a cloud. `max_resolution_m`: io::ReadOptions::max_resolution_m. Throws
/// IoError like io::cloud_facts().
void print_cloud(const std::string& path, double max_resolution_m, InfoWarnings& warnings);

/// Prints the facts of lines or building models. Throws IoError like io::read_lines().
void print_lines(const std::string& path, InfoWarnings& warnings);

}  // namespace ridgeline::apps
