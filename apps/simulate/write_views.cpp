// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/write_views.h"

#include "apps/simulate/edge_tracks.h"
#include "apps/simulate/fittings.h"
#include "apps/simulate/photograph.h"
#include "apps/simulate/planned_views.h"
#include "apps/simulate/reference_matches.h"
#include "apps/simulate/write_orientation.h"
#include "io/project/matches_file.h"
#include "io/project/write_patch.h"
#include "reconstruct/geometry/plan_box.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <span>
#include <utility>

namespace ridgeline::apps {
namespace {

constexpr const char* kMatchesFile = "matches.csv";
constexpr const char* kTracksFile = "tracks.csv";
constexpr const char* kPatchFile = "patch.yaml";

/// Two views have matches only.
bool have_tracks(std::size_t num_views) { return num_views > 2; }

/// Writes the image of a view and returns the part that shows the village.
simulate::ImageWindow write_image(const simulate::SyntheticScene& scene,
                                  const simulate::AerialView& view,
                                  const ViewOptions& options,
                                  const results::OutputFolder& out) {
  ViewFile file(out.path(image_file(view.id)), view, options);
  simulate::ImageWindow village = simulate::photograph(
      simulate::Renderer(scene, light_of(options, view)), view, sensor_of(options, view),
      [&](const cv::Mat& rows) { file.write_rows(rows); });
  file.commit();
  return village;
}

io::PatchKeys patch_keys(const std::string& orientation) {
  if (orientation.empty()) return {};
  const simulate::OrientationFiles files = simulate::orientation_files(orientation);
  return {.orientation = files.orientation, .cameras = files.cameras, .matrix = files.matrix};
}

void write_patch_file(const simulate::SyntheticScene& scene,
                      const std::string& patch_id,
                      std::span<const simulate::AerialView> views,
                      const ViewOptions& options,
                      const results::OutputFolder& out) {
  io::PatchFile patch;
  patch.id = patch_id;
  patch.crs = scene.crs;
  patch.height_range_m = simulate::height_range_m(scene);
  if (options.flight.frame_px) {
    const auto [x_min, y_min, x_max, y_max] = area_m(scene, options.flight.margin_m);
    patch.area_m = corners_of({Eigen::Vector2d(x_min, y_min), Eigen::Vector2d(x_max, y_max)});
  }
  for (const simulate::AerialView& view : views) {
    io::PatchImage& image = patch.images.emplace_back();
    image.id = view.id;
    image.path = image_file(view.id);
    image.image_from_world = view.image_from_world;
  }
  patch.lidar = {"lidar.las"};
  patch.reference_matches = kMatchesFile;
  if (have_tracks(views.size())) patch.reference_tracks = kTracksFile;
  patch.reference_lines = "truth.geojson";
  io::write_patch(out.path(kPatchFile), patch, patch_keys(options.orientation));
}

void write_true_edges(std::span<const simulate::ShownEdge> edges,
                      std::span<const simulate::AerialView> views,
                      const results::OutputFolder& out) {
  io::write_reference_edges(out.path(kMatchesFile), simulate::reference_matches(edges));
  if (!have_tracks(views.size())) return;
  out.write(kTracksFile, simulate::tracks_csv(simulate::edge_tracks(edges), views));
}

io::LineSet seen_by_views(const simulate::SyntheticScene& scene,
                          const simulate::SurfaceOracle& oracle,
                          std::span<const simulate::AerialView> views,
                          io::LineSet truth) {
  std::vector<ProjectionMatrix> cameras;
  for (const simulate::AerialView& view : views) cameras.push_back(view.image_from_world);
  truth = simulate::classed_by_views(std::move(truth), cameras);
  const std::vector<std::vector<double>> shares = simulate::visible_shares(scene, oracle);
  for (std::size_t i = 0; i < truth.lines.size(); ++i) {
    constexpr double kHalf = 0.5;
    truth.lines[i].visible_base = shares[i][0];
    truth.lines[i].visible_other = shares[i][1];
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
  std::ranges::move(simulate::orientation_files(options.orientation).files,
                    std::back_inserter(names));
  return names;
}

io::LineSet write_views(const simulate::SyntheticScene& bare_scene,
                        const std::string& patch_id,
                        const ViewOptions& options,
                        io::LineSet truth,
                        const results::OutputFolder& out) {
  simulate::SyntheticScene scene = bare_scene;
  simulate::add_fittings(scene, options.render.seed);
  const std::vector<simulate::AerialView> views = simulate::aerial_views(scene, options.flight);
  if (!options.orientation.empty()) {
    simulate::write_orientation(std::filesystem::path(out.path(kPatchFile)).parent_path().string(),
                                options.orientation,
                                orientation_of(scene, views, options.flight.frame_px.has_value()));
  }
  const simulate::SurfaceOracle oracle(scene, views);
  std::vector<simulate::ShownEdge> edges = simulate::shown_edges(scene, oracle);
  for (std::size_t i = 0; i < views.size(); ++i) {
    simulate::measure_contrast(i, write_image(scene, views[i], options, out), edges);
  }
  write_true_edges(edges, views, out);
  write_patch_file(scene, patch_id, views, options, out);
  return seen_by_views(scene, oracle, views, std::move(truth));
}

}  // namespace ridgeline::apps
