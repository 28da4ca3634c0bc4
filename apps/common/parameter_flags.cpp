// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/parameter_flags.h"

#include "apps/common/option_flags.h"

namespace ridgeline::apps {

void add_preset_option(CLI::App& app, std::string& preset) {
  app.add_option("--preset", preset,
                 "default: the best known; published: as the papers say, nothing of ours")
      ->check(CLI::IsMember({"default", "published"}))
      ->capture_default_str();
}

void add_config_option(CLI::App& app, std::string& config) {
  if (app.get_option_no_throw("--config") != nullptr) return;
  app.add_option("--config", config,
                 "parameters in YAML as `ridgeline config` prints them; any may be left out");
}

void add_method_options(CLI::App& app, ParameterArguments& arguments) {
  add_preset_option(app, arguments.preset);
  add_config_option(app, arguments.config);
  add_class_option(app, arguments);
}

void add_class_option(CLI::App& app, ParameterArguments& arguments) {
  app.add_option("--max-aligned-angle-deg", arguments.max_aligned_angle_deg,
                 "lines up to this angle to the epipolar line are aligned; default: 10")
      ->check(in_range(0.0, 90.0));
}

void add_judge_options(CLI::App& app, ParameterArguments& arguments) {
  add_config_option(app, arguments.config);
  app.add_option("--lidar-sigma-m", arguments.lidar_sigma_m,
                 "range noise of the cloud; default: 0.034")
      ->check(in_range(0.0, 10.0));
}

void add_matcher_option(CLI::App& app, std::vector<std::string>& names) {
  app.add_option("--matcher", names, "of the line segments: pairwise, chio, or both: pairwise,chio")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"pairwise", "chio"}))
      ->capture_default_str();
}

}  // namespace ridgeline::apps
