// SPDX-License-Identifier: BSD-3-Clause
// Clouds cut at every structural boundary, and with changed bytes, read as the program reads them:
// each gives an error that names the file, or an answer; soon, and within bounded memory.
#include "io/cloud/bytes.h"
#include "io/cloud/las_header.h"
#include "io/cloud/laz/laz_points.h"
#include "io/cloud/read_cloud.h"
#include "io/error.h"
#include "tests/io/cloud/las_bytes.h"
#include "tests/io/laz/copc_builder.h"
#include "tests/io/laz/laz_builder.h"
#include "tests/io/laz/laz_samples.h"
#include "tests/support/temp_folder.h"

#include <gtest/gtest.h>

#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <set>

#ifdef __SANITIZE_ADDRESS__
/// AddressSanitizer keeps 256 MB of freed memory unless told otherwise, which would count as held.
// NOLINTNEXTLINE(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp): the sanitizer's name
extern "C" const char* __asan_default_options() {
  return "quarantine_size_mb=8:max_allocation_size_mb=512";
}
#endif

namespace ridgeline::io::laz {
namespace {

constexpr double kMaxTime_s = 2.0;  // processor time, so that no test fails on a busy machine
constexpr std::size_t kMaxMemory_bytes = std::size_t{512} << 20U;

struct SampleFile {
  std::string name;
  FileBytes bytes;
};

FileBytes bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

FileBytes small_las() {
  LasBytes las(4, 7, 3);
  las.add_vlr("ridgeline", 1, "first").add_vlr("ridgeline", 2, "");
  for (std::int32_t i = 0; i < 20; ++i) las.add_point({i, -i, 7 * i});
  std::string evlr(60, '\0');
  evlr[20] = 4;
  las.set<std::uint64_t>(235, las.bytes().size()).set<std::uint32_t>(243, 1);
  return bytes_of(las.add_tail(evlr + "last").bytes());
}

FileBytes small_laz(LazBuilder::Table table) {
  LazBuilder builder;
  builder.table = table;
  for (std::int32_t i = 0; i < 4; ++i) builder.add_single_point(i, 2 * i, -i);
  return builder.build();
}

FileBytes small_copc() {
  std::mt19937 rng(3);
  std::vector<CopcPoint> points(300);
  for (CopcPoint& point : points) {
    for (std::int32_t& x : point.x) x = static_cast<std::int32_t>(rng() % 10000);
    point.classification = static_cast<std::uint8_t>(2 + rng() % 5);
  }
  return CopcBuilder{.n_levels = 3, .entries_per_page = 8}.build(points);
}

/// Files of this test, then those of the shared data that are there.
std::vector<SampleFile> samples() {
  std::vector<SampleFile> samples{
      {"las", small_las()},
      {"laz", small_laz(LazBuilder::Table::kBehindChunks)},
      {"laz, table position last", small_laz(LazBuilder::Table::kAtEndOfFile)},
      {"copc", small_copc()}};
  for (const char* name :
       {"las_samples/laspy_simple.las", "las_samples/lazrs_point-time.laz",
        "las_samples/loadersgl_pdrf4-1.3.laz", "las_samples/loadersgl_pdrf7-v4-1.4.laz",
        "las_samples/laspy_1_4_w_evlr.laz", "las_samples/laspy_simple.copc.laz"}) {
    if (have_shared_file(name)) samples.push_back({name, read_file(shared_file(name))});
  }
  return samples;
}

/// Adds the places where the chunks, and the layers in them, begin and end.
void add_chunk_boundaries(const FileBytes& file,
                          const LasHeader& header,
                          std::set<std::size_t>& at) {
  constexpr std::size_t kMaxLayers = 9;  // layers of the core of a layered record
  const LazPoints points(file, header, "sample");
  for (const Chunk& chunk : points.chunks()) {
    at.insert({chunk.offset, chunk.offset + chunk.n_bytes});
    at.insert(chunk.offset + header.record_length);
    if (header.point_format < 6) continue;
    const std::size_t sizes = chunk.offset + header.record_length + 4;
    std::size_t layer = sizes + 4 * kMaxLayers;
    for (std::size_t i = 0; i < kMaxLayers; ++i) {
      at.insert(layer);
      layer += load<std::uint32_t>(&file[sizes + 4 * i]);
    }
  }
  if (header.record_length == 0 || points.chunks().empty()) return;
  at.insert(load<std::uint64_t>(&file[header.point_offset]));
  at.insert(load<std::uint64_t>(&file[header.point_offset]) + 8);
}

/// The ends of fields of the header, records, points, chunks, layers and pages that lie within the
/// file.
std::set<std::size_t> boundaries(const FileBytes& file) {
  const LasHeader header = parse_las_header(file, "sample");
  std::set<std::size_t> at{0,
                           4,
                           24,
                           94,
                           96,
                           100,
                           104,
                           107,
                           131,
                           155,
                           179,
                           227,
                           235,
                           243,
                           247,
                           375,
                           header.header_size,
                           header.point_offset};
  for (const LasVlr& vlr : header.vlrs) {
    at.insert({vlr.data_offset - 54, vlr.data_offset, vlr.data_offset + vlr.data_size});
    if (vlr.user_id != "copc" || vlr.record_id != 1000) continue;
    for (std::size_t entry = 0; entry < vlr.data_size; entry += 32)
      at.insert(vlr.data_offset + entry);
  }
  if (header.is_compressed()) {
    add_chunk_boundaries(file, header, at);
  } else {
    at.insert(header.point_offset + header.n_points * header.record_length);
  }
  at.erase(at.lower_bound(file.size()), at.end());
  return at;
}

std::size_t peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kib = 0;
    if (word == "VmHWM:" && status >> kib) return kib << 10U;
  }
  return 0;
}

class MutatedCloud : public testing::Test {
 protected:
  /// Resets the peak of memory, so that it does not count what other tests of the process used
  /// before.
  void SetUp() override { std::ofstream("/proc/self/clear_refs") << 5; }

  /// The points, or nothing for an error.
  std::optional<std::vector<CloudPoint>> read(const FileBytes& bytes, const std::string& what) {
    std::filesystem::remove(
        path_);  // some file systems write a file at once that is cut and filled
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    const std::clock_t start = std::clock();
    std::optional<std::vector<CloudPoint>> points;
    try {
      points = read_cloud({path_}).points;
    } catch (const IoError& error) {
      EXPECT_NE(std::string(error.what()).find(path_), std::string::npos) << what << error.what();
    }
    const double duration_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_LT(duration_s, kMaxTime_s) << what;
    return points;
  }

 private:
  TempFolder folder_;
  std::string path_ = folder_.file("mutated.las");
};

TEST_F(MutatedCloud, CutAtAnyBoundaryIsAnErrorOrLosesNoPoint) {
  for (const SampleFile& sample : samples()) {
    const auto whole = read(sample.bytes, sample.name);
    ASSERT_TRUE(whole) << sample.name;
    for (const std::size_t boundary : boundaries(sample.bytes)) {
      for (const std::size_t size : {boundary - 1, boundary, boundary + 1}) {
        if (size >= sample.bytes.size()) continue;  // -1 is left out as well
        const std::string what = sample.name + " cut to " + std::to_string(size);
        const auto cut = read(
            {sample.bytes.begin(), sample.bytes.begin() + static_cast<std::ptrdiff_t>(size)}, what);
        if (!cut) continue;
        ASSERT_EQ(cut->size(), whole->size()) << what;
        EXPECT_EQ(std::memcmp(cut->data(), whole->data(), cut->size() * sizeof(CloudPoint)), 0)
            << what;
      }
    }
  }
  EXPECT_LT(peak_memory(), kMaxMemory_bytes);
}

TEST_F(MutatedCloud, ChangedBytesOfHeadersAndTablesGiveNoMorePointsThanAreThere) {
  constexpr std::size_t kHeaders = 700;
  for (const SampleFile& sample : samples()) {
    const bool is_small = sample.bytes.size() < 10000;
    const auto whole = read(sample.bytes, sample.name);
    ASSERT_TRUE(whole) << sample.name;
    for (std::size_t at = 0; at < std::min(kHeaders, sample.bytes.size());
         at += is_small ? 1 : 37) {
      FileBytes changed = sample.bytes;
      changed[at] ^= static_cast<std::byte>(1U << (at % 8));
      const std::string what = sample.name + " byte " + std::to_string(at);
      const auto points = read(changed, what);
      if (!points) continue;
      EXPECT_LE(points->size(), 2 * whole->size() + 64) << what;
    }
  }
  EXPECT_LT(peak_memory(), kMaxMemory_bytes);
}

TEST_F(MutatedCloud, ChangedBytesAnywhereAreSurvived) {
  constexpr int kTrials = 60;
  for (const SampleFile& sample : samples()) {
    std::mt19937 rng(11);
    for (int trial = 0; trial < kTrials; ++trial) {
      FileBytes changed = sample.bytes;
      for (int flip = 0; flip <= trial % 4; ++flip) {
        changed[rng() % changed.size()] ^= static_cast<std::byte>(1 + rng() % 255);
      }
      read(changed, sample.name + " trial " + std::to_string(trial));
    }
  }
  EXPECT_LT(peak_memory(), kMaxMemory_bytes);
}

}  // namespace
}  // namespace ridgeline::io::laz
