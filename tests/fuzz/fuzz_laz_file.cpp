// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a LAZ or COPC file: header, LASzip record, chunk table, hierarchy and points.
#include "io/cloud/las_header.h"
#include "io/cloud/laz/codec_error.h"
#include "io/cloud/laz/copc.h"
#include "io/cloud/laz/laz_points.h"
#include "io/error.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace {

using namespace ridgeline::io;

// A stream of repetitions is small and long at once; a fuzzer needs short runs.
constexpr std::uint64_t kMaxPoints = 20'000;

void decode_all(std::span<const std::byte> file, const LasHeader& header) {
  const laz::LazPoints points(file, header, "fuzz.laz");
  if (header.n_points > kMaxPoints) return;
  for (std::size_t block = 0; block < points.n_blocks(); ++block) {
    points.decode(block, laz::RecordParts::kAll, [](std::span<const std::byte>, std::size_t) {});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> file = std::as_bytes(std::span(data, size));
  try {
    const LasHeader header = parse_las_header(file, "fuzz.laz");
    if (!header.is_compressed()) return 0;
    laz::read_copc_hierarchy(file, header);
    decode_all(file, header);
  } catch (const IoError&) {
  } catch (const laz::CodecError&) {
  }
  return 0;
}
