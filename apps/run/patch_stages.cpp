// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/patch_stages.h"

#include "apps/pipeline/check_pair.h"
#include "apps/pipeline/made_from.h"
#include "apps/pipeline/match_tables.h"
#include "apps/pipeline/patch_matching.h"
#include "apps/pipeline/patch_scene.h"
#include "apps/pipeline/reconstructed_lines.h"
#include "evaluate/files/write_results.h"
#include "evaluate/tables/summary_json.h"
#include "io/cloud/labelled_points.h"
#include "io/cloud/las_writer.h"
#include "io/files/atomic_file.h"
#include "io/project/matches_file.h"
#include "io/project/segments_file.h"
#include "io/project/tracks_file.h"
#include "reconstruct/extract/beyond/soft_edges/edge_facts.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridgeline::apps {
namespace {

/// The list of matches from which lines are reconstructed.
constexpr const char* kMatchList = "matches.csv";
constexpr const char* kUnmatchedList = "unmatched.csv";
constexpr const char* kChioList = "chio.csv";
constexpr const char* kVerdictList = "verdicts.csv";
/// The observations of each edge, for three or more images.
constexpr const char* kTrackList = "tracks.csv";

/// left_id,right_id,verdict: correct, false and unjudged matches, then the missed ones.
std::string verdicts_csv(const std::vector<Correspondence>& matches,
                         const evaluate::MatchingScore& score) {
  std::string text = "left_id,right_id,verdict\n";
  for (std::size_t i = 0; i < matches.size(); ++i) {
    text += fmt::format("{},{},{}\n", matches[i].base, matches[i].other,
                        evaluate::name(score.verdicts[i]));
  }
  for (const Correspondence& missed : score.missed) {
    text += fmt::format("{},{},missed\n", missed.base, missed.other);
  }
  return text;
}

nlohmann::ordered_json to_json(const reconstruct::EdgeFacts& facts) {
  nlohmann::ordered_json scales = nlohmann::ordered_json::array();
  for (const reconstruct::EdgesOfScale& edges : facts.scales)
    scales.push_back({{"scale_px", edges.scale_px},
                      {"n_segments", edges.n_segments},
                      {"length_px", std::round(edges.length_px)},
                      {"width_px", evaluate::number_json(edges.width_px)}});
  return {{"scales", std::move(scales)}, {"noise", evaluate::number_json(facts.noise)}};
}

}  // namespace

PatchStages::PatchStages(const io::Patch& patch,
                         const RunOptions& options,
                         const results::OutputFolder& out,
                         results::RunRecord& record)
    : patch_(patch),
      options_(options),
      out_(out),
      record_(record),
      parameters_(echo(options.parameters)),
      scene_(patch_scene(patch)) {}

/// Any of the options of `match`, `chio` and `reconstruct` may ask for the surface.
std::vector<Stage> PatchStages::table() {
  const auto options_of = [&](const char* group) { return parameters_[group].dump(); };
  const std::string views = views_key();
  const std::string extraction = extraction_key();
  const reconstruct::Matcher matcher = options_.parameters.method.matching.matcher;
  const std::string matches = key_of({views, options_of("match"), options_of("tracks"),
                                      options_of("chio"), extraction, name(matcher)});
  std::vector<Stage> stages{
      {"check pairs",
       key_of({views, options_of("tracks"), fmt::format("{}", options_.max_y_parallax_px)}),
       {},
       [this](auto&) { check_pairs(); }},
      {"extract", extraction, edge_files(), [this](auto&) { extract(); }},
      {kMatchStage, matches, match_files(), [this](auto& files) { match(files); }},
      {kSurfaceStage,
       key_of({matches, options_of("reconstruct"), patch_.crs.definition}),
       {kSurfaceFile},
       [this](auto&) { keep_surface(); }}};
  for (const reconstruct::Method method : options_.methods) {
    const std::vector<std::string> files = line_files(method);
    std::vector<std::string> parts{matches, reconstruct::name(method), options_of("reconstruct"),
                                   patch_.crs.definition};
    parts.insert(parts.end(), files.begin(), files.end());
    if (options_.local_origin) parts.emplace_back("local origin");
    stages.push_back({fmt::format("reconstruct {}", reconstruct::name(method)), key_of(parts),
                      files, [this, method](auto&) { reconstruct(method); }});
  }
  return stages;
}

/// The key of the images, their cameras and their height range.
std::string PatchStages::views_key() const {
  std::vector<std::string> parts{fmt::format("{}", fmt::join(patch_.height_range_m, " "))};
  for (const io::PatchImage& image : patch_.images)
    parts.push_back(key_of_view(image, record_.hash_of(image.path)));
  return key_of(parts);
}

/// One key for all images, because they are searched at a common size.
std::string PatchStages::extraction_key() const {
  std::vector<std::string> parts{parameters_["extract"].dump()};
  for (const io::PatchImage& image : patch_.images) {
    parts.push_back(key_of_picture(image, record_.hash_of(image.path)));
    if (image.segments)
      parts.push_back(
          fmt::format("{} {}", record_.hash_of(*image.segments), image.segment_sigma_px));
  }
  return key_of(parts);
}

std::vector<std::string> PatchStages::edge_files() const {
  return transformed(patch_.images, edges_file);
}

std::vector<std::string> PatchStages::segment_files() const {
  return transformed(patch_.images, segments_file);
}

std::vector<std::string> PatchStages::match_files() const {
  std::vector<std::string> files = segment_files();
  files.insert(files.end(), {kMatchList, kUnmatchedList, kTrackList, kChioList, kVerdictList});
  return files;
}

std::string PatchStages::line_file(reconstruct::Method method, std::string_view extension) {
  return fmt::format("lines.{}{}", reconstruct::name(method), extension);
}

/// The formats of the line files in addition to GeoJSON.
std::vector<io::LineFormatInfo> PatchStages::more_line_formats() const {
  std::vector<io::LineFormatInfo> formats;
  for (const io::LineFormatInfo& info : io::line_formats()) {
    const bool is_wanted = std::ranges::count(options_.line_formats, info.format) > 0;
    if (is_wanted && info.format != io::LineFormat::kGeoJson) formats.push_back(info);
  }
  return formats;
}

std::vector<std::string> PatchStages::line_files(reconstruct::Method method) const {
  std::vector<std::string> files{line_file(method)};
  for (const io::LineFormatInfo& info : more_line_formats()) {
    files.push_back(line_file(method, info.extension));
  }
  return files;
}

std::string PatchStages::path(const std::string& file) const {
  return out_.path(patch_.id + "/" + file);
}

void PatchStages::read_images() {
  if (!scene_.views[0].image.empty()) return;
  scene_ = patch_scene(patch_, patch_images(patch_, options_.max_image_mpx));
}

std::array<std::vector<EdgeSegment>, 2> PatchStages::segments_of_pair() const {
  const std::vector<std::string> files = segment_files();
  return {io::read_segments(path(files[0])), io::read_segments(path(files[1]))};
}

void PatchStages::read_views(const std::vector<std::string>& files) {
  read_images();
  for (std::size_t i = 0; i < files.size(); ++i)
    scene_.views[i].segments = io::read_segments(path(files[i]));
}

/// The stages share the surfaces, so that they are computed only once.
const std::vector<std::optional<reconstruct::Surface>>& PatchStages::surfaces() {
  if (surfaces_.empty()) {
    surfaces_ = transformed(pairs(), [&](const ViewPair& pair) {
      return reconstruct::surface_of(stereo_pair(scene_, pair), options_.parameters.method);
    });
  }
  return surfaces_;
}

std::vector<ViewPair> PatchStages::pairs() const {
  return pairs_of(scene_, options_.parameters.method);
}

/// The folder for the files of a pair; empty for the base pair, whose files are in the folder of
/// the patch.
std::string PatchStages::pair_folder(const ViewPair& pair) const {
  if (pair.base == kPairOfPatch.base && pair.search == kPairOfPatch.search) return "";
  return fmt::format("pairs/{}-{}/", patch_.images[pair.base].id, patch_.images[pair.search].id);
}

void PatchStages::check_pairs() {
  read_images();
  record_.add_warnings(
      check_matched_pairs(patch_, scene_, options_.parameters.method, options_.max_y_parallax_px));
}

void PatchStages::extract() {
  read_images();
  reconstruct::extract(scene_.views, options_.parameters.method.extraction);
  const std::vector<std::string> files = edge_files();
  for (std::size_t i = 0; i < files.size(); ++i)
    io::write_segments(path(files[i]), scene_.views[i].segments);
  record_.add_warnings(image_warnings(patch_, scene_));
}

/// Writes points of the base pair's surface, or removes the file of an earlier run if there is no
/// surface.
void PatchStages::keep_surface() {
  read_views(segment_files());
  const std::optional<reconstruct::Surface>& kept = surfaces().front();
  if (!kept) return out_.remove(patch_.id + "/" + kSurfaceFile);
  const std::vector<Eigen::Vector3d> points = points_in_local(*kept, kMaxSurfacePoints);
  io::write_las(path(kSurfaceFile), transformed(points, io::single_return), scene_.frame,
                patch_.crs);
}

void PatchStages::match(std::vector<std::string>& files) {
  // lists of an earlier run would look like those of this run
  for (const char* file : {kChioList, kVerdictList, kTrackList})
    out_.remove(patch_.id + "/" + file);
  read_views(edge_files());
  reconstruct::Matched matched =
      reconstruct::match_all(scene_, pairs(), options_.parameters.method);
  const std::vector<std::string> segment_names = segment_files();
  for (std::size_t i = 0; i < segment_names.size(); ++i)
    io::write_segments(path(segment_names[i]), scene_.views[i].segments);
  for (const reconstruct::PairMatches& result : matched.pairs) {
    const std::string folder = pair_folder(result.views);
    io::write_matches(path(folder + kMatchList), result.list.matches);
    io::write_file(path(folder + kUnmatchedList), unmatched_csv(result.list));
    if (!folder.empty()) files.insert(files.end(), {folder + kMatchList, folder + kUnmatchedList});
  }
  if (const auto& chio = matched.pairs.front().chio)
    io::write_file(path(kChioList), chio_csv(*chio, scene_.frame));
  if (scene_.views.size() > 2) {
    io::write_tracks(path(kTrackList), matched.tracks,
                     transformed(patch_.images, &io::PatchImage::id));
  }
  surfaces_.clear();
  for (reconstruct::PairMatches& result : matched.pairs)
    surfaces_.push_back(std::move(result.surface));
}

std::vector<Track> PatchStages::tracks() const {
  if (patch_.images.size() > 2)
    return io::read_tracks(path(kTrackList), transformed(patch_.images, &io::PatchImage::id));
  return tracks_of_pair(kPairOfPatch, read_correspondences(path(kMatchList), segments_of_pair()));
}

void PatchStages::reconstruct(reconstruct::Method method) {
  reconstruct::Options options = options_.parameters.method;
  options.estimation.lines.method = method;
  const std::vector<Track> of_file = tracks();
  read_views(segment_files());
  const io::LineSet lines =
      line_set_of(reconstruct::estimate(scene_, of_file, used_pairs(pairs(), surfaces()), options),
                  scene_, patch_.crs, method, options.estimation.lines.max_aligned_angle_deg);
  io::write_lines(path(line_file(method)), lines, io::LineFormat::kGeoJson);
  for (const io::LineFormatInfo& info : more_line_formats()) {
    const std::string file = line_file(method, info.extension);
    const std::size_t n_left_out =
        io::write_lines(path(file), lines, info.format, {.local_origin = options_.local_origin});
    if (n_left_out == 0) continue;
    spdlog::info("{}/{}: {} lines without geometry are not written", patch_.id, file, n_left_out);
  }
}

PatchCounts PatchStages::counts() const {
  return {patch_.id, !patch_.lidar.empty(), segments_of_pair()[0].size(),
          io::read_matches(path(kMatchList)).size()};
}

nlohmann::ordered_json PatchStages::edge_facts() {
  read_images();
  std::vector<reconstruct::EdgeFacts> facts(patch_.images.size());
  tbb::parallel_for(std::size_t{0}, facts.size(), [&](std::size_t i) {
    reconstruct::View view = scene_.views[i];
    view.segments = io::read_segments(path(edges_file(patch_.images[i])));
    facts[i] = reconstruct::edge_facts(view);
  });
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < facts.size(); ++i) json[patch_.images[i].id] = to_json(facts[i]);
  return json;
}

std::optional<evaluate::Table1Row> PatchStages::score_matches() const {
  const std::array<std::vector<EdgeSegment>, 2> extracted = segments_of_pair();
  const std::vector<Correspondence> matches = read_correspondences(path(kMatchList), extracted);
  const auto score = score_patch_matches(patch_, extracted, matches);
  if (!score) return std::nullopt;
  io::write_file(path(kVerdictList), verdicts_csv(matches, *score));
  const char* matcher = name(options_.parameters.method.matching.matcher);
  return evaluate::Table1Row{patch_.id, matcher, score->counts, score->n_unjudged};
}

std::optional<evaluate::PatchTracks> PatchStages::score_tracks() const {
  if (!patch_.reference_tracks) return std::nullopt;
  const reconstruct::Options& options = options_.parameters.method;
  const std::vector<std::vector<EdgeSegment>> segments = transformed(
      segment_files(), [&](const std::string& file) { return io::read_segments(path(file)); });
  auto score =
      score_patch_tracks(patch_, options.matching.tracks.all_views ? segments.size() : 2, segments,
                         tracks(), options.estimation.lines.max_aligned_angle_deg);
  if (!score) return std::nullopt;
  return evaluate::PatchTracks{patch_.id, std::move(score->cells), score->n_unjudged};
}

void remove_other_methods(std::span<const reconstruct::Method> methods,
                          const results::OutputFolder& out,
                          const std::string& subfolder) {
  for (const reconstruct::Method method : reconstruct::kMethods) {
    if (std::ranges::find(methods, method) != methods.end()) continue;
    std::vector<std::string> names = results::evaluation_names(reconstruct::name(method));
    names.push_back(fmt::format("fig8.{}.png", reconstruct::name(method)));
    for (const io::LineFormatInfo& info : io::line_formats())
      names.push_back(PatchStages::line_file(method, info.extension));
    for (const std::string& name : names) out.remove(subfolder + name);
  }
}

}  // namespace ridgeline::apps
