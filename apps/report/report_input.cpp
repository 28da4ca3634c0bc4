// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/report_input.h"

#include "apps/common/patch_matching.h"
#include "apps/common/patch_views.h"
#include "apps/common/result_folder_reader.h"
#include "apps/evaluate/judge_files.h"
#include "apps/report/run_inputs.h"
#include "evaluate/statistics/reference_errors.h"
#include "io/cloud/read_cloud.h"
#include "io/csv_table.h"
#include "io/error.h"
#include "io/lines/read_lines.h"
#include "io/segments_file.h"
#include "io/text_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <unordered_map>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using evaluate::Json;

Json read_object(const fs::path& file) {
  Json json = Json::parse(io::read_text_file(file.string()), nullptr, false);
  if (!json.is_object()) throw io::IoError(file.string(), "is no JSON object");
  return json;
}

/// Runs `read`; a file's fault becomes a note: the rest of the report does not depend on it.
template <typename Read>
void read_or_note(ReportPatch& patch, const char* what, const Read& read) {
  try {
    read();
  } catch (const io::IoError& error) {
    patch.notes.push_back(fmt::format("{}: {}", what, error.what()));
  } catch (const std::invalid_argument& error) {
    patch.notes.push_back(fmt::format("{}: {}", what, error.what()));
  }
}

std::vector<std::optional<io::Line>> in_order_of(const Json& judged, io::LineSet set) {
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < set.lines.size(); ++i) index.try_emplace(set.lines[i].id, i);
  std::vector<std::optional<io::Line>> lines(judged.size());
  for (std::size_t i = 0; i < judged.size(); ++i) {
    // the file's own order, which ids that occur twice need; else by id
    const std::string id = judged[i].at("id").get<std::string>();
    const auto found = index.find(id);
    if (i < set.lines.size() && set.lines[i].id == id) {
      lines[i] = set.lines[i];
    } else if (found != index.end()) {
      lines[i] = set.lines[found->second];
    }
  }
  return lines;
}

ReportMethod read_method(const fs::path& file, const RunInputs& inputs, ReportPatch& patch) {
  ReportMethod method;
  method.evaluation = read_object(file);
  try {
    method.name = method.evaluation.at("method").get<std::string>();
    const Json& judged = method.evaluation.at("lines");
    method.lines.resize(judged.size());
    read_or_note(patch, "lines are not drawn", [&] {
      fs::path lines = file.parent_path() / fmt::format("lines.{}.geojson", method.name);
      if (!fs::exists(lines)) lines = inputs.lines_of(method.name);
      if (lines.empty()) throw io::IoError(file.string(), "the file of its lines is not known");
      method.lines = in_order_of(judged, io::read_lines(inputs.unchanged(lines.string())));
    });
  } catch (const Json::exception& error) {
    throw io::IoError(file.string(), std::string("is no evaluation: ") + error.what());
  }
  return method;
}

LocalFrame frame_of(const Json& evaluation) {
  const auto o = evaluation.at("origin_m").get<std::array<double, 3>>();
  return {{o[0], o[1], o[2]}};
}

std::vector<LineMatch> line_matches(const std::vector<io::MatchRow>& rows) {
  std::vector<LineMatch> matches;
  matches.reserve(rows.size());
  for (const io::MatchRow& row : rows) matches.push_back(row.scored.match);
  return matches;
}

void read_images(const fs::path& folder, const RunInputs& inputs, ReportPatch& patch) {
  ReportImages shown;
  for (std::size_t i = 0; i < 2; ++i) {
    (void)inputs.unchanged(patch.patch->images[i].path);
    shown.images[i] = patch_image(*patch.patch, i);
  }
  const auto segments = [&](std::size_t i) {
    return folder / fmt::format("segments.{}.csv", patch.patch->images[i].id);
  };
  if (fs::exists(segments(0)) && fs::exists(folder / "matches.csv")) {
    for (std::size_t i = 0; i < 2; ++i) {
      shown.segments[i] = io::read_segments(segments(i).string());
    }
    shown.matches = io::read_matches((folder / "matches.csv").string());
  }
  if (fs::exists(folder / "unmatched.csv")) {
    const io::CsvTable table((folder / "unmatched.csv").string());
    const std::size_t reason = table.column("reason");
    for (std::size_t row = 0; row < table.size(); ++row) {
      ++shown.n_unmatched[std::string(table.text(row, reason))];
    }
  }
  patch.images = std::move(shown);
}

/// Of a cloud that may cover a town: what is near the lines. Nothing where there are no lines.
std::optional<io::PlanMask> mask_around_lines(const ReportPatch& patch) {
  constexpr double kRadius_m = 10.0;
  std::vector<Segment2> segments;
  for (const ReportMethod& method : patch.methods) {
    for (const auto& line : method.lines) {
      if (!line || !all_finite(line->segment_in_world)) continue;
      segments.push_back({patch.frame.local_from_world(line->segment_in_world.start).head<2>(),
                          patch.frame.local_from_world(line->segment_in_world.end).head<2>()});
    }
  }
  if (segments.empty()) return std::nullopt;
  return io::PlanMask(segments, kRadius_m);
}

void read_points(const std::vector<std::string>& files,
                 const RunInputs& inputs,
                 const Json& run,
                 ReportPatch& patch) {
  for (const std::string& file : io::expand_patterns(files)) (void)inputs.unchanged(file);
  io::ReadOptions options;
  options.frame = patch.frame;
  const Json echoed = run.value("options", Json::object());
  if (echoed.contains("classes") && !echoed["classes"].empty()) {
    options.classes = echoed["classes"].get<std::set<std::uint8_t>>();
  }
  options.exclude_withheld = echoed.value("exclude_withheld", true);
  options.last_returns = echoed.value("last_returns", false);
  options.assume_crs.definition = echoed.value("assume_crs", "");
  if (inputs.is_of_files()) options.near = mask_around_lines(patch);
  patch.cloud = io::read_cloud(files, options);
  const std::vector<std::string>& warnings = patch.cloud->warnings;
  patch.notes.insert(patch.notes.end(), warnings.begin(), warnings.end());
}

void read_true_errors(const RunInputs& inputs, const std::string& reference, ReportPatch& patch) {
  const auto references =
      reference_lines_of(io::read_lines(inputs.unchanged(reference)), patch.frame);
  for (ReportMethod& method : patch.methods) {
    io::LineSet set;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < method.lines.size(); ++i) {
      if (!method.lines[i]) continue;
      set.lines.push_back(*method.lines[i]);
      index.push_back(i);
    }
    const auto errors_m =
        evaluate::reference_errors_m(judged_lines_of(set, patch.frame, patch.patch), references);
    method.true_errors_m.resize(method.lines.size());
    for (std::size_t k = 0; k < index.size(); ++k) method.true_errors_m[index[k]] = errors_m[k];
  }
}

/// The data of the run, by the paths that it recorded.
void read_run_data(const fs::path& folder,
                   const RunInputs& inputs,
                   const Json& run,
                   ReportPatch& patch) {
  read_or_note(patch, "images and cameras are not shown", [&] {
    patch.patch = inputs.patch(patch.id);
    if (patch.patch && patch.patch->images.size() >= 2) {
      read_images(folder / patch.subfolder, inputs, patch);
    }
  });
  const std::vector<std::string> clouds =
      inputs.is_of_files() || !patch.patch ? inputs.paths("cloud") : patch.patch->lidar;
  read_or_note(patch, "points are not shown", [&] {
    if (clouds.empty()) {
      patch.notes.emplace_back("no LIDAR: lines are shown, but not judged");
    } else if (inputs.is_of_files() || patch.patch) {
      read_points(clouds, inputs, run, patch);
    }
  });
  if (patch.images && patch.patch->reference_matches) {
    read_or_note(patch, "matches are not judged", [&] {
      (void)inputs.unchanged(*patch.patch->reference_matches);
      patch.images->score = score_patch_matches(*patch.patch, patch.images->segments,
                                                line_matches(patch.images->matches));
    });
  }
  const std::optional<std::string> reference = inputs.reference_lines(patch.patch);
  if (reference) {
    read_or_note(patch, "true errors are not shown",
                 [&] { read_true_errors(inputs, *reference, patch); });
  }
}

/// Patches and methods in the order of Table 2, which is that of the run; what an earlier run with
/// other methods left in the folder is not in it and goes.
void arrange_as_table2(const fs::path& folder, std::vector<ReportPatch>& patches) {
  if (!fs::exists(folder / "table2.json")) return;
  std::map<std::string, std::size_t> rank;
  for (const Json& row : read_object(folder / "table2.json").value("rows", Json::array())) {
    rank.try_emplace(row.value("patch", ""), rank.size());
    rank.try_emplace(row.value("patch", "") + "\n" + row.value("method", ""), rank.size());
  }
  const auto place = [&rank](const std::string& key) {
    const auto found = rank.find(key);
    return found == rank.end() ? rank.size() : found->second;
  };
  std::stable_sort(patches.begin(), patches.end(),
                   [&](const auto& a, const auto& b) { return place(a.id) < place(b.id); });
  for (ReportPatch& patch : patches) {
    std::erase_if(patch.methods, [&](const ReportMethod& method) {
      return !rank.contains(patch.id + "\n" + method.name);
    });
    std::stable_sort(patch.methods.begin(), patch.methods.end(), [&](const auto& a, const auto& b) {
      return place(patch.id + "\n" + a.name) < place(patch.id + "\n" + b.name);
    });
  }
  std::erase_if(patches, [](const ReportPatch& patch) { return patch.methods.empty(); });
}

std::vector<ReportPatch> read_patches(const fs::path& folder, const RunInputs& inputs) {
  std::vector<ReportPatch> patches;
  for (const fs::path& file : evaluation_files(folder)) {
    const std::string subfolder =
        fs::equivalent(file.parent_path(), folder) ? "" : file.parent_path().filename() / "";
    if (patches.empty() || patches.back().subfolder != subfolder) {
      patches.emplace_back().subfolder = subfolder;
    }
    ReportPatch& patch = patches.back();
    patch.methods.push_back(read_method(file, inputs, patch));
    try {
      patch.id = patch.methods.back().evaluation.at("patch").get<std::string>();
      patch.frame = frame_of(patch.methods.back().evaluation);
    } catch (const Json::exception& error) {
      throw io::IoError(file.string(), std::string("is no evaluation: ") + error.what());
    }
  }
  return patches;
}

/// Without the folders of the data, which are the sender's own business.
void shorten_paths(const std::vector<std::string>& paths, std::string& note) {
  for (const std::string& path : paths) {
    const std::size_t at = note.find(path);
    if (at != std::string::npos) note.replace(at, path.size(), fs::path(path).filename().string());
  }
}

}  // namespace

ReportInput read_report_input(const std::string& folder) {
  if (!fs::is_directory(folder)) throw io::IoError(folder, "is no folder of results");
  ReportInput input;
  const fs::path path(folder);
  input.run = fs::exists(path / "run.json") ? read_object(path / "run.json") : Json::object();
  const RunInputs inputs(input.run, (path / "run.json").string());
  input.input_paths = inputs.all_paths();
  input.table1 = Json::array();
  if (fs::exists(path / "table1.json")) {
    input.table1 = read_object(path / "table1.json").value("rows", Json::array());
  }
  input.patches = read_patches(path, inputs);
  if (input.patches.empty()) {
    throw io::IoError(folder, "holds no evaluation.*.json; must be the --out of run or evaluate");
  }
  arrange_as_table2(path, input.patches);
  for (ReportPatch& patch : input.patches) {
    read_run_data(path, inputs, input.run, patch);
    for (std::string& note : patch.notes) shorten_paths(input.input_paths, note);
  }
  return input;
}

}  // namespace ridgeline::apps
