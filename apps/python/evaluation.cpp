// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/open_patch.h"
#include "apps/pipeline/parameters.h"
#include "apps/python/bindings.h"
#include "apps/python/clouds.h"
#include "apps/python/entries.h"
#include "apps/python/in_memory.h"
#include "apps/python/interruptible.h"
#include "apps/python/judged.h"
#include "apps/python/lines.h"
#include "apps/python/views.h"
#include "evaluate/files/cloud_name.h"
#include "evaluate/tables/shift_text.h"
#include "io/crs/geoid.h"
#include "io/lines/line_checks.h"
#include "reconstruct/geometry/check.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;
namespace {

/// The path of a line file, or lines in memory.
using LineSource = std::variant<std::string, io::LineSet>;

LineSource line_source(const py::object& lines, const char* name) {
  if (py::isinstance<py::str>(lines)) return lines.cast<std::string>();
  return line_set_of(lines.cast<py::dict>(), name);
}

io::LineSet read_source(const LineSource& source, const io::ReadLinesOptions& options) {
  if (const auto* path = std::get_if<std::string>(&source)) return io::read_lines(*path, options);
  io::LineSet set = std::get<io::LineSet>(source);
  if (options.assume_crs.known()) set.crs = options.assume_crs;
  io::check_lines(set);
  return set;
}

apps::Parameters parameters_of(const py::dict& entries) {
  apps::ParameterArguments arguments;
  take(entries, "config", arguments.config);
  take(entries, "config_text", arguments.config_text);
  take(entries, "max_aligned_angle_deg", arguments.max_aligned_angle_deg);
  return read_parameters(arguments);
}

results::JudgeFilesOptions judge_options(const py::dict& entries) {
  results::JudgeFilesOptions options;
  options.cloud = read_options(entries);
  options.lines.assume_crs = options.cloud.assume_crs;
  take(entries, "vertex_pairs", options.lines.vertex_pairs);
  take(entries, "lod", options.lines.lod);
  take(entries, "scale_to_ground", options.scale_to_ground);
  take(entries, "apply_shift", options.apply_shift);
  take(entries, "geoid", options.geoid);
  take(entries, "completeness", options.completeness);
  if (entries.contains("decoys") && !entries["decoys"].is_none()) {
    take(entries, "decoys", options.n_decoys.emplace());
  }
  if (!options.geoid.empty()) io::require_geoid_grid(options.geoid);
  take(entries, "cloud_memory_mib", options.cloud_memory_mib);
  take(entries, "name", options.patch_name);
  const apps::Parameters parameters = parameters_of(entries);
  options.max_aligned_angle_deg = parameters.method.estimation.lines.max_aligned_angle_deg;
  options.judge = parameters.judge;
  take(entries, "gross_m", options.summary.gross_m);
  take(entries, "sigma_sys_m", options.summary.sigma_sys_m);
  take(entries, "bootstrap_replicates", options.summary.bootstrap.replicates);
  take(entries, "bootstrap_seed", options.summary.bootstrap.seed);
  take(entries, "bca", options.summary.bootstrap.bca);
  validate(options.summary);
  std::string patch;
  take(entries, "patch", patch);
  if (!patch.empty()) {
    options.patch = apps::read_patch(patch, options.cloud.assume_crs);
    if (options.patch_name.empty()) options.patch_name = options.patch->id;
  } else if (entries.contains("views")) {
    options.patch = patch_of_views(entries);
  }
  return options;
}

std::vector<results::InputFile> input_files(const LineSource& lines,
                                            const std::optional<LineSource>& references,
                                            const results::JudgeFilesOptions& options,
                                            const py::dict& entries) {
  std::vector<results::InputFile> files;
  const auto add = [&](const char* role, const LineSource& source) {
    if (const auto* path = std::get_if<std::string>(&source)) files.push_back({role, *path});
  };
  add("lines", lines);
  for (const std::string& path : io::expand_patterns(options.cloud_paths)) {
    files.push_back({"cloud", path});
  }
  if (options.patch && options.patch->path != kViewsInMemory) {
    files.push_back({"patch", options.patch->path});
    for (const std::string& path : options.patch->orientation_files)
      files.push_back({"orientation", path});
  }
  if (references) add("reference", *references);
  if (!options.geoid.empty()) files.push_back({"geoid", options.geoid});
  std::string config;
  take(entries, "config", config);
  if (!config.empty()) files.push_back({"config", config});
  return files;
}

/// Lines in memory without a reference system are assumed to be in that of the cloud.
void take_crs(const io::Crs& of_cloud, const LineSource& source, io::LineSet& set) {
  if (std::holds_alternative<io::LineSet>(source) && !set.crs.known()) set.crs = of_cloud;
}

/// Judges lines. `lines`, `references`: path, dict of arrays, or None (references only). `cloud`:
/// list of paths, or an array, with its reference system in the entry `cloud_crs`.
Judged evaluate_lines(const py::object& lines,
                      const py::object& cloud,
                      const py::object& references,
                      const py::dict& entries) {
  results::JudgeFilesOptions options = judge_options(entries);
  const LineSource source = line_source(lines, kLinesInMemory);
  std::optional<LineSource> truth;
  if (!references.is_none()) truth = line_source(references, kReferencesInMemory);
  const CloudInput input = cloud_input(cloud, entries);
  if (const auto* path = std::get_if<std::string>(&source)) options.line_paths = {*path};
  options.cloud_paths = input.paths;
  if (options.patch_name.empty()) {
    options.patch_name = input.points ? kCloudInMemory : results::cloud_name(input.paths);
  }
  Judged judged;
  judged.inputs = input_files(source, truth, options, entries);
  interruptibly([&] {
    results::LinesToJudge to_judge;
    to_judge.sets.push_back(read_source(source, options.lines));
    if (truth) to_judge.references = read_source(*truth, options.lines);
    io::CloudFiles files = input.open(options.cloud, to_judge.sets.front().crs);
    take_crs(files.crs(), source, to_judge.sets.front());
    if (truth) take_crs(files.crs(), *truth, *to_judge.references);
    judged.files = results::judge_lines(std::move(to_judge), files, options, judged.record);
  });
  if (options.patch) {
    std::ranges::move(apps::notes_on(*options.patch), std::back_inserter(judged.files.warnings));
  }
  std::ranges::move(evaluate::shift_messages(judged.files.evaluations, options.apply_shift),
                    std::back_inserter(judged.files.warnings));
  std::erase_if(judged.inputs, [&](const results::InputFile& file) {
    return std::ranges::find(judged.files.unread_clouds, file.path) !=
           judged.files.unread_clouds.end();
  });
  judged.record.set_options(apps::echo(options));
  return judged;
}

}  // namespace

void add_evaluation(py::module_& core) {
  add_judged(core);
  core.attr("judge_options") = apps::judge_parameter_names();
  core.def("evaluate", &evaluate_lines, py::arg("lines"), py::arg("cloud"), py::arg("references"),
           py::arg("options"));
}

}  // namespace ridgeline::python
