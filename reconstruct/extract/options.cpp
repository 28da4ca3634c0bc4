// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/options.h"

#include <array>

namespace ridgeline::reconstruct {

const char* name(Detector detector) {
  switch (detector) {
    case Detector::kOurs:
      return "ours";
    case Detector::kEdgeDrawing:
      return "edge_drawing";
    default:
      return "lsd";
  }
}

Detector detector_named(std::string_view text) {
  for (const Detector detector : {Detector::kOurs, Detector::kEdgeDrawing, Detector::kLsd}) {
    if (text == name(detector)) return detector;
  }
  check(false, "detector = ", text, ", must be ours, edge_drawing or lsd");
  return Detector::kOurs;
}

}  // namespace ridgeline::reconstruct
