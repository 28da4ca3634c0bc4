// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/view_files.h"

#include "apps/simulate/photograph.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridgeline::apps {

std::string image_file(const std::string& view_id) { return view_id + ".tif"; }

void check_degraded(const ViewOptions& options, std::span<const std::string> view_ids) {
  constexpr std::size_t kMaxNamedViews = 30;  // all views of a patch; a block may have thousands
  const simulate::SensorOptions& sensor = options.sensor;
  check(options.degraded.empty() || sensor.blur_px > 0.0 || sensor.bayer || sensor.jpeg_quality > 0,
        "--degraded-views, must be with --blur-px, --bayer or --jpeg-quality");
  for (const std::string& id : options.degraded) {
    const auto named = view_ids.first(std::min(view_ids.size(), kMaxNamedViews));
    check(std::ranges::find(view_ids, id) != view_ids.end(), "--degraded-views = ", id,
          ", must be one of ", fmt::format("{}", fmt::join(named, ", ")),
          named.size() < view_ids.size() ? ", ..." : "");
  }
}

simulate::SensorOptions sensor_of(const ViewOptions& options, const simulate::AerialView& view) {
  simulate::SensorOptions sensor = options.sensor;
  const std::vector<std::string>& degraded = options.degraded;
  if (degraded.empty() || std::ranges::find(degraded, view.id) != degraded.end()) return sensor;
  sensor.blur_px = 0.0;
  sensor.bayer = false;
  sensor.jpeg_quality = 0;
  return sensor;
}

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

io::Orientation orientation_of(const simulate::SyntheticScene& scene,
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

std::array<double, 4> area_m(const simulate::SyntheticScene& scene, double margin_m) {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(margin_m);
  const Eigen::Vector2d origin_m = scene.frame.origin_m.head<2>();
  const Eigen::Vector2d low = origin_m - margin;
  const Eigen::Vector2d high = origin_m + scene.extent_m + margin;
  return {low.x(), low.y(), high.x(), high.y()};
}

}  // namespace ridgeline::apps
