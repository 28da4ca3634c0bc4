// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/match/match_overlay.h"
#include "apps/pipeline/check_pair.h"
#include "apps/pipeline/check_patch.h"
#include "apps/pipeline/match_tables.h"
#include "apps/pipeline/open_patch.h"
#include "apps/pipeline/patch_scene.h"
#include "evaluate/files/output_folder.h"
#include "io/files/atomic_file.h"
#include "io/images/png_writer.h"
#include "io/project/matches_file.h"
#include "io/project/segments_file.h"
#include "reconstruct/match/chio_wang2000/four_processes.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <span>

namespace ridgeline::apps {
namespace {

struct MatchArguments {
  std::string patch;
  std::string out;
  std::string overlay;
  std::string segments;  ///< folder for the segments.IMAGE.csv
  std::string provenance;
  ParameterArguments parameters;
  double max_image_mpx = 0.0;
  bool overwrite = false;
  double max_y_parallax_px = kDefaultMaxYParallax_px;
  std::string matcher = "pairwise";
  reconstruct::Options options;  ///< made from `parameters` and `matcher`
};

void print_summary(std::span<const reconstruct::View> views,
                   const reconstruct::PairMatches& result) {
  say("{} segments in the left, {} in the right image\n", views[0].segments.size(),
      views[1].segments.size());
  std::map<std::string, int> n;
  for (const std::string& reason : result.list.reasons) ++n[reason];
  for (const auto& [reason, count] : n) say("  {:<21}{}\n", reason, count);
}

/// Prints the numbers of lines in the categories of Chio and Wang (2000): first two processes,
/// third and fourth process, and relaxed limit.
void print_processes(const reconstruct::ChioResult& result) {
  const auto count = [&](auto holds) {
    return std::count_if(result.lines.begin(), result.lines.end(),
                         [&](const reconstruct::ChioLine& line) { return holds(line.acquired); });
  };
  using reconstruct::Acquired;
  say("lines of chio by process:\n");
  say("  1 and 2              {}\n", count([](const Acquired& a) { return a.process <= 2; }));
  say("  then 3 and 4         {}\n",
      count([](const Acquired& a) { return a.process > 2 && !a.relaxed; }));
  say("  relaxed to {:<5} m   {}\n", reconstruct::kRelaxedHeightDifference_m,
      count([](const Acquired& a) { return a.relaxed; }));
}

/// The files of the segments to which the matches refer. None are written next to a device such as
/// /dev/stdout.
std::vector<std::string> segment_files(const MatchArguments& a, const io::Patch& patch) {
  namespace fs = std::filesystem;
  const bool is_device = fs::exists(a.out) && !fs::is_regular_file(a.out);
  if (a.segments.empty() && is_device) return {};
  const fs::path folder = a.segments.empty() ? fs::path(a.out).parent_path() : fs::path(a.segments);
  return {(folder / segments_file(patch.images[0])).string(),
          (folder / segments_file(patch.images[1])).string()};
}

void check_outputs(const MatchArguments& a, const io::Patch& patch) {
  check(a.provenance.empty() || a.options.matching.matcher == reconstruct::Matcher::kChio,
        "provenance: only lines of chio have one; requires --matcher chio");
  std::vector<std::string> others = results::paths_of(input_files(patch));
  std::vector<std::string> files = segment_files(a, patch);
  files.insert(files.end(), {a.out, a.overlay, a.provenance});
  for (const std::string& file : files) {
    results::check_output_file(file, others, a.overwrite);
    others.push_back(file);
  }
  results::check_is_png("--overlay", a.overlay);
}

int run_match(MatchArguments a) {
  a.options = read_parameters(a.parameters).method;
  a.options.matching.matcher = matcher_named(a.matcher);
  const io::Patch patch =
      open_patch(a.patch, {.max_image_mpx = a.max_image_mpx}, [&](const io::Patch& decided) {
        tell_of(decided);
        check_outputs(a, decided);
      });
  reconstruct::Scene scene = patch_scene(patch, patch_images(patch, a.max_image_mpx));
  warn_of(check_pairs(patch, scene, {&kPairOfPatch, 1}, a.max_y_parallax_px));
  reconstruct::extract(scene.views, a.options.extraction);
  warn_of(image_warnings(patch, scene));
  const reconstruct::Matched matched = reconstruct::match_all(scene, {&kPairOfPatch, 1}, a.options);
  const reconstruct::PairMatches& result = matched.pairs.front();
  const std::vector<reconstruct::View>& views = scene.views;
  const std::vector<std::string> files = segment_files(a, patch);
  for (std::size_t i = 0; i < files.size(); ++i) io::write_segments(files[i], views[i].segments);
  io::write_matches(a.out, result.list.matches);
  if (!a.provenance.empty()) io::write_file(a.provenance, chio_csv(*result.chio, patch.frame));
  if (!a.overlay.empty()) {
    io::write_png(a.overlay, match_overlay(views[0], views[1], result.list.matches));
  }
  print_summary(views, result);
  if (result.chio) print_processes(*result.chio);
  return kDone;
}

}  // namespace

Run add_match(CLI::App& subcommand) {
  auto a = std::make_shared<MatchArguments>();
  subcommand.add_option("patch", a->patch, "patch file (YAML)")->required();
  subcommand
      .add_option(
          "--out", a->out,
          "CSV: left_id,right_id,score,votes,matcher; ids are the segment numbers of each image")
      ->required();
  subcommand.add_option("--overlay", a->overlay,
                        "write a PNG of both images with the matched segments");
  subcommand.add_option("--segments", a->segments,
                        "folder for segments.IMAGE.csv of both images, which define the ids; "
                        "default: the folder of --out, where reconstruct --matches expects them");
  add_matcher_option(subcommand, a->matcher);
  subcommand.add_option("--provenance", a->provenance,
                        "write a CSV with process, neighbour and height of each line of chio");
  add_pair_check_option(subcommand, a->max_y_parallax_px);
  add_overwrite_flag(subcommand, a->overwrite);
  add_image_size_option(subcommand, a->max_image_mpx);
  add_preset_option(subcommand, a->parameters.preset);
  add_config_option(subcommand, a->parameters.config);
  return [a] { return run_match(*a); };
}

}  // namespace ridgeline::apps
