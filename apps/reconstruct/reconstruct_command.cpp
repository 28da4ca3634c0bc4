// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/pipeline/check_pair.h"
#include "apps/pipeline/check_patch.h"
#include "apps/pipeline/open_patch.h"
#include "apps/pipeline/patch_matching.h"
#include "apps/pipeline/patch_scene.h"
#include "apps/pipeline/reconstructed_lines.h"
#include "evaluate/files/output_folder.h"
#include "io/cloud/labelled_points.h"
#include "io/cloud/las_writer.h"
#include "io/error.h"
#include "io/files/input_file.h"
#include "io/lines/write_lines.h"
#include "io/project/segments_file.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/surface/surface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

struct ReconstructArguments {
  std::string patch, matches, out, surface, method, format;
  ParameterArguments parameters;
  reconstruct::Options options;  ///< made from `parameters`, `matcher` and `method`
  std::string matcher = "pairwise";
  double max_image_mpx = 0.0;
  double max_y_parallax_px = kDefaultMaxYParallax_px;
  bool local_origin = false;
  bool overwrite = false;
};

/// Gives the views the segments to which the matches refer: from segments.IMAGE.csv next to the
/// match file, else newly extracted ones.
void find_segments(const io::Patch& patch,
                   const ReconstructArguments& a,
                   reconstruct::Scene& scene) {
  if (a.matches.empty()) return reconstruct::extract(scene.views, a.options.extraction);
  const fs::path folder = fs::path(a.matches).parent_path();
  const auto files = transformed(
      patch.images, [&](const io::PatchImage& image) { return folder / segments_file(image); });
  const auto is_there = [](const fs::path& file) { return fs::exists(file); };
  // Extract from all images, because they are searched at a common size.
  if (!std::ranges::all_of(files, is_there))
    reconstruct::extract(scene.views, a.options.extraction);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (is_there(files[i])) scene.views[i].segments = io::read_segments(files[i].string());
  }
}

/// The matches from the file, which are those of the first two images, or new matches of all
/// images. Segments found during matching are added to the scene.
reconstruct::Matched find_matches(reconstruct::Scene& scene, const ReconstructArguments& a) {
  if (a.matches.empty())
    return reconstruct::match_all(scene, pairs_of(scene, a.options), a.options);
  reconstruct::Matched of_file;
  of_file.tracks = tracks_of_pair(
      kPairOfPatch,
      read_correspondences(a.matches, {scene.views[0].segments, scene.views[1].segments}));
  of_file.pairs.resize(1);
  of_file.pairs[0].views = kPairOfPatch;
  of_file.pairs[0].surface = reconstruct::surface_of(stereo_pair(scene, kPairOfPatch), a.options);
  return of_file;
}

/// Writes all points of the surface. Throws IoError if the pair has no surface.
void write_whole_surface(const std::string& file,
                         const io::Patch& patch,
                         const std::optional<reconstruct::Surface>& surface) {
  if (!surface)
    throw io::IoError(patch.path, "--write-surface: the images cannot be rectified to each other");
  io::write_las(file, transformed(points_in_local(*surface), io::single_return), patch.frame,
                patch.crs);
}

/// Reconstructs the lines of the patch, from the matches in a file or from new ones.
std::vector<reconstruct::ReconstructedLine> lines_of(const io::Patch& patch,
                                                     const ReconstructArguments& a) {
  reconstruct::Scene scene = patch_scene(patch, patch_images(patch, a.max_image_mpx));
  warn_of(check_matched_pairs(patch, scene, a.options, a.max_y_parallax_px));
  find_segments(patch, a, scene);
  if (a.matches.empty()) warn_of(image_warnings(patch, scene));
  const reconstruct::Matched found = find_matches(scene, a);
  if (a.options.estimation.lines.method == reconstruct::Method::kPlanes &&
      std::ranges::none_of(found.pairs, [](const auto& p) { return p.surface.has_value(); })) {
    throw io::IoError(patch.path,
                      "--method planes: there is no surface to find planes in; the images cannot "
                      "be rectified to each other, or --config turns off every key that uses it");
  }
  if (!a.surface.empty()) {
    write_whole_surface(a.surface, patch,
                        found.pairs[0].surface
                            ? found.pairs[0].surface
                            : reconstruct::surface_of(stereo_pair(scene, kPairOfPatch)));
  }
  return reconstruct::estimate(scene, found.tracks, used_pairs(found.pairs), a.options);
}

void check_outputs(const ReconstructArguments& a, std::vector<std::string> inputs) {
  if (!a.matches.empty()) io::require_regular_file(a.matches, io::FileGroup::kMatches);
  inputs.push_back(a.matches);
  results::check_output_file(a.out, inputs, a.overwrite);
  inputs.push_back(a.out);
  results::check_output_file(a.surface, inputs, a.overwrite);
  check(a.surface.empty() || a.surface.ends_with(".las"), "--write-surface: ", a.surface,
        ", must end in .las");
}

int run_reconstruct(ReconstructArguments a) {
  a.options = read_parameters(a.parameters).method;
  a.options.matching.matcher = matcher_named(a.matcher);
  if (a.method.empty()) a.method = default_methods(a.parameters).back();
  a.options.estimation.lines.method = method_named(a.method);
  check_preset(a.parameters, {a.options.estimation.lines.method});
  const io::Patch patch = open_patch(a.patch, {.max_image_mpx = a.max_image_mpx}, tell_of);
  check_outputs(a, results::paths_of(input_files(patch)));
  const io::LineFormat format = line_format_of(a.out, a.format);
  io::require_writable(format);
  const io::LineSet lines = line_set_of(lines_of(patch, a), patch_scene(patch), patch.crs,
                                        a.options.estimation.lines.method,
                                        a.options.estimation.lines.max_aligned_angle_deg);
  const std::size_t n_left_out =
      io::write_lines(a.out, lines, format, {.local_origin = a.local_origin});
  const auto with_geometry =
      std::count_if(lines.lines.begin(), lines.lines.end(),
                    [](const io::Line& line) { return all_finite(line.segment_in_world); });
  say("{}: {} lines by {}, {} without geometry{}\n", a.out, with_geometry, a.method,
      static_cast<std::ptrdiff_t>(lines.lines.size()) - with_geometry,
      n_left_out > 0 ? ", not written to the file" : "");
  return kDone;
}

}  // namespace

Run add_reconstruct(CLI::App& subcommand) {
  auto a = std::make_shared<ReconstructArguments>();
  subcommand.add_option("patch", a->patch, "patch file (YAML): images and cameras")->required();
  subcommand.add_option("--out", a->out, "file for the 3D lines")->required();
  subcommand
      .add_option("--method", a->method,
                  fmt::format("{}; default: lines, or joint with --preset published",
                              fmt::join(method_names(), ", ")))
      ->check(CLI::IsMember(method_names()));
  subcommand.add_option("--matches", a->matches,
                        "matches.csv; ids refer to segments.IMAGE.csv next to it, else to newly "
                        "extracted segments; default: match now");
  add_line_format_option(subcommand, a->format);
  subcommand.add_option("--write-surface", a->surface,
                        "write the points from dense matching of the pair to this LAS file");
  add_overwrite_flag(subcommand, a->overwrite);
  add_local_origin_flag(subcommand, a->local_origin);
  add_pair_check_option(subcommand, a->max_y_parallax_px);
  add_image_size_option(subcommand, a->max_image_mpx);
  add_method_options(subcommand, a->parameters);
  add_matcher_option(subcommand, a->matcher);
  return [a] { return run_reconstruct(*a); };
}

}  // namespace ridgeline::apps
