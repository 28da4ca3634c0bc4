// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight.h"
#include "apps/simulate/render.h"
#include "apps/simulate/sensor.h"
#include "io/images/image_writer.h"
#include "io/orientation/orientation.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// How views are taken and written.
struct ViewOptions {
  simulate::FlightOptions flight;
  simulate::RenderOptions render;
  simulate::SensorOptions sensor;
  /// Ids of the views to which blur_px, bayer and jpeg_quality of the sensor apply; empty: all.
  std::vector<std::string> degraded;
  std::string orientation;  ///< format of write_orientation(); empty: matrices in patch.yaml
};

/// The file of a view; in an orientation the name of its image.
std::string image_file(const std::string& view_id);

/// Throws std::invalid_argument if a degraded view is not one of `view_ids`, or if views are named
/// but neither blur, Bayer pattern nor JPEG is set.
void check_degraded(const ViewOptions& options, std::span<const std::string> view_ids);

/// The sensor of a view: without blur, Bayer pattern and JPEG unless the view is a degraded one.
simulate::SensorOptions sensor_of(const ViewOptions& options, const simulate::AerialView& view);

/// The light in which a view is taken: the sun moves on while the views are taken.
simulate::RenderOptions light_of(const ViewOptions& options, const simulate::AerialView& view);

/// The TIFF of a view, which takes its rows from top to bottom as photograph() hands them over;
/// frames are tiled.
class ViewFile {
 public:
  ViewFile(std::string path, const simulate::AerialView& view, const ViewOptions& options);
  void write_rows(const cv::Mat& rows);
  void commit() { writer_->commit(); }

 private:
  std::string path_;
  cv::Size size_px_;
  io::TiffLayout layout_;
  std::optional<io::TiffWriter> writer_;  ///< from the first rows on, which tell the type
};

/// Whole frames are of one camera. Other images are of one each, whose principal point is off the
/// middle, and which is named after the image, since PAT-B names no cameras.
io::Orientation orientation_of(const simulate::SyntheticScene& scene,
                               std::span<const simulate::AerialView> views,
                               bool are_frames);

/// The plan with a margin, on the map: x_min, y_min, x_max, y_max.
std::array<double, 4> area_m(const simulate::SyntheticScene& scene, double margin_m);

}  // namespace ridgeline::apps
