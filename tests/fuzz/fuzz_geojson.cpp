// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as GeoJSON: structure, positions and the attributes of a line.
#include "io/error.h"
#include "io/lines/readers.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    ridgeline::io::read_geojson("fuzz.geojson", {reinterpret_cast<const char*>(data), size});
  } catch (const ridgeline::io::IoError&) {
  }
  return 0;
}
