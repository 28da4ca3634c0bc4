// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/laz_points.h"

#include "io/cloud/laz/codec_error.h"
#include "io/cloud/laz/damaged_chunk.h"
#include "io/cloud/laz/record_decoder.h"
#include "io/cloud/laz/sequential_records.h"
#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ridgeline::io::laz {
namespace {

constexpr std::size_t kPortion = 1024;  // records decoded at once, some ten KiB

// Rejects a count that the bytes cannot hold, before anything depends on it.
void check_count(std::uint64_t n_points, std::uint64_t n_bytes, const std::string& path) {
  if (!may_hold(n_bytes, n_points)) {
    throw IoError(
        path, fmt::format(
                  "the header has {} points, but {} bytes of compressed data cannot hold that many",
                  n_points, n_bytes));
  }
}

}  // namespace

LazPoints::LazPoints(std::span<const std::byte> file, const LasHeader& header, std::string path)
    : file_(file), path_(std::move(path)), laszip_(read_laszip_record(file, header, path_)) {
  std::size_t first_chunk = header.point_offset;
  if (laszip_.compressor != Compressor::kPointwise) {
    try {
      chunks_ = read_chunk_table(file, header, laszip_);
      return;
    } catch (const CodecError& error) {
      if (laszip_.has_variable_chunks()) {
        throw IoError(
            path_,
            fmt::format(
                "chunk table cannot be used: {}; it is needed to locate chunks of varying size",
                error.what()));
      }
      warnings_.push_back(
          fmt::format("chunk table cannot be used: {}; the chunks are decoded one "
                      "after the other",
                      error.what()));
    }
    first_chunk = std::min(first_chunk + kChunkTableOffsetSize, file.size());
  }
  const std::span<const std::byte> bytes = file.subspan(first_chunk);
  check_count(header.n_points, bytes.size(), path_);
  sequential_ = std::make_unique<SequentialRecords>(bytes, laszip_, header.n_points, path_);
}

LazPoints::~LazPoints() = default;
LazPoints::LazPoints(LazPoints&&) noexcept = default;
LazPoints& LazPoints::operator=(LazPoints&&) noexcept = default;

std::size_t LazPoints::n_blocks() const {
  return sequential_ ? sequential_->n_blocks() : chunks_.size();
}

std::size_t LazPoints::n_points(std::size_t block) const {
  return sequential_ ? sequential_->n_records(block) : chunks_[block].n_points;
}

void LazPoints::decode(std::size_t block, RecordParts parts, const Consume& consume) const {
  if (sequential_) {
    consume(sequential_->block(block), 0);
  } else {
    decode_chunk(block, parts, consume);
  }
}

void LazPoints::decode_chunk(std::size_t block, RecordParts parts, const Consume& consume) const {
  const Chunk& chunk = chunks_[block];
  const std::size_t length = laszip_.record_length;
  std::vector<std::byte> records(std::min<std::size_t>(kPortion, chunk.n_points) * length);
  std::size_t point = 0;
  std::unique_ptr<RecordDecoder> decoder;
  const auto decode_portion = [&](std::size_t n_records) {
    try {
      if (!decoder) {
        decoder = make_record_decoder(laszip_, file_.subspan(chunk.offset, chunk.n_bytes), parts);
      }
      for (std::size_t i = 0; i < n_records; ++i, ++point) decoder->next(&records[i * length]);
    } catch (const CodecError& error) {
      throw damaged_chunk(path_, block, point, error);
    }
  };
  while (point < chunk.n_points) {
    const std::size_t first = point;
    const std::size_t n_records = std::min<std::size_t>(kPortion, chunk.n_points - first);
    decode_portion(n_records);
    consume(std::span(records).first(n_records * length), first);
  }
}

}  // namespace ridgeline::io::laz
