// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an uncompressed LAS file: header, records of the reference system, points; as given
// and salvaged.
#include "io/cloud/las_source.h"
#include "io/error.h"
#include "tests/fuzz/decode_blocks.h"
#include "tests/fuzz/input_file.h"

namespace {

using namespace ridgeline::io;

void read(const std::string& path, bool salvage) {
  try {
    fuzz::decode_blocks(*open_las(MappedFile(path), path, {.salvage = salvage}));
  } catch (const IoError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kFormatByte = 104;
  constexpr unsigned kCompressed = 0xC0;
  static const fuzz::InputFile file("las");
  if (size > kFormatByte && (data[kFormatByte] & kCompressed) != 0) return 0;  // fuzz_laz_file's
  const std::string& path = file.hold(data, size);
  read(path, false);
  read(path, true);
  return 0;
}
