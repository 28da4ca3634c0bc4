// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/layered_items.h"

#include "io/cloud/bytes.h"
#include "io/cloud/laz/channel_contexts.h"
#include "io/cloud/laz/color.h"
#include "io/cloud/laz/point14.h"
#include "io/cloud/laz/wave_packet.h"
#include "io/cloud/laz/wrapping.h"

#include <vector>

namespace ridgeline::io::laz {
namespace {

Layer make_layer(Bytes bytes) {
  if (bytes.empty()) return std::nullopt;
  return ArithmeticDecoder(ByteStream(bytes));
}

/// RGB14, wave packets: one layer with the whole value.
template <typename Models, typename Value>
class OneLayer final : public LayeredItemDecoder {
 public:
  OneLayer(ItemVersion version, unsigned channel, Bytes first, std::span<const Bytes> layers)
      : layer_(make_layer(layers[0])),
        contexts_(version, channel, Models(), load<Value>(first.data())) {}

  void decode(unsigned channel, std::byte* item) override {
    auto [models, last] = contexts_.select(channel);
    if (layer_) last = models.decode(*layer_, last);
    store(item, last);
  }

 private:
  Layer layer_;
  ChannelContexts<Models, Value> contexts_;
};

class RgbNir14 final : public LayeredItemDecoder {
 public:
  RgbNir14(ItemVersion version, unsigned channel, Bytes first, std::span<const Bytes> layers)
      : rgb_layer_(make_layer(layers[0])),
        nir_layer_(make_layer(layers[1])),
        contexts_(version, channel, Models{}, load<Value>(first.data())) {}

  void decode(unsigned channel, std::byte* item) override {
    auto [models, last] = contexts_.select(channel);
    if (rgb_layer_) last.rgb = models.rgb.decode(*rgb_layer_, last.rgb);
    if (nir_layer_) last.nir = models.nir.decode(*nir_layer_, last.nir);
    store(item, last);
  }

 private:
  struct Models {
    RgbModels rgb;
    NirModels nir;
  };
  struct Value {
    Rgb rgb;
    std::uint16_t nir;
  };
  static_assert(sizeof(Value) == 8);

  Layer rgb_layer_;
  Layer nir_layer_;
  ChannelContexts<Models, Value> contexts_;
};

class Byte14 final : public LayeredItemDecoder {
 public:
  Byte14(ItemVersion version, unsigned channel, Bytes first, std::span<const Bytes> layers)
      : contexts_(version,
                  channel,
                  Models(first.size(), SymbolModel(256)),
                  Value(first.begin(), first.end())) {
    for (const Bytes layer : layers) layers_.push_back(make_layer(layer));
  }

  void decode(unsigned channel, std::byte* item) override {
    auto [models, last] = contexts_.select(channel);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (layers_[i]) {
        last[i] = static_cast<std::byte>(std::to_integer<std::uint32_t>(last[i]) +
                                         layers_[i]->decode_symbol(models[i]));
      }
      item[i] = last[i];
    }
  }

 private:
  using Models = std::vector<SymbolModel>;
  using Value = std::vector<std::byte>;

  std::vector<Layer> layers_;
  ChannelContexts<Models, Value> contexts_;
};

}  // namespace

std::unique_ptr<LayeredItemDecoder> make_layered_item_decoder(const Item& item,
                                                              unsigned channel,
                                                              Bytes first,
                                                              std::span<const Bytes> layers) {
  const auto version = static_cast<ItemVersion>(item.version);
  switch (item.type) {
    case ItemType::kRgb14:
      return std::make_unique<OneLayer<RgbModels, Rgb>>(version, channel, first, layers);
    case ItemType::kRgbNir14:
      return std::make_unique<RgbNir14>(version, channel, first, layers);
    case ItemType::kWavePacket14:
      return std::make_unique<OneLayer<WavePacketModels, WavePacket>>(version, channel, first,
                                                                      layers);
    default:
      return std::make_unique<Byte14>(version, channel, first, layers);
  }
}

}  // namespace ridgeline::io::laz
