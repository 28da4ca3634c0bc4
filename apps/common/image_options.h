// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace ridgeline::apps {

/// `--max-image-mpx`; 0, the default, is the rule of io::check_image_size().
void add_image_size_option(CLI::App& app, double& max_image_mpx);

/// `--max-y-parallax-px`, with the default of check_pair().
void add_pair_check_option(CLI::App& app, double& max_y_parallax_px);

}  // namespace ridgeline::apps
