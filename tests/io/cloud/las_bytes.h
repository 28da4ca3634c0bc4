// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Builds a LAS file byte by byte, independent of the writer, so that any field can be spoilt.
/// Scale 0.01, offset (1000, 2000, 0), header bounds 0.
class LasBytes {
 public:
  LasBytes(int version_minor, std::uint8_t point_format, std::uint16_t extra_bytes = 0)
      : version_minor_(version_minor),
        record_length_(static_cast<std::uint16_t>(las_record_size(point_format) + extra_bytes)) {
    constexpr std::array<std::uint16_t, 6> kHeaderSizes{227, 227, 227, 235, 375, 393};
    header_.assign(kHeaderSizes.at(static_cast<std::size_t>(version_minor)), '\0');
    header_.replace(0, 4, "LASF");
    set<std::uint8_t>(24, 1);
    set(25, static_cast<std::uint8_t>(version_minor));
    set(94, static_cast<std::uint16_t>(header_.size()));
    set(104, point_format);
    set(105, record_length_);
    const std::array<double, 6> transform{0.01, 0.01, 0.01, 1000.0, 2000.0, 0.0};
    for (std::size_t i = 0; i < transform.size(); ++i) set(131 + 8 * i, transform[i]);
  }

  /// Overwrites header bytes. It must come after the add_*() calls, because these keep the counts
  /// up to date.
  template <typename T>
  LasBytes& set(std::size_t byte, T value) {
    std::memcpy(header_.data() + byte, &value, sizeof(T));
    return *this;
  }

  LasBytes& add_vlr(std::string_view user, std::uint16_t id, std::string_view payload) {
    std::string record(54, '\0');
    record.replace(2, user.size(), user);
    std::memcpy(&record[18], &id, 2);
    const auto size = static_cast<std::uint16_t>(payload.size());
    std::memcpy(&record[20], &size, 2);
    vlrs_ += record;
    vlrs_ += payload;
    return set(100, ++n_vlrs_).set(96, point_offset());
  }

  /// Adds a record of zeros except for its raw position, with `fields` written over from byte 12
  /// on.
  LasBytes& add_point(std::array<std::int32_t, 3> raw, std::string_view fields = {}) {
    std::string record(record_length_, '\0');
    std::memcpy(record.data(), raw.data(), sizeof(raw));
    record.replace(12, fields.size(), fields);
    records_ += record;
    ++n_points_;
    if (version_minor_ >= 4) {
      set<std::uint64_t>(247, n_points_);
    } else {
      set<std::uint32_t>(107, n_points_);
    }
    return set(96, point_offset());
  }

  /// Appends bytes behind the records: EVLRs, or anything else.
  LasBytes& add_tail(std::string_view bytes) {
    tail_ += bytes;
    return *this;
  }

  [[nodiscard]] std::uint32_t point_offset() const {
    return static_cast<std::uint32_t>(header_.size() + vlrs_.size());
  }
  [[nodiscard]] std::string bytes() const { return header_ + vlrs_ + records_ + tail_; }

 private:
  int version_minor_;
  std::uint16_t record_length_;
  std::uint32_t n_vlrs_ = 0;
  std::uint32_t n_points_ = 0;
  std::string header_, vlrs_, records_, tail_;
};

/// GeoTIFF key directory (record 34735) with short values: pairs of key and value.
inline std::string geotiff_directory(std::initializer_list<std::array<std::uint16_t, 2>> keys) {
  std::string bytes;
  const auto append = [&](std::uint16_t value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(1);
  append(1);
  append(0);
  append(static_cast<std::uint16_t>(keys.size()));
  for (const auto& [key, value] : keys) {
    append(key);
    append(0);
    append(1);
    append(value);
  }
  return bytes;
}

}  // namespace ridgeline::io
