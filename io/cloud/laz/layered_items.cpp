// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/layered_items.h"

#include "io/cloud/bytes.h"
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

class Rgb14 final : public LayeredItemDecoder {
 public:
  Rgb14(ItemVersion version, unsigned channel, Bytes first, std::span<const Bytes> layers)
      : layer_(make_layer(layers[0])),
        contexts_(version, channel, RgbModels(), load<Rgb>(first.data())) {}

  void decode(unsigned channel, std::byte* item) override {
    auto [models, last] = contexts_.select(channel);
    if (layer_) last = models.decode(*layer_, last);
    store(item, last);
  }

 private:
  Layer layer_;
  ChannelContexts<RgbModels, Rgb> contexts_;
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

class WavePacket14 final : public LayeredItemDecoder {
 public:
  WavePacket14(ItemVersion version, unsigned channel, Bytes first, std::span<const Bytes> layers)
      : layer_(make_layer(layers[0])),
        contexts_(version, channel, WavePacketModels(), load<WavePacket>(first.data())) {}

  void decode(unsigned channel, std::byte* item) override {
    auto [models, last] = contexts_.select(channel);
    if (layer_) last = models.decode(*layer_, last);
    store(item, last);
  }

 private:
  Layer layer_;
  ChannelContexts<WavePacketModels, WavePacket> contexts_;
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

std::unique_ptr<LayeredItemDecoder> make_rgb14_decoder(ItemVersion version,
                                                       unsigned channel,
                                                       Bytes first,
                                                       std::span<const Bytes> layers) {
  return std::make_unique<Rgb14>(version, channel, first, layers);
}

std::unique_ptr<LayeredItemDecoder> make_rgb_nir14_decoder(ItemVersion version,
                                                           unsigned channel,
                                                           Bytes first,
                                                           std::span<const Bytes> layers) {
  return std::make_unique<RgbNir14>(version, channel, first, layers);
}

std::unique_ptr<LayeredItemDecoder> make_wave_packet14_decoder(ItemVersion version,
                                                               unsigned channel,
                                                               Bytes first,
                                                               std::span<const Bytes> layers) {
  return std::make_unique<WavePacket14>(version, channel, first, layers);
}

std::unique_ptr<LayeredItemDecoder> make_byte14_decoder(ItemVersion version,
                                                        unsigned channel,
                                                        Bytes first,
                                                        std::span<const Bytes> layers) {
  return std::make_unique<Byte14>(version, channel, first, layers);
}

}  // namespace ridgeline::io::laz
