// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/write_scene.h"

#include "io/images/image_writer.h"
#include "io/lines/write_lines.h"
#include "io/project/matches_file.h"
#include "io/project/write_patch.h"
#include "tests/other_scenes/photograph.h"
#include "tests/other_scenes/random_stream.h"
#include "tests/other_scenes/settlement.h"
#include "tests/other_scenes/true_edges.h"

#include <array>
#include <cmath>
#include <vector>

namespace ridgeline::other {
namespace {

/// Of the local frame in the CRS of the files.
const Eigen::Vector3d kOrigin_m(438000.0, 5612000.0, 212.0);
const char* const kCrs = "EPSG:25832";

bool is_roof_kind(const std::string& kind) {
  return kind == "ridge" || kind == "hip" || kind == "valley" || kind == "eave" || kind == "verge";
}

/// Roof lines too short to be asked for are called fittings.
std::string reference_kind(const Edge& edge) {
  constexpr double kShortest_m = 1.5;
  return is_roof_kind(edge.kind) && length(edge.segment) < kShortest_m ? "fitting" : edge.kind;
}

/// Whether both images show enough of an edge to tell where it is.
bool is_shown(const TrueEdge& edge) {
  constexpr double kShortest_px = 6.0, kLeastShare = 0.25;
  return length(edge.visible_px[0]) >= kShortest_px && length(edge.visible_px[1]) >= kShortest_px &&
         edge.visible[0] >= kLeastShare && edge.visible[1] >= kLeastShare;
}

void write_matches(const std::string& path, const std::vector<TrueEdge>& edges) {
  std::vector<io::ReferenceEdge> rows;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [left, right] = edges[i].visible_px;
    rows.push_back({std::to_string(i), edges[i].edge.kind, left, right, false});
  }
  io::write_reference_edges(path, rows);
}

void write_truth(const std::string& path, const std::vector<TrueEdge>& edges) {
  io::LineSet set;
  set.crs = {kCrs};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Segment3& segment = edges[i].edge.segment;
    io::Line line;
    line.id = std::to_string(i);
    line.segment_in_world = {segment.start + kOrigin_m, segment.end + kOrigin_m};
    line.kind = reference_kind(edges[i].edge);
    line.visible_left = edges[i].visible[0];
    line.visible_right = edges[i].visible[1];
    set.lines.push_back(std::move(line));
  }
  io::write_lines(path, set, io::LineFormat::kGeoJson);
}

void write_patch_file(const std::string& folder,
                      std::uint64_t seed,
                      const std::array<AerialCamera, 2>& cameras) {
  constexpr double kBelow_m = 12.0, kAbove_m = 28.0;
  io::PatchFile patch;
  patch.id = "other" + std::to_string(seed);
  patch.crs = {kCrs};
  patch.height_range_m = {kOrigin_m.z() - kBelow_m, kOrigin_m.z() + kAbove_m};
  for (std::size_t c = 0; c < 2; ++c) {
    const std::string id = c == 0 ? "left" : "right";
    patch.images.push_back({.id = id,
                            .path = id + ".tif",
                            .image_from_world = cameras[c].image_from_world(kOrigin_m),
                            .window_px = Eigen::Vector2d::Zero(),
                            .interior = std::nullopt});
  }
  patch.reference_matches = "matches.csv";
  patch.reference_lines = "truth.geojson";
  io::write_patch(folder + "/patch.yaml", patch);
}

/// Two exposures of one flight: brightness, contrast and sharpness differ a little.
Film random_film(RandomStream& random) {
  return {.gain = random.uniform(0.85, 1.15),
          .offset = random.uniform(0.0, 0.012),
          .gamma = random.uniform(0.42, 0.52),
          .blur_sigma_px = random.uniform(0.5, 0.7),
          .read_noise = random.uniform(0.0015, 0.003),
          .photon_noise = random.uniform(0.006, 0.014),
          .seed = random.bits()};
}

}  // namespace

void write_scene(const std::string& folder, std::uint64_t seed) {
  const Scene scene = make_settlement(seed);
  const RayTracer tracer(scene);
  const std::array<AerialCamera, 2> cameras = cameras_for(scene, seed);
  RandomStream random(seed + 2000U);
  for (std::size_t c = 0; c < 2; ++c) {
    const cv::Mat image = expose(light(scene, tracer, cameras[c]), random_film(random));
    io::write_tiff(folder + (c == 0 ? "/left.tif" : "/right.tif"), image);
  }
  std::vector<Edge> edges = scene.edges;
  for (Edge& edge : shadow_edges(scene, tracer)) edges.push_back(std::move(edge));
  std::vector<TrueEdge> truth = true_edges(scene, tracer, cameras, edges);
  std::erase_if(truth, [](const TrueEdge& edge) { return !is_shown(edge); });
  write_matches(folder + "/matches.csv", truth);
  write_truth(folder + "/truth.geojson", truth);
  write_patch_file(folder, seed, cameras);
}

}  // namespace ridgeline::other
