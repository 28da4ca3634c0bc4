// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/judged.h"

#include "apps/python/arrays.h"
#include "apps/python/interruptible.h"
#include "apps/python/lines.h"
#include "evaluate/files/judged_map.h"
#include "evaluate/files/model_files.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/files/write_results.h"
#include "evaluate/tables/completeness_table.h"
#include "evaluate/tables/decoy_table.h"
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/table2.h"
#include "evaluate/tables/terminal_table.h"

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;
namespace {

using evaluate::LineEvaluation;

py::dict lines_dict(const Judged& judged) {
  const std::vector<LineEvaluation>& lines = judged.evaluation().lines;
  py::dict d;
  using L = LineEvaluation;
  d["id"] = list_of(lines, [](const L& l) { return l.id; });
  d["line_class"] = list_of(lines, [](const L& l) { return l.line_class; });
  d["class_base"] = list_of(lines, [](const L& l) { return l.class_base; });
  d["status"] = list_of(lines, [](const L& l) { return std::string(name(l.status)); });
  d["reason"] = list_of(lines, [](const L& l) { return l.reason; });
  d["kind"] = list_of(lines, [](const L& l) { return std::string(name(l.kind)); });
  d["flags"] = list_of(lines, [](const L& l) { return py::cast(l.flags); });
  d["surface"] = list_of(lines, [](const L& l) { return std::string(name(l.surface)); });
  d["surface_other"] =
      list_of(lines, [](const L& l) { return std::string(name(l.surface_other)); });
  d["surface_probability"] = number_array(lines, &L::surface_probability);
  d["decided_by"] = list_of(lines, [](const L& l) { return std::string(name(l.decided_by)); });
  d["plane_ids"] = list_of(lines, [](const L& l) {
    py::list ids;
    for (const evaluate::JudgingPlane& plane : l.planes) ids.append(plane.id);
    return ids;
  });
  d["length_m"] = number_array(lines, [](const L& l) { return std::optional(l.length_m); });
  d["mean_distance_m"] = number_array(lines, &L::mean_distance_m);
  d["max_distance_m"] = number_array(lines, &L::max_distance_m);
  d["signed_mean_m"] = number_array(lines, &L::signed_mean_m);
  d["sigma_plane_m"] = number_array(lines, &L::sigma_plane_m);
  d["sigma_line_m"] = number_array(lines, &L::sigma_line_m);
  d["z"] = number_array(lines, &L::z);
  d["n_images"] = number_array(lines, [](const L& l) {
    return l.n_images ? std::optional<double>(*l.n_images) : std::nullopt;
  });
  d["epipolar_angle_deg"] = number_array(lines, [](const L& l) { return l.epipolar_angle_deg; });
  d["horizontal_m"] = number_array(lines, [](const L& l) {
    return l.displacement ? std::optional(l.displacement->horizontal_m) : std::nullopt;
  });
  d["vertical_m"] = number_array(lines, [](const L& l) {
    return l.displacement ? std::optional(l.displacement->vertical_m) : std::nullopt;
  });
  return d;
}

py::list planes_list(const Judged& judged) {
  const Eigen::Vector3d origin = judged.files.frame.origin_m;
  py::list planes;
  for (const evaluate::JudgedPlane& plane : judged.files.planes.front()) {
    py::dict d;
    const Eigen::Vector3d& n = plane.plane.normal();
    d["id"] = plane.id;
    d["normal"] = py::array_t<double>(3, n.data());
    d["offset_m"] = plane.plane.offset() - n.dot(origin);
    d["n_points"] = plane.n_inliers;
    d["n_lines"] = plane.n_lines;
    d["rms_m"] = plane.rms_m;
    py::array_t<double> outline = nan_array({static_cast<py::ssize_t>(plane.outline.size()), 3});
    Eigen::Map<Eigen::Matrix3Xd> corners(outline.mutable_data(), 3, outline.shape(0));
    for (Eigen::Index i = 0; i < corners.cols(); ++i) {
      corners.col(i) = plane.outline[static_cast<std::size_t>(i)] + origin;
    }
    d["outline"] = outline;
    planes.append(d);
  }
  return planes;
}

/// The tables as pairs of name and CSV text.
std::vector<std::pair<std::string, std::string>> tables(const Judged& judged) {
  const evaluate::Table2 table2 = evaluate::make_table2(judged.files.evaluations);
  const results::TruthRows& truth = judged.files.truth.front();
  std::vector<std::pair<std::string, std::string>> all{
      {"table2", evaluate::to_csv(table2)},
      {"parts", evaluate::parts_to_csv(table2)},
      {"tolerances", evaluate::tolerances_to_csv(truth.tolerances)}};
  if (!judged.evaluation().decoys.empty()) {
    all.emplace_back("decoys", evaluate::decoys_to_csv(judged.files.evaluations));
  }
  if (judged.evaluation().completeness) {
    all.emplace_back("completeness", evaluate::completeness_to_csv(judged.files.evaluations));
  }
  const results::ModelTables of_model = results::model_tables(judged.files, {});
  if (!of_model.buildings.empty()) {
    all.emplace_back("buildings", of_model.buildings);
    all.emplace_back("faces", of_model.faces);
    all.emplace_back("kinds", of_model.kinds);
    if (of_model.with_scan_edges) all.emplace_back("missing_roofs", of_model.missing_roofs);
  }
  if (truth.references.empty()) return all;
  all.emplace_back("reference_errors", evaluate::reference_errors_to_csv(truth.references));
  all.emplace_back("reference_completeness",
                   evaluate::reference_completeness_to_csv(truth.references));
  all.emplace_back("wireframe", evaluate::wireframe_to_csv(truth.references));
  return all;
}

void write_map(const Judged& judged, const std::string& path, const std::string& schema) {
  results::check_output_file(path, results::paths_of(judged.inputs), true);
  const results::MapSchema columns = results::map_schema_named(schema);
  interruptibly([&] { results::write_judged_map(path, judged.files, 0, columns); });
}

void write_to(const std::string& folder, const Judged& judged, results::MapSchema schema) {
  results::RunRecord record = judged.record;
  record.resume();
  const results::OutputFolder out(folder, results::paths_of(judged.inputs));
  for (const std::string& name : results::result_names({judged.evaluation().method})) {
    (void)out.path(name);
  }
  record.add_warnings(judged.files.warnings);
  for (const results::InputFile& input : judged.inputs) record.add_input(input);
  results::write_judged(judged.files, schema, out, "");
  results::write_tables(judged.files.evaluations, judged.files.truth, out);
  results::write_models(results::model_tables(judged.files, {}), out);
  record.end_stage("write");
  out.write_record(record.to_json());
}

void write_folder(const Judged& judged, const std::string& folder, const std::string& schema) {
  const results::MapSchema columns = results::map_schema_named(schema);
  interruptibly([&] { write_to(folder, judged, columns); });
}

}  // namespace

void add_judged(py::module_& core) {
  py::class_<Judged>(core, "Judged")
      .def("lines", &lines_dict)
      .def("segments", [](const Judged& j) { return dict_of(j.files.line_sets.front()); })
      .def("planes", &planes_list)
      .def("tables", &tables)
      .def("json", [](const Judged& j) { return evaluate::to_json(j.evaluation()); })
      .def("text",
           [](const Judged& j) {
             return evaluate::to_terminal(evaluate::make_table2(j.files.evaluations));
           })
      .def("warnings", [](const Judged& j) { return j.files.warnings; })
      .def("write_map", &write_map, py::arg("path"), py::arg("schema"))
      .def("write", &write_folder, py::arg("folder"), py::arg("schema"));
}

}  // namespace ridgeline::python
