// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/write_block.h"

#include "apps/common/progress.h"
#include "apps/simulate/fittings.h"
#include "apps/simulate/photograph.h"
#include "apps/simulate/write_orientation.h"
#include "io/cloud/las_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>

namespace ridgeline::apps {
namespace {

constexpr const char* kBlockFile = "block.yaml";

std::string frame_file(const simulate::AerialView& frame) {
  return "frames/" + image_file(frame.id);
}

/// A square of the plan (local) and its file, which is named after the square's corner in world
/// coordinates.
struct Tile {
  std::string file;
  Eigen::AlignedBox2d window_m;
};

/// The tiles in rows from the south-west. They are disjoint: the next begins where one ends.
std::vector<Tile> tiles_of(const simulate::SyntheticScene& scene, int side_m) {
  std::vector<Tile> tiles;
  const auto end_m = [&](int from_m, double extent_m) {
    const double next_m = from_m + side_m;
    return next_m < extent_m ? std::nextafter(next_m, 0.0) : extent_m;
  };
  for (int y = 0; y < scene.extent_m.y(); y += side_m) {
    for (int x = 0; x < scene.extent_m.x(); x += side_m) {
      const Eigen::Vector2d corner = scene.frame.origin_m.head<2>() + Eigen::Vector2d(x, y);
      tiles.push_back({fmt::format("tiles/{:.0f}_{:.0f}.las", corner.x(), corner.y()),
                       {Eigen::Vector2d(x, y), Eigen::Vector2d(end_m(x, scene.extent_m.x()),
                                                               end_m(y, scene.extent_m.y()))}});
    }
  }
  return tiles;
}

std::size_t write_tiles(const simulate::SyntheticScene& scene,
                        const SimulateArguments& a,
                        Progress& progress,
                        const results::OutputFolder& out) {
  const simulate::AlsScanner scanner(scene, a.als);
  std::size_t num_points = 0;
  for (const Tile& tile : tiles_of(scene, a.tile_m)) {
    progress.begin(tile.file);
    const io::PointCloud cloud = scanner.scan(tile.window_m);
    io::write_las(out.path(tile.file), cloud.points, cloud.frame, scene.crs);
    num_points += cloud.points.size();
  }
  return num_points;
}

void write_frames(const simulate::SyntheticScene& scene,
                  std::span<const simulate::AerialView> frames,
                  const ViewOptions& options,
                  Progress& progress,
                  const results::OutputFolder& out) {
  std::optional<simulate::Renderer> renderer;
  for (const simulate::AerialView& frame : frames) {
    progress.begin(frame_file(frame));
    // if the sun does not move, one renderer serves all frames
    if (!renderer || options.flight.sun_step_deg != 0.0) {
      renderer.emplace(scene, light_of(options, frame));
    }
    ViewFile file(out.path(frame_file(frame)), frame, options);
    simulate::photograph_rows(*renderer, frame, sensor_of(options, frame),
                              [&](const cv::Mat& rows, int) { file.write_rows(rows); });
    file.commit();
  }
}

std::string block_text(const simulate::SyntheticScene& scene,
                       const std::string& block_id,
                       const SimulateArguments& a) {
  const simulate::OrientationFiles files = simulate::orientation_files(a.views.orientation);
  std::string text;
  const auto add = [&](const char* key, const std::string& value) {
    if (!value.empty()) text += fmt::format("{}: {}\n", key, value);
  };
  // any JSON string is also a valid YAML string
  add("block", nlohmann::json(block_id).dump());
  add("crs", nlohmann::json(scene.crs.definition).dump());
  add("orientation", files.orientation);
  add("cameras", files.cameras);
  add("matrix", files.matrix);
  add("images", "frames/*.tif");
  add("lidar", "[tiles/*.las]");
  add("height_range", "auto");
  add("area", fmt::format("[{}]", fmt::join(area_m(scene, a.views.flight.margin_m), ", ")));
  add("patch_size_m", "60");
  add("reference_lines", "truth.geojson");
  return text;
}

}  // namespace

std::vector<simulate::AerialView> block_frames(const simulate::SyntheticScene& scene,
                                               const SimulateArguments& a) {
  const simulate::FlightOptions& flight = a.views.flight;
  std::vector<simulate::AerialView> frames =
      simulate::aerial_views(scene, flight, simulate::block_views(a.block, flight, scene));
  const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(std::max(0.0, flight.margin_m));
  simulate::check_shown_twice(scene, frames, {-margin_m, scene.extent_m + margin_m});
  return frames;
}

std::vector<std::string> block_file_names(const simulate::SyntheticScene& scene,
                                          std::span<const simulate::AerialView> frames,
                                          const SimulateArguments& a) {
  std::vector<std::string> names{kBlockFile};
  for (const simulate::AerialView& frame : frames) names.push_back(frame_file(frame));
  for (const Tile& tile : tiles_of(scene, a.tile_m)) names.push_back(tile.file);
  std::ranges::move(simulate::orientation_files(a.views.orientation).files,
                    std::back_inserter(names));
  return names;
}

std::size_t write_block(const simulate::SyntheticScene& bare_scene,
                        std::span<const simulate::AerialView> frames,
                        const std::string& block_id,
                        const SimulateArguments& a,
                        const results::OutputFolder& out) {
  Progress progress(tiles_of(bare_scene, a.tile_m).size() + frames.size());
  const std::size_t num_points = write_tiles(bare_scene, a, progress, out);
  constexpr bool kAreFrames = true;
  simulate::write_orientation(std::filesystem::path(out.path(kBlockFile)).parent_path().string(),
                              a.views.orientation, orientation_of(bare_scene, frames, kAreFrames));
  simulate::SyntheticScene scene = bare_scene;
  simulate::add_fittings(scene, a.views.render.seed);
  write_frames(scene, frames, a.views, progress, out);
  out.write(kBlockFile, block_text(scene, block_id, a));
  return num_points;
}

}  // namespace ridgeline::apps
