// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/cloud_options.h"
#include "apps/common/command.h"
#include "apps/common/option_flags.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/evaluate/write_evaluation.h"
#include "apps/pipeline/open_patch.h"
#include "apps/report/write_report.h"
#include "evaluate/files/cloud_name.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/files/judged_attributes.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/files/write_results.h"
#include "io/cloud/labelled_points.h"

#include <memory>
#include <optional>

namespace ridgeline::apps {
namespace {

/// The options as given on the command line.
struct EvaluateArguments {
  std::vector<std::string> lines;
  CloudArguments cloud;
  std::string out, patch, reference_lines, write_points, schema = "plain";
  bool vertex_pairs = false, report = true, overwrite = false, completeness = false;
  std::vector<double> area;
  std::string lod, write_attributes, id_column, building_column;
  std::vector<std::string> by;
  ParameterArguments parameters;
  evaluate::SummaryOptions summary;
  ShiftArguments shift;
  std::optional<std::size_t> n_decoys;
  PageFacts page;
};

void add_inputs(CLI::App& app, EvaluateArguments& a) {
  app.add_option("--lines", a.lines,
                 "3D lines: GeoJSON, GeoPackage, Shapefile, DXF, WKT, CSV, OBJ, PLY, Line3D++, "
                 "LIMAP, ELSR; or building models: CityJSON, CityGML; every file is judged")
      ->required();
  add_cloud_option(app, a.cloud);
  app.add_option("--out", a.out, "folder for the results")->required();
  app.add_option("--patch", a.patch,
                 "patch file; its cameras classify lines as aligned or not_aligned, its lidar is "
                 "the default for --cloud");
  app.add_option("--reference-lines", a.reference_lines,
                 "true 3D lines, or polygons with heights (their edges), for precision and "
                 "completeness in addition to distances");
  add_assume_crs_option(app, a.cloud);
  app.add_option("--lod", a.lod,
                 "level of detail of a building model: 2.2, or 2 for the highest 2.x; default: the "
                 "highest of each building, up to 3");
  app.add_option("--id", a.id_column, "column of line ids; default: id, else the line number");
  app.add_option("--building", a.building_column,
                 "column of the building of a line, or of the building names of a model without "
                 "ids; default: building");
  app.add_option("--by", a.by, "building attributes of a model for grouping in buildings_by.csv")
      ->delimiter(',');
  app.add_option("--write-attributes", a.write_attributes,
                 "write the model with the figures of its buildings as attributes to this file "
                 "(.json, .jsonl, .gml, .gpkg); a single model only");
  app.add_option("--area", a.area,
                 "x_min,y_min,x_max,y_max in the cloud's own coordinates: judge only the lines "
                 "whose middle lies there (x_min <= x < x_max), for `ridgeline pool`")
      ->delimiter(',')
      ->expected(4);
  add_scale_to_ground_flag(app, a.cloud);
  app.add_option("--write-points", a.write_points,
                 "write the points of the planes, coloured by plane, to this file (.las, .pcd, "
                 ".ply); a single line file only");
  add_overwrite_flag(app, a.overwrite);
  add_shift_options(app, a.shift);
  add_decoys_option(app, a.n_decoys);
  add_completeness_flag(app, a.completeness);
  add_schema_option(app, a.schema);
  add_page_options(app, a.page);
  add_report_flag(app, a.report);
  app.add_flag("--pairs", a.vertex_pairs,
               "read every two consecutive vertices of an OBJ as a line");
}

void add_statistics_options(CLI::App& app, EvaluateArguments& a) {
  const char* group = "Statistics";
  app.add_option("--gross-m", a.summary.gross_m, "distance above which a line is a gross error, m")
      ->capture_default_str()
      ->group(group);
  app.add_option("--sigma-sys-m", a.summary.sigma_sys_m,
                 "systematic part of the accuracy of the cloud (datum, strips), m")
      ->capture_default_str()
      ->group(group);
  app.add_option("--bootstrap-replicates", a.summary.bootstrap.replicates, "of the intervals")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->group(group);
  app.add_option("--bootstrap-seed", a.summary.bootstrap.seed, "of the intervals")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->group(group);
  app.add_flag("--bca", a.summary.bootstrap.bca, "compute bias-corrected and accelerated intervals")
      ->group(group);
}

Eigen::AlignedBox2d area_of(const EvaluateArguments& a) {
  const Eigen::AlignedBox2d area(Eigen::Vector2d(a.area[0], a.area[1]),
                                 Eigen::Vector2d(a.area[2], a.area[3]));
  check(area.min().allFinite() && area.max().allFinite() && (area.sizes().array() > 0.0).all(),
        "--area = ", a.area[0], ",", a.area[1], ",", a.area[2], ",", a.area[3],
        ", must be x_min,y_min,x_max,y_max with x_min < x_max and y_min < y_max");
  check(a.reference_lines.empty(),
        "--reference-lines: completeness is that of all lines, and --area judges some");
  check(a.write_attributes.empty(),
        "--write-attributes: the model has all buildings, and --area judges some");
  return area;
}

results::JudgeFilesOptions judge_files_options(const EvaluateArguments& a) {
  results::JudgeFilesOptions options;
  options.line_paths = a.lines;
  options.cloud_paths = a.cloud.clouds;
  if (!a.patch.empty()) {
    options.patch = read_patch(a.patch, {a.cloud.assume_crs});
    options.patch_name = options.patch->id;
    if (options.cloud_paths.empty()) options.cloud_paths = options.patch->lidar;
    options.reference_lines = options.patch->reference_lines;
  }
  if (!a.reference_lines.empty()) options.reference_lines = a.reference_lines;
  if (options.cloud_paths.empty()) {
    throw std::invalid_argument("no cloud: give --cloud FILE, or --patch with the key lidar");
  }
  if (options.patch_name.empty()) options.patch_name = results::cloud_name(options.cloud_paths);
  options.cloud = read_options(a.cloud);
  options.scale_to_ground = a.cloud.scale_to_ground;
  if (!a.area.empty()) {
    options.area = area_of(a);
    options.reference_lines.reset();
    options.refuse_other_places = false;  // cannot be determined from a part of the lines
  }
  options.cloud_memory_mib = a.cloud.cloud_memory_mib;
  options.apply_shift = a.shift.apply;
  options.geoid = a.shift.geoid;
  options.n_decoys = a.n_decoys;
  options.completeness = a.completeness;
  options.lines.assume_crs.definition = a.cloud.assume_crs;
  options.lines.vertex_pairs = a.vertex_pairs;
  options.lines.lod = a.lod;
  options.lines.id_column = a.id_column;
  options.lines.building_column = a.building_column;
  options.by = a.by;
  options.needs_models = !a.write_attributes.empty();
  const Parameters parameters = read_parameters(a.parameters);
  options.max_aligned_angle_deg = parameters.method.estimation.lines.max_aligned_angle_deg;
  options.judge = parameters.judge;
  options.judge.keep_points = !a.write_points.empty();
  options.summary = a.summary;
  validate(options.summary);
  return options;
}

void check_points_file(const EvaluateArguments& a, const std::vector<std::string>& inputs) {
  if (a.write_points.empty()) return;
  check(a.lines.size() == 1, "--write-points: there are ", a.lines.size(),
        " line files, whose planes differ; give one");
  io::require_point_format(a.write_points);
  results::check_output_file(a.write_points, inputs, a.overwrite);
}

void check_attributes(const EvaluateArguments& a,
                      std::vector<std::string> others,
                      const results::OutputFolder& out) {
  if (a.write_attributes.empty()) return;
  check(a.lines.size() == 1, "--write-attributes: there are ", a.lines.size(),
        " line files; give one model");
  for (const std::string& name : results::result_names(a.lines)) others.push_back(out.path(name));
  results::check_output_file(a.write_attributes, others, a.overwrite);
  results::check_attributes_file(a.write_attributes);
}

int run_evaluate(const EvaluateArguments& arguments) {
  check_shift_options(arguments.shift);
  results::RunRecord record("evaluate");
  const results::JudgeFilesOptions options = judge_files_options(arguments);
  record.set_options(echo(options));
  if (options.patch) {
    inform_of(options.patch->decisions);
    warn_of(options.patch->warnings);
    record.add_warnings(notes_on(*options.patch));
  }
  const std::vector<results::InputFile> inputs = inputs_of(options, arguments.parameters.config);
  const std::vector<std::string> paths = results::paths_of(inputs);
  const results::OutputFolder out(arguments.out, paths);
  for (const std::string& name : results::result_names(options.line_paths)) (void)out.path(name);

  check_points_file(arguments, paths);
  check_attributes(arguments, paths, out);

  const results::JudgedFiles judged = results::judge_files(options, record);
  write_evaluation(judged, options, inputs, out,
                   {.folder = arguments.out,
                    .schema = arguments.schema,
                    .plane_points = arguments.write_points,
                    .attributes = arguments.write_attributes,
                    .report = arguments.report,
                    .page = arguments.page},
                   record);
  return kDone;
}

}  // namespace

Run add_evaluate(CLI::App& subcommand) {
  auto arguments = std::make_shared<EvaluateArguments>();
  add_inputs(subcommand, *arguments);
  add_cloud_filters(subcommand, arguments->cloud);
  add_judge_options(subcommand, arguments->parameters);
  add_class_option(subcommand, arguments->parameters);
  add_statistics_options(subcommand, *arguments);
  return [arguments] { return run_evaluate(*arguments); };
}

}  // namespace ridgeline::apps
