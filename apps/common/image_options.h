// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace ridgeline::apps {

/// Adds `--max-image-mpx`. Its default 0 stands for the rule of io::check_image_size().
void add_image_size_option(CLI::App& app, double& max_image_mpx);

/// Adds `--max-y-parallax-px`. Its default is the value that `max_y_parallax_px` has.
void add_pair_check_option(CLI::App& app, double& max_y_parallax_px);

}  // namespace ridgeline::apps
