// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/write_views.h"

#include "apps/simulate/edge_tracks.h"
#include "apps/simulate/fittings.h"
#include "apps/simulate/photograph.h"
#include "apps/simulate/planned_views.h"
#include "apps/simulate/reference_matches.h"
#include "io/images/image_writer.h"
#include "io/orientation/write_orientation.h"
#include "io/project/matches_file.h"
#include "io/project/write_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace ridgeline::apps {
namespace {

constexpr const char* kMatchesFile = "matches.csv";
constexpr const char* kTracksFile = "tracks.csv";
constexpr const char* kPatchFile = "patch.yaml";

std::string image_file(const std::string& id) { return id + ".tif"; }

/// Two views have matches and no more.
bool have_tracks(std::size_t num_views) { return num_views > 2; }

/// Writes the image of a view and returns what it shows of the village.
simulate::ImageWindow write_image(const simulate::Scene& scene,
                                  const simulate::AerialView& view,
                                  const ViewOptions& options,
                                  const results::OutputFolder& out) {
  constexpr double kTurnDeg = 360.0;
  simulate::RenderOptions render = options.render;
  const auto steps = static_cast<double>(view.number);
  render.sun_azimuth_deg =
      std::fmod(render.sun_azimuth_deg + steps * options.flight.sun_step_deg, kTurnDeg);
  const io::TiffLayout layout =
      options.flight.frame_px ? io::TiffLayout::kTiles : io::TiffLayout::kStrips;
  static_assert(simulate::kRowsAtOnce % io::kTile_px == 0);
  std::optional<io::TiffWriter> image;
  simulate::ImageWindow village = simulate::photograph(
      simulate::Renderer(scene, render), view, options.sensor, [&](const cv::Mat& rows) {
        if (!image) {
          image.emplace(out.path(image_file(view.id)), cv::Size(view.size_px.x(), view.size_px.y()),
                        rows.type(), layout);
        }
        image->write_rows(rows);
      });
  image->commit();
  return village;
}

/// Whole frames are of one camera. Other images are of one each, whose principal point is off the middle, and which is
/// named after the image, since PAT-B names no cameras.
io::Orientation orientation_of(const simulate::Scene& scene,
                               std::span<const simulate::AerialView> views,
                               bool are_frames) {
  io::Orientation orientation;
  orientation.crs = scene.crs;
  orientation.ground_height_m =
      scene.frame.origin_m.z() + scene.mean_terrain(Eigen::Vector2d(0.5 * scene.extent_m));
  for (const simulate::AerialView& view : views) {
    if (orientation.cameras.empty() || !are_frames) {
      orientation.cameras.push_back({are_frames ? "frame" : image_file(view.id), view.interior});
    }
    orientation.images.push_back(
        {image_file(view.id), orientation.cameras.size() - 1, view.exterior});
  }
  return orientation;
}

/// What the images show of the plan, on the map.
std::array<double, 4> area_m(const simulate::Scene& scene, double margin_m) {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(margin_m);
  const Eigen::Vector2d origin_m = scene.frame.origin_m.head<2>();
  const Eigen::Vector2d low = origin_m - margin;
  const Eigen::Vector2d high = origin_m + scene.extent_m + margin;
  return {low.x(), low.y(), high.x(), high.y()};
}

io::PatchKeys patch_keys(const simulate::Scene& scene, const ViewOptions& options) {
  io::PatchKeys keys;
  if (options.flight.frame_px) keys.area_m = area_m(scene, options.flight.margin_m);
  if (options.orientation.empty()) return keys;
  const io::OrientationFiles files = io::orientation_files(options.orientation);
  keys.orientation = files.orientation;
  keys.cameras = files.cameras;
  keys.matrix = files.matrix;
  return keys;
}

void write_patch_file(const simulate::Scene& scene,
                      const std::string& patch_id,
                      std::span<const simulate::AerialView> views,
                      const io::PatchKeys& keys,
                      const results::OutputFolder& out) {
  io::PatchFile patch;
  patch.id = patch_id;
  patch.crs = scene.crs;
  patch.height_range_m = simulate::height_range_m(scene);
  for (const simulate::AerialView& view : views) {
    io::PatchImage image;
    image.id = view.id;
    image.path = image_file(view.id);
    image.image_from_world = view.image_from_world;
    patch.images.push_back(std::move(image));
  }
  patch.lidar = {"lidar.las"};
  patch.reference_matches = kMatchesFile;
  if (have_tracks(views.size())) patch.reference_tracks = kTracksFile;
  patch.reference_lines = "truth.geojson";
  io::write_patch(out.path(kPatchFile), patch, keys);
}

void write_true_edges(std::span<const simulate::ShownEdge> edges,
                      std::span<const simulate::AerialView> views,
                      const results::OutputFolder& out) {
  io::write_reference_edges(out.path(kMatchesFile), simulate::reference_matches(edges));
  if (!have_tracks(views.size())) return;
  out.write(kTracksFile, simulate::tracks_csv(simulate::edge_tracks(edges), views));
}

io::LineSet seen_by_views(const simulate::Scene& scene,
                          const simulate::SurfaceOracle& oracle,
                          std::span<const simulate::AerialView> views,
                          io::LineSet truth) {
  std::vector<ProjectionMatrix> cameras;
  for (const simulate::AerialView& view : views) cameras.push_back(view.image_from_world);
  truth = simulate::classed_by_views(std::move(truth), cameras);
  const std::vector<std::vector<double>> shares = simulate::visible_shares(scene, oracle);
  for (std::size_t i = 0; i < truth.lines.size(); ++i) {
    constexpr double kHalf = 0.5;
    truth.lines[i].visible_left = shares[i][0];
    truth.lines[i].visible_right = shares[i][1];
    if (!have_tracks(views.size())) continue;
    truth.lines[i].n_images = static_cast<int>(
        std::ranges::count_if(shares[i], [](double share) { return share >= kHalf; }));
  }
  return truth;
}

}  // namespace

std::vector<std::string> view_file_names(const ViewOptions& options) {
  std::vector<std::string> names{kMatchesFile, kPatchFile};
  const std::vector<simulate::PlannedView> views = simulate::planned_views(options.flight);
  for (const simulate::PlannedView& view : views) names.push_back(image_file(view.id));
  if (have_tracks(views.size())) names.emplace_back(kTracksFile);
  if (options.orientation.empty()) return names;
  std::ranges::move(io::orientation_files(options.orientation).files, std::back_inserter(names));
  return names;
}

io::LineSet write_views(const simulate::Scene& bare_scene,
                        const std::string& patch_id,
                        const ViewOptions& options,
                        io::LineSet truth,
                        const results::OutputFolder& out) {
  simulate::Scene scene = bare_scene;
  simulate::add_fittings(scene, options.render.seed);
  const std::vector<simulate::AerialView> views = simulate::aerial_views(scene, options.flight);
  if (!options.orientation.empty()) {
    io::write_orientation(std::filesystem::path(out.path(kPatchFile)).parent_path().string(),
                          options.orientation,
                          orientation_of(scene, views, options.flight.frame_px.has_value()));
  }
  const simulate::SurfaceOracle oracle(scene, views);
  std::vector<simulate::ShownEdge> edges = simulate::shown_edges(scene, oracle);
  for (std::size_t i = 0; i < views.size(); ++i) {
    simulate::measure_contrast(i, write_image(scene, views[i], options, out), edges);
  }
  write_true_edges(edges, views, out);
  write_patch_file(scene, patch_id, views, patch_keys(scene, options), out);
  return seen_by_views(scene, oracle, views, std::move(truth));
}

}  // namespace ridgeline::apps
