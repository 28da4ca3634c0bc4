// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/point14.h"

#include "io/cloud/bytes.h"
#include "io/cloud/laz/gps_time.h"
#include "io/cloud/laz/integer_decompressor.h"
#include "io/cloud/laz/return_contexts.h"
#include "io/cloud/laz/running_median.h"
#include "io/cloud/laz/wrapping.h"

#include <cstdint>
#include <vector>

namespace ridgeline::io::laz {
namespace {

enum LayerIndex : std::size_t {
  kXyLayer,
  kZLayer,
  kClassificationLayer,
  kFlagsLayer,
  kIntensityLayer,
  kScanAngleLayer,
  kUserDataLayer,
  kSourceLayer,
  kGpsTimeLayer,
};

bool is_wanted(std::size_t layer, RecordParts parts) {
  switch (layer) {
    case kXyLayer:
    case kZLayer:
    case kClassificationLayer:
    case kFlagsLayer:
    case kIntensityLayer:
    case kSourceLayer:
      return true;
    default:
      return parts == RecordParts::kAll;
  }
}

struct Point14 {
  std::int32_t x, y, z;
  std::uint16_t intensity;
  std::uint8_t return_number, number_of_returns;
  std::uint8_t flags;  // classification flags (4 bits), scan direction, edge of flight line
  std::uint8_t classification, user_data;
  std::uint16_t scan_angle, source_id;
  std::uint64_t gps_time;
};

unsigned stored_channel(std::span<const std::byte> item) {
  return (std::to_integer<unsigned>(item[15]) >> 4) & 3U;
}

Point14 load_point(std::span<const std::byte> item) {
  const auto returns = load<std::uint8_t>(&item[14]);
  const auto flags = load<std::uint8_t>(&item[15]);
  return {.x = load<std::int32_t>(&item[0]),
          .y = load<std::int32_t>(&item[4]),
          .z = load<std::int32_t>(&item[8]),
          .intensity = load<std::uint16_t>(&item[12]),
          .return_number = static_cast<std::uint8_t>(returns & 0x0FU),
          .number_of_returns = static_cast<std::uint8_t>(returns >> 4),
          .flags = static_cast<std::uint8_t>((flags & 0x0FU) | ((flags >> 2) & 0x30U)),
          .classification = load<std::uint8_t>(&item[16]),
          .user_data = load<std::uint8_t>(&item[17]),
          .scan_angle = load<std::uint16_t>(&item[18]),
          .source_id = load<std::uint16_t>(&item[20]),
          .gps_time = load<std::uint64_t>(&item[22])};
}

void store_point(const Point14& point, unsigned channel, std::byte* item) {
  store(item, point.x);
  store(item + 4, point.y);
  store(item + 8, point.z);
  store(item + 12, point.intensity);
  store(item + 14, static_cast<std::uint8_t>(point.return_number | (point.number_of_returns << 4)));
  store(item + 15, static_cast<std::uint8_t>((point.flags & 0x0FU) | (channel << 4) |
                                             ((point.flags & 0x30U) << 2)));
  store(item + 16, point.classification);
  store(item + 17, point.user_data);
  store(item + 18, point.scan_angle);
  store(item + 20, point.source_id);
  store(item + 22, point.gps_time);
}

std::vector<SymbolModel> models(std::size_t count, std::uint32_t num_symbols) {
  return {count, SymbolModel(num_symbols)};
}

}  // namespace

struct Point14Decoder::Change {
  Channel* channel;
  unsigned return_step;  // 0 same return number, 1 next, 2 previous, 3 another
  bool number_of_returns;
  bool scan_angle;
  bool gps_time;
  bool source_id;
};

struct Point14Decoder::Channel {
  explicit Channel(const Point14& point)
      : last(point), times(GpsTimeSequences::Alphabet::kWithoutUnchanged, point.gps_time) {
    last_z.fill(point.z);
    last_intensity.fill(point.intensity);
  }

  Point14 last;
  bool gps_time_changed = false;

  std::vector<SymbolModel> changed = models(8, 128);
  SymbolModel channel_step{3};
  std::vector<SymbolModel> number_of_returns = models(16, 16);
  std::vector<SymbolModel> return_number = models(16, 16);
  SymbolModel return_step_same_time{13};
  std::array<RunningMedian, 12> median_dx;
  std::array<RunningMedian, 12> median_dy;
  IntegerDecompressor dx{32, 2};
  IntegerDecompressor dy{32, 22};

  std::array<std::int32_t, 8> last_z{};
  IntegerDecompressor z{32, 20};
  std::vector<SymbolModel> classification = models(64, 256);
  std::vector<SymbolModel> flags = models(64, 64);
  std::array<std::uint16_t, 8> last_intensity{};
  IntegerDecompressor intensity{16, 4};
  IntegerDecompressor scan_angle{16, 2};
  std::vector<SymbolModel> user_data = models(64, 256);
  IntegerDecompressor source_id{16};
  GpsTimeSequences times;
};

Point14Decoder::Point14Decoder(std::span<const std::byte> first,
                               std::span<const std::span<const std::byte>> layers,
                               RecordParts parts) {
  for (std::size_t i = 0; i < kNumLayers; ++i) {
    if (!layers[i].empty() && is_wanted(i, parts)) layers_[i].emplace(ByteStream(layers[i]));
  }
  channel_ = stored_channel(first);
  channels_[channel_] = std::make_unique<Channel>(load_point(first));
}

Point14Decoder::~Point14Decoder() = default;

void Point14Decoder::decode(std::byte* item) {
  if (!layers_[kXyLayer]) throw CodecError("the layer of x and y is empty");
  const Change change = decode_change();
  Channel& channel = *change.channel;
  decode_returns(channel, change);
  decode_position(channel, change);
  decode_attributes(channel, change);
  channel.gps_time_changed = change.gps_time;
  store_point(channel.last, channel_, item);
}

Point14Decoder::Change Point14Decoder::decode_change() {
  ArithmeticDecoder& decoder = *layers_[kXyLayer];
  Channel* channel = channels_[channel_].get();
  const Point14& last = channel->last;
  const unsigned context = (last.return_number == 1 ? 1U : 0U) |
                           (last.return_number >= last.number_of_returns ? 2U : 0U) |
                           (channel->gps_time_changed ? 4U : 0U);
  const std::uint32_t changed = decoder.decode_symbol(channel->changed[context]);
  channel_changed_ = (changed & 64U) != 0;
  if (channel_changed_) channel = &switch_channel(decoder.decode_symbol(channel->channel_step) + 1);
  return {.channel = channel,
          .return_step = changed & 3U,
          .number_of_returns = (changed & 4U) != 0,
          .scan_angle = (changed & 8U) != 0,
          .gps_time = (changed & 16U) != 0,
          .source_id = (changed & 32U) != 0};
}

Point14Decoder::Channel& Point14Decoder::switch_channel(std::uint32_t step) {
  const Point14& last = channels_[channel_]->last;
  channel_ = (channel_ + step) % 4;
  if (!channels_[channel_]) channels_[channel_] = std::make_unique<Channel>(last);
  return *channels_[channel_];
}

void Point14Decoder::decode_returns(Channel& channel, const Change& change) {
  ArithmeticDecoder& decoder = *layers_[kXyLayer];
  Point14& point = channel.last;
  if (change.number_of_returns) {
    point.number_of_returns = static_cast<std::uint8_t>(
        decoder.decode_symbol(channel.number_of_returns[point.number_of_returns]));
  }
  std::uint32_t return_number = point.return_number;
  switch (change.return_step) {
    case 0:
      break;
    case 1:
      return_number += 1;
      break;
    case 2:
      return_number += 15;
      break;
    default:
      if (change.gps_time) {
        return_number = decoder.decode_symbol(channel.return_number[return_number]);
      } else {
        return_number += decoder.decode_symbol(channel.return_step_same_time) + 2;
      }
  }
  point.return_number = static_cast<std::uint8_t>(return_number % 16);
}

void Point14Decoder::decode_position(Channel& channel, const Change& change) {
  ArithmeticDecoder& decoder = *layers_[kXyLayer];
  Point14& point = channel.last;
  const unsigned kind = 2U * kReturnKind16[point.number_of_returns][point.return_number] +
                        (change.gps_time ? 1U : 0U);
  const unsigned single = point.number_of_returns == 1 ? 1 : 0;

  const std::int32_t dx = channel.dx.decode(decoder, channel.median_dx[kind].get(), single);
  channel.median_dx[kind].add(dx);
  point.x = wrapping_add(point.x, dx);

  const unsigned x_bits = channel.dx.last_bit_count();
  const std::int32_t dy =
      channel.dy.decode(decoder, channel.median_dy[kind].get(), single + even_part(x_bits, 20));
  channel.median_dy[kind].add(dy);
  point.y = wrapping_add(point.y, dy);

  if (!layers_[kZLayer]) return;
  const unsigned mean_bits = (x_bits + channel.dy.last_bit_count()) / 2;
  const unsigned level = return_level(point.number_of_returns, point.return_number);
  point.z =
      channel.z.decode(*layers_[kZLayer], channel.last_z[level], single + even_part(mean_bits, 18));
  channel.last_z[level] = point.z;
}

void Point14Decoder::decode_attributes(Channel& channel, const Change& change) {
  Point14& point = channel.last;
  const bool is_first = point.return_number == 1;
  const bool is_last = point.return_number >= point.number_of_returns;
  const unsigned place = (is_first ? 1U : 0U) + (is_last ? 2U : 0U);
  const unsigned time_changed = change.gps_time ? 1 : 0;

  if (Layer& layer = layers_[kClassificationLayer]) {
    const unsigned context = 2 * (point.classification & 0x1FU) + (place == 3 ? 1 : 0);
    point.classification =
        static_cast<std::uint8_t>(layer->decode_symbol(channel.classification[context]));
  }
  if (Layer& layer = layers_[kFlagsLayer]) {
    point.flags = static_cast<std::uint8_t>(layer->decode_symbol(channel.flags[point.flags]));
  }
  if (Layer& layer = layers_[kIntensityLayer]) {
    std::uint16_t& last = channel.last_intensity[2 * place + time_changed];
    last = static_cast<std::uint16_t>(channel.intensity.decode(*layer, last, place));
    point.intensity = last;
  }
  if (Layer& layer = layers_[kScanAngleLayer]; layer && change.scan_angle) {
    point.scan_angle = static_cast<std::uint16_t>(
        channel.scan_angle.decode(*layer, point.scan_angle, time_changed));
  }
  if (Layer& layer = layers_[kUserDataLayer]) {
    point.user_data =
        static_cast<std::uint8_t>(layer->decode_symbol(channel.user_data[point.user_data / 4]));
  }
  if (Layer& layer = layers_[kSourceLayer]; layer && change.source_id) {
    point.source_id = static_cast<std::uint16_t>(channel.source_id.decode(*layer, point.source_id));
  }
  if (Layer& layer = layers_[kGpsTimeLayer]; layer && change.gps_time) {
    point.gps_time = channel.times.decode(*layer);
  }
}

}  // namespace ridgeline::io::laz
