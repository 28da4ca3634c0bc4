// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/evaluated_patches.h"

#include "evaluate/files/judged_lines.h"
#include "evaluate/files/read_evaluations.h"
#include "io/error.h"
#include "io/lines/read_lines.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using evaluate::Evaluation;
using evaluate::LineEvaluation;

std::vector<std::optional<io::Line>> in_order_of(const std::vector<LineEvaluation>& judged,
                                                 const io::LineSet& set) {
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < set.lines.size(); ++i) index.try_emplace(set.lines[i].id, i);
  std::vector<std::optional<io::Line>> lines(judged.size());
  for (std::size_t i = 0; i < judged.size(); ++i) {
    // ids may occur twice: the line at the same position in the file takes precedence over others
    // with its id
    const std::string& id = judged[i].id;
    const auto found = index.find(id);
    if (i < set.lines.size() && set.lines[i].id == id) {
      lines[i] = set.lines[i];
    } else if (found != index.end()) {
      lines[i] = set.lines[found->second];
    }
  }
  return lines;
}

std::optional<Segment3> segment_in_local(const std::optional<io::Line>& line,
                                         const LocalFrame& frame) {
  if (!line || !all_finite(line->segment_in_world)) return std::nullopt;
  return Segment3{frame.local_from_world(line->segment_in_world.start),
                  frame.local_from_world(line->segment_in_world.end)};
}

/// The file with the lines that were judged.
std::string line_file(const fs::path& evaluation,
                      const std::string& method,
                      const RunInputs& inputs) {
  if (inputs.is_of_files()) {
    const std::string given = inputs.lines_of(method);
    if (given.empty()) {
      throw io::IoError(evaluation.string(), "its line file is unknown");
    }
    return inputs.unchanged(given);
  }
  return (evaluation.parent_path() / fmt::format("lines.{}.geojson", method)).string();
}

void read_lines_of(const fs::path& file,
                   const RunInputs& inputs,
                   ReportMethod& method,
                   ReportPatch& patch) {
  method.lines.resize(method.evaluation.lines.size());
  read_or_note(patch, "lines are not drawn", [&] {
    const std::string lines = line_file(file, method.evaluation.method, inputs);
    method.lines = in_order_of(method.evaluation.lines,
                               results::in_metres(io::read_lines(lines, inputs.lines_options())));
  });
  for (const auto& line : method.lines) {
    method.segments.push_back(segment_in_local(line, patch.frame));
  }
}

ReportPatch& patch_of(const std::string& subfolder,
                      const Evaluation& evaluation,
                      std::vector<ReportPatch>& patches) {
  for (ReportPatch& patch : patches) {
    if (patch.subfolder == subfolder && patch.id == evaluation.patch) return patch;
  }
  ReportPatch& patch = patches.emplace_back();
  patch.id = evaluation.patch;
  patch.subfolder = subfolder;
  patch.frame = {evaluation.origin_m};
  return patch;
}

}  // namespace

std::vector<ReportPatch> read_evaluated_patches(const fs::path& folder, const RunInputs& inputs) {
  auto found = results::read_evaluations(folder, inputs.is_of_files());
  std::ranges::stable_sort(found, {}, &results::FoundEvaluation::rank);
  std::vector<ReportPatch> patches;
  for (results::FoundEvaluation& file : found) {
    ReportPatch& patch = patch_of(file.subfolder, file.evaluation, patches);
    ReportMethod& method = patch.methods.emplace_back();
    method.evaluation = std::move(file.evaluation);
    read_lines_of(file.path, inputs, method, patch);
  }
  return patches;
}

}  // namespace ridgeline::apps
