// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the edges of an OBJ (also vertices two by two) or a PLY.
#include "io/error.h"
#include "io/lines/readers.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using namespace ridgeline::io;

template <typename Read>
void expect_lines_or_io_error(const Read& read) {
  try {
    read();
  } catch (const IoError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  if (content.starts_with("ply")) {
    expect_lines_or_io_error([&] { read_ply("fuzz.ply", content); });
    return 0;
  }
  expect_lines_or_io_error([&] { read_obj("fuzz.obj", content, false); });
  expect_lines_or_io_error([&] { read_obj("fuzz.obj", content, true); });
  return 0;
}
