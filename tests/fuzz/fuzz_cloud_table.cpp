// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as PCD, PLY or text of `x y z` lines, by the first bytes as open_cloud() does.
#include "io/cloud/pcd_source.h"
#include "io/cloud/ply_source.h"
#include "io/cloud/xyz_source.h"
#include "io/error.h"
#include "tests/fuzz/decode_blocks.h"
#include "tests/fuzz/input_file.h"

#include <string_view>

namespace {

using namespace ridgeline::io;

std::unique_ptr<CloudSource> open(const std::string& path, std::string_view content) {
  if (content.starts_with("ply")) return open_ply(MappedFile(path), path);
  if (content.starts_with("# .PCD") || content.starts_with("VERSION")) {
    return open_pcd(MappedFile(path), path);
  }
  return open_xyz(MappedFile(path), path);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("xyz");
  try {
    fuzz::decode_blocks(*open(file.hold(data, size), {reinterpret_cast<const char*>(data), size}));
  } catch (const IoError&) {
  }
  return 0;
}
