// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/arithmetic_model.h"

#include <algorithm>

namespace ridgeline::io::laz {
namespace {

constexpr std::uint32_t kMaxBitCount = 1U << BitModel::kShift;
constexpr std::uint32_t kMaxSymbolCount = 1U << SymbolModel::kShift;
constexpr std::uint32_t kMaxBitCycle = 64;
constexpr std::uint32_t kMaxSymbolsWithoutLookup = 16;

}  // namespace

void BitModel::update() {
  total_ += update_cycle_;
  if (total_ > kMaxBitCount) {
    total_ = (total_ + 1) / 2;
    zero_count_ = (zero_count_ + 1) / 2;
    if (zero_count_ == total_) ++total_;
  }
  zero_probability_ = (zero_count_ * (0x80000000U / total_)) >> (31 - kShift);
  update_cycle_ = std::min(5 * update_cycle_ / 4, kMaxBitCycle);
  until_update_ = update_cycle_;
}

void SymbolModel::build() {
  std::size_t lookup_size = 0;
  if (num_symbols_ > kMaxSymbolsWithoutLookup) {
    lookup_bits_ = 3;
    while (num_symbols_ > (1U << (lookup_bits_ + 2))) ++lookup_bits_;
    lookup_size = (1U << lookup_bits_) + 2;
  }
  tables_.assign(std::size_t{2} * num_symbols_ + lookup_size, 1);
  update_cycle_ = num_symbols_;
  update();
  update_cycle_ = (num_symbols_ + 6) / 2;
  until_update_ = update_cycle_;
}

void SymbolModel::halve_counts() {
  total_ = 0;
  for (std::uint32_t i = num_symbols_; i < 2 * num_symbols_; ++i) {
    tables_[i] = static_cast<std::uint16_t>((tables_[i] + 1) / 2);
    total_ += tables_[i];
  }
}

void SymbolModel::update() {
  total_ += update_cycle_;
  if (total_ > kMaxSymbolCount) halve_counts();

  const std::uint32_t scale = 0x80000000U / std::max(total_, 1U);
  std::uint16_t* const lower = tables_.data();
  const std::uint16_t* const counts = lower + num_symbols_;
  std::uint32_t sum = 0;
  for (std::uint32_t i = 0; i < num_symbols_; ++i) {
    lower[i] = static_cast<std::uint16_t>((scale * sum) >> (31 - kShift));
    sum += counts[i];
  }
  if (lookup_bits_ > 0) {
    // Entry t holds the last symbol whose interval begins at or before cell t of the code values.
    std::uint16_t* const lookup = lower + std::size_t{2} * num_symbols_;
    const std::uint32_t end = (1U << lookup_bits_) + 2;
    std::uint32_t cell = 0;
    lookup[0] = 0;
    for (std::uint32_t i = 1; i < num_symbols_; ++i) {
      const std::uint32_t first_cell = lower[i] >> (kShift - lookup_bits_);
      while (cell < first_cell) lookup[++cell] = static_cast<std::uint16_t>(i - 1);
    }
    while (cell + 1 < end) lookup[++cell] = static_cast<std::uint16_t>(num_symbols_ - 1);
  }
  update_cycle_ = std::min(5 * update_cycle_ / 4, 8 * (num_symbols_ + 6));
  until_update_ = update_cycle_;
}

}  // namespace ridgeline::io::laz
