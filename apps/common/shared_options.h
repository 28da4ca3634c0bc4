// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/pipeline/parameters.h"
#include "io/lines/write_lines.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// Options shared by several commands.

namespace ridgeline::apps {

void add_preset_option(CLI::App& app, std::string& preset);
/// Adds `--config`, unless the command has it already.
void add_config_option(CLI::App& app, std::string& config);
/// Adds `--max-aligned-angle-deg`.
void add_class_option(CLI::App& app, ParameterArguments& arguments);
/// Adds `--preset`, `--config` and `--max-aligned-angle-deg`.
void add_method_options(CLI::App& app, ParameterArguments& arguments);
/// Adds `--config` and `--lidar-sigma-m`.
void add_judge_options(CLI::App& app, ParameterArguments& arguments);
/// Adds `--matcher`, which takes one matcher.
void add_matcher_option(CLI::App& app, std::string& name);

std::vector<std::string> line_format_names();

/// Adds `--format`, which takes one of them.
void add_line_format_option(CLI::App& app, std::string& name);
/// The format of a file of lines: the one with this name, else by the file extension; GeoJSON if
/// neither states one. Throws std::invalid_argument if they differ, or for an unknown extension.
io::LineFormat line_format_of(const std::string& out, const std::string& name);

/// Adds `--overwrite`, for results::check_output_file().
void add_overwrite_flag(CLI::App& app, bool& overwrite);

/// Adds `--local-origin`.
void add_local_origin_flag(CLI::App& app, bool& local_origin);

/// Adds `--max-image-mpx`. Its default 0 means the limit of io::check_image_size().
void add_image_size_option(CLI::App& app, double& max_image_mpx);

/// Adds `--max-y-parallax-px`. Its default is the current value of `max_y_parallax_px`.
void add_pair_check_option(CLI::App& app, double& max_y_parallax_px);

/// Adds `--schema`, which takes a name for results::map_schema_named().
void add_schema_option(CLI::App& app, std::string& schema);

/// How to handle a common shift between lines and LIDAR planes.
struct ShiftArguments {
  bool apply = false;
  std::string geoid;  ///< geoid grid; may be empty
};

/// Adds `--decoys`.
void add_decoys_option(CLI::App& app, std::optional<std::size_t>& n_decoys);

/// Adds `--completeness`.
void add_completeness_flag(CLI::App& app, bool& completeness);

/// Adds `--apply-shift` and `--geoid`.
void add_shift_options(CLI::App& app, ShiftArguments& arguments);

/// Throws IoError for a geoid grid that cannot be read.
void check_shift_options(const ShiftArguments& arguments);

/// Texts for the top of the report; empty ones are left out.
struct PageFacts {
  std::string title, project, operator_name, date;
};

/// Adds `--title`, `--project`, `--operator` and `--date`.
void add_page_options(CLI::App& app, PageFacts& facts);

nlohmann::ordered_json to_json(const PageFacts& facts);

}  // namespace ridgeline::apps
