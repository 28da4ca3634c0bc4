// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/run_options.h"

#include "apps/common/option_flags.h"
#include "apps/common/shared_options.h"
#include "apps/report/write_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ridgeline::apps {

void add_block_flags(CLI::App& app, RunFlags& flags) {
  add_method_options(app, flags.parameters);
  add_judge_options(app, flags.parameters);
  app.add_option("--methods", flags.methods,
                 fmt::format("methods of reconstruction: {}; default: lines, or direct,joint with "
                             "--preset published",
                             fmt::join(method_names(), ", ")))
      ->delimiter(',')
      ->allow_extra_args(false)  // a patch file may follow
      ->check(CLI::IsMember(method_names()));
  add_matcher_option(app, flags.matcher);
  add_shift_options(app, flags.options.shift);
  add_completeness_flag(app, flags.options.completeness);
  add_schema_option(app, flags.schema);
  add_pair_check_option(app, flags.options.max_y_parallax_px);
  add_image_size_option(app, flags.options.max_image_mpx);
  add_report_flag(app, flags.options.report);
  add_page_options(app, flags.options.page);
  app.add_option("--gross-m", flags.options.summary.gross_m,
                 "distance above which a line is a gross error, m")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void add_run_flags(CLI::App& app, RunFlags& flags) {
  add_block_flags(app, flags);
  app.add_option("--lines-format", flags.line_formats,
                 "more formats of the 3D lines, in addition to GeoJSON")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(line_format_names()));
  add_local_origin_flag(app, flags.options.local_origin);
  add_decoys_option(app, flags.options.n_decoys);
  app.add_flag("--resume", flags.options.resume,
               "skip stages finished by an earlier run with the same inputs and options");
  app.add_option("--until", flags.options.until,
                 "last stage: extract, match, reconstruct or evaluate. Later results of an earlier "
                 "run are removed, with --resume only if they no longer fit")
      ->check(CLI::IsMember({"extract", "match", "reconstruct", kLastStage}))
      ->capture_default_str();
  app.add_option("--assume-crs", flags.options.assume_crs.definition,
                 "CRS of patches, clouds and reference lines, overriding theirs");
}

RunOptions run_options(const RunFlags& flags) {
  RunOptions options = flags.options;
  options.methods.clear();
  for (const std::string& name :
       flags.methods.empty() ? default_methods(flags.parameters) : flags.methods) {
    const reconstruct::Method method = method_named(name);
    if (std::find(options.methods.begin(), options.methods.end(), method) ==
        options.methods.end()) {
      options.methods.push_back(method);
    }
  }
  options.parameters = read_parameters(flags.parameters);
  options.config_path = flags.parameters.config;
  options.parameters.method.matching.matcher = matcher_named(flags.matcher);
  check_preset(flags.parameters, options.methods);
  for (const std::string& name : flags.line_formats) {
    const auto format = io::line_format(name);
    if (!format) continue;
    io::require_writable(*format);
    options.line_formats.push_back(*format);
  }
  options.map_schema = results::map_schema_named(flags.schema);
  validate(options.summary);
  check_shift_options(options.shift);
  return options;
}

}  // namespace ridgeline::apps
