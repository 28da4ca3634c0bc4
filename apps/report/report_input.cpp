// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/report_input.h"

#include "apps/pipeline/made_from.h"
#include "apps/pipeline/patch_matching.h"
#include "apps/pipeline/patch_scene.h"
#include "apps/report/display_image.h"
#include "apps/report/evaluated_patches.h"
#include "apps/report/path_shortener.h"
#include "apps/report/run_inputs.h"
#include "evaluate/files/judged_lines.h"
#include "evaluate/files/result_folder_reader.h"
#include "evaluate/files/to_fix.h"
#include "evaluate/statistics/reference_errors.h"
#include "io/cloud/cloud_files.h"
#include "io/error.h"
#include "io/files/csv_table.h"
#include "io/kinds/recognise.h"
#include "io/lines/read_lines.h"
#include "io/project/segments_file.h"
#include "io/project/tracks_file.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

std::array<std::vector<EdgeSegment>, 2> segments_of(const ReportImages& images,
                                                    const ViewPair& views) {
  return {images.segments[views.base], images.segments[views.search]};
}

void read_pair(const std::string& file, const ViewPair& views, ReportImages& images) {
  ReportPair& pair = images.pairs.emplace_back(ReportPair{views, io::read_matches(file)});
  check_segment_ids(file, pair.matches, segments_of(images, views));
}

/// Reads the matches of further pairs and the tracks that the run has written.
void read_tracks_and_pairs(const fs::path& folder,
                           const std::vector<std::string>& ids,
                           ReportImages& images) {
  const MadeFrom stages(folder);
  if (const auto tracks = stages.written_file(kMatchStage, "tracks.csv")) {
    images.tracks = io::read_tracks(*tracks, ids);
  }
  for (std::size_t base = 0; base < ids.size(); ++base) {
    for (std::size_t search = 0; search < ids.size(); ++search) {
      const auto matches = stages.written_file(
          kMatchStage, fmt::format("pairs/{}-{}/matches.csv", ids[base], ids[search]));
      if (matches) read_pair(*matches, {base, search}, images);
    }
  }
}

/// Reads the segments, matches and tracks, if the run has extracted segments.
void read_segments_and_matches(const fs::path& folder,
                               const io::Patch& patch,
                               ReportImages& images) {
  images.segments.resize(patch.images.size());
  const std::string matches = (folder / "matches.csv").string();
  if (!fs::exists(folder / segments_file(patch.images[0])) || !fs::exists(matches)) return;
  for (std::size_t i = 0; i < patch.images.size(); ++i) {
    const fs::path file = folder / segments_file(patch.images[i]);
    if (i < 2 || fs::exists(file)) images.segments[i] = io::read_segments(file.string());
  }
  read_pair(matches, kPairOfPatch, images);
  if (patch.images.size() > 2) {
    read_tracks_and_pairs(folder, transformed(patch.images, &io::PatchImage::id), images);
  }
}

void read_images(const fs::path& folder, const RunInputs& inputs, ReportPatch& patch) {
  ReportImages shown;
  for (std::size_t i = 0; i < patch.patch->images.size(); ++i) {
    const io::PatchImage& stated = patch.patch->images[i];
    (void)inputs.unchanged(stated.path);
    const cv::Mat image = read_image(stated, inputs.max_image_mpx()).image;
    shown.pictures.push_back(display_image(image));
    shown.sizes_px.emplace_back(image.cols, image.rows);
    if (i < shown.base_pair.size()) shown.base_pair[i] = image;
  }
  read_segments_and_matches(folder, *patch.patch, shown);
  if (fs::exists(folder / "unmatched.csv")) {
    const io::CsvTable table((folder / "unmatched.csv").string());
    const std::size_t reason = table.column("reason");
    for (std::size_t row = 0; row < table.size(); ++row) {
      ++shown.n_unmatched[std::string(table.text(row, reason))];
    }
  }
  patch.images = std::move(shown);
}

/// The surroundings of the lines, to which the cloud is limited because it may cover a town;
/// std::nullopt if there are no lines.
std::optional<io::PlanMask> mask_around_lines(const ReportPatch& patch) {
  constexpr double kRadius_m = 10.0;
  std::vector<Segment2> segments;
  for (const ReportMethod& method : patch.methods) {
    for (const auto& segment : method.segments) {
      if (segment) segments.push_back(plan(*segment));
    }
  }
  if (segments.empty()) return std::nullopt;
  return io::PlanMask(segments, kRadius_m);
}

/// The box in plan around most of the lines, without the few that lie far off.
std::optional<Eigen::AlignedBox3d> box_of_lines(const ReportPatch& patch) {
  constexpr double kMargin_m = 20.0;
  constexpr double kShareCut = 0.01;
  std::array<std::vector<double>, 2> coordinates;
  for (const ReportMethod& method : patch.methods) {
    for (const auto& line : method.lines) {
      if (!line || !all_finite(line->segment_in_world)) continue;
      for (const Eigen::Vector3d& x : {line->segment_in_world.start, line->segment_in_world.end}) {
        coordinates[0].push_back(x.x());
        coordinates[1].push_back(x.y());
      }
    }
  }
  if (coordinates[0].empty()) return std::nullopt;
  Eigen::AlignedBox3d box(Eigen::Vector3d::Constant(-HUGE_VAL),
                          Eigen::Vector3d::Constant(HUGE_VAL));
  for (std::size_t a = 0; a < 2; ++a) {
    std::vector<double>& values = coordinates[a];
    std::sort(values.begin(), values.end());
    const auto cut = static_cast<std::size_t>(kShareCut * static_cast<double>(values.size()));
    box.min()[static_cast<Eigen::Index>(a)] = values[cut] - kMargin_m;
    box.max()[static_cast<Eigen::Index>(a)] = values[values.size() - 1 - cut] + kMargin_m;
  }
  return box;
}

/// Reads the cloud. It may cover a town, so only points around the lines are kept, thinned to the
/// number shown.
void read_points(const std::vector<std::string>& files,
                 const RunInputs& inputs,
                 ReportPatch& patch) {
  for (const std::string& file : io::expand_patterns(files)) (void)inputs.unchanged(file);
  constexpr std::uint64_t kMaxPoints = 4'000'000;  // held during thinning, 128 MB
  io::ReadOptions options = inputs.cloud_options();
  options.frame = patch.frame;
  io::CloudFiles cloud_files(files, options);
  std::optional<io::PlanMask> near;
  if (inputs.is_of_files()) {
    near = mask_around_lines(patch);
  } else if (const auto box = box_of_lines(patch)) {
    cloud_files.set_bounds(*box);
  }
  const io::PointCloud cloud = cloud_files.read_thinned(near, kMaxPoints);
  patch.cloud = shown_cloud(cloud, near.has_value());
  patch.notes.insert(patch.notes.end(), cloud.warnings.begin(), cloud.warnings.end());
}

/// Reads the points of the surface, if the run saved any.
void read_surface(const fs::path& folder, ReportPatch& patch) {
  const auto file = MadeFrom(folder).written_file(kSurfaceStage, kSurfaceFile);
  if (!file) return;
  io::ReadOptions options;
  options.frame = patch.frame;
  for (const io::CloudPoint& p : io::read_cloud({*file}, options).points) {
    patch.surface_in_local.emplace_back(p.x, p.y, p.z);
  }
}

void read_true_errors(const RunInputs& inputs, const std::string& reference, ReportPatch& patch) {
  const auto references = results::reference_lines_of(
      io::read_lines(inputs.unchanged(reference), inputs.lines_options(true)), patch.frame);
  for (ReportMethod& method : patch.methods) {
    io::LineSet set;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < method.lines.size(); ++i) {
      if (!method.lines[i]) continue;
      set.lines.push_back(*method.lines[i]);
      index.push_back(i);
    }
    const auto errors_m = evaluate::reference_errors_m(
        results::moved(results::judged_lines_of(set, patch.frame, patch.patch), method.moved_m()),
        references);
    method.true_errors_m.resize(method.lines.size());
    for (std::size_t k = 0; k < index.size(); ++k) method.true_errors_m[index[k]] = errors_m[k];
  }
}

/// Adds each row of a table, as JSON, to the rows of its method. Missing `numbers` become null.
/// Does nothing without the file, which older runs lack.
void read_rows(const fs::path& file,
               const std::vector<const char*>& texts,
               const std::vector<const char*>& numbers,
               ReportPatch& patch,
               evaluate::Json ReportMethod::*rows) {
  if (!fs::exists(file)) return;
  const io::CsvTable table(file.string());
  const std::size_t name = table.column("method");
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto method = std::ranges::find_if(patch.methods, [&](const ReportMethod& m) {
      return m.evaluation.method == table.text(row, name);
    });
    if (method == patch.methods.end()) continue;
    evaluate::Json& json = ((*method).*rows).emplace_back();
    for (const char* const key : texts) json[key] = std::string(table.text(row, table.column(key)));
    for (const char* const key : numbers) {
      const bool is_given = table.has(key) && !table.text(row, table.column(key)).empty();
      json[key] =
          is_given ? evaluate::Json(table.number(row, table.column(key))) : evaluate::Json();
    }
  }
}

void read_buildings(const fs::path& folder, ReportPatch& patch) {
  read_rows(folder / "buildings.csv", {"id", "verdict", "worst_line"},
            {"n_lines", "n_judged_lines", "rms_m", "worst_distance_m", "n_faces", "n_judged_faces",
             "ridge_height_m", "eave_height_m", "unexplained_share", "shift_x_m", "shift_y_m",
             "shift_z_m", "points_rms_m", "points_p90_m", "area_m2", "judged_area_m2"},
            patch, &ReportMethod::buildings);
}

void read_to_fix(const fs::path& folder, ReportPatch& patch) {
  read_rows(folder / patch.subfolder / results::kToFixName, {"what", "id", "building", "kind"},
            {"gain_share", "off_m", "move_x_m", "move_y_m", "move_z_m"}, patch,
            &ReportMethod::to_fix);
}

/// Reads the data of the run from the paths that it recorded.
void read_run_data(const fs::path& folder, const RunInputs& inputs, ReportPatch& patch) {
  read_or_note(patch, "images and cameras are not shown", [&] {
    patch.patch = inputs.patch(patch.id);
    if (patch.patch && patch.patch->images.size() >= 2) {
      read_images(folder / patch.subfolder, inputs, patch);
    }
  });
  if (!inputs.is_of_files()) {
    read_or_note(patch, "points of the surface are not shown",
                 [&] { read_surface(folder / patch.subfolder, patch); });
  }
  const std::vector<std::string> clouds =
      inputs.is_of_files() || !patch.patch ? inputs.paths("cloud") : patch.patch->lidar;
  read_or_note(patch, "points are not shown", [&] {
    patch.judge = inputs.judge_options();
    patch.max_aligned_angle_deg = inputs.max_aligned_angle_deg();
    if (clouds.empty()) {
      patch.notes.emplace_back("no LIDAR: lines are shown but not judged");
    } else if (inputs.is_of_files() || patch.patch) {
      read_points(clouds, inputs, patch);
    }
  });
  if (patch.images && patch.patch->reference_matches) {
    read_or_note(patch, "matches are not judged", [&] {
      (void)inputs.unchanged(*patch.patch->reference_matches);
      const ReportImages& images = *patch.images;
      const std::vector<Correspondence> none;
      patch.images->score =
          score_patch_matches(*patch.patch, segments_of(images, kPairOfPatch),
                              images.pairs.empty() ? none : images.pairs.front().matches);
    });
  }
  const std::optional<std::string> reference = inputs.reference_lines(patch.patch);
  if (reference) {
    read_or_note(patch, "true errors are not shown",
                 [&] { read_true_errors(inputs, *reference, patch); });
  }
}

/// A shortener for all paths that may occur in the texts of the report.
PathShortener path_shortener(const std::string& folder,
                             const RunInputs& inputs,
                             const std::vector<ReportPatch>& patches) {
  std::vector<std::string> paths = inputs.all_paths();
  for (const std::string& path : inputs.given_paths()) paths.push_back(path);
  paths.push_back(folder);
  paths.push_back((fs::path(folder) / "run.json").string());
  for (const ReportPatch& patch : patches) {
    if (!patch.patch) continue;
    for (const io::PatchImage& image : patch.patch->images) paths.push_back(image.path);
    paths.insert(paths.end(), patch.patch->lidar.begin(), patch.patch->lidar.end());
    if (patch.patch->reference_matches) paths.push_back(*patch.patch->reference_matches);
    if (patch.patch->reference_lines) paths.push_back(*patch.patch->reference_lines);
  }
  return PathShortener(paths);
}

}  // namespace

ReportInput read_report_input(const std::string& folder) {
  if (!fs::is_directory(folder)) {
    io::require_kind(folder, io::FileGroup::kResultFolder);
    throw io::IoError(folder, "is not a results folder");
  }
  ReportInput input;
  const fs::path path(folder);
  input.run = results::read_run_json(path);
  const RunInputs inputs(input.run, (path / "run.json").string());
  input.input_paths = inputs.all_paths();
  input.table1 = results::read_matching(path, inputs.is_of_files());
  input.patches = read_evaluated_patches(path, inputs);
  for (ReportPatch& patch : input.patches) {
    if (inputs.is_of_files()) read_buildings(path, patch);
    read_to_fix(path, patch);
    read_run_data(path, inputs, patch);
  }
  const PathShortener shortener = path_shortener(folder, inputs, input.patches);
  shortener.shorten(input.run);
  for (ReportPatch& patch : input.patches) {
    for (std::string& note : patch.notes) shortener.shorten(note);
  }
  return input;
}

}  // namespace ridgeline::apps
