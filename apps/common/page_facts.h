// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <string>

namespace ridgeline::apps {

/// Texts that the operator wants on top of the report; empty ones are left out.
struct PageFacts {
  std::string title, project, operator_name, date;
};

/// Adds `--title`, `--project`, `--operator` and `--date`.
void add_page_options(CLI::App& app, PageFacts& facts);

nlohmann::ordered_json to_json(const PageFacts& facts);

}  // namespace ridgeline::apps
