// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/bytes.h"
#include "io/cloud/laz/integer_decompressor.h"
#include "io/cloud/laz/item_decoder.h"
#include "io/cloud/laz/return_contexts.h"
#include "io/cloud/laz/running_median.h"
#include "io/cloud/laz/wrapping.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace ridgeline::io::laz {
namespace {

// The core of point formats 0 to 5 as stored in the file, without padding.
struct Point10 {
  std::int32_t x, y, z;
  std::uint16_t intensity;
  std::uint8_t returns;  // return number (3 bits), number of returns (3), scan direction, edge
  std::uint8_t classification;
  std::uint8_t scan_angle;
  std::uint8_t user_data;
  std::uint16_t source_id;

  [[nodiscard]] unsigned return_number() const { return returns & 7U; }
  [[nodiscard]] unsigned number_of_returns() const { return (returns >> 3) & 7U; }
  [[nodiscard]] unsigned scan_direction() const { return (returns >> 6) & 1U; }
};
static_assert(sizeof(Point10) == 20);

using ByteModels = std::vector<SymbolModel>;

ByteModels byte_models(std::size_t count) { return ByteModels(count, SymbolModel(256)); }

// Decodes a byte whose distribution depends on its previous value.
std::uint8_t decode_next(ArithmeticDecoder& decoder, ByteModels& models, std::uint8_t previous) {
  return static_cast<std::uint8_t>(decoder.decode_symbol(models[previous]));
}

std::int32_t median(const std::array<std::int32_t, 3>& values) {
  const auto [low, high] = std::minmax(values[0], values[1]);
  return std::clamp(values[2], low, high);
}

class Point10Version1 final : public ItemDecoder {
 public:
  explicit Point10Version1(std::span<const std::byte> first) : last_(load<Point10>(first.data())) {}

  void decode(ArithmeticDecoder& decoder, std::byte* item) override {
    const unsigned bit_count = decode_position(decoder);
    decode_attributes(decoder, bit_count);
    store(item, last_);
  }

 private:
  unsigned decode_position(ArithmeticDecoder& decoder) {
    constexpr unsigned kLastContext = 19;
    const std::int32_t dx = dx_.decode(decoder, median(last_dx_));
    const unsigned x_bits = dx_.last_bit_count();
    const std::int32_t dy = dy_.decode(decoder, median(last_dy_), std::min(x_bits, kLastContext));
    const unsigned mean_bits = (x_bits + dy_.last_bit_count()) / 2;
    last_.x = wrapping_add(last_.x, dx);
    last_.y = wrapping_add(last_.y, dy);
    last_.z = z_.decode(decoder, last_.z, std::min(mean_bits, kLastContext));
    last_dx_[oldest_] = dx;
    last_dy_[oldest_] = dy;
    oldest_ = (oldest_ + 1) % 3;
    return mean_bits;
  }

  void decode_attributes(ArithmeticDecoder& decoder, unsigned mean_bits) {
    const std::uint32_t changed = decoder.decode_symbol(changed_);
    if ((changed & 32U) != 0) {
      last_.intensity = static_cast<std::uint16_t>(intensity_.decode(decoder, last_.intensity));
    }
    if ((changed & 16U) != 0) last_.returns = decode_next(decoder, returns_, last_.returns);
    if ((changed & 8U) != 0) {
      last_.classification = decode_next(decoder, classification_, last_.classification);
    }
    if ((changed & 4U) != 0) {
      last_.scan_angle = static_cast<std::uint8_t>(
          scan_angle_.decode(decoder, last_.scan_angle, mean_bits < 3 ? 1 : 0));
    }
    if ((changed & 2U) != 0) last_.user_data = decode_next(decoder, user_data_, last_.user_data);
    if ((changed & 1U) != 0) {
      last_.source_id = static_cast<std::uint16_t>(source_id_.decode(decoder, last_.source_id));
    }
  }

  Point10 last_;
  std::array<std::int32_t, 3> last_dx_{};
  std::array<std::int32_t, 3> last_dy_{};
  std::size_t oldest_ = 0;
  IntegerDecompressor dx_{32};
  IntegerDecompressor dy_{32, 20};
  IntegerDecompressor z_{32, 20};
  IntegerDecompressor intensity_{16};
  IntegerDecompressor scan_angle_{8, 2};
  IntegerDecompressor source_id_{16};
  SymbolModel changed_{64};
  ByteModels returns_ = byte_models(256);
  ByteModels classification_ = byte_models(256);
  ByteModels user_data_ = byte_models(256);
};

class Point10Version2 final : public ItemDecoder {
 public:
  explicit Point10Version2(std::span<const std::byte> first) : last_(load<Point10>(first.data())) {
    last_.intensity = 0;  // the intensity of the first record predicts nothing
  }

  void decode(ArithmeticDecoder& decoder, std::byte* item) override {
    decode_attributes(decoder);
    decode_position(decoder);
    store(item, last_);
  }

 private:
  void decode_attributes(ArithmeticDecoder& decoder) {
    const std::uint32_t changed = decoder.decode_symbol(changed_);
    if (changed == 0) return;
    if ((changed & 32U) != 0) last_.returns = decode_next(decoder, returns_, last_.returns);
    decode_intensity(decoder, (changed & 16U) != 0);
    if ((changed & 8U) != 0) {
      last_.classification = decode_next(decoder, classification_, last_.classification);
    }
    if ((changed & 4U) != 0) {
      const std::uint32_t step = decoder.decode_symbol(scan_angle_[last_.scan_direction()]);
      last_.scan_angle = static_cast<std::uint8_t>(last_.scan_angle + step);
    }
    if ((changed & 2U) != 0) last_.user_data = decode_next(decoder, user_data_, last_.user_data);
    if ((changed & 1U) != 0) {
      last_.source_id = static_cast<std::uint16_t>(source_id_.decode(decoder, last_.source_id));
    }
  }

  void decode_intensity(ArithmeticDecoder& decoder, bool changed) {
    const unsigned kind = kReturnKind8[last_.number_of_returns()][last_.return_number()];
    if (changed) {
      last_intensity_[kind] = static_cast<std::uint16_t>(
          intensity_.decode(decoder, last_intensity_[kind], std::min(kind, 3U)));
    }
    last_.intensity = last_intensity_[kind];
  }

  void decode_position(ArithmeticDecoder& decoder) {
    const unsigned returns = last_.number_of_returns();
    const unsigned kind = kReturnKind8[returns][last_.return_number()];
    const unsigned level = return_level(returns, last_.return_number());
    const unsigned single = returns == 1 ? 1 : 0;

    const std::int32_t dx = dx_.decode(decoder, median_dx_[kind].get(), single);
    median_dx_[kind].add(dx);
    last_.x = wrapping_add(last_.x, dx);

    const unsigned x_bits = dx_.last_bit_count();
    const std::int32_t dy =
        dy_.decode(decoder, median_dy_[kind].get(), single + even_part(x_bits, 20));
    median_dy_[kind].add(dy);
    last_.y = wrapping_add(last_.y, dy);

    const unsigned mean_bits = (x_bits + dy_.last_bit_count()) / 2;
    last_.z = z_.decode(decoder, last_z_[level], single + even_part(mean_bits, 18));
    last_z_[level] = last_.z;
  }

  Point10 last_;
  std::array<std::uint16_t, 16> last_intensity_{};
  std::array<RunningMedian, 16> median_dx_;
  std::array<RunningMedian, 16> median_dy_;
  std::array<std::int32_t, 8> last_z_{};
  IntegerDecompressor dx_{32, 2};
  IntegerDecompressor dy_{32, 22};
  IntegerDecompressor z_{32, 20};
  IntegerDecompressor intensity_{16, 4};
  IntegerDecompressor source_id_{16};
  SymbolModel changed_{64};
  ByteModels scan_angle_ = byte_models(2);
  ByteModels returns_ = byte_models(256);
  ByteModels classification_ = byte_models(256);
  ByteModels user_data_ = byte_models(256);
};

}  // namespace

std::unique_ptr<ItemDecoder> make_point10_decoder(int version, std::span<const std::byte> first) {
  if (version == 1) return std::make_unique<Point10Version1>(first);
  return std::make_unique<Point10Version2>(first);
}

}  // namespace ridgeline::io::laz
