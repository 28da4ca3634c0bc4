// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/write_stereo.h"

#include "apps/simulate/aerial_pair.h"
#include "apps/simulate/fittings.h"
#include "apps/simulate/reference_matches.h"
#include "io/images/image_writer.h"
#include "io/project/write_patch.h"

#include <array>

namespace ridgeline::apps {
namespace {

constexpr std::array kImageIds{"left", "right"};

std::string image_file(std::size_t i) { return std::string(kImageIds[i]) + ".tif"; }

void write_patch_file(const simulate::Scene& scene,
                      const std::string& patch_id,
                      const std::array<simulate::AerialView, 2>& views,
                      const results::OutputFolder& out) {
  io::PatchFile patch;
  patch.id = patch_id;
  patch.crs = scene.crs;
  patch.height_range_m = simulate::height_range_m(scene);
  for (std::size_t i = 0; i < views.size(); ++i) {
    io::PatchImage image;
    image.id = kImageIds[i];
    image.path = image_file(i);
    image.image_from_world = views[i].image_from_world;
    patch.images.push_back(std::move(image));
  }
  patch.lidar = {"lidar.las"};
  patch.reference_matches = "matches.csv";
  patch.reference_lines = "truth.geojson";
  io::write_patch(out.path("patch.yaml"), patch);
}

}  // namespace

io::LineSet write_stereo(const simulate::Scene& bare_scene,
                         const std::string& patch_id,
                         const StereoOptions& options,
                         io::LineSet truth,
                         const results::OutputFolder& out) {
  simulate::Scene scene = bare_scene;
  simulate::add_fittings(scene, options.render.seed);
  const std::array<simulate::AerialView, 2> views = simulate::aerial_pair(scene, options.flight);
  const simulate::Renderer renderer(scene, options.render);
  std::array<cv::Mat, 2> images;
  for (std::size_t i = 0; i < views.size(); ++i) {
    images[i] = simulate::expose(renderer.radiance(views[i]), options.sensor, i);
    io::write_tiff(out.path(image_file(i)), images[i]);
  }
  const simulate::SurfaceOracle oracle(scene, views);
  out.write("matches.csv",
            simulate::reference_csv(simulate::reference_matches(scene, oracle, images)));
  write_patch_file(scene, patch_id, views, out);

  truth = simulate::classed_by_pair(std::move(truth),
                                    {views[0].image_from_world, views[1].image_from_world});
  const auto shares = simulate::visible_shares(scene, oracle);
  for (std::size_t i = 0; i < truth.lines.size(); ++i) {
    truth.lines[i].visible_left = shares[i][simulate::SurfaceOracle::kLeft];
    truth.lines[i].visible_right = shares[i][simulate::SurfaceOracle::kRight];
  }
  return truth;
}

}  // namespace ridgeline::apps
