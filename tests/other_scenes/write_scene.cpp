// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/write_scene.h"

#include "io/cloud/las_writer.h"
#include "io/images/image_writer.h"
#include "io/lines/write_lines.h"
#include "io/project/matches_file.h"
#include "io/project/write_patch.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/epipolar.h"
#include "tests/other_scenes/laser.h"
#include "tests/other_scenes/photograph.h"
#include "tests/other_scenes/random_stream.h"
#include "tests/other_scenes/settlement.h"
#include "tests/other_scenes/surface_lines.h"
#include "tests/other_scenes/true_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ridgeline::other {
namespace {

/// Of the local frame in the CRS of the files.
const Eigen::Vector3d kOrigin_m(438000.0, 5612000.0, 212.0);
const char* const kCrs = "EPSG:25832";

std::string image_file(const AerialCamera& camera) { return camera.id + ".tif"; }

bool is_roof_kind(const std::string& kind) {
  return kind == "ridge" || kind == "hip" || kind == "valley" || kind == "eave" || kind == "verge";
}

/// Roof lines too short to be asked for are called fittings.
std::string reference_kind(const Edge& edge) {
  constexpr double kMinRoofEdgeLength_m = 1.5;
  return is_roof_kind(edge.kind) && length(edge.segment) < kMinRoofEdgeLength_m ? "fitting"
                                                                                : edge.kind;
}

/// What the first two images show; an edge has the number of its true line.
void write_matches(const std::string& path, const std::vector<TrueEdge>& edges) {
  std::vector<ReferenceEdge> rows;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!edges[i].base_px) continue;
    const auto& [left, right] = *edges[i].base_px;
    rows.push_back({left, right, false, std::to_string(i), edges[i].edge.kind});
  }
  io::write_reference_edges(path, rows);
}

/// Shares of an edge that the two images show that show most of it, in the order of the images.
std::array<double, 2> largest_shares(const TrueEdge& edge) {
  std::vector<double> shares = edge.visible;
  while (shares.size() > 2) shares.erase(std::min_element(shares.begin(), shares.end()));
  return {shares[0], shares[1]};
}

double largest_epipolar_angle_deg(const TrueEdge& edge, const std::vector<AerialCamera>& cameras) {
  std::vector<ProjectionMatrix> image_from_local;
  for (const std::size_t view : edge.views) {
    image_from_local.push_back(cameras[view].image_from_world(Eigen::Vector3d::Zero()));
  }
  return epipolar_angle_rad(image_from_local, edge.edge.segment) * 180.0 / M_PI;
}

/// What depends on which images show a line: for a pair all are the same.
void add_views(const TrueEdge& edge, const std::vector<AerialCamera>& cameras, io::Line& line) {
  const double angle_deg = largest_epipolar_angle_deg(edge, cameras);
  line.line_class = angle_deg <= kMaxAlignedAngle_deg ? "aligned" : "not_aligned";
  line.n_images = static_cast<int>(edge.views.size());
}

/// Edges of hard scenes are called by the surfaces that they lie on.
std::string kind_by_surfaces(const Scene& scene, const Edge& edge) {
  const auto line = with_surfaces(scene, edge);
  return line ? reference_kind({edge.segment, line->kind}) : reference_kind(edge);
}

void write_lidar(const std::string& path,
                 const Scene& scene,
                 const RayTracer& tracer,
                 std::uint64_t seed) {
  constexpr double kDensity_per_m2 = 5.0;
  std::vector<io::CloudPoint> points;
  for (const Eigen::Vector3d& x : laser_points(scene, tracer, seed, kDensity_per_m2)) {
    points.push_back(io::single_return(x));
  }
  LocalFrame frame;
  frame.origin_m = kOrigin_m;
  io::write_las(path, points, frame, {kCrs});
}

void write_truth(const std::string& path,
                 const std::vector<TrueEdge>& edges,
                 const std::vector<AerialCamera>& cameras,
                 const Scene* named_by) {
  io::LineSet set;
  set.crs = {kCrs};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Segment3& segment = edges[i].edge.segment;
    io::Line line;
    line.id = std::to_string(i);
    line.segment_in_world = {segment.start + kOrigin_m, segment.end + kOrigin_m};
    line.kind = named_by != nullptr ? kind_by_surfaces(*named_by, edges[i].edge)
                                    : reference_kind(edges[i].edge);
    const auto [left, right] = largest_shares(edges[i]);
    line.visible_base = left;
    line.visible_other = right;
    if (cameras.size() > 2) add_views(edges[i], cameras, line);
    set.lines.push_back(std::move(line));
  }
  io::write_lines(path, set, io::LineFormat::kGeoJson);
}

void write_patch_file(const std::string& folder,
                      std::uint64_t seed,
                      const std::vector<AerialCamera>& cameras,
                      bool has_lidar) {
  constexpr double kBelow_m = 12.0, kAbove_m = 28.0;
  io::PatchFile patch;
  patch.id = "other" + std::to_string(seed);
  patch.crs = {kCrs};
  patch.height_range_m = {kOrigin_m.z() - kBelow_m, kOrigin_m.z() + kAbove_m};
  for (const AerialCamera& camera : cameras) {
    patch.images.push_back({.id = camera.id,
                            .path = image_file(camera),
                            .image_from_world = camera.image_from_world(kOrigin_m),
                            .window_px = Eigen::Vector2d::Zero(),
                            .interior = std::nullopt});
  }
  if (has_lidar) patch.lidar = {"lidar.las"};
  patch.reference_matches = "matches.csv";
  patch.reference_lines = "truth.geojson";
  io::write_patch(folder + "/patch.yaml", patch);
}

/// Exposures of one flight: brightness, contrast and sharpness differ a little.
Film random_film(RandomStream& random) {
  return {.gain = random.uniform(0.85, 1.15),
          .offset = random.uniform(0.0, 0.012),
          .gamma = random.uniform(0.42, 0.52),
          .blur_sigma_px = random.uniform(0.5, 0.7),
          .read_noise = random.uniform(0.0015, 0.003),
          .photon_noise = random.uniform(0.006, 0.014),
          .seed = random.bits()};
}

void check_degradation(const Degradation& d, const std::vector<AerialCamera>& cameras) {
  check(d.blur_px >= 0.0 && d.blur_px <= 20.0, "blur_px = ", d.blur_px, ", must be in [0, 20]");
  check(d.jpeg_quality >= 0 && d.jpeg_quality <= 100, "jpeg_quality = ", d.jpeg_quality,
        ", must be in [0, 100]");
  std::string ids;
  for (const AerialCamera& camera : cameras) ids += (ids.empty() ? "" : ", ") + camera.id;
  for (const std::string& view : d.views) {
    check(std::ranges::count(cameras, view, &AerialCamera::id) == 1, "degraded view = ", view,
          ", must be one of ", ids);
  }
}

/// The film with the degradation, if that is for the view.
Film degraded(Film film, const Degradation& d, const std::string& view) {
  if (!d.views.empty() && std::ranges::count(d.views, view) == 0) return film;
  film.blur_sigma_px = std::hypot(film.blur_sigma_px, d.blur_px);
  film.bayer = d.bayer;
  film.jpeg_quality = d.jpeg_quality;
  return film;
}

}  // namespace

Eigen::Vector3d scene_origin_m() { return kOrigin_m; }

void write_scene(const std::string& folder,
                 std::uint64_t seed,
                 const FlightPlan& plan,
                 bool is_hard,
                 const Degradation& degradation) {
  const Scene scene = make_settlement(seed, is_hard);
  const RayTracer tracer(scene);
  const std::vector<AerialCamera> cameras = cameras_for(scene, seed, plan);
  check_degradation(degradation, cameras);
  RandomStream random(seed + 2000U);
  for (const AerialCamera& camera : cameras) {
    const Film film = degraded(random_film(random), degradation, camera.id);
    const cv::Mat image = expose(light(scene, tracer, camera), film);
    io::write_tiff(folder + "/" + image_file(camera), image);
  }
  std::vector<Edge> edges = scene.edges;
  for (Edge& edge : shadow_edges(scene, tracer)) edges.push_back(std::move(edge));
  const std::vector<TrueEdge> truth = true_edges(scene, tracer, cameras, edges);
  write_matches(folder + "/matches.csv", truth);
  write_truth(folder + "/truth.geojson", truth, cameras, is_hard ? &scene : nullptr);
  if (is_hard) write_lidar(folder + "/lidar.las", scene, tracer, seed);
  write_patch_file(folder, seed, cameras, is_hard);
}

}  // namespace ridgeline::other
