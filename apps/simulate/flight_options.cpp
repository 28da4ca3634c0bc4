// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/flight_options.h"

namespace ridgeline::simulate {

FlightOptions chio_wang_flight() {
  constexpr double kFocalMm = 152.0;
  constexpr double kPixelMm = 0.03;
  constexpr double kScale = 8000.0;
  constexpr double kFrameMm = 230.0;
  constexpr double kOverlap = 0.6;
  FlightOptions options;
  options.focal_length_px = kFocalMm / kPixelMm;
  options.height_above_ground_m = kScale * kFocalMm / 1000.0;
  options.base_to_height = (1.0 - kOverlap) * kFrameMm / kFocalMm;
  options.size_px = {{180, 180}, {225, 180}};
  return options;
}

}  // namespace ridgeline::simulate
