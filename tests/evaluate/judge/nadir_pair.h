// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "reconstruct/geometry/epipolar.h"

namespace ridgeline::test {

/// A frame looking straight down from 800 m above x, y = 0; GSD 8 cm.
inline ProjectionMatrix camera_at(double x) {
  ProjectionMatrix p;
  p << 10000, 0, 0, -10000 * x, 0, -10000, 0, 0, 0, 0, -1, 800;
  return p;
}

/// What a pair with a base of 208 m along x, x = -100 m for the first image, shows of a line.
inline evaluate::ImageEvidence seen(const Segment3& line) {
  evaluate::ImageEvidence images{{}, {-10.0, 30.0}};
  for (const ProjectionMatrix& camera : {camera_at(-100.0), camera_at(108.0)}) {
    images.observations.push_back({camera, project(camera, line)});
  }
  return images;
}

}  // namespace ridgeline::test
