// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/write_results.h"

#include "evaluate/files/model_files.h"
#include "evaluate/files/to_fix.h"
#include "evaluate/statistics/accuracy.h"
#include "evaluate/statistics/product_method.h"
#include "evaluate/statistics/strata.h"
#include "evaluate/tables/accuracy_table.h"
#include "evaluate/tables/completeness_table.h"
#include "evaluate/tables/decoy_table.h"
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/shift_text.h"
#include "evaluate/tables/standards_table.h"
#include "evaluate/tables/table2.h"
#include "io/cloud/labelled_points.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace ridgeline::results {
namespace {

using evaluate::Evaluation;

/// The evaluations without the method `planes`, whose ids do not correspond to those of other
/// methods.
std::vector<Evaluation> of_matches(std::span<const Evaluation> evaluations) {
  std::vector<Evaluation> kept(evaluations.begin(), evaluations.end());
  std::erase_if(kept, [](const Evaluation& e) { return e.method == evaluate::kPlanesMethod; });
  return kept;
}

/// The evaluations, grouped by patch, restricted to the common lines of their patch.
std::vector<Evaluation> on_common_lines_by_patch(std::span<const Evaluation> evaluations) {
  std::vector<Evaluation> common;
  for (std::size_t first = 0; first < evaluations.size();) {
    std::size_t last = first;
    while (last < evaluations.size() && evaluations[last].patch == evaluations[first].patch) ++last;
    for (Evaluation& e : evaluate::on_common_lines(evaluations.subspan(first, last - first))) {
      common.push_back(std::move(e));
    }
    first = last;
  }
  return common;
}

bool has_several_methods(std::span<const Evaluation> evaluations) {
  for (std::size_t i = 1; i < evaluations.size(); ++i) {
    if (evaluations[i].patch == evaluations[i - 1].patch) return true;
  }
  return false;
}

void write_quality(std::span<const Evaluation> evaluations,
                   const std::vector<TruthRows>& truth,
                   const OutputFolder& out) {
  constexpr double kTolerance_m = 0.25;  // one of the tolerances measured
  std::vector<evaluate::StandardsRow> rows;
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    std::optional<evaluate::ToleranceMeasures> against_lines;
    for (const evaluate::ToleranceRow& row : truth[i].tolerances) {
      const bool counts = row.reference == "lines" && row.measures.tolerance_m == kTolerance_m;
      if (counts) against_lines = row.measures;
    }
    rows.push_back({evaluations[i].patch, evaluations[i].method,
                    evaluate::standards_blocks(evaluations[i], against_lines)});
  }
  out.write("quality.csv", evaluate::measures_to_csv(rows));
  out.write("quality.xml", evaluate::measures_to_xml(rows));
}

/// Writes the figures other than the distances from planes. `note`: text below the Markdown forms;
/// may be empty.
void write_truth(const std::vector<TruthRows>& rows,
                 const std::string& note,
                 const OutputFolder& out) {
  std::vector<evaluate::ToleranceRow> tolerances;
  std::vector<evaluate::ReferenceRow> references;
  for (const TruthRows& part : rows) {
    tolerances.insert(tolerances.end(), part.tolerances.begin(), part.tolerances.end());
    references.insert(references.end(), part.references.begin(), part.references.end());
  }
  out.write("tolerances.csv", evaluate::tolerances_to_csv(tolerances));
  out.write("tolerances.md", evaluate::tolerances_to_markdown(tolerances) + note);
  if (references.empty()) {
    for (const char* name :
         {"reference_errors.csv", "reference_completeness.csv", "reference.md", "wireframe.csv"}) {
      out.remove(name);
    }
    return;
  }
  out.write("reference_errors.csv", evaluate::reference_errors_to_csv(references));
  out.write("reference_completeness.csv", evaluate::reference_completeness_to_csv(references));
  out.write("wireframe.csv", evaluate::wireframe_to_csv(references));
  out.write("reference.md", evaluate::reference_to_markdown(references) + note);
}

void write_table2(std::span<const Evaluation> evaluations,
                  const OutputFolder& out,
                  bool joint_adjusts_to_faces) {
  const evaluate::Table2 table = evaluate::make_table2(evaluations, joint_adjusts_to_faces);
  out.write("table2.md", evaluate::to_markdown(table));
  out.write("table2.csv", evaluate::to_csv(table));
  out.write("table2.json", evaluate::to_json(table));
  out.write("table2.tex", evaluate::to_latex(table));
  out.write("parts.csv", evaluate::parts_to_csv(table));
  const std::vector<Evaluation> with_matches = of_matches(evaluations);
  if (has_several_methods(with_matches)) {
    const evaluate::Table2 paired =
        evaluate::make_table2(on_common_lines_by_patch(with_matches), joint_adjusts_to_faces);
    out.write("table2.common.md", evaluate::to_markdown(paired));
    out.write("table2.common.csv", evaluate::to_csv(paired));
  } else {
    out.remove("table2.common.md");
    out.remove("table2.common.csv");
  }
}

}  // namespace

std::vector<std::string> evaluation_names(const std::string& method) {
  return {fmt::format("evaluation.{}.json", method), fmt::format("evaluation.{}.csv", method),
          fmt::format("accuracy.{}.md", method), map_name(method)};
}

std::vector<std::string> result_names(const std::vector<std::string>& line_paths) {
  std::vector<std::string> names{
      "table2.md",    "table2.csv",           "table2.json",
      "table2.tex",   "table2.common.md",     "table2.common.csv",
      "run.json",     "tolerances.csv",       "tolerances.md",
      "reference.md", "reference_errors.csv", "reference_completeness.csv",
      "parts.csv",    "wireframe.csv",        "quality.csv",
      "quality.xml",  "decoys.csv",           "completeness.csv",
      kToFixName};
  for (std::string& name : model_names()) names.push_back(std::move(name));
  for (const std::string& path : line_paths) {
    for (std::string& name : evaluation_names(stem_of(path))) names.push_back(std::move(name));
  }
  return names;
}

void write_evaluation_files(const Evaluation& e,
                            const OutputFolder& out,
                            const std::string& subfolder) {
  const std::vector<std::string> names = evaluation_names(e.method);
  out.write(subfolder + names[0], evaluate::to_json(e));
  out.write(subfolder + names[1], evaluate::to_line_csv(e));
  const std::string note = evaluate::moved_note(e);
  out.write(subfolder + names[2],
            (note.empty() ? "" : note + "\n\n") +
                evaluate::to_markdown(evaluate::accuracy_statements(e)) + "\n" +
                evaluate::to_markdown(evaluate::stratify(e)) +
                evaluate::standards_to_markdown(evaluate::standards_blocks(e)) +
                evaluate::decoys_to_markdown(e) + evaluate::completeness_to_markdown(e));
}

void write_judged(const JudgedFiles& judged,
                  MapSchema schema,
                  const OutputFolder& out,
                  const std::string& subfolder) {
  for (std::size_t i = 0; i < judged.evaluations.size(); ++i) {
    const Evaluation& e = judged.evaluations[i];
    write_evaluation_files(e, out, subfolder);
    write_judged_map(out.path(subfolder + map_name(e.method)), judged, i, schema);
  }
  std::vector<std::vector<ToFix>> lists;
  for (std::size_t i = 0; i < judged.evaluations.size(); ++i) lists.push_back(to_fix(judged, i));
  out.write(subfolder + kToFixName, to_fix_csv(judged, lists));
}

void write_plane_points(const std::string& path, const JudgedFiles& judged) {
  // the largest plane, usually the ground, is grey; the report uses the same colours (colours.ts)
  using Rgb = std::array<std::uint8_t, 3>;
  constexpr std::array<Rgb, 8> kColours{
      Rgb{0xb9, 0xb1, 0xa7}, Rgb{0xc3, 0xd3, 0xe3}, Rgb{0xe0, 0xcf, 0xae}, Rgb{0xc5, 0xd6, 0xb8},
      Rgb{0xdf, 0xdc, 0xb4}, Rgb{0xbf, 0xc6, 0xdc}, Rgb{0xe0, 0xc4, 0xbd}, Rgb{0xd9, 0xc6, 0xd2}};
  std::vector<evaluate::JudgedPlane> planes = judged.planes.front();
  std::ranges::stable_sort(planes, std::greater<>(), &evaluate::JudgedPlane::n_inliers);
  std::map<std::uint64_t, Rgb> colours;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    colours[planes[i].id] = kColours[i % kColours.size()];
  }
  io::LabelledPoints points{.frame = judged.frame,
                            .crs = judged.cloud_crs,
                            .unit_m = judged.cloud_unit_m,
                            .x_in_local = {},
                            .labels = {}};
  for (const evaluate::PlanePoint& point : judged.points) {
    points.x_in_local.push_back(point.x);
    points.labels.push_back({colours.at(point.plane_id), static_cast<std::uint32_t>(point.plane_id),
                             static_cast<float>(point.distance_m)});
  }
  io::write_labelled_points(path, points);
}

void write_tables(std::span<const Evaluation> evaluations,
                  const std::vector<TruthRows>& truth,
                  const OutputFolder& out,
                  bool joint_adjusts_to_faces) {
  write_table2(evaluations, out, joint_adjusts_to_faces);
  std::string note;
  for (const std::string& moved : evaluate::moved_notes(evaluations)) note += "\n" + moved + "\n";
  write_truth(truth, note, out);
  write_quality(evaluations, truth, out);
  if (std::ranges::any_of(evaluations, [](const Evaluation& e) { return !e.decoys.empty(); })) {
    out.write("decoys.csv", evaluate::decoys_to_csv(evaluations));
  } else {
    out.remove("decoys.csv");
  }
  if (std::ranges::any_of(evaluations,
                          [](const Evaluation& e) { return e.completeness.has_value(); })) {
    out.write("completeness.csv", evaluate::completeness_to_csv(evaluations));
  } else {
    out.remove("completeness.csv");
  }
}

}  // namespace ridgeline::results
