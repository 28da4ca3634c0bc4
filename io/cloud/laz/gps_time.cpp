// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/gps_time.h"

#include "io/cloud/laz/wrapping.h"

namespace ridgeline::io::laz {
namespace {

// Once a sequence has a step, a symbol states how a difference is coded: 0 for one that is unlike
// every multiple of the step, 1..500 for that multiple, 501..510 for the multiples -1..-10.
constexpr std::uint32_t kMaxMultiple = 500;
constexpr std::uint32_t kMinMultiple = 510;
constexpr int kMaxUnlike = 3;

// Contexts of the differences.
constexpr unsigned kFirstStep = 0;
constexpr unsigned kSameStep = 1;
constexpr unsigned kSmallMultiple = 2;
constexpr unsigned kLargeMultiple = 3;
constexpr unsigned kAtMaxMultiple = 4;
constexpr unsigned kNegativeMultiple = 5;
constexpr unsigned kAtMinMultiple = 6;
constexpr unsigned kUnlike = 7;
constexpr unsigned kHighHalf = 8;

}  // namespace

GpsTimeSequences::GpsTimeSequences(Alphabet alphabet, std::uint64_t first)
    : num_unchanged_(alphabet == Alphabet::kWithUnchanged ? 1 : 0),
      without_step_(5 + num_unchanged_),
      with_step_(kMinMultiple + 5 + num_unchanged_) {
  sequences_[0].time = first;
}

std::uint64_t GpsTimeSequences::decode(ArithmeticDecoder& decoder) {
  while (true) {
    const Decision decision = decode_decision(decoder);
    switch (decision.action) {
      case Action::kUnchanged:
        break;
      case Action::kDifference:
        if (sequences_[current_].step == 0) {
          decode_first_step(decoder);
        } else {
          decode_difference(decoder, decision.argument);
        }
        break;
      case Action::kFull:
        decode_full(decoder);
        break;
      case Action::kSwitch:
        current_ = (current_ + decision.argument) % sequences_.size();
        continue;
    }
    return sequences_[current_].time;
  }
}

GpsTimeSequences::Decision GpsTimeSequences::decode_decision(ArithmeticDecoder& decoder) {
  return sequences_[current_].step == 0 ? decode_decision_without_step(decoder)
                                        : decode_decision_with_step(decoder);
}

GpsTimeSequences::Decision GpsTimeSequences::decode_decision_without_step(
    ArithmeticDecoder& decoder) {
  const std::uint32_t symbol = decoder.decode_symbol(without_step_);
  if (symbol < num_unchanged_) return {Action::kUnchanged, 0};
  const std::uint32_t kind = symbol - num_unchanged_;
  if (kind == 0) return {Action::kDifference, 0};
  if (kind == 1) return {Action::kFull, 0};
  return {Action::kSwitch, kind - 1};
}

GpsTimeSequences::Decision GpsTimeSequences::decode_decision_with_step(ArithmeticDecoder& decoder) {
  const std::uint32_t symbol = decoder.decode_symbol(with_step_);
  if (symbol <= kMinMultiple) return {Action::kDifference, symbol};
  const std::uint32_t behind_multiples = symbol - kMinMultiple - 1;
  if (behind_multiples < num_unchanged_) return {Action::kUnchanged, 0};
  const std::uint32_t kind = behind_multiples - num_unchanged_;
  if (kind == 0) return {Action::kFull, 0};
  return {Action::kSwitch, kind};
}

void GpsTimeSequences::decode_first_step(ArithmeticDecoder& decoder) {
  Sequence& sequence = sequences_[current_];
  sequence.step = difference_.decode(decoder, 0, kFirstStep);
  sequence.time += static_cast<std::uint64_t>(std::int64_t{sequence.step});
  sequence.num_unlike = 0;
}

void GpsTimeSequences::decode_difference(ArithmeticDecoder& decoder, std::uint32_t multiple) {
  Sequence& sequence = sequences_[current_];
  const auto predict = [&](std::int32_t factor, unsigned context) {
    return difference_.decode(decoder, wrapping_multiply(factor, sequence.step), context);
  };
  const auto factor = static_cast<std::int32_t>(multiple);
  std::int32_t difference = 0;
  if (multiple == 1) {
    difference = predict(1, kSameStep);
    sequence.num_unlike = 0;
  } else if (multiple == 0) {
    difference = predict(0, kUnlike);
    keep_step_if_unlike_often(difference);
  } else if (multiple < kMaxMultiple) {
    difference = predict(factor, multiple < 10 ? kSmallMultiple : kLargeMultiple);
  } else if (multiple == kMaxMultiple) {
    difference = predict(factor, kAtMaxMultiple);
    keep_step_if_unlike_often(difference);
  } else if (multiple < kMinMultiple) {
    difference = predict(static_cast<std::int32_t>(kMaxMultiple) - factor, kNegativeMultiple);
  } else {
    difference = predict(static_cast<std::int32_t>(kMaxMultiple) - factor, kAtMinMultiple);
    keep_step_if_unlike_often(difference);
  }
  sequence.time += static_cast<std::uint64_t>(std::int64_t{difference});
}

void GpsTimeSequences::keep_step_if_unlike_often(std::int32_t difference) {
  Sequence& sequence = sequences_[current_];
  if (++sequence.num_unlike <= kMaxUnlike) return;
  sequence.step = difference;
  sequence.num_unlike = 0;
}

void GpsTimeSequences::decode_full(ArithmeticDecoder& decoder) {
  const auto last_high = static_cast<std::int32_t>(sequences_[current_].time >> 32);
  const std::int32_t high = difference_.decode(decoder, last_high, kHighHalf);
  const std::uint64_t low = decoder.read_u32();
  newest_ = (newest_ + 1) % sequences_.size();
  current_ = newest_;
  sequences_[current_] = {.time = (std::uint64_t{static_cast<std::uint32_t>(high)} << 32) | low};
}

}  // namespace ridgeline::io::laz
