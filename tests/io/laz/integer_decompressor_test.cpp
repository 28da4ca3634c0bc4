// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/integer_decompressor.h"

#include "tests/io/laz/arithmetic_encoder.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace ridgeline::io::laz {
namespace {

struct Sample {
  std::int32_t prediction, value;
  unsigned context;
};

std::vector<std::int32_t> read_back(unsigned num_bits, const std::vector<Sample>& samples) {
  ArithmeticEncoder encoder;
  IntegerCompressor written(num_bits, 3);
  for (const auto& [prediction, value, context] : samples) {
    written.encode(encoder, prediction, value, context);
  }
  const std::vector<std::byte> bytes = encoder.finish();
  ArithmeticDecoder decoder{ByteStream(bytes)};
  IntegerDecompressor read(num_bits, 3);
  std::vector<std::int32_t> values;
  for (const auto& [prediction, value, context] : samples) {
    values.push_back(read.decode(decoder, prediction, context));
  }
  return values;
}

std::vector<std::int32_t> values_of(const std::vector<Sample>& samples) {
  std::vector<std::int32_t> values;
  for (const Sample& sample : samples) values.push_back(sample.value);
  return values;
}

TEST(IntegerDecompressor, ReadsBackDifferencesOfEveryLength) {
  std::vector<Sample> samples;
  for (int k = 0; k < 31; ++k) {
    for (const std::int64_t near : {-1, 0, 1}) {
      const auto difference = static_cast<std::int32_t>((std::int64_t{1} << k) + near);
      samples.push_back({0, difference, 0});
      samples.push_back({0, -difference, 1});
    }
  }
  EXPECT_EQ(read_back(32, samples), values_of(samples));
}

TEST(IntegerDecompressor, WrapsAtTheLimitsOf32Bits) {
  constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
  const std::vector<Sample> samples{{0, kMin, 0},    {0, kMax, 0},  {kMax, kMin, 0},
                                    {kMin, kMax, 0}, {kMax, -1, 0}, {-1, kMax, 0}};
  EXPECT_EQ(read_back(32, samples), values_of(samples));
}

TEST(IntegerDecompressor, ReadsBackRandomNumbersOf8And16Bits) {
  for (const unsigned num_bits : {8U, 16U}) {
    SCOPED_TRACE(num_bits);
    std::mt19937 rng(num_bits);
    std::uniform_int_distribution<std::int32_t> uniform(0, (1 << num_bits) - 1);
    std::vector<Sample> samples;
    for (unsigned i = 0; i < 20'000; ++i) samples.push_back({uniform(rng), uniform(rng), i % 3});
    EXPECT_EQ(read_back(num_bits, samples), values_of(samples));
  }
}

TEST(IntegerDecompressor, TellsTheNumberOfBitsOfTheLastDifference) {
  ArithmeticEncoder encoder;
  IntegerCompressor written(32);
  // [-(2^k - 1), -2^(k-1)] and [2^(k-1) + 1, 2^k]: 1 has k = 0, -1 and 2 have 1, 1000 has 10.
  for (const std::int32_t value : {1, -1, 2, 1000}) written.encode(encoder, 0, value);
  const std::vector<std::byte> bytes = encoder.finish();
  ArithmeticDecoder decoder{ByteStream(bytes)};
  IntegerDecompressor read(32);
  for (const unsigned bits : {0U, 1U, 1U, 10U}) {
    read.decode(decoder, 0);
    EXPECT_EQ(read.last_bit_count(), bits);
  }
}

}  // namespace
}  // namespace ridgeline::io::laz
