// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight.h"
#include "apps/simulate/render.h"
#include "apps/simulate/sensor.h"

#include <opencv2/core/mat.hpp>

#include <utility>
#include <vector>

namespace ridgeline::test {

/// A scene with its views and what they show.
struct ObservedScene {
  simulate::Scene scene;
  std::vector<simulate::AerialView> views;
  std::vector<cv::Mat> images;
};

inline ObservedScene observed(simulate::Scene scene, const simulate::FlightOptions& flight = {}) {
  ObservedScene o{std::move(scene), {}, {}};
  o.views = simulate::aerial_views(o.scene, flight);
  simulate::RenderOptions options;
  options.samples_per_side = 1;  // quick; edges are asked for, not measured
  const simulate::Renderer renderer(o.scene, options);
  for (const simulate::AerialView& view : o.views) {
    o.images.push_back(simulate::expose(renderer.radiance(view), {}, view.number));
  }
  return o;
}

}  // namespace ridgeline::test
