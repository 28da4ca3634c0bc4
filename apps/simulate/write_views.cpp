// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/write_views.h"

#include "apps/simulate/edge_tracks.h"
#include "apps/simulate/fittings.h"
#include "apps/simulate/planned_views.h"
#include "apps/simulate/reference_matches.h"
#include "io/images/image_writer.h"
#include "io/project/matches_file.h"
#include "io/project/write_patch.h"

#include <algorithm>
#include <cmath>
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

cv::Mat photograph(const simulate::Scene& scene,
                   const simulate::AerialView& view,
                   const ViewOptions& options) {
  constexpr double kTurnDeg = 360.0;
  simulate::RenderOptions render = options.render;
  const auto steps = static_cast<double>(view.number);
  render.sun_azimuth_deg =
      std::fmod(render.sun_azimuth_deg + steps * options.flight.sun_step_deg, kTurnDeg);
  return simulate::expose(simulate::Renderer(scene, render).radiance(view), options.sensor,
                          view.number);
}

void write_patch_file(const simulate::Scene& scene,
                      const std::string& patch_id,
                      std::span<const simulate::AerialView> views,
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
  io::write_patch(out.path(kPatchFile), patch);
}

void write_true_edges(const simulate::Scene& scene,
                      const simulate::SurfaceOracle& oracle,
                      std::span<const simulate::AerialView> views,
                      std::span<const cv::Mat> images,
                      const results::OutputFolder& out) {
  const std::vector<simulate::ShownEdge> edges = simulate::shown_edges(scene, oracle);
  io::write_reference_edges(out.path(kMatchesFile), simulate::reference_matches(edges, images));
  if (!have_tracks(views.size())) return;
  out.write(kTracksFile, simulate::tracks_csv(simulate::edge_tracks(edges, images), views));
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

std::vector<std::string> view_file_names(const simulate::FlightOptions& flight) {
  std::vector<std::string> names{kMatchesFile, kPatchFile};
  const std::vector<simulate::PlannedView> views = simulate::planned_views(flight);
  for (const simulate::PlannedView& view : views) names.push_back(image_file(view.id));
  if (have_tracks(views.size())) names.emplace_back(kTracksFile);
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
  std::vector<cv::Mat> images;
  for (const simulate::AerialView& view : views) {
    images.push_back(photograph(scene, view, options));
    io::write_tiff(out.path(image_file(view.id)), images.back());
  }
  const simulate::SurfaceOracle oracle(scene, views);
  write_true_edges(scene, oracle, views, images, out);
  write_patch_file(scene, patch_id, views, out);
  return seen_by_views(scene, oracle, views, std::move(truth));
}

}  // namespace ridgeline::apps
