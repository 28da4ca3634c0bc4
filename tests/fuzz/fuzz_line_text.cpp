// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as rows of lines: CSV, WKT, Line3D++, LIMAP, ELSR++, told apart as read_lines() does.
#include "io/error.h"
#include "io/lines/read_lines.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ridgeline::io::fuzz::InputFile file("txt");
  try {
    ridgeline::io::read_lines(file.hold(data, size));
  } catch (const ridgeline::io::IoError&) {
  }
  return 0;
}
