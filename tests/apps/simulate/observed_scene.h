// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight.h"
#include "apps/simulate/render.h"
#include "apps/simulate/sensor.h"
#include "apps/simulate/shown_edge.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace ridgeline::test {

/// A scene with its views and what they show.
struct ObservedScene {
  simulate::SyntheticScene scene;
  std::vector<simulate::AerialView> views;
  std::vector<cv::Mat> images;
};

inline ObservedScene observed(simulate::SyntheticScene scene,
                              const simulate::FlightOptions& flight = {}) {
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

/// The edges of the scene with their contrast in the images.
inline std::vector<simulate::ShownEdge> measured_edges(const ObservedScene& o,
                                                       const simulate::SurfaceOracle& oracle) {
  std::vector<simulate::ShownEdge> edges = simulate::shown_edges(o.scene, oracle);
  for (std::size_t view = 0; view < o.images.size(); ++view) {
    simulate::measure_contrast(view, {o.images[view]}, edges);
  }
  return edges;
}

}  // namespace ridgeline::test
