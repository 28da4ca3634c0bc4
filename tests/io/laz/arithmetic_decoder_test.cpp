// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/arithmetic_decoder.h"

#include "io/cloud/laz/codec_error.h"
#include "tests/io/laz/arithmetic_encoder.h"

#include <gtest/gtest.h>

#include <random>

namespace ridgeline::io::laz {
namespace {

// Few symbols are frequent, so that the models become skewed and their counts are halved.
std::uint32_t skewed_symbol(std::mt19937& rng, std::uint32_t num_symbols) {
  std::geometric_distribution<std::uint32_t> geometric(0.3);
  return std::min(geometric(rng), num_symbols - 1);
}

TEST(ArithmeticDecoder, ReadsBackSymbolsOfEveryAlphabet) {
  for (const std::uint32_t num_symbols : {2U, 3U, 13U, 16U, 17U, 33U, 64U, 128U, 256U, 516U}) {
    SCOPED_TRACE(num_symbols);
    std::mt19937 rng(num_symbols);
    std::uniform_int_distribution<std::uint32_t> uniform(0, num_symbols - 1);
    std::vector<std::uint32_t> symbols(40'000);
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      symbols[i] = i % 2000 < 1000 ? uniform(rng) : skewed_symbol(rng, num_symbols);
    }
    ArithmeticEncoder encoder;
    SymbolModel written(num_symbols);
    for (const std::uint32_t symbol : symbols) encoder.encode_symbol(written, symbol);
    const std::vector<std::byte> bytes = encoder.finish();

    ArithmeticDecoder decoder{ByteStream(bytes)};
    SymbolModel read(num_symbols);
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      ASSERT_EQ(decoder.decode_symbol(read), symbols[i]) << i;
    }
  }
}

TEST(ArithmeticDecoder, ReadsBackMixedBitsSymbolsAndRawNumbers) {
  constexpr int kCount = 20'000;
  ArithmeticEncoder encoder;
  BitModel written_bit;
  SymbolModel written_symbol(40);
  std::mt19937 rng(5);
  std::bernoulli_distribution coin(0.03);
  const auto raw_number = [&rng](unsigned num_bits) {
    return static_cast<std::uint32_t>(rng()) >> (32 - num_bits);
  };
  for (int i = 0; i < kCount; ++i) {
    encoder.encode_bit(written_bit, coin(rng));
    encoder.encode_symbol(written_symbol, skewed_symbol(rng, 40));
    const auto num_bits = static_cast<unsigned>(1 + i % 32);
    encoder.write_bits(num_bits, raw_number(num_bits));
  }
  const std::vector<std::byte> bytes = encoder.finish();

  ArithmeticDecoder decoder{ByteStream(bytes)};
  BitModel read_bit;
  SymbolModel read_symbol(40);
  rng.seed(5);
  for (int i = 0; i < kCount; ++i) {
    ASSERT_EQ(decoder.decode_bit(read_bit), coin(rng)) << i;
    ASSERT_EQ(decoder.decode_symbol(read_symbol), skewed_symbol(rng, 40)) << i;
    const auto num_bits = static_cast<unsigned>(1 + i % 32);
    ASSERT_EQ(decoder.read_bits(num_bits), raw_number(num_bits)) << i;
  }
}

TEST(ArithmeticDecoder, ReadsTheLowHalvesOfLongNumbersFirst) {
  ArithmeticEncoder encoder;
  encoder.write_bits(16, 0x3210);
  encoder.write_bits(16, 0x7654);
  encoder.write_bits(16, 0xBA98);
  encoder.write_bits(16, 0xFEDC);
  const std::vector<std::byte> bytes = encoder.finish();
  EXPECT_EQ(ArithmeticDecoder{ByteStream(bytes)}.read_u64(), 0xFEDCBA9876543210U);
}

TEST(ArithmeticDecoder, RefusesAStreamThatEnds) {
  const std::vector<std::byte> three(3);
  EXPECT_THROW(ArithmeticDecoder{ByteStream(three)}, CodecError);
  const std::vector<std::byte> four(4);
  ArithmeticDecoder decoder{ByteStream(four)};
  SymbolModel model(256);
  EXPECT_THROW(
      {
        for (int i = 0; i < 20'000; ++i) decoder.decode_symbol(model);
      },
      CodecError);
}

TEST(ArithmeticDecoder, RefusesTheCodeThatNoEncoderBeginsWith) {
  const std::vector<std::byte> bytes(8, std::byte{0xFF});
  EXPECT_THROW(ArithmeticDecoder{ByteStream(bytes)}, CodecError);
}

TEST(ArithmeticDecoder, StaysInsideTheAlphabetForRandomBytes) {
  std::mt19937 rng(11);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<std::byte> bytes(300);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(rng());
    bytes[0] = std::byte{0x7F};  // avoids the impossible code
    ArithmeticDecoder decoder{ByteStream(bytes)};
    SymbolModel large(516);
    SymbolModel small(3);
    try {
      while (true) {
        ASSERT_LT(decoder.decode_symbol(large), 516U);
        ASSERT_LT(decoder.decode_symbol(small), 3U);
        ASSERT_LT(decoder.read_bits(7), 128U);
      }
    } catch (const CodecError&) {
      SUCCEED();  // the end of the stream ends it at the latest
    }
  }
}

}  // namespace
}  // namespace ridgeline::io::laz
