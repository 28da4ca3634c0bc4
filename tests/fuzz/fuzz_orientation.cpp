// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an orientation of any format but COLMAP's, told apart as read_orientation() does.
#include "io/error.h"
#include "io/orientation/read_orientation.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ridgeline::io::fuzz::InputFile file("ori");
  const std::string& path = file.hold(data, size);
  ridgeline::io::OrientationOptions options;
  options.angles = ridgeline::io::AngleUnit::kDegree;
  options.matrix = ridgeline::io::MatrixDirection::kWorldFromCamera;
  try {
    ridgeline::io::read_orientation(path, options);
  } catch (const ridgeline::io::IoError&) {
  }
  return 0;
}
