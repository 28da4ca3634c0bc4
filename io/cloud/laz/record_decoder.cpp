// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/record_decoder.h"

#include "io/cloud/bytes.h"
#include "io/cloud/laz/item_decoder.h"
#include "io/cloud/laz/layered_items.h"
#include "io/cloud/laz/point14.h"

#include <cstring>
#include <vector>

namespace ridgeline::io::laz {
namespace {

template <typename Decoder>
struct Placed {
  std::unique_ptr<Decoder> decoder;
  std::size_t offset;  // byte of the record at which the item begins
};

// A chunk consists of the first record, raw, and one stream in which the items of each record
// alternate.
class PointwiseDecoder final : public RecordDecoder {
 public:
  PointwiseDecoder(const LaszipRecord& laszip, ByteStream stream)
      : first_(stream.take(laszip.record_length)), decoder_(stream) {
    std::size_t offset = 0;
    for (const Item& item : laszip.items) {
      items_.push_back({make_item_decoder(item, first_.subspan(offset, item.size)), offset});
      offset += item.size;
    }
  }

  void next(std::byte* record) override {
    if (is_first_) {
      std::memcpy(record, first_.data(), first_.size());
      is_first_ = false;
      return;
    }
    for (const auto& [decoder, offset] : items_) decoder->decode(decoder_, record + offset);
  }

  [[nodiscard]] std::size_t position() const override { return decoder_.stream().position(); }

 private:
  Bytes first_;
  ArithmeticDecoder decoder_;
  std::vector<Placed<ItemDecoder>> items_;
  bool is_first_ = true;
};

std::size_t num_layers(const Item& item) {
  switch (item.type) {
    case ItemType::kPoint14:
      return Point14Decoder::kNumLayers;
    case ItemType::kRgbNir14:
      return 2;
    case ItemType::kByte14:
      return item.size;
    default:
      return 1;
  }
}

// A layered chunk: the first record, raw, then the number of points, the sizes of all layers and
// all layers.
struct LayeredChunk {
  LayeredChunk(const LaszipRecord& laszip, ByteStream stream)
      : first(stream.take(laszip.record_length)) {
    stream.take(sizeof(std::uint32_t));  // the number of points is also in the chunk table
    std::size_t n_layers = 0;
    for (const Item& item : laszip.items) n_layers += num_layers(item);
    const Bytes sizes = stream.take(n_layers * sizeof(std::uint32_t));
    for (std::size_t i = 0; i < n_layers; ++i) {
      layers.push_back(stream.take(load<std::uint32_t>(&sizes[i * sizeof(std::uint32_t)])));
    }
    size = stream.position();
  }

  Bytes first;
  std::vector<Bytes> layers;
  std::size_t size;
};

class LayeredDecoder final : public RecordDecoder {
 public:
  LayeredDecoder(const LaszipRecord& laszip, const LayeredChunk& chunk, RecordParts parts)
      : first_(chunk.first),
        size_(chunk.size),
        version_(static_cast<ItemVersion>(laszip.items.front().version)),
        point_(chunk.first, chunk.layers, parts) {
    if (parts != RecordParts::kAll) return;
    std::size_t offset = Point14Decoder::kItemSize;
    std::span<const Bytes> layers = chunk.layers;
    layers = layers.subspan(Point14Decoder::kNumLayers);
    for (std::size_t i = 1; i < laszip.items.size(); ++i) {
      const Item& item = laszip.items[i];
      items_.push_back({make_layered_item_decoder(item, point_.channel(),
                                                  first_.subspan(offset, item.size), layers),
                        offset});
      offset += item.size;
      layers = layers.subspan(num_layers(item));
    }
  }

  void next(std::byte* record) override {
    if (is_first_) {
      std::memcpy(record, first_.data(), first_.size());
      is_first_ = false;
      return;
    }
    point_.decode(record);
    const unsigned channel = channel_of_items();
    for (const auto& [decoder, offset] : items_) decoder->decode(channel, record + offset);
  }

  [[nodiscard]] std::size_t position() const override { return size_; }

 private:
  // The encoder of version 3 reports the channel to the items after the core only when it changes;
  // these items treat every other record as one of channel 0 (github.com/LASzip/LASzip/issues/74).
  [[nodiscard]] unsigned channel_of_items() const {
    return version_ == ItemVersion::k4 || point_.channel_changed() ? point_.channel() : 0;
  }

  Bytes first_;
  std::size_t size_;
  ItemVersion version_;
  Point14Decoder point_;
  std::vector<Placed<LayeredItemDecoder>> items_;
  bool is_first_ = true;
};

}  // namespace

std::unique_ptr<RecordDecoder> make_record_decoder(const LaszipRecord& laszip,
                                                   std::span<const std::byte> bytes,
                                                   RecordParts parts) {
  const ByteStream stream(bytes);
  if (laszip.compressor == Compressor::kLayered) {
    return std::make_unique<LayeredDecoder>(laszip, LayeredChunk(laszip, stream), parts);
  }
  return std::make_unique<PointwiseDecoder>(laszip, stream);
}

}  // namespace ridgeline::io::laz
