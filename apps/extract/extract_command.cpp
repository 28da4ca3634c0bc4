// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/extract/segment_overlay.h"
#include "apps/pipeline/black_border.h"
#include "apps/pipeline/open_patch.h"
#include "apps/pipeline/patch_scene.h"
#include "evaluate/files/output_folder.h"
#include "io/error.h"
#include "io/images/png_writer.h"
#include "io/project/patch.h"
#include "io/project/segments_file.h"
#include "reconstruct/reconstruct.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace ridgeline::apps {
namespace {

struct ExtractArguments {
  std::string image, out, overlay, patch, image_id;
  std::vector<int> window_px;
  double max_image_mpx = 0.0;
  bool overwrite = false;
  ParameterArguments parameters;
};

/// The image of the patch with the id given by --image-id; without an id, the one whose file is
/// processed.
io::PatchImage camera_of(const ExtractArguments& a) {
  const io::Patch patch = read_patch(a.patch);
  tell_of(patch);
  for (const io::PatchImage& image : patch.images) {
    const bool chosen = a.image_id.empty() ? std::filesystem::weakly_canonical(image.path) ==
                                                 std::filesystem::weakly_canonical(a.image)
                                           : image.id == a.image_id;
    if (chosen) return image;
  }
  throw io::IoError(a.patch, a.image_id.empty()
                                 ? "has no image " + a.image + "; select one with --image-id"
                                 : "has no image of id " + a.image_id);
}

/// The image to be read, with its camera, if any.
io::PatchImage image_of(const ExtractArguments& a) {
  io::PatchImage image;
  if (a.patch.empty()) {
    check(a.image_id.empty(), "--image-id = ", a.image_id, ", requires --patch");
  } else {
    image = camera_of(a);
  }
  image.path = a.image;
  if (a.window_px.empty()) return image;
  check(!image.window, "--window: cannot be combined with --patch, which defines the window");
  io::read_window_only(image, {a.window_px[0], a.window_px[1], a.window_px[2], a.window_px[3]});
  return image;
}

void check_outputs(const ExtractArguments& a) {
  results::check_output_file(a.out, {a.image, a.patch}, a.overwrite);
  results::check_output_file(a.overlay, {a.image, a.patch, a.out}, a.overwrite);
  results::check_is_png("--overlay", a.overlay);
}

int run_extract(const ExtractArguments& a) {
  const reconstruct::ExtractionOptions options = read_parameters(a.parameters).method.extraction;
  check_outputs(a);
  const io::PatchImage image = image_of(a);
  reconstruct::View view = view_of(image, LocalFrame{});
  const PatchPicture picture = read_image(image, a.max_image_mpx);
  view.image = picture.image;
  view.is_valid = picture.is_valid;
  if (const auto warning = black_border(image.path, view.image, view.is_valid)) warn_of({*warning});
  const std::vector<EdgeSegment> segments = reconstruct::extract(view, options);
  io::write_segments(a.out, segments);
  if (!a.overlay.empty()) {
    io::write_png(a.overlay, segment_overlay(view.image, segments));
  }
  double total_px = 0.0;
  for (const EdgeSegment& segment : segments) total_px += length(segment.in_image);
  say("{}: {} x {} px, {} bands: {} segments, total length {:.0f} px\n", a.image, view.image.cols,
      view.image.rows, view.image.channels(), segments.size(), total_px);
  return kDone;
}

}  // namespace

Run add_extract(CLI::App& subcommand) {
  auto a = std::make_shared<ExtractArguments>();
  subcommand
      .add_option("image", a->image,
                  "image: TIFF, PNG, JPEG or JPEG 2000, 8 or 16 bit, 1 to 4 bands")
      ->required();
  subcommand
      .add_option("--out", a->out,
                  "CSV of ends, covariance and flanks; (0,0) is the centre of the first pixel")
      ->required();
  subcommand.add_option("--overlay", a->overlay, "write a PNG of the image with its segments");
  subcommand.add_option("--patch", a->patch, "patch file whose camera removes the lens distortion");
  subcommand.add_option("--image-id", a->image_id,
                        "id of the image in the patch; default: the one with this file");
  subcommand
      .add_option("--window", a->window_px,
                  "part of the image to read: column,row,columns,rows; segments are in its pixels")
      ->delimiter(',')
      ->expected(4);
  add_overwrite_flag(subcommand, a->overwrite);
  add_image_size_option(subcommand, a->max_image_mpx);
  add_preset_option(subcommand, a->parameters.preset);
  add_config_option(subcommand, a->parameters.config);
  return [a] { return run_extract(*a); };
}

}  // namespace ridgeline::apps
