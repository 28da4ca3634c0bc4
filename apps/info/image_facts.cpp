// SPDX-License-Identifier: BSD-3-Clause
#include "apps/info/image_facts.h"

#include "apps/info/own_files.h"
#include "io/error.h"
#include "io/images/image.h"
#include "reconstruct/extract/beyond/soft_edges/edge_facts.h"
#include "reconstruct/reconstruct.h"
#include "reconstruct/scene/normalised_image.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace ridgeline::apps {
namespace {

/// Prints the values that are mapped to 0 and 1, unless this would require decoding too much.
void print_radiometry(const std::string& path,
                      const io::ImageFacts& facts,
                      InfoWarnings& warnings) {
  constexpr int kSmall_px = 2;
  if (facts.width_px < kSmall_px || facts.height_px < kSmall_px) return;
  const io::Window last{facts.width_px - kSmall_px, facts.height_px - kSmall_px, kSmall_px,
                        kSmall_px};
  try {
    if (const auto slow = io::slow_reading(path, last)) return warnings.add(path, *slow);
    std::vector<std::string> ranges;
    for (const auto& [low, high] :
         reconstruct::band_ranges(io::read_picture(path, {.window = last}).sample))
      ranges.push_back(fmt::format("[{:g}, {:g}]", low, high));
    fmt::print("  radiometry  [{}]\n", fmt::join(ranges, ", "));
  } catch (const io::IoError& error) {
    warnings.add(path, error.what());
  }
}

/// Prints the sharpness at the centre of an image.
void print_edges(const std::string& path, const io::ImageFacts& facts) {
  constexpr int kSide_px = 1024;
  constexpr int kMinSide_px = 64;
  if (std::min(facts.width_px, facts.height_px) < kMinSide_px) return;
  const cv::Size size(std::min(kSide_px, facts.width_px), std::min(kSide_px, facts.height_px));
  const io::Window middle{(facts.width_px - size.width) / 2, (facts.height_px - size.height) / 2,
                          size.width, size.height};
  try {
    if (io::slow_reading(path, middle)) return;
    reconstruct::View view;
    const io::Picture picture = io::read_picture(path, {.window = middle, .samples = false});
    view.image = reconstruct::normalised_image(picture.pixels);
    view.is_valid = picture.is_valid;
    view.corner_px = {middle.column, middle.row};
    view.segments = reconstruct::extract(view);
    const reconstruct::EdgeFacts edges = edge_facts(view);
    fmt::print("  edges       in the central {} x {} px{}\n", size.width, size.height,
               edges.noise ? fmt::format(", noise {:.2g} %", 100.0 * *edges.noise) : "");
    for (const reconstruct::EdgesOfScale& scale : edges.scales)
      fmt::print("              at {} size: {} segment{}, total length {:.0f} px{}\n",
                 scale.scale_px == 1 ? "full" : fmt::format("1/{}", scale.scale_px),
                 scale.n_segments, scale.n_segments == 1 ? "" : "s", scale.length_px,
                 scale.width_px ? fmt::format(", {:.1f} px wide (sigma)", *scale.width_px) : "");
  } catch (const io::IoError&) {  // already reported by print_radiometry()
  }
}

}  // namespace

/// The facts of an image, "970 x 977 px, 3 bands of 8 bit, GTiff", or "missing".
std::string image_text(const std::string& path) {
  if (!std::filesystem::exists(path)) return "missing";
  const io::ImageFacts facts = io::image_facts(path);
  return fmt::format("{} x {} px, {} bands of {} bit, {}", facts.width_px, facts.height_px,
                     facts.n_bands, facts.bits, facts.format);
}

void print_image(const std::string& path, InfoWarnings& warnings) {
  const io::ImageFacts facts = io::image_facts(path);
  fmt::print("{}: {}\n  size        {} x {} px\n  bands       {} of {} bit\n", path, facts.format,
             facts.width_px, facts.height_px, facts.n_bands, facts.bits);
  if (facts.alpha) fmt::print("  mask        transparent pixels (alpha band)\n");
  if (facts.turn != io::ImageTurn::kNone)
    fmt::print("  rotation    EXIF orientation {}\n", static_cast<int>(facts.turn));
  print_radiometry(path, facts, warnings);
  print_edges(path, facts);
  print_use(
      fmt::format("name it under images in a patch file; ridgeline extract {} --out FILE", path));
}

}  // namespace ridgeline::apps
