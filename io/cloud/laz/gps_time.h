// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/integer_decompressor.h"

#include <array>
#include <cstdint>

namespace ridgeline::io::laz {

/// GPS times (the bits of a double) as four interleaved sequences, each of nearly constant step:
/// a symbol gives the multiple of the last step that predicts the next time, switches to another
/// sequence, or starts a sequence from a full value. Point formats 1 to 5 (item version 2) and 6 to
/// 10 (versions 3 and 4) differ by one symbol, "time unchanged".
class GpsTimeSequences {
 public:
  enum class Alphabet { kWithUnchanged, kWithoutUnchanged };

  GpsTimeSequences(Alphabet alphabet, std::uint64_t first);

  /// The time of the next record.
  std::uint64_t decode(ArithmeticDecoder& decoder);

 private:
  struct Sequence {
    std::uint64_t time = 0;
    std::int32_t step = 0;
    int num_unlike = 0;  // consecutive differences far from the step
  };
  // The meaning of a symbol, whichever alphabet it comes from.
  enum class Action { kUnchanged, kDifference, kFull, kSwitch };
  struct Decision {
    Action action;
    std::uint32_t argument;  // multiple of the step, or the number of sequences to advance
  };

  Decision decode_decision(ArithmeticDecoder& decoder);
  Decision decode_decision_without_step(ArithmeticDecoder& decoder);
  Decision decode_decision_with_step(ArithmeticDecoder& decoder);
  void decode_difference(ArithmeticDecoder& decoder, std::uint32_t multiple);
  void decode_first_step(ArithmeticDecoder& decoder);
  void decode_full(ArithmeticDecoder& decoder);
  void keep_step_if_unlike_often(std::int32_t difference);

  std::uint32_t num_unchanged_;  // symbols for "unchanged": 1 or 0
  std::array<Sequence, 4> sequences_;
  std::size_t current_ = 0;
  std::size_t newest_ = 0;
  SymbolModel without_step_;
  SymbolModel with_step_;
  IntegerDecompressor difference_{32, 9};
};

}  // namespace ridgeline::io::laz
