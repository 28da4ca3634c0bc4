// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/bytes.h"
#include "io/cloud/laz/color.h"
#include "io/cloud/laz/gps_time.h"
#include "io/cloud/laz/integer_decompressor.h"
#include "io/cloud/laz/item_decoder.h"
#include "io/cloud/laz/wave_packet.h"
#include "io/cloud/laz/wrapping.h"

#include <vector>

namespace ridgeline::io::laz {
namespace {

class GpsTimeVersion1 final : public ItemDecoder {
 public:
  explicit GpsTimeVersion1(std::span<const std::byte> first)
      : time_(load<std::uint64_t>(first.data())) {}

  void decode(ArithmeticDecoder& decoder, std::byte* item) override {
    if (step_ == 0) {
      decode_without_step(decoder);
    } else {
      decode_with_step(decoder);
    }
    store(item, time_);
  }

 private:
  static constexpr std::uint32_t kMaxMultiple = 509;
  static constexpr std::uint32_t kFull = 510;
  static constexpr std::uint32_t kUnchanged = 511;
  static constexpr int kMaxUnlike = 3;

  void decode_without_step(ArithmeticDecoder& decoder) {
    const std::uint32_t kind = decoder.decode_symbol(without_step_);
    if (kind == 1) {
      step_ = difference_.decode(decoder, 0, 0);
      advance(step_);
    } else if (kind == 2) {
      time_ = decoder.read_u64();
    }
  }

  void decode_with_step(ArithmeticDecoder& decoder) {
    const std::uint32_t multiple = decoder.decode_symbol(with_step_);
    if (multiple == kUnchanged) return;
    if (multiple == kFull) {
      time_ = decoder.read_u64();
      return;
    }
    const std::int32_t prediction =
        multiple == 0 ? step_ / 4 : wrapping_multiply(static_cast<std::int32_t>(multiple), step_);
    const std::int32_t difference = difference_.decode(decoder, prediction, context_of(multiple));
    advance(difference);
    const bool is_unlike = multiple == 0 || multiple == kMaxMultiple;
    if (multiple == 1 || (is_unlike && ++num_unlike_ > kMaxUnlike)) {
      step_ = difference;
      num_unlike_ = 0;
    }
  }

  static unsigned context_of(std::uint32_t multiple) {
    if (multiple == 1) return 1;
    if (multiple == 0) return 2;
    if (multiple < 10) return 3;
    return multiple < 50 ? 4 : 5;
  }

  void advance(std::int32_t difference) {
    time_ += static_cast<std::uint64_t>(std::int64_t{difference});
  }

  std::uint64_t time_;
  std::int32_t step_ = 0;
  int num_unlike_ = 0;
  SymbolModel without_step_{3};
  SymbolModel with_step_{512};
  IntegerDecompressor difference_{32, 6};
};

class GpsTimeVersion2 final : public ItemDecoder {
 public:
  explicit GpsTimeVersion2(std::span<const std::byte> first)
      : times_(GpsTimeSequences::Alphabet::kWithUnchanged, load<std::uint64_t>(first.data())) {}

  void decode(ArithmeticDecoder& decoder, std::byte* item) override {
    store(item, times_.decode(decoder));
  }

 private:
  GpsTimeSequences times_;
};

class RgbVersion1 final : public ItemDecoder {
 public:
  explicit RgbVersion1(std::span<const std::byte> first) : last_(load<Rgb>(first.data())) {}

  void decode(ArithmeticDecoder& decoder, std::byte* item) override {
    const std::uint32_t changed = decoder.decode_symbol(changed_);
    for (unsigned byte = 0; byte < 6; ++byte) {
      if ((changed & (1U << byte)) == 0) continue;
      const unsigned shift = 8 * (byte % 2);
      std::uint16_t& value = last_[byte / 2];
      const std::int32_t decoded = difference_.decode(decoder, (value >> shift) & 0xFF, byte);
      value = static_cast<std::uint16_t>((value & (0xFF00U >> shift)) |
                                         (static_cast<std::uint32_t>(decoded) << shift));
    }
    store(item, last_);
  }

 private:
  Rgb last_;
  SymbolModel changed_{64};
  IntegerDecompressor difference_{8, 6};
};

/// A value that its models decode as a whole.
template <typename Models, typename Value>
class Modelled final : public ItemDecoder {
 public:
  explicit Modelled(std::span<const std::byte> first) : last_(load<Value>(first.data())) {}

  void decode(ArithmeticDecoder& decoder, std::byte* item) override {
    last_ = models_.decode(decoder, last_);
    store(item, last_);
  }

 private:
  Value last_;
  Models models_;
};

class BytesVersion1 final : public ItemDecoder {
 public:
  explicit BytesVersion1(std::span<const std::byte> first)
      : last_(first.begin(), first.end()), difference_(8, static_cast<unsigned>(first.size())) {}

  void decode(ArithmeticDecoder& decoder, std::byte* item) override {
    for (unsigned i = 0; i < last_.size(); ++i) {
      last_[i] = static_cast<std::byte>(
          difference_.decode(decoder, std::to_integer<std::int32_t>(last_[i]), i));
    }
    std::memcpy(item, last_.data(), last_.size());
  }

 private:
  std::vector<std::byte> last_;
  IntegerDecompressor difference_;
};

class BytesVersion2 final : public ItemDecoder {
 public:
  explicit BytesVersion2(std::span<const std::byte> first)
      : last_(first.begin(), first.end()), differences_(first.size(), SymbolModel(256)) {}

  void decode(ArithmeticDecoder& decoder, std::byte* item) override {
    for (std::size_t i = 0; i < last_.size(); ++i) {
      last_[i] = static_cast<std::byte>(std::to_integer<std::uint32_t>(last_[i]) +
                                        decoder.decode_symbol(differences_[i]));
    }
    std::memcpy(item, last_.data(), last_.size());
  }

 private:
  std::vector<std::byte> last_;
  std::vector<SymbolModel> differences_;
};

/// One of two versions of a decoder.
template <typename Version1, typename Version2>
std::unique_ptr<ItemDecoder> of_version(int version, std::span<const std::byte> first) {
  if (version == 1) return std::make_unique<Version1>(first);
  return std::make_unique<Version2>(first);
}

}  // namespace

std::unique_ptr<ItemDecoder> make_item_decoder(const Item& item, std::span<const std::byte> first) {
  switch (item.type) {
    case ItemType::kPoint10:
      return make_point10_decoder(item.version, first);
    case ItemType::kGpsTime11:
      return of_version<GpsTimeVersion1, GpsTimeVersion2>(item.version, first);
    case ItemType::kRgb12:
      return of_version<RgbVersion1, Modelled<RgbModels, Rgb>>(item.version, first);
    case ItemType::kWavePacket13:  // only version 1 exists
      return std::make_unique<Modelled<WavePacketModels, WavePacket>>(first);
    default:
      return of_version<BytesVersion1, BytesVersion2>(item.version, first);
  }
}

}  // namespace ridgeline::io::laz
