// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/check_pair.h"
#include "apps/common/command.h"
#include "apps/common/exit_code.h"
#include "apps/common/image_options.h"
#include "apps/common/parameters.h"
#include "apps/common/patch_matchers.h"
#include "apps/common/patch_matching.h"
#include "apps/common/patch_views.h"
#include "apps/common/reconstructed_lines.h"
#include "apps/common/say.h"
#include "apps/common/surface_file.h"
#include "apps/run/run_options.h"
#include "io/cloud/labelled_points.h"
#include "io/error.h"
#include "io/input_file.h"
#include "io/lines/write_lines.h"
#include "io/results/output_folder.h"
#include "io/segments_file.h"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

struct ReconstructArguments {
  std::string patch, matches, out, surface, method = "joint", format = "geojson";
  ParameterArguments parameters;
  reconstruct::Options options;  ///< as the parameters say
  std::vector<std::string> matchers{"pairwise"};
  double max_image_mpx = 0.0;
  double max_y_parallax_px = kDefaultMaxYParallax_px;
  bool local_origin = false;
};

/// The segments that a matches file speaks of: those in segments.IMAGE.csv beside it, else
/// extracted now with the given options.
std::vector<EdgeSegment> segments_of(const io::PatchFile& patch,
                                     std::size_t i,
                                     const cv::Mat& image,
                                     const ReconstructArguments& a) {
  if (!a.matches.empty()) {
    const fs::path file =
        fs::path(a.matches).parent_path() / fmt::format("segments.{}.csv", patch.images[i].id);
    if (fs::exists(file)) return io::read_segments(file.string());
  }
  return extract_patch_image(patch, i, image, a.options.extraction);
}

std::vector<LineMatch> matches_of(reconstruct::StereoPair& pair,
                                  const reconstruct::Options& options,
                                  const std::optional<reconstruct::Surface>& surface) {
  reconstruct::Matches matches = reconstruct::match(pair, options.matching, surface);
  reconstruct::guide(pair, matches, options, surface);
  return reconstruct::line_matches(matches.used());
}

/// Throws IoError for a pair that has none.
void write_whole_surface(const std::string& file,
                         const io::PatchFile& patch,
                         const std::optional<reconstruct::Surface>& surface) {
  if (!surface)
    throw io::IoError(patch.path, "--write-surface: the images cannot be rectified to each other");
  write_surface(file, patch, points_in_local(*surface));
}

/// The lines of the patch, from the matches of a file or from those made now.
std::vector<reconstruct::ReconstructedLine> lines_of(const io::PatchFile& patch,
                                                     const ReconstructArguments& a) {
  const std::array<cv::Mat, 2> images = patch_images(patch);
  if (const auto doubt = check_pair(patch, images, a.max_y_parallax_px)) spdlog::warn("{}", *doubt);
  std::array<std::vector<EdgeSegment>, 2> segments;
  for (std::size_t i = 0; i < 2; ++i) segments[i] = segments_of(patch, i, images[i], a);
  reconstruct::StereoPair pair = stereo_pair(patch, images, segments);
  const std::optional<reconstruct::Surface> surface = reconstruct::surface_of(pair, a.options);
  if (!surface && a.options.estimation.lines.method == reconstruct::Method::kPlanes) {
    throw io::IoError(
        patch.path,
        "--method planes: there is no surface to find planes in; the images cannot be "
        "rectified to each other, or --config turns every key off that needs it");
  }
  if (!a.surface.empty())
    write_whole_surface(a.surface, patch, surface ? surface : dense_surface(pair));
  const std::vector<LineMatch> matches = a.matches.empty() ? matches_of(pair, a.options, surface)
                                                           : read_line_matches(a.matches, segments);
  return reconstruct::estimate(pair, matches, a.options.estimation, a.options.matching.pairwise,
                               surface);
}

/// How files of the format begin that were written here. Those that GDAL writes bear no such mark.
std::optional<std::string_view> own_beginning(io::LineFormat format) {
  switch (format) {
    case io::LineFormat::kGeoJson:
      return "{\"type\":\"FeatureCollection\",\n";
    case io::LineFormat::kCsv:
      return "x1,y1,z1,x2,y2,z2,id,";
    case io::LineFormat::kObj:
      return "# 3D line segments, metres\n";
    case io::LineFormat::kPly:
      return "ply\nformat ascii 1.0\ncomment 3D line segments, metres\n";
    default:
      return std::nullopt;
  }
}

/// Neither an input nor anything of a user.
void check_out(const ReconstructArguments& a, std::vector<std::string> inputs) {
  if (!a.matches.empty()) io::require_regular_file(a.matches, io::Expected::kMatches);
  inputs.push_back(a.matches);
  (void)results::output_file(a.out, inputs);
  if (!a.surface.empty()) {
    check(a.surface.ends_with(".las"), "--write-surface: ", a.surface, ", must end in .las");
    inputs.push_back(a.out);
    (void)results::output_file(a.surface, inputs);
    results::check_is_own(a.surface, io::is_own_points_file, "points file");
  }
  const std::optional<std::string_view> beginning = own_beginning(*io::line_format(a.format));
  if (beginning) return results::check_is_own(a.out, *beginning, "file of lines");
  if (!results::holds_something(a.out)) return;
  throw io::IoError(a.out,
                    "stands there and would be written over; choose another name or remove it");
}

int run_reconstruct(ReconstructArguments a) {
  a.options = read_parameters(a.parameters).method;
  a.options.matching.matchers = matchers_named(a.matchers);
  a.options.estimation.lines.method = method_named(a.method);
  check_preset(a.parameters, {a.options.estimation.lines.method});
  io::PatchFile patch = io::read_patch(a.patch);
  patch.max_image_mpx = a.max_image_mpx;
  check_patch(patch);
  check_out(a, results::paths_of(input_files(patch)));
  io::require_writable(*io::line_format(a.format));
  const io::LineSet lines = line_set_of(lines_of(patch, a), patch_frame(patch), patch.crs,
                                        a.options.estimation.lines.method);
  const std::size_t n_left_out =
      io::write_lines(a.out, lines, *io::line_format(a.format), {.local_origin = a.local_origin});
  const auto with_geometry =
      std::count_if(lines.lines.begin(), lines.lines.end(),
                    [](const io::Line& line) { return all_finite(line.segment_in_world); });
  say("{}: {} lines by {}, {} without geometry{}\n", a.out, with_geometry, a.method,
      static_cast<std::ptrdiff_t>(lines.lines.size()) - with_geometry,
      n_left_out > 0 ? ", left out of the file" : "");
  return kDone;
}

}  // namespace

Run add_reconstruct(CLI::App& subcommand) {
  auto a = std::make_shared<ReconstructArguments>();
  subcommand.add_option("patch", a->patch, "patch file (YAML): images and cameras")->required();
  subcommand.add_option("--out", a->out, "file for the 3D lines")->required();
  subcommand.add_option("--method", a->method, "direct, joint, network, planes")
      ->check(CLI::IsMember(method_names()))
      ->capture_default_str();
  subcommand.add_option("--matches", a->matches,
                        "matches.csv; its ids are those of segments.IMAGE.csv beside it, else of "
                        "the segments extracted now. Default: match now");
  subcommand.add_option("--format", a->format, "of --out")
      ->check(CLI::IsMember(line_format_names()))
      ->capture_default_str();
  subcommand.add_option("--write-surface", a->surface,
                        "LAS file for the points that dense matching of the pair knows");
  add_local_origin_flag(subcommand, a->local_origin);
  add_pair_check_option(subcommand, a->max_y_parallax_px);
  add_image_size_option(subcommand, a->max_image_mpx);
  add_method_options(subcommand, a->parameters);
  add_matcher_option(subcommand, a->matchers);
  return [a] { return run_reconstruct(*a); };
}

}  // namespace ridgeline::apps
