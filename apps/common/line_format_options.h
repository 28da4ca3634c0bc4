// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ridgeline::apps {

std::vector<std::string> line_format_names();

/// Adds `--local-origin`.
void add_local_origin_flag(CLI::App& app, bool& local_origin);

}  // namespace ridgeline::apps
