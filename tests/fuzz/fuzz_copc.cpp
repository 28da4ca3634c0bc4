// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a COPC file: hierarchy, levels down to a resolution, and the nodes of a window. The
// reference system is left out, as fuzz_las has it: PROJ takes most of the time there.
#include "io/cloud/block_reader.h"
#include "io/cloud/laz/laz_source.h"
#include "io/error.h"
#include "tests/fuzz/input_file.h"

#include <tbb/global_control.h>

namespace {

using namespace ridgeline::io;

void read(const std::string& path, const OpenCloudOptions& options) {
  constexpr std::uint64_t kMaxPoints = 20'000;  // a stream of repetitions is small and long at once
  try {
    MappedFile bytes(path);
    LasHeader header = parse_las_header(bytes.bytes(), path);
    if (!header.is_compressed()) return;
    const auto source = open_laz(std::move(bytes), std::move(header), {.path = path}, options);
    if (source->info().n_points > kMaxPoints || source->n_blocks() == 0) return;
    const std::optional<BlockExtent> node = source->block_extent(source->n_blocks() / 2);
    ReadOptions window;
    if (node && !node->box_in_file.isEmpty()) window.bounds_in_file = node->box_in_file;
    std::vector<CloudPoint> points;
    append_points(*source, {}, PointFilter(window, {}), points);
  } catch (const IoError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("laz");
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const std::string& path = file.hold(data, size);
  read(path, {});
  read(path, {.max_resolution_m = 1.0});
  return 0;
}
