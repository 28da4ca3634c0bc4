// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/shared_options.h"

#include "apps/common/option_flags.h"
#include "io/crs/geoid.h"
#include "io/images/image.h"
#include "reconstruct/geometry/check.h"

#include <filesystem>

namespace ridgeline::apps {

void add_preset_option(CLI::App& app, std::string& preset) {
  app.add_option(
         "--preset", preset,
         "default: best-performing settings; published: the papers' method without our extensions")
      ->check(CLI::IsMember({"default", "published"}))
      ->capture_default_str();
}

void add_config_option(CLI::App& app, std::string& config) {
  if (app.get_option_no_throw("--config") != nullptr) return;
  app.add_option("--config", config,
                 "YAML file of parameters as printed by `ridgeline config`; all are optional");
}

void add_method_options(CLI::App& app, ParameterArguments& arguments) {
  add_preset_option(app, arguments.preset);
  add_config_option(app, arguments.config);
  add_class_option(app, arguments);
}

void add_class_option(CLI::App& app, ParameterArguments& arguments) {
  app.add_option("--max-aligned-angle-deg", arguments.max_aligned_angle_deg,
                 "largest angle to the epipolar line of aligned lines, degrees; default: 10")
      ->check(in_range(0.0, 90.0));
}

void add_judge_options(CLI::App& app, ParameterArguments& arguments) {
  add_config_option(app, arguments.config);
  app.add_option("--lidar-sigma-m", arguments.lidar_sigma_m,
                 "range noise of the cloud, m; default: 0.034")
      ->check(in_range(0.0, 10.0));
}

void add_matcher_option(CLI::App& app, std::string& name) {
  app.add_option("--matcher", name, "matcher of line segments: pairwise or chio")
      ->capture_default_str();
}

std::vector<std::string> line_format_names() {
  std::vector<std::string> names;
  for (const io::LineFormatInfo& info : io::line_formats()) names.emplace_back(info.name);
  return names;
}

void add_line_format_option(CLI::App& app, std::string& name) {
  app.add_option("--format", name, "format of --out; default: by its extension, else geojson")
      ->check(CLI::IsMember(line_format_names()));
}

io::LineFormat line_format_of(const std::string& out, const std::string& name) {
  const std::optional<io::LineFormat> by_ending = io::line_format_of_file(out);
  const std::optional<io::LineFormat> stated = io::line_format(name);
  const auto is_table = [](std::optional<io::LineFormat> format) {
    return format == io::LineFormat::kCsv || format == io::LineFormat::kWktCsv;
  };
  const bool fits = stated == by_ending || (is_table(stated) && is_table(by_ending));
  check(!stated || !by_ending || fits, "--format ", name, ": ", out,
        " has the extension of another format; omit --format or choose another name");
  check(stated || by_ending || std::filesystem::path(out).extension().empty(), "--out = ", out,
        ": no known format has this extension; use another name or give --format");
  if (stated) return *stated;
  return by_ending.value_or(io::LineFormat::kGeoJson);
}

void add_local_origin_flag(CLI::App& app, bool& local_origin) {
  app.add_flag("--local-origin", local_origin,
               "write OBJ and PLY relative to an origin stated in the file, for programs with "
               "32-bit coordinates");
}

void add_overwrite_flag(CLI::App& app, bool& overwrite) {
  app.add_flag("--overwrite", overwrite,
               "replace existing output files; default: stop with an error");
}

void add_image_size_option(CLI::App& app, double& max_image_mpx) {
  constexpr double kMaxImageSize_mpx = static_cast<double>(io::kMaxImagePixels) / 1e6;
  app.add_option("--max-image-mpx", max_image_mpx,
                 fmt::format("largest image to read, million pixels; 0: {:g}, but for small files "
                             "{:g} plus {:g} pixels per byte",
                             io::kDefaultMaxImage_mpx, io::kFreeImage_mpx, io::kMaxPixelsPerByte))
      ->check(in_range(0.0, kMaxImageSize_mpx))
      ->capture_default_str();
}

void add_pair_check_option(CLI::App& app, double& max_y_parallax_px) {
  constexpr double kMaxParallax_px = 1e6;
  app.add_option(
         "--max-y-parallax-px", max_y_parallax_px,
         "reject a pair whose tie points have a median y-parallax above this, px; 0: no check")
      ->check(in_range(0.0, kMaxParallax_px))
      ->capture_default_str();
}

void add_schema_option(CLI::App& app, std::string& schema) {
  app.add_option("--schema", schema,
                 "columns of the lines in the map; fkb: objtype and accuracies in cm, named as in "
                 "FKB-Bygning")
      ->check(CLI::IsMember({"plain", "fkb"}))
      ->capture_default_str();
}

void add_decoys_option(CLI::App& app, std::optional<std::size_t>& n_decoys) {
  app.add_option("--decoys", n_decoys,
                 "number of lines to move on purpose and judge again, to find out how many wrong "
                 "lines would pass; default: half the number of lines, 200 to 2000; 0: none")
      ->check(CLI::NonNegativeNumber);
}

void add_completeness_flag(CLI::App& app, bool& completeness) {
  app.add_flag("--completeness", completeness,
               "find the roof edges in the LIDAR cloud and report which of them the lines show; "
               "takes several seconds per million points");
}

void add_shift_options(CLI::App& app, ShiftArguments& arguments) {
  app.add_flag("--apply-shift", arguments.apply,
               "remove a significant common shift between lines and LIDAR planes before judging; "
               "default: only report it");
  app.add_option("--geoid", arguments.geoid,
                 "geoid grid (.gtx, .tif) for explaining a height shift; default: grids of PROJ");
}

void check_shift_options(const ShiftArguments& arguments) {
  if (!arguments.geoid.empty()) io::require_geoid_grid(arguments.geoid);
}

void add_page_options(CLI::App& app, PageFacts& facts) {
  const char* const group = "Report";
  app.add_option("--title", facts.title, "title of the report")->group(group);
  app.add_option("--project", facts.project, "named in the report")->group(group);
  app.add_option("--operator", facts.operator_name, "named in the report")->group(group);
  app.add_option("--date", facts.date, "printed verbatim in the report")->group(group);
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
