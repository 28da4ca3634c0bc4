// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/plan_block.h"

#include "apps/block/block_heights.h"
#include "apps/block/estimate.h"
#include "apps/pipeline/area_views.h"
#include "apps/pipeline/check_patch.h"
#include "apps/pipeline/image_points.h"
#include "apps/pipeline/patch_scene.h"
#include "io/error.h"
#include "io/gdal/surface_heights.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/plan_box.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/scene/normalised_image.h"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace ridgeline::apps {
namespace {

using reconstruct::GridCell;
using reconstruct::PatchGrid;

/// The points where the rays through the corners of a frame meet a height; empty if one of them
/// points above the horizon.
std::vector<Eigen::Vector2d> footprint(const io::PatchImage& image, double height_m) {
  const Eigen::Vector2i size_px =
      image.interior && image.interior->size_px
          ? *image.interior->size_px
          : Eigen::Vector2i(image.facts.value().width_px, image.facts.value().height_px);
  const Eigen::Matrix3d inverse = image.image_from_world.leftCols<3>().inverse();
  const Eigen::Vector3d centre = projection_centre(image.image_from_world).hnormalized();
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector2d& px :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(size_px.x(), 0),
        Eigen::Vector2d(size_px.cast<double>()), Eigen::Vector2d(0, size_px.y())}) {
    const Eigen::Vector3d ray = inverse * px.homogeneous();
    if (ray.z() == 0.0 || (height_m - centre.z()) / ray.z() < 0.0) return {};
    corners.push_back((centre + (height_m - centre.z()) / ray.z() * ray).head<2>());
  }
  return corners;
}

/// The heights stated by the block, else 0.
std::array<double, 2> stated_heights_m(const io::BlockFile& block) {
  return block.height_range_m.value_or(std::array{0.0, 0.0});
}

/// The box to be divided into squares: that of the area, else of the LIDAR from which the heights
/// are derived, else of the ground shown in the images.
Eigen::AlignedBox2d extent_of(const io::BlockFile& block, const BlockHeights& heights) {
  if (!block.area_m.empty()) return box_around(block.area_m);
  if (!heights.extent_m().isEmpty()) return heights.extent_m();
  Eigen::AlignedBox2d extent;
  const auto [low_m, high_m] = stated_heights_m(block);
  for (const io::PatchImage& image : block.images) {
    for (const Eigen::Vector2d& x : footprint(image, 0.5 * (low_m + high_m))) extent.extend(x);
  }
  return extent;
}

/// The squares of the extent that intersect the area, in order.
std::vector<GridCell> squares_of(const PatchGrid& grid,
                                 const Eigen::AlignedBox2d& extent,
                                 const std::vector<Eigen::Vector2d>& area) {
  constexpr std::int64_t kMaxSquares = 1'000'000;
  const GridCell first = grid.cell_of(extent.min());
  const GridCell last = grid.cell_of(extent.max());
  check((last.column - first.column + 1) * (last.row - first.row + 1) <= kMaxSquares,
        "patch_size_m = ", grid.size_m(), " divides the block into more than ", kMaxSquares,
        " squares");
  std::vector<GridCell> squares;
  for (std::int64_t column = first.column; column <= last.column; ++column) {
    for (std::int64_t row = first.row; row <= last.row; ++row) {
      const Eigen::AlignedBox2d core = grid.square({column, row}).intersection(extent);
      if ((core.sizes().array() <= 0.0).any()) continue;
      if (meets(area, core)) squares.push_back({column, row});
    }
  }
  return squares;
}

/// A square of the block and what is known about it.
struct Square {
  PlannedPatch plan;
  bool has_heights = true;  ///< of its own, otherwise those of the whole block
  bool has_views = true;    ///< at least two; the plan is incomplete without
};

Square planned(const io::BlockFile& block,
               const PatchGrid& grid,
               const GridCell& cell,
               const Eigen::AlignedBox2d& extent,
               const BlockHeights& heights) {
  Square square;
  PlannedPatch& plan = square.plan;
  plan.cell = cell;
  plan.id = fmt::format("{}_{}", cell.column, cell.row);
  plan.core_m = grid.square(cell).intersection(extent);
  plan.area_m = grown(plan.core_m, block.overlap_m);
  const std::optional<std::array<double, 2>> own_m = heights.range_m(plan.area_m);
  square.has_heights = own_m.has_value();
  plan.height_range_m = own_m.value_or(heights.whole_range_m());
  const SearchedPlace place{corners_of(plan.area_m), plan.height_range_m};
  const std::vector<io::PatchImage> images =
      best_images(block.images, block.max_views.value(), place);
  square.has_views = images.size() >= 2;
  if (!square.has_views) return square;
  plan.images = transformed(images, &io::PatchImage::id);
  for (const io::PatchImage& image : images) {
    const Eigen::Vector2i size_px(image.interior.value().size_px.value());
    if (const auto window = window_of_area(place, image, size_px))
      plan.windows_mpx += 1e-6 * window->width * window->height;
  }
  const TaskEstimate estimated = estimate_of_patch(plan.windows_mpx);
  plan.estimated_s = estimated.seconds;
  plan.estimated_mib = estimated.memory_mib;
  return square;
}

/// The values of a whole frame that map to 0 and 1, by band; empty for a uniformly grey frame.
std::vector<std::array<double, 2>> radiometry_of(const std::string& path) {
  const io::Picture picture = io::read_picture(path, {.window = io::Window{0, 0, 2, 2}});
  reconstruct::BandRanges ranges = reconstruct::band_ranges(picture.sample);
  const bool all_rise = std::ranges::all_of(ranges, [](const auto& r) { return r[0] < r[1]; });
  return all_rise ? ranges : reconstruct::BandRanges{};
}

std::vector<PlannedFrame> frames_of(const io::BlockFile& block,
                                    const std::vector<PlannedPatch>& patches) {
  std::set<std::string> used;
  for (const PlannedPatch& patch : patches) used.insert(patch.images.begin(), patch.images.end());
  std::vector<PlannedFrame> frames;
  for (const io::PatchImage& image : block.images) {
    if (used.contains(image.id)) frames.push_back({{"image", image.path, 0, 0, ""}, image.id, {}});
  }
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    frames[i].file = state_of("image", frames[i].file.path, true);
    frames[i].radiometry = radiometry_of(frames[i].file.path);
  });
  return frames;
}

/// "3 of 25 squares (4_5, 4_6, 5_5)"; empty if none meets the condition.
std::string named(const std::vector<Square>& squares, bool Square::*is_fine) {
  constexpr std::size_t kNamed = 10;
  std::vector<std::string> ids;
  for (const Square& square : squares) {
    if (!(square.*is_fine)) ids.push_back(square.plan.id);
  }
  if (ids.empty()) return "";
  const std::size_t n = ids.size();
  ids.resize(std::min(n, kNamed));
  return fmt::format("{} of {} squares ({}{})", n, squares.size(), fmt::join(ids, ", "),
                     n > kNamed ? ", ..." : "");
}

/// Warnings about squares without heights, and about those left out of the area that the block
/// states.
std::vector<std::string> warnings_of(const io::BlockFile& block,
                                     const BlockHeights& heights,
                                     const std::vector<Square>& squares) {
  std::vector<std::string> warnings;
  if (heights.warning()) warnings.push_back(*heights.warning());
  if (const std::string names = named(squares, &Square::has_heights); !names.empty()) {
    const auto& [low_m, high_m] = heights.whole_range_m();
    warnings.push_back(fmt::format(
        "{}: {} have no heights and are searched at those of the whole block, {:.1f} to {:.1f} m",
        block.path, names, low_m, high_m));
  }
  if (const std::string names = named(squares, &Square::has_views);
      !names.empty() && !block.area_m.empty()) {
    warnings.push_back(
        fmt::format("{}: {} of the area are shown by fewer than two images and are left out",
                    block.path, names));
  }
  return warnings;
}

std::vector<std::string> warnings_of(const io::BlockFile& block) {
  std::vector<std::string> warnings = block.warnings;
  if (const std::size_t n = block.without_file.size(); n > 0) {
    warnings.push_back(fmt::format("{}: {} images of the orientation have no file; the first is {}",
                                   block.path, n, block.without_file.front().id));
  }
  return warnings;
}

/// Reads the sizes of the frames, which are needed before their windows are known. Throws IoError
/// for a file that does not fit its camera.
void read_sizes(io::BlockFile& block) {
  auto& images = block.images;
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
    images[i].facts = io::image_facts(images[i].path);
    if (!images[i].interior || images[i].interior->size_px) return;
    images[i].interior->size_px =
        Eigen::Vector2i(images[i].facts->width_px, images[i].facts->height_px);
  });
}

}  // namespace

/// Makes paths absolute, because they are written to patch files in other folders.
io::BlockFile read_block(const std::string& path) {
  const std::string absolute = std::filesystem::absolute(path).lexically_normal().string();
  io::BlockFile block = io::read_block_file(absolute, find_points_in_files);
  check_positions(block);
  read_sizes(block);
  return block;
}

std::vector<FileState> planned_inputs(const io::BlockFile& block) {
  std::vector<results::InputFile> inputs = input_files(block);
  std::erase_if(inputs, [](const auto& input) { return input.role == "image"; });
  if (block.surface_model) {
    for (const std::string& file : io::files_beside_surface_model(*block.surface_model))
      inputs.push_back({"surface_model", file});
  }
  return transformed(inputs, [](const results::InputFile& input) {
    const bool is_small = input.role != "cloud" && input.role != "surface_model";
    return state_of(input.role == "patch" ? "block" : input.role, input.path, is_small);
  });
}

std::string key_of_plan(const io::BlockFile& block,
                        const std::vector<FileState>& inputs,
                        double max_image_mpx) {
  const int source = block.height_range_m ? 0 : block.surface_model ? 2 : 1;
  std::vector<std::string> parts{
      block.crs.definition,
      fmt::format("{} {} {} {} {} {}", max_image_mpx, block.max_views.value(), block.patch_size_m,
                  block.overlap_m, source, fmt::join(stated_heights_m(block), " "))};
  for (const Eigen::Vector2d& corner : block.area_m)
    parts.push_back(fmt::format("{} {}", corner.x(), corner.y()));
  for (const io::PatchImage& image : block.images) parts.push_back(key_of_view(image, image.path));
  for (const FileState& file : inputs) {
    if (file.role == "cloud" || file.role == "surface_model")
      parts.push_back(fmt::format("{} {} {}", file.path, file.bytes, file.modified_ns));
  }
  return key_of(parts);
}

BlockPlan plan_block(const io::BlockFile& block, double max_image_mpx) {
  BlockPlan plan;
  plan.block = block.id;
  plan.block_file = block.path;
  plan.crs = block.crs.definition;
  plan.patch_size_m = block.patch_size_m;
  plan.overlap_m = block.overlap_m;
  plan.area_m = block.area_m;
  plan.inputs = planned_inputs(block);
  plan.key = key_of_plan(block, plan.inputs, max_image_mpx);
  plan.warnings = warnings_of(block);
  const BlockHeights heights(block);
  const Eigen::AlignedBox2d extent = extent_of(block, heights);
  if (extent.isEmpty()) throw io::IoError(block.path, "no image shows the ground");
  plan.extent_m = extent;
  const PatchGrid grid = grid_of(plan);
  const std::vector<GridCell> cells = squares_of(grid, extent, block.area_m);
  std::vector<Square> squares(cells.size());
  tbb::parallel_for(std::size_t{0}, squares.size(), [&](std::size_t i) {
    squares[i] = planned(block, grid, cells[i], extent, heights);
  });
  std::ranges::move(warnings_of(block, heights, squares), std::back_inserter(plan.warnings));
  for (Square& square : squares) {
    if (square.has_views) {
      plan.patches.push_back(std::move(square.plan));
    } else {
      ++plan.n_without_views;
    }
  }
  if (plan.patches.empty()) {
    throw io::IoError(
        block.path,
        fmt::format("none of the {} images overlap in any of the {} squares of {} m of the area",
                    block.images.size(), squares.size(), grid.size_m()));
  }
  plan.frames = frames_of(block, plan.patches);
  return plan;
}

io::PatchFile patch_of(const io::BlockFile& block,
                       const BlockPlan& plan,
                       const PlannedPatch& planned) {
  io::PatchFile patch;
  patch.path = block.path;
  patch.id = planned.id;
  patch.crs = block.crs;
  patch.area_m = corners_of(planned.area_m);
  patch.height_range_m = planned.height_range_m;
  for (const std::string& id : planned.images) {
    const auto image = std::ranges::find(block.images, id, &io::PatchImage::id);
    const auto frame = std::ranges::find(plan.frames, id, &PlannedFrame::id);
    check(image != block.images.end() && frame != plan.frames.end(), "image ", id,
          ", is no longer in the block");
    patch.images.push_back(*image);
    patch.images.back().radiometry = frame->radiometry;
  }
  return patch;
}

}  // namespace ridgeline::apps
