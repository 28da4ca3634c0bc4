// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace ridgeline::apps {

/// Adds `--schema`, which takes a name for results::map_schema_named().
void add_schema_option(CLI::App& app, std::string& schema);

}  // namespace ridgeline::apps
