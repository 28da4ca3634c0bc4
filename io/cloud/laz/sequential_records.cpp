// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/sequential_records.h"

#include "io/cloud/laz/codec_error.h"
#include "io/cloud/laz/damaged_chunk.h"

#include <algorithm>
#include <utility>

namespace ridgeline::io::laz {

SequentialRecords::SequentialRecords(std::span<const std::byte> bytes,
                                     LaszipRecord laszip,
                                     std::uint64_t n_records,
                                     std::string path,
                                     std::uint32_t block_size)
    : bytes_(bytes),
      laszip_(std::move(laszip)),
      n_records_(n_records),
      chunk_size_(laszip_.compressor == Compressor::kPointwise ? n_records : laszip_.chunk_size),
      block_size_(block_size),
      path_(std::move(path)) {}

std::vector<std::byte> SequentialRecords::block(std::size_t index) {
  const std::lock_guard lock(mutex_);
  if (const auto kept = kept_.find(index); kept != kept_.end()) return kept->second;
  if (index < next_block_) restart();
  while (next_block_ < index) {
    const std::size_t passed = next_block_;
    kept_.emplace(passed, decode_next());
    if (kept_.size() > kBlocksKept) kept_.erase(kept_.begin());
  }
  return decode_next();
}

void SequentialRecords::restart() {
  next_block_ = 0;
  kept_.clear();
  decoder_.reset();
  chunk_begin_ = 0;
  chunk_index_ = 0;
  place_in_chunk_ = 0;
}

std::size_t SequentialRecords::n_blocks() const {
  return n_records_ / block_size_ + (n_records_ % block_size_ != 0 ? 1 : 0);
}

std::size_t SequentialRecords::n_records(std::size_t block) const {
  return std::min<std::uint64_t>(block_size_, n_records_ - std::uint64_t{block} * block_size_);
}

std::vector<std::byte> SequentialRecords::decode_next() {
  std::vector<std::byte> records(n_records(next_block_) * laszip_.record_length);
  try {
    for (std::size_t at = 0; at < records.size(); at += laszip_.record_length) {
      decode_record(&records[at]);
    }
  } catch (const CodecError& error) {
    const std::uint64_t chunk = chunk_index_;
    const std::uint64_t point = place_in_chunk_;
    restart();  // a later call gets the same error, not a decoder that has lost its place
    throw damaged_chunk(path_, chunk, point, error);
  }
  ++next_block_;
  return records;
}

void SequentialRecords::decode_record(std::byte* record) {
  if (decoder_ && place_in_chunk_ == chunk_size_) {
    chunk_begin_ += decoder_->position();
    decoder_.reset();
    ++chunk_index_;
    place_in_chunk_ = 0;
  }
  if (!decoder_) {
    decoder_ = make_record_decoder(laszip_, bytes_.subspan(chunk_begin_), RecordParts::kAll);
  }
  decoder_->next(record);
  ++place_in_chunk_;
}

}  // namespace ridgeline::io::laz
