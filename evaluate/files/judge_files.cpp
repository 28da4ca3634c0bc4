// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judge_files.h"

#include "evaluate/files/finish_judging.h"
#include "evaluate/files/judge_decoys.h"
#include "evaluate/files/line_area.h"
#include "evaluate/files/model_files.h"
#include "evaluate/files/prepare_lines.h"
#include "evaluate/files/scan_comparison.h"
#include "io/error.h"
#include "io/text/utf8.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace ridgeline::results {
namespace {

/// Throws IoError, before anything is judged, for a file that must be a model but is not, and for
/// an attribute that no model has.
void check_models(const std::vector<io::LineSet>& sets, const JudgeFilesOptions& options) {
  for (const io::LineSet& set : sets) {
    if (!options.needs_models || set.model) continue;
    throw io::IoError(set.path, "is not a building model, which `write_attributes` needs");
  }
  for (const std::string& name : options.by) {
    std::vector<std::string> known;
    for (const io::LineSet& set : sets) {
      if (!set.model) continue;
      for (const io::Column& column : set.features.columns) known.push_back(column.name);
    }
    if (std::ranges::find(known, name) != known.end()) continue;
    throw io::IoError(
        sets.front().path,
        fmt::format("`by` {}: buildings have no such attribute; {}", name,
                    known.empty() ? "the file is not a building model with attributes"
                                  : fmt::format("available: {}", fmt::join(known, ", "))));
  }
}

/// Adds the judged buildings to the record of the area.
void add_buildings(JudgedFiles& judged, std::size_t i, const std::vector<std::string>& by) {
  evaluate::AreaPart& area = *judged.evaluations[i].area;
  for (const std::size_t number : judged.models[i]->places) {
    evaluate::AreaBuilding& building = area.buildings.emplace_back();
    building.number = number;
    for (const std::string& column : by) {
      building.by.push_back(value_in(judged.line_sets[i].features, number, column));
    }
  }
}

/// Judges the buildings of all line files that are models.
void judge_models(io::CloudFiles& cloud,
                  const JudgeFilesOptions& options,
                  RunRecord& record,
                  JudgedFiles& judged) {
  judged.models.resize(judged.line_sets.size());
  bool has_models = false;
  for (std::size_t i = 0; i < judged.line_sets.size(); ++i) {
    if (!judged.line_sets[i].model) continue;
    std::optional<std::vector<std::size_t>> numbers;
    if (options.area) {
      numbers =
          buildings_in(area_in_local(*options.area, cloud), judged.line_sets[i], judged.frame);
    }
    judged.models[i] = judge_model(cloud, judged.line_sets[i], judged.evaluations[i], judged.frame,
                                   options.judge, options.cloud_memory_mib << 20U, numbers);
    if (options.area) add_buildings(judged, i, options.by);
    has_models = true;
  }
  if (has_models) record.end_stage("judge_faces");
}

}  // namespace

void require_same_frame(std::string_view what,
                        const std::string& path,
                        const io::Crs& crs,
                        const io::Crs& other,
                        std::vector<std::string>* warnings) {
  const io::CrsAgreement agreement = io::compare(crs, other);
  if (!agreement.compatible) {
    throw io::IoError(path, fmt::format("{} do not match: {}; transform one of them, or declare "
                                        "the CRS with `assume_crs`",
                                        what, agreement.reason));
  }
  if (warnings != nullptr && !agreement.warning.empty()) {
    warnings->push_back(path + ": " + agreement.warning);
  }
}

std::vector<std::string> own_warnings(const io::LineSet& set) {
  return transformed(set.warnings,
                     [&](const std::string& warning) { return set.path + ": " + warning; });
}

std::string stem_of(const std::string& path) {
  return io::as_utf8(std::filesystem::path(path).stem().string());
}

JudgedFiles judge_files(const JudgeFilesOptions& options, RunRecord& record) {
  LinesToJudge lines = read_lines_to_judge(options);
  io::CloudFiles cloud(options.cloud_paths, options.cloud);
  return judge_lines(std::move(lines), cloud, options, record);
}

JudgedFiles judge_lines(LinesToJudge to_judge,
                        io::CloudFiles& cloud,
                        const JudgeFilesOptions& options,
                        RunRecord& record) {
  PreparedLines prepared = prepare_lines(std::move(to_judge), cloud, options);
  check_models(prepared.judged.line_sets, options);
  record.end_stage("read_lines");
  std::vector<std::vector<Segment3>> finding;
  if (options.completeness) finding = finding_lines(prepared.lines);
  DecoySets decoys = decoys_of(prepared.lines, options);
  std::vector<AreaLines> of_area;
  if (options.area) of_area = keep_area(options, cloud, prepared, decoys);
  JudgedBatches batches =
      judge_in_batches(cloud, prepared.lines, options.judge, options.cloud_memory_mib << 20U,
                       std::move(decoys), !options.area);
  if (options.area) drop_neighbours(of_area, prepared, batches);
  JudgedFiles judged =
      finish_judging(std::move(prepared), std::move(batches), cloud, options, record);
  judge_models(cloud, options, record, judged);
  if (options.completeness) {
    compare_files_with_scan(std::move(finding), cloud, options, record, judged);
  }
  return judged;
}

}  // namespace ridgeline::results
