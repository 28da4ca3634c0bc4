// SPDX-License-Identifier: BSD-3-Clause
// Damaged files give an error or some answer, quickly and within the memory of the undamaged file;
// under sanitizers also no undefined behaviour.
#include "io/error.h"
#include "tests/io/laz/laz_builder.h"
#include "tests/io/laz/laz_samples.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace ridgeline::io::laz {
namespace {

constexpr const char* kSamples[] = {
    "las_samples/lazperf_point10-1.0.laz", "las_samples/lazrs_point-time.laz",
    "las_samples/laspy_simple.laz",        "las_samples/loadersgl_pdrf4-1.3.laz",
    "las_samples/laspy_1_4_w_evlr.laz",    "las_samples/loadersgl_pdrf7-v4-1.4.laz",
    "las_samples/loadersgl_pdrf8-1.4.laz", "las_samples/loadersgl_pdrf10-1.4.laz",
    "las_samples/lasrs_autzen.copc.laz",   "las_samples/laspy_simple.copc.laz",
    "las_samples/laszip_broken_coder.laz", "las_samples/laszip_broken_size.laz",
};

// The number of trials; RIDGELINE_LAZ_TRIALS=20000 makes a larger run.
int num_trials() {
  const char* const text = std::getenv("RIDGELINE_LAZ_TRIALS");
  return text == nullptr ? 60 : std::atoi(text);
}

// Whether the file could be decoded. More records than it claims would be a fault of the decoder.
bool decodes(const FileBytes& file) {
  try {
    decode_laz(file);
    return true;
  } catch (const IoError&) {
    return false;
  }
}

TEST(DamagedLaz, GivesAnErrorWhereverTheFileIsCut) {
  for (const char* name : kSamples) {
    RIDGELINE_NEED_SHARED_FILE(name);
    const FileBytes file = read_file(shared_file(name));
    std::mt19937 rng(1);
    for (int trial = 0; trial < num_trials(); ++trial) {
      FileBytes cut = file;
      cut.resize(std::uniform_int_distribution<std::size_t>(0, file.size() / 2)(rng));
      EXPECT_FALSE(decodes(cut)) << name << " cut to " << cut.size() << " bytes";
    }
  }
}

TEST(DamagedLaz, SurvivesFlippedBytes) {
  int num_refused = 0;
  for (const char* name : kSamples) {
    RIDGELINE_NEED_SHARED_FILE(name);
    const FileBytes file = read_file(shared_file(name));
    std::mt19937 rng(2);
    for (int trial = 0; trial < num_trials(); ++trial) {
      FileBytes damaged = file;
      // Headers and tables are small beside the points: every other flip goes to the first KiB.
      const std::size_t range =
          trial % 2 == 0 ? std::min<std::size_t>(1024, file.size()) : file.size();
      const int num_flips = 1 + trial % 4;
      for (int flip = 0; flip < num_flips; ++flip) {
        damaged[std::uniform_int_distribution<std::size_t>(0, range - 1)(rng)] ^=
            static_cast<std::byte>(1 + rng() % 255);
      }
      if (!decodes(damaged)) ++num_refused;
    }
  }
  EXPECT_GT(num_refused, 0);
}

TEST(DamagedLaz, SurvivesACutAtEveryByteOfASmallFile) {
  LazBuilder builder;
  builder.chunk_size = 2;
  for (std::int32_t i = 0; i < 4; ++i) builder.add_single_point(i, i, i);
  builder.chunk_size = 1;
  const FileBytes file = builder.build();
  const std::size_t end_of_points = file.size() - 24;  // the table follows, maybe shorter
  for (std::size_t size = 0; size < end_of_points; ++size) {
    EXPECT_FALSE(decodes({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
  }
}

}  // namespace
}  // namespace ridgeline::io::laz
