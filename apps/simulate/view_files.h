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

/// The file name of a view; also the name of its image in an orientation.
std::string image_file(const std::string& view_id);

/// Throws std::invalid_argument if a degraded view is not one of `view_ids`, or if views are named
/// but none of blur, Bayer pattern and JPEG is set.
void check_degraded(const ViewOptions& options, std::span<const std::string> view_ids);

/// The sensor of a view: without blur, Bayer pattern and JPEG unless the view is a degraded one.
simulate::SensorOptions sensor_of(const ViewOptions& options, const simulate::AerialView& view);

/// The light for a view: the sun moves from view to view.
simulate::RenderOptions light_of(const ViewOptions& options, const simulate::AerialView& view);

/// The TIFF of a view, written row by row as photograph() delivers them; frames are tiled.
class ViewFile {
 public:
  ViewFile(std::string path, const simulate::AerialView& view, const ViewOptions& options);
  void write_rows(const cv::Mat& rows);
  void commit() { writer_->commit(); }

 private:
  std::string path_;
  cv::Size size_px_;
  io::TiffLayout layout_;
  std::optional<io::TiffWriter> writer_;  ///< created with the first rows, which determine the type
};

/// Whole frames share one camera. Any other image has a camera of its own with an off-centre
/// principal point, named after the image because PAT-B has no camera names.
io::Orientation orientation_of(const simulate::SyntheticScene& scene,
                               std::span<const simulate::AerialView> views,
                               bool are_frames);

/// The bounds of the plan with a margin, in world coordinates: x_min, y_min, x_max, y_max.
std::array<double, 4> area_m(const simulate::SyntheticScene& scene, double margin_m);

}  // namespace ridgeline::apps
