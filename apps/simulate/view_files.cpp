// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/view_files.h"

#include "apps/simulate/photograph.h"

#include <cmath>
#include <utility>

namespace ridgeline::apps {

std::string image_file(const std::string& view_id) { return view_id + ".tif"; }

simulate::RenderOptions light_of(const ViewOptions& options, const simulate::AerialView& view) {
  constexpr double kTurnDeg = 360.0;
  simulate::RenderOptions light = options.render;
  const auto steps = static_cast<double>(view.number);
  light.sun_azimuth_deg =
      std::fmod(light.sun_azimuth_deg + steps * options.flight.sun_step_deg, kTurnDeg);
  return light;
}

ViewFile::ViewFile(std::string path, const simulate::AerialView& view, const ViewOptions& options)
    : path_(std::move(path)),
      size_px_(view.size_px.x(), view.size_px.y()),
      layout_(options.flight.frame_px ? io::TiffLayout::kTiles : io::TiffLayout::kStrips) {}

void ViewFile::write_rows(const cv::Mat& rows) {
  static_assert(simulate::kRowsAtOnce % io::kTile_px == 0);
  if (!writer_) writer_.emplace(path_, size_px_, rows.type(), layout_);
  writer_->write_rows(rows);
}

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

std::array<double, 4> area_m(const simulate::Scene& scene, double margin_m) {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(margin_m);
  const Eigen::Vector2d origin_m = scene.frame.origin_m.head<2>();
  const Eigen::Vector2d low = origin_m - margin;
  const Eigen::Vector2d high = origin_m + scene.extent_m + margin;
  return {low.x(), low.y(), high.x(), high.y()};
}

}  // namespace ridgeline::apps
