// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/arithmetic_decoder.h"
#include "io/cloud/laz/record_parts.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

namespace ridgeline::io::laz {

/// A layer of a chunk: absent if the chunk stores no bytes for it (the value never changes) or if
/// it is not wanted.
using Layer = std::optional<ArithmeticDecoder>;

/// The core of point formats 6 to 10 (POINT14; versions 3 and 4 are identical here). Each of the
/// four scanner channels has its own models and previous point. When a channel first occurs, its
/// models are new and its previous point is that of the channel before it.
class Point14Decoder {
 public:
  static constexpr std::size_t kItemSize = 30;
  static constexpr std::size_t kNumLayers = 9;

  /// `first` is the item of the chunk's first record, stored raw; the layers are in file order.
  Point14Decoder(std::span<const std::byte> first,
                 std::span<const std::span<const std::byte>> layers,
                 RecordParts parts);
  ~Point14Decoder();
  Point14Decoder(const Point14Decoder&) = delete;
  Point14Decoder& operator=(const Point14Decoder&) = delete;

  /// Decodes the item of the next record. Parts that are not wanted keep the value of the chunk's
  /// first record.
  void decode(std::byte* item);

  /// Scanner channel of the last decoded record.
  [[nodiscard]] unsigned channel() const { return channel_; }
  /// Whether the last decoded record changed the channel.
  [[nodiscard]] bool channel_changed() const { return channel_changed_; }

 private:
  struct Channel;
  struct Change;

  Channel& switch_channel(std::uint32_t step);
  Change decode_change();
  void decode_returns(Channel& channel, const Change& change);
  void decode_position(Channel& channel, const Change& change);
  void decode_attributes(Channel& channel, const Change& change);

  std::array<Layer, kNumLayers> layers_;
  std::array<std::unique_ptr<Channel>, 4> channels_;
  unsigned channel_ = 0;
  bool channel_changed_ = false;
};

}  // namespace ridgeline::io::laz
