// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/shared_options.h"

#include "apps/common/option_flags.h"
#include "io/crs/geoid.h"
#include "io/images/image.h"
#include "io/lines/write_lines.h"

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

std::vector<std::string> line_format_names() {
  std::vector<std::string> names;
  for (const io::LineFormatInfo& info : io::line_formats()) names.emplace_back(info.name);
  return names;
}

void add_local_origin_flag(CLI::App& app, bool& local_origin) {
  app.add_flag(
      "--local-origin", local_origin,
      "lines as OBJ and PLY relative to an origin that the file states, for programs that hold "
      "coordinates in 32 bits");
}

void add_overwrite_flag(CLI::App& app, bool& overwrite) {
  app.add_flag("--overwrite", overwrite, "replace output files that exist; default: they are kept");
}

void add_image_size_option(CLI::App& app, double& max_image_mpx) {
  constexpr double kMaxImageSize_mpx = static_cast<double>(io::kMaxImagePixels) / 1e6;
  app.add_option("--max-image-mpx", max_image_mpx,
                 fmt::format("largest image to be read, million pixels; 0: {:g}, and of a small "
                             "file no more than {:g} "
                             "and {:g} pixels per byte",
                             io::kDefaultMaxImage_mpx, io::kFreeImage_mpx, io::kMaxPixelsPerByte))
      ->check(in_range(0.0, kMaxImageSize_mpx))
      ->capture_default_str();
}

void add_pair_check_option(CLI::App& app, double& max_y_parallax_px) {
  constexpr double kMaxParallax_px = 1e6;
  app.add_option("--max-y-parallax-px", max_y_parallax_px,
                 "images do not fit their cameras if points that both show lie farther from the "
                 "epipolar lines of "
                 "each other, median, px; 0: no check")
      ->check(in_range(0.0, kMaxParallax_px))
      ->capture_default_str();
}

void add_schema_option(CLI::App& app, std::string& schema) {
  app.add_option(
         "--schema", schema,
         "of the map's lines; fkb: with objtype and accuracies in cm as FKB-Bygning names them")
      ->check(CLI::IsMember({"plain", "fkb"}))
      ->capture_default_str();
}

void add_decoys_option(CLI::App& app, std::optional<std::size_t>& n_decoys) {
  app.add_option(
         "--decoys", n_decoys,
         "moves lines to so many wrong places and judges them again, to see how many of them "
         "would pass; default: half as many as lines, 200 to 2000; 0: none")
      ->check(CLI::NonNegativeNumber);
}

void add_shift_options(CLI::App& app, ShiftArguments& arguments) {
  app.add_flag("--apply-shift", arguments.apply,
               "judge the lines without a shift that all have against the LIDAR planes, if it is "
               "significant; "
               "default: it is reported, and nothing is moved");
  app.add_option("--geoid", arguments.geoid,
                 "geoid grid (.gtx, .tif) that explains a shift in height; default: what PROJ has");
}

void check_shift_options(const ShiftArguments& arguments) {
  if (!arguments.geoid.empty()) io::require_geoid_grid(arguments.geoid);
}

void add_page_options(CLI::App& app, PageFacts& facts) {
  const char* const group = "Report";
  app.add_option("--title", facts.title, "of the report")->group(group);
  app.add_option("--project", facts.project, "named in the report")->group(group);
  app.add_option("--operator", facts.operator_name, "named in the report")->group(group);
  app.add_option("--date", facts.date, "named in the report, as it is written here")->group(group);
}

nlohmann::ordered_json to_json(const PageFacts& facts) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) json[name] = value;
  };
  add("title", facts.title);
  add("project", facts.project);
  add("operator", facts.operator_name);
  add("date", facts.date);
  return json;
}

}  // namespace ridgeline::apps
