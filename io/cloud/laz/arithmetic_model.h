// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace ridgeline::io::laz {

/// Adaptive probability of a bit, in units of 2^-13 (A. Said, "Introduction to Arithmetic Coding",
/// HP Labs report HPL-2004-76, the FastAC coder that LASzip uses).
class BitModel {
 public:
  static constexpr unsigned kShift = 13;

  std::uint32_t zero_probability() const { return zero_probability_; }

  void count(bool bit) {
    zero_count_ += bit ? 0 : 1;
    if (--until_update_ == 0) update();
  }

 private:
  void update();

  std::uint32_t zero_probability_ = 1U << (kShift - 1);
  std::uint32_t zero_count_ = 1;
  std::uint32_t total_ = 2;
  std::uint32_t update_cycle_ = 4;
  std::uint32_t until_update_ = 4;
};

/// Adaptive distribution of 2 to 2048 symbols, in units of 2^-15 (source: see BitModel). The tables
/// are built on first use, because most of the hundreds of models of a chunk are never used.
class SymbolModel {
 public:
  static constexpr unsigned kShift = 15;

  explicit SymbolModel(std::uint32_t num_symbols) : num_symbols_(num_symbols) {}

  void prepare() {
    if (tables_.empty()) build();
  }

  std::uint32_t num_symbols() const { return num_symbols_; }

  /// Lower end of the interval of a symbol; strictly increasing, 0 for the first.
  std::uint32_t lower(std::uint32_t symbol) const { return tables_[symbol]; }

  /// The symbols whose intervals can contain a code value below 2^15 + 2^7: the first one, and one
  /// past the last.
  struct Candidates {
    std::uint32_t first;
    std::uint32_t end;
  };
  Candidates candidates(std::uint32_t code) const {
    if (lookup_bits_ == 0) return {0, num_symbols_};
    const std::uint16_t* entry = &tables_[2 * num_symbols_ + (code >> (kShift - lookup_bits_))];
    return {entry[0], entry[1] + 1U};
  }

  void count(std::uint32_t symbol) {
    ++tables_[num_symbols_ + symbol];
    if (--until_update_ == 0) update();
  }

 private:
  void build();
  void update();
  void halve_counts();

  std::uint32_t num_symbols_;
  std::uint32_t lookup_bits_ = 0;  // 0: a small alphabet, searched without a look-up table
  std::uint32_t total_ = 0;
  std::uint32_t update_cycle_ = 0;
  std::uint32_t until_update_ = 0;
  std::vector<std::uint16_t> tables_;  // lower ends, counts, look-up table: one block of memory
};

}  // namespace ridgeline::io::laz
