// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/aerial_pair.h"
#include "apps/simulate/render.h"
#include "apps/simulate/sensor.h"
#include "io/lines/line_set.h"
#include "io/results/output_folder.h"

#include <string>

namespace ridgeline::apps {

struct StereoOptions {
  simulate::FlightOptions flight;
  simulate::RenderOptions render;
  simulate::SensorOptions sensor;
};

/// Renders both views of a scene, with its fittings, and writes left.tif, right.tif, matches.csv (the reference) and
/// patch.yaml, which names lidar.las and truth.geojson too. Returns `truth`, the true lines in order of
/// Scene::lines, with their class by these cameras and the visible shares.
io::LineSet write_stereo(const simulate::Scene& bare_scene,
                         const std::string& patch_id,
                         const StereoOptions& options,
                         io::LineSet truth,
                         const results::OutputFolder& out);

}  // namespace ridgeline::apps
